// SPDX-License-Identifier: Apache-2.0
// Pictures and how they are sampled (glTF 2.0, section 3.8 "Texture Data").
#pragma once

#include "import/gltf/asset.h"

namespace sundog::import::gltf {

/// What a texture's numbers mean.
enum class TextureMeaning : std::uint8_t {
    color,  ///< sRGB-encoded; what is missing is shown as a checker.
    data,   ///< Linear; what is missing is left off.
};

/// Reads textureInfo objects: the texture with its picture, sampler and transform. Keeps what is read once.
class TextureReader {
public:
    explicit TextureReader(Asset& asset) : asset_(asset), places_(asset.list("images").element_locations()) {}

    /// What a textureInfo says, with `strength` 1; no texture for nothing. Errors: InputError for what can't be
    /// understood; a picture that is missing or can't be read is a warning.
    scene::TextureUse read(const Json& info, TextureMeaning meaning);

private:
    scene::Index picture(std::size_t number, TextureMeaning meaning);
    scene::Index load(std::size_t image, TextureMeaning meaning);
    void read_sampler(const Json& texture, scene::TextureUse& use);

    Asset& asset_;
    std::vector<SourceLocation> places_;                   ///< Of the images.
    std::unordered_map<std::size_t, scene::Index> known_;  ///< By twice the image's number, and 1 for data.
};

}  // namespace sundog::import::gltf
