// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_corner_textures.h"

#include <algorithm>
#include <vector>

#include "import/pov/build_texture_map.h"

namespace sundog::pov {
namespace {

using scene::Pigment;
using scene::PigmentColor;

bool is_plain(const TexturePointer& texture) {
    return texture->layers.size() == 1 && texture->layers[0].pigment->kind == Pigment::Kind::solid;
}

bool shine_alike(const TexturePointer& a, const TexturePointer& b) {
    return !a->layers[0].normal && !b->layers[0].normal && same_finishes(a->layers[0].finish, b->layers[0].finish);
}

/// Linear in the point, between 0 and 1.
class CornerShare final : public scene::ShareOfPoint {
public:
    void add(Vec3d slope, double constant) { slope_ = slope_ + slope, constant_ += constant; }
    [[nodiscard]] double at(Vec3d point) const override { return std::clamp(dot(slope_, point) + constant_, 0.0, 1.0); }

private:
    Vec3d slope_;
    double constant_ = 0;
};

PigmentColor color_of(const TexturePointer& texture) { return texture->layers[0].pigment->color; }

/// a + b - c
PigmentColor fourth_corner(const PigmentColor& a, const PigmentColor& b, const PigmentColor& c) {
    return {a.r + b.r - c.r, a.g + b.g - c.g, a.b + b.b - c.b, a.filter + b.filter - c.filter,
            a.transmit + b.transmit - c.transmit};
}

/// From one colour to another along an axis of uv space, between 0 and 1/2.
Pigment along(Vec3d axis, const SourceLocation& where) {
    Pigment pigment;
    pigment.where = where;
    pigment.kind = Pigment::Kind::mapped;
    pigment.pattern.kind = scene::Pattern::Kind::gradient;
    pigment.pattern.axis = axis;
    return pigment;
}

}  // namespace

TexturePointer blended_between(const CornerTextures& corners, const std::array<Vec3d, 3>& positions,
                               const SourceLocation& where) {
    const Vec3d normal = cross(positions[1] - positions[0], positions[2] - positions[0]);
    const double area = dot(normal, normal);
    if (!(area > 0)) return nullptr;
    std::vector<std::shared_ptr<CornerShare>> shares;
    std::vector<SharedTexture> textures;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto known = std::find_if(textures.begin(), textures.end(),
                                        [&](const SharedTexture& t) { return t.texture == corners[i]; });
        const auto number = static_cast<std::size_t>(known - textures.begin());
        if (known == textures.end()) {
            shares.push_back(std::make_shared<CornerShare>());
            textures.push_back({shares.back(), corners[i]});
        }
        // From 0 at the opposite side to 1 at the corner.
        const Vec3d begin = positions[(i + 1) % 3];
        const Vec3d slope = cross(normal, positions[(i + 2) % 3] - begin) / area;
        shares[number]->add(slope, -dot(slope, begin));
    }
    auto blended = textures_by_shares(textures, where);
    return blended ? std::make_shared<const scene::LayeredTexture>(*std::move(blended)) : nullptr;
}

TexturePointer CornerBlender::blended(const CornerTextures& corners) {
    if (!std::all_of(corners.begin(), corners.end(), is_plain) || !shine_alike(corners[0], corners[1]) ||
        !shine_alike(corners[0], corners[2]))
        return nullptr;
    const auto [place, is_new] = known_.try_emplace(corners, nullptr);
    if (!is_new) return place->second;
    const PigmentColor a = color_of(corners[0]);
    const PigmentColor b = color_of(corners[1]);
    const PigmentColor c = color_of(corners[2]);
    const scene::TextureLayer& first = corners[0]->layers[0];
    // Linear in u and v: from one gradient along u to another, along v, of the parallelogram on the triangle's sides.
    const auto row = [&](const PigmentColor& from, const PigmentColor& to) {
        Pigment pigment = along({1, 0, 0}, first.pigment->where);
        pigment.entries = {{0, from, nullptr}, {0.5F, to, nullptr}};
        return std::make_shared<const Pigment>(std::move(pigment));
    };
    Pigment pigment = along({0, 1, 0}, first.pigment->where);
    pigment.uv_mapping = true;
    pigment.entries = {{0, {}, row(a, b)}, {0.5F, {}, row(c, fourth_corner(b, c, a))}};
    scene::LayeredTexture texture;
    texture.layers.push_back({std::make_shared<const Pigment>(std::move(pigment)), first.finish, first.normal});
    place->second = std::make_shared<const scene::LayeredTexture>(std::move(texture));
    return place->second;
}

void set_corner_uvs(scene::SolidMesh& mesh, const std::vector<std::size_t>& triangles) {
    if (triangles.empty()) return;
    const auto first = static_cast<std::uint32_t>(mesh.uvs.size());
    mesh.uvs.insert(mesh.uvs.end(), kCornerUvs.begin(), kCornerUvs.end());
    for (const std::size_t i : triangles) mesh.triangles[i].uv = {first, first + 1, first + 2};
}

}  // namespace sundog::pov
