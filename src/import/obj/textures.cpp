// SPDX-License-Identifier: Apache-2.0
#include "import/obj/textures.h"

#include <algorithm>
#include <optional>

#include "import/obj/paths.h"
#include "output/image.h"

namespace sundog::import {
namespace {

constexpr const char* kMissingName = "(missing texture)";

std::optional<scene::Index> find_texture(const scene::Scene& scene, const std::string& name, bool srgb) {
    const auto it = std::find_if(scene.textures.begin(), scene.textures.end(),
                                 [&](const scene::Texture& t) { return t.srgb == srgb && t.name == name; });
    if (it == scene.textures.end()) return std::nullopt;
    return static_cast<scene::Index>(it - scene.textures.begin());
}

scene::Index append(scene::Scene& scene, scene::Texture texture) {
    scene.textures.push_back(std::move(texture));
    return static_cast<scene::Index>(scene.textures.size() - 1);
}

}  // namespace

scene::Index texture_from_file(scene::Scene& scene, const std::filesystem::path& file, bool srgb,
                               const SourceLocation& where) {
    const std::string name = file.string();
    if (const auto known = find_texture(scene, name, srgb)) return *known;
    scene::Texture texture{name, where, 0, 0, {}, srgb};
    if (const auto other = find_texture(scene, name, !srgb)) {
        const scene::Texture& same_pixels = scene.textures[*other];
        texture.width = same_pixels.width, texture.height = same_pixels.height;
        texture.rgba8 = same_pixels.rgba8;
        return append(scene, std::move(texture));
    }
    output::Rgba8 pixels = output::read_rgba8(file);
    texture.width = pixels.width, texture.height = pixels.height;
    texture.rgba8 = std::move(pixels.pixels);
    add_file(scene, file);
    return append(scene, std::move(texture));
}

scene::Index missing_texture(scene::Scene& scene) {
    if (const auto known = find_texture(scene, kMissingName, true)) return *known;
    constexpr std::uint32_t kSize = 16;
    constexpr std::uint32_t kMagenta = 0xffff00ffU;
    constexpr std::uint32_t kBlack = 0xff000000U;
    scene::Texture texture{kMissingName, {}, kSize, kSize, {}, true};
    for (std::uint32_t y = 0; y < kSize; ++y)
        for (std::uint32_t x = 0; x < kSize; ++x) texture.rgba8.push_back((x / 2 + y / 2) % 2 == 0 ? kMagenta : kBlack);
    return append(scene, std::move(texture));
}

}  // namespace sundog::import
