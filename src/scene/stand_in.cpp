// SPDX-License-Identifier: Apache-2.0
#include "scene/stand_in.h"

#include <algorithm>
#include <utility>

namespace sundog::scene {

Material missing_material(std::string name, SourceLocation where) {
    Material material;
    material.name = std::move(name);
    material.where = std::move(where);
    material.mtl->diffuse = {1, 0, 1};
    material.mtl->checker = Checker{8, 8, {0, 0, 0}};
    material.mtl->illum = 1;
    return material;
}

Index missing_texture(Scene& scene) {
    constexpr const char* kName = "(missing texture)";
    constexpr std::uint32_t kSize = 16;
    constexpr std::uint32_t kMagenta = 0xffff00ffU;
    constexpr std::uint32_t kBlack = 0xff000000U;
    const auto known = std::find_if(scene.textures.begin(), scene.textures.end(),
                                    [&](const Texture& texture) { return texture.name == kName; });
    if (known != scene.textures.end()) return static_cast<Index>(known - scene.textures.begin());
    Texture texture{kName, {}, kSize, kSize, {}, true};
    for (std::uint32_t y = 0; y < kSize; ++y)
        for (std::uint32_t x = 0; x < kSize; ++x) texture.rgba8.push_back((x / 2 + y / 2) % 2 == 0 ? kMagenta : kBlack);
    scene.textures.push_back(std::move(texture));
    return static_cast<Index>(scene.textures.size() - 1);
}

}  // namespace sundog::scene
