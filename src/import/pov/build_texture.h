// SPDX-License-Identifier: Apache-2.0
// Textures, materials and what #default says (POV-Ray reference, section 3.4.6 "Texture").
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>

#include "import/pov/build_context.h"
#include "import/pov/build_finish.h"
#include "import/pov/build_items.h"
#include "scene/pigment.h"

namespace sundog::pov {

using TexturePointer = std::shared_ptr<const scene::LayeredTexture>;
using InteriorPointer = std::shared_ptr<const scene::Interior>;

/// Moves all layers as move_pigment() does.
void move_texture(scene::LayeredTexture& texture, const Affine3d& old_from_new);

/// True if a texture looks different in different places.
bool is_positional(const scene::LayeredTexture& texture);

/// What #default had set where a block begins.
struct DefaultTexture {
    scene::TextureLayer layer;
    TexturePointer texture;  ///< That layer alone.
};

/// What a `material { }` says.
struct MaterialParts {
    TexturePointer texture, interior_texture;
    InteriorPointer interior;
};

/// Reads textures, each declared one only once, and gives equal plain ones the same pointer.
class TextureReader {
public:
    explicit TextureReader(BuildContext& context) : context_(context) {}

    /// The texture of a `texture { }` or `interior_texture { }`.
    TexturePointer read(const std::shared_ptr<const Block>& block);
    /// `texture` changed by an object's own `pigment { }`, `normal { }` or `finish { }`; null: #default's texture is.
    TexturePointer changed(const TexturePointer& texture, const Block& block, const Block& owner);
    /// Two layers or groups of them, `over` on top.
    TexturePointer layered(const TexturePointer& under, const TexturePointer& over);
    /// `texture` with uv_mapping on all its layers.
    TexturePointer uv_mapped(const TexturePointer& texture);
    /// `texture`, moved.
    TexturePointer moved(const TexturePointer& texture, const Affine3d& old_from_new);
    TexturePointer default_texture(const Block& owner);
    MaterialParts read_material(const std::shared_ptr<const Block>& block);
    InteriorPointer read_interior(const Block& block);
    /// The interior that finishes of before version 3.1 stated in this texture; null for others.
    [[nodiscard]] InteriorPointer interior_of(const TexturePointer& texture) const;

private:
    friend class TextureBlockReader;
    const DefaultTexture& defaults_of(const Block& owner);
    DefaultTexture read_defaults(const Block& block);
    /// The one pointer for all textures equal to this one, if it is plain; else a new one.
    TexturePointer shared(scene::LayeredTexture texture);

    BuildContext& context_;
    using WeakBlock = std::weak_ptr<const Block>;
    std::map<WeakBlock, TexturePointer, std::owner_less<WeakBlock>> read_before_;
    std::map<WeakBlock, DefaultTexture, std::owner_less<WeakBlock>> defaults_;
    std::optional<DefaultTexture> no_defaults_;
    std::unordered_map<std::string, TexturePointer> plain_;
    std::unordered_map<std::string, InteriorPointer> interiors_;
    std::map<TexturePointer, InteriorPointer> old_interiors_;
};

}  // namespace sundog::pov
