// SPDX-License-Identifier: Apache-2.0
#include "compile/bodies.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "compile/insides_at.h"
#include "compile/materials_of.h"
#include "scene/bounds.h"

namespace sundog {
namespace {

/// What is in a body.
struct Content {
    float ior = 1;
    kernel::vec3 attenuation{};

    [[nodiscard]] bool dims() const { return attenuation.x > 0 || attenuation.y > 0 || attenuation.z > 0; }
    [[nodiscard]] std::array<float, 4> key() const { return {ior, attenuation.x, attenuation.y, attenuation.z}; }
};

std::optional<Content> content_of(const RenderScene& scene, const kernel::Material& m) {
    if ((m.flags & kernel::MATERIAL_PATTERNED) != 0) return std::nullopt;
    if (m.bsdf == kernel::NONE) {
        if ((m.flags & kernel::MATERIAL_TRANSPARENT) == 0 || m.ior == 1) return std::nullopt;
        return Content{m.ior, {}};
    }
    const kernel::Bsdf& bsdf = scene.bsdfs[m.bsdf];
    if (bsdf.kind == kernel::BSDF_DIELECTRIC) return Content{bsdf.ior, {}};
    if (bsdf.kind != kernel::BSDF_PRINCIPLED || bsdf.thin != 0 || !(bsdf.transmission > 0)) return std::nullopt;
    return Content{bsdf.ior, bsdf.attenuation};
}

/// What there is of bodies in an object.
struct Part {
    int bodies = 0;       ///< Different ones.
    bool dims = false;    ///< One of them does.
    bool others = false;  ///< Surfaces that aren't a body's.
    Bounds3 bounds;
    bool endless = false;  ///< The bounds aren't known.
};

bool meet(const Part& a, const Part& b) { return a.endless || b.endless || scene::overlap(a.bounds, b.bounds); }

Part part_of(const scene::Object& object, const std::vector<std::optional<Content>>& contents) {
    Part part;
    std::vector<std::array<float, 4>> seen;
    const auto add = [&](scene::Index material) {
        const std::optional<Content>& content = contents[material];
        if (!content) {
            part.others = true;
            return;
        }
        part.dims = part.dims || content->dims();
        if (std::find(seen.begin(), seen.end(), content->key()) == seen.end()) seen.push_back(content->key());
    };
    scene::Index last = scene::kNone;
    for_each_material(object, [&](scene::Index material) {
        if (material != last) add(last = material);
    });
    part.bodies = static_cast<int>(seen.size());
    part.bounds = scene::bounds_of(object);
    part.endless = scene::moves(object) || object.deformation != nullptr ||
                   (part.bounds.empty() && !std::holds_alternative<Boxed<scene::Mesh>>(object.shape));
    return part;
}

/// True if what a ray is in can't be told by the side of the surface that it meets.
bool count(const scene::Scene& scene, const std::vector<std::optional<Content>>& contents) {
    std::vector<Part> parts;
    for (const scene::Object& object : scene.objects) parts.push_back(part_of(object, contents));
    // Looking at all pairs of more would take longer than lists of bodies do.
    constexpr auto kMostLookedAt = 1000;
    if (std::count_if(parts.begin(), parts.end(), [](const Part& p) { return p.bodies > 0; }) > kMostLookedAt)
        return true;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Part& one = parts[i];
        if (one.bodies == 0) continue;
        if (one.bodies > 1 || (one.dims && one.others)) return true;
        for (std::size_t j = 0; j < parts.size(); ++j)
            if (j != i && (one.dims || parts[j].bodies > 0) && meet(one, parts[j])) return true;
    }
    return false;
}

}  // namespace

void find_bodies(const scene::Scene& scene, RenderScene& out) {
    std::vector<std::optional<Content>> contents;
    contents.reserve(out.materials.size());
    bool any = false;
    for (const kernel::Material& m : out.materials) {
        if ((m.flags & kernel::MATERIAL_PATTERNED) != 0) return;  // Their interiors take the lists.
        contents.push_back(content_of(out, m));
        any = any || contents.back();
    }
    if (!any || !count(scene, contents)) return;
    out.features |= kernel::FEATURE_BODIES;
    // The numbers before are kept as in scenes with layers.
    out.interiors.resize(kInteriorAround + 1, {1, 1, 0, {1, 1, 1}, 1, 1, 0, {0, 0, 0}});
    std::map<std::array<float, 4>, std::uint32_t> known;
    for (std::size_t i = 0; i < contents.size(); ++i) {
        if (!contents[i]) continue;
        const auto next =
            static_cast<std::uint32_t>(std::min<std::size_t>(out.interiors.size(), kernel::MAX_INTERIORS - 1));
        const auto [number, is_new] = known.try_emplace(contents[i]->key(), next);
        if (is_new && next == out.interiors.size())
            out.interiors.push_back({contents[i]->ior, 1, 0, {1, 1, 1}, 1, 1, 0, contents[i]->attenuation});
        out.materials[i].interior = number->second;
    }
}

}  // namespace sundog
