// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_corner_textures.h"

#include <algorithm>

namespace sundog::pov {
namespace {

using scene::Pigment;
using scene::PigmentColor;

bool is_plain(const TexturePointer& texture) {
    return texture->layers.size() == 1 && texture->layers[0].pigment->kind == Pigment::Kind::solid;
}

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

TexturePointer CornerBlender::blended(const CornerTextures& corners) {
    if (!std::all_of(corners.begin(), corners.end(), is_plain)) return nullptr;
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
