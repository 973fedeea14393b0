// SPDX-License-Identifier: Apache-2.0
// Texture statements of material libraries: options and a file name.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "base/text_file.h"
#include "scene/scene.h"

namespace sundog::import {

/// What a texture's numbers mean.
enum class MapKind {
    color,    ///< sRGB-encoded colour; missing files are shown as a checker.
    height,   ///< Linear; one channel counts, by default luminance. Missing files leave the map off.
    opacity,  ///< Likewise, but by default the alpha channel of a picture that is not opaque all over.
    normal,   ///< Linear directions. Missing files leave the map off.
};

/// A warning and a key under which it is said only once.
using KeyedWarningSink = std::function<void(const Diagnostic&, std::string_view key)>;

/// Reads what follows the keyword: `[-option arguments]… file name`. The cursor's line comes from `library`; the
/// texture is appended to the scene. Errors: InputError for malformed options; a file that is missing or can't be
/// read is a warning.
scene::TextureUse read_texture_use(LineCursor& cursor, MapKind kind, const std::filesystem::path& library,
                                   scene::Scene& scene, const KeyedWarningSink& warn);

}  // namespace sundog::import
