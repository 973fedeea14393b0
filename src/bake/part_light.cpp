// SPDX-License-Identifier: Apache-2.0
#include "bake/part_light.h"

#include <utility>

namespace sundog::bake {

namespace {

/// How much brighter the back must be before an object is taken for turned.
constexpr double kClearly = 1.25;

}  // namespace

bool is_textured(const scene::Material& material) {
    if (material.principled) return material.principled->base_color_map.texture != scene::kNone;
    return !material.patterned && material.mtl->map_diffuse.texture != scene::kNone;
}

Vec3 light_of_white(Vec3 radiance, Vec3 albedo) {
    const auto channel = [](float light, float share) { return share > 1e-3F ? light / share : 0.0F; };
    return {channel(radiance.x, albedo.x), channel(radiance.y, albedo.y), channel(radiance.z, albedo.z)};
}

bool is_turned(const PartSides& sides) {
    std::array<double, 2> all{};
    for (std::size_t side = 0; side < 2; ++side)
        for (const Vec3& light : sides[side]) all[side] += light.x + light.y + light.z;
    return all[1] > kClearly * all[0];
}

void take_side(Part& part, PartSides& sides, bool turned) {
    part.light = std::move(sides[turned ? 1 : 0]);
    if (!turned) return;
    for (Vec3& n : part.normals) n = n * -1;
    for (auto* const triangles : {&part.triangles, &part.undivided})
        for (auto& t : *triangles) std::swap(t[1], t[2]);
}

}  // namespace sundog::bake
