// SPDX-License-Identifier: Apache-2.0
#include "import/obj/textures.h"

#include <algorithm>
#include <optional>

#include "output/image.h"
#include "scene/files.h"

namespace sundog::import {
namespace {

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
    scene::add_file(scene, file);
    return append(scene, std::move(texture));
}

}  // namespace sundog::import
