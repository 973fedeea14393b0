// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_texture.h"

#include <algorithm>
#include <array>
#include <utility>

#include "import/pov/build_material_map.h"
#include "import/pov/build_media.h"
#include "import/pov/build_normal.h"
#include "import/pov/build_pattern.h"
#include "import/pov/build_pigment.h"
#include "import/pov/build_radiosity.h"
#include "import/pov/build_texture_map.h"
#include "import/pov/build_transform.h"
#include "import/pov/byte_key.h"

namespace sundog::pov {
namespace {

using scene::LayeredTexture;
using scene::Pigment;
using scene::TextureLayer;

/// How many different plain textures are kept in mind at a time.
constexpr std::size_t kMostRemembered = 256;

/// Tells plain single-layer textures apart; empty for all others.
std::string key_of(const LayeredTexture& texture) {
    if (texture.layers.size() != 1 || is_positional(texture)) return {};
    const scene::PigmentColor& c = texture.layers[0].pigment->color;
    std::string key = bytes_of(texture.layers[0].finish);
    append_bytes(key, c.r, c.g, c.b, c.filter, c.transmit);
    return key;
}

/// A copy of what is shared, changed.
template <class T, class Change>
void change_copy(std::shared_ptr<const T>& shared, const Change& change) {
    auto copy = std::make_shared<T>(*shared);
    change(*copy);
    shared = std::move(copy);
}

void set_uv_mapping(TextureLayer& layer) {
    const auto map = [](auto& part) { part.uv_mapping = true; };
    change_copy(layer.pigment, map);
    if (layer.normal) change_copy(layer.normal, map);
}

void keep_depth(TextureLayer& layer) {
    if (!layer.normal) return;
    change_copy(layer.normal, [](scene::Normal& normal) {
        for (scene::PatternNormal& part : normal.parts) part.keeps_depth = true;
    });
}

/// Calls change_normal and change_pigment for all of a texture that lies in space.
template <class ChangeNormal, class ChangePigment>
void change_texture(LayeredTexture& texture, const ChangeNormal& change_normal, const ChangePigment& change_pigment) {
    if (texture.blended) {
        change_copy(texture.blended,
                    [&](LayeredTexture& blended) { change_texture(blended, change_normal, change_pigment); });
    }
    for (TextureLayer& layer : texture.layers) {
        if (layer.normal) change_copy(layer.normal, change_normal);
        if (layer.share) change_copy(layer.share, change_pigment);
        if (is_positional(*layer.pigment)) change_copy(layer.pigment, change_pigment);
    }
}

void bend_texture(LayeredTexture& texture, const scene::Warp& warp) {
    change_texture(
        texture, [&](scene::Normal& normal) { bend_normal(normal, warp); },
        [&](Pigment& pigment) { bend_pigment(pigment, warp); });
}

}  // namespace

void move_texture(LayeredTexture& texture, const Affine3d& old_from_new) {
    change_texture(
        texture, [&](scene::Normal& normal) { move_normal(normal, old_from_new); },
        [&](Pigment& pigment) { move_pigment(pigment, old_from_new); });
}

bool is_positional(const LayeredTexture& texture) {
    return std::any_of(texture.layers.begin(), texture.layers.end(), [](const TextureLayer& layer) {
        return layer.normal || layer.share || is_positional(*layer.pigment);
    });
}

/// Reads one `texture { }`.
class TextureBlockReader {
public:
    TextureBlockReader(TextureReader& owner, const Block& block)
        : owner_(owner), context_(owner.context_), block_(block), items_(context_, block) {}

    TexturePointer read() {
        while (!items_.at_end()) read_item();
        if (parts_.given) {
            if (entries_.empty())
                context_.fail(block_.where, "a patterned texture without textures",
                              "expected texture_map { } or textures after the pattern");
            own_ = blend_textures(context_, block_.where, parts_.pattern, entries_);
            changed_ = true;
        }
        if (!changed_ && base_) {
            const bool moved = !parts_.warps.empty() || !(parts_.texture_from_pattern == Affine3d{});
            if (!moved || !is_positional(*base_)) return base_;
            own_ = *base_;
        }
        if (!changed_ && !base_) return owner_.default_texture(block_);
        place(
            parts_, [this](const Affine3d& old_from_new) { move_texture(own_, old_from_new); },
            [this](const scene::Warp& warp) { bend_texture(own_, warp); });
        if (uv_mapping_)
            for (TextureLayer& layer : own_.layers) set_uv_mapping(layer);
        if (keeps_depth_)
            for (TextureLayer& layer : own_.layers) keep_depth(layer);
        TexturePointer result = owner_.shared(std::move(own_));
        if (interior_) owner_.old_interiors_[result] = std::make_shared<const scene::Interior>(*interior_);
        return result;
    }

private:
    void read_item() {
        if (const auto base = items_.take_block(Keyword::texture)) {
            take_base(owner_.read(base));
        } else if (const auto pigment = items_.take_block(Keyword::pigment)) {
            TextureLayer& layer = top();
            layer.pigment = std::make_shared<const Pigment>(read_pigment(context_, *pigment, *layer.pigment));
        } else if (const auto finish = items_.take_block(Keyword::finish)) {
            take_finish(*finish);
        } else if (const auto normal = items_.take_block(Keyword::normal)) {
            TextureLayer& layer = top();
            layer.normal = read_normal(context_, *normal, layer.normal, owner_.defaults_of(block_).layer.normal);
        } else if (const auto map = items_.take_block(Keyword::texture_map)) {
            read_map(*map);
        } else if (const auto materials = items_.take_block(Keyword::material_map)) {
            read_textures_of_material_map(*materials);
        } else if (const auto tiles = items_.take_block(Keyword::tiles)) {
            read_tiles(*tiles);
        } else if (items_.take(Keyword::uv_mapping)) {
            if (items_.flag()) top(), uv_mapping_ = true;
        } else if (items_.take(Keyword::no_bump_scale)) {
            if (items_.flag()) top(), keeps_depth_ = true;
        } else {
            read_pattern();
        }
    }

    void take_base(TexturePointer base) {
        if (!base_ && !changed_) {
            base_ = std::move(base);
            return;
        }
        if (!changed_) own_ = *base_;
        changed_ = true;
        own_.blended = nullptr;
        own_.layers.insert(own_.layers.end(), base->layers.begin(), base->layers.end());
    }

    /// The layer that items change: the last one.
    TextureLayer& top() {
        if (!changed_) own_ = base_ ? *base_ : LayeredTexture{{owner_.defaults_of(block_).layer}};
        changed_ = true;
        own_.blended = nullptr;
        return own_.layers.back();
    }

    void take_finish(const Block& block) {
        const FinishParts parts = read_finish(context_, block, {top().finish, {}, false});
        own_.layers.back().finish = parts.finish;
        if (parts.has_interior) interior_ = parts.interior;
    }

    void read_map(const Block& map) {
        ItemReader items(context_, map);
        while (!items.at_end()) {
            if (const auto base = items.take_block(Keyword::texture_map)) {
                read_map(*base);
                continue;
            }
            const auto row = items.take_row();
            if (!row) items.unexpected("a row in square brackets");
            ItemReader inside(context_, *row, Keyword::texture_map);
            // In an average the number is a weight, which may be left out.
            const std::optional<double> given = inside.maybe_number();
            const float at = given ? static_cast<float>(*given) : 1.0F;
            const Block texture = block_of_row(*row, given ? 1 : 0, Keyword::texture, block_);
            entries_.push_back({at, TextureBlockReader(owner_, texture).read()});
        }
    }

    void read_choices(ItemReader& items, std::size_t count) {
        while (entries_.size() < count) {
            const auto block = items.take_block(Keyword::texture);
            if (!block) return;
            entries_.push_back({0, owner_.read(block)});
        }
    }

    void read_textures_of_material_map(const Block& block) {
        MaterialMap map = read_material_map(context_, block);
        for (const auto& texture : map.textures) entries_.push_back({0, owner_.read(texture)});
        parts_.pattern = std::move(map.pattern);
        parts_.given = true;
    }

    void read_tiles(const Block& block) {
        ItemReader items(context_, block);
        while (!items.at_end()) {
            if (const auto texture = items.take_block(Keyword::texture)) {
                entries_.push_back({0, owner_.read(texture)});
            } else if (!items.take(Keyword::tile2)) {
                items.unexpected("texture { } tile2 texture { }");
            }
        }
        if (entries_.size() != 2) context_.fail(block.where, "tiles { } takes two textures");
        std::swap(entries_[0], entries_[1]);  // the second lies where a checker has its first
        parts_.pattern.kind = scene::Pattern::Kind::checker;
        parts_.given = true;
    }

    void read_pattern() {
        const bool given = parts_.given;
        parts_.given = false;
        if (!read_pattern_item(items_, parts_)) {
            static constexpr std::array kValid{Keyword::pigment,     Keyword::normal,       Keyword::finish,
                                               Keyword::texture_map, Keyword::material_map, Keyword::tiles,
                                               Keyword::rotate,      Keyword::translate,    Keyword::scale,
                                               Keyword::matrix,      Keyword::transform,    Keyword::uv_mapping,
                                               Keyword::gradient,    Keyword::checker};
            items_.unexpected(kValid);
        }
        const std::size_t count = parts_.given ? choice_count(parts_.pattern.kind) : 0;
        if (const auto list = std::exchange(parts_.list, nullptr)) {
            ItemReader inside(context_, *list);
            read_choices(inside, count);
        } else {
            read_choices(items_, count);
        }
        parts_.given |= given;
    }

    TextureReader& owner_;
    BuildContext& context_;
    const Block& block_;
    ItemReader items_;
    TexturePointer base_;  // Of an identifier, as long as nothing changes it.
    LayeredTexture own_;
    bool changed_ = false;
    bool uv_mapping_ = false, keeps_depth_ = false;
    PatternParts parts_;
    std::vector<TextureEntry> entries_;
    std::optional<scene::Interior> interior_;
};

TexturePointer TextureReader::shared(LayeredTexture texture) {
    std::string key = key_of(texture);
    if (key.empty()) return std::make_shared<const LayeredTexture>(std::move(texture));
    // Where each of a million objects has its own colour, remembering all of them only costs.
    if (plain_.size() >= kMostRemembered) plain_.clear();
    TexturePointer& known = plain_[std::move(key)];
    if (!known) known = std::make_shared<const LayeredTexture>(std::move(texture));
    return known;
}

TexturePointer TextureReader::read(const std::shared_ptr<const Block>& block) {
    if (block.use_count() <= 2) return TextureBlockReader(*this, *block).read();
    const auto known = read_before_.find(block);
    if (known != read_before_.end()) return known->second;
    TexturePointer texture = TextureBlockReader(*this, *block).read();
    read_before_.emplace(block, texture);
    return texture;
}

DefaultTexture TextureReader::read_defaults(const Block& block) {
    DefaultTexture result;
    result.layer.pigment = std::make_shared<const Pigment>();
    ItemReader items(context_, block);
    while (!items.at_end()) {
        if (const auto texture = items.take_block(Keyword::texture)) {
            const TexturePointer read = TextureBlockReader(*this, *texture).read();
            result.layer = read->layers.back();
        } else if (const auto pigment = items.take_block(Keyword::pigment)) {
            result.layer.pigment =
                std::make_shared<const Pigment>(read_pigment(context_, *pigment, *result.layer.pigment));
        } else if (const auto finish = items.take_block(Keyword::finish)) {
            result.layer.finish = read_finish(context_, *finish, {result.layer.finish, {}, false}).finish;
        } else if (const auto normal = items.take_block(Keyword::normal)) {
            result.layer.normal = read_normal(context_, *normal, result.layer.normal, nullptr);
        } else if (const auto radiosity = items.take_block(Keyword::radiosity)) {
            read_importance(context_, *radiosity);
        } else if (!items.take_block(Keyword::camera)) {
            static constexpr std::array kValid{Keyword::texture, Keyword::pigment, Keyword::normal,
                                               Keyword::finish,  Keyword::camera,  Keyword::radiosity};
            items.unexpected(kValid);
        }
    }
    result.texture = shared({{result.layer}});
    return result;
}

const DefaultTexture& TextureReader::defaults_of(const Block& owner) {
    if (!owner.defaults) {
        if (!no_defaults_) no_defaults_ = read_defaults(Block{});
        return *no_defaults_;
    }
    const auto known = defaults_.find(owner.defaults);
    if (known != defaults_.end()) return known->second;
    return defaults_.emplace(owner.defaults, read_defaults(*owner.defaults)).first->second;
}

TexturePointer TextureReader::default_texture(const Block& owner) { return defaults_of(owner).texture; }

TexturePointer TextureReader::changed(const TexturePointer& texture, const Block& block, const Block& owner) {
    LayeredTexture result = texture ? *texture : LayeredTexture{{defaults_of(owner).layer}};
    result.blended = nullptr;
    TextureLayer& layer = result.layers.back();
    if (block.keyword == Keyword::pigment) {
        layer.pigment = std::make_shared<const Pigment>(read_pigment(context_, block, *layer.pigment));
        return shared(std::move(result));
    }
    if (block.keyword == Keyword::normal) {
        layer.normal = read_normal(context_, block, layer.normal, defaults_of(owner).layer.normal);
        return shared(std::move(result));
    }
    const FinishParts parts = read_finish(context_, block, {layer.finish, {}, false});
    layer.finish = parts.finish;
    TexturePointer finished = shared(std::move(result));
    if (parts.has_interior) old_interiors_[finished] = std::make_shared<const scene::Interior>(parts.interior);
    return finished;
}

TexturePointer TextureReader::layered(const TexturePointer& under, const TexturePointer& over) {
    if (!under) return over;
    auto result = std::make_shared<LayeredTexture>(*under);
    result->blended = nullptr;
    result->layers.insert(result->layers.end(), over->layers.begin(), over->layers.end());
    return result;
}

TexturePointer TextureReader::uv_mapped(const TexturePointer& texture) {
    if (!texture || !is_positional(*texture)) return texture;
    auto result = std::make_shared<LayeredTexture>(*texture);
    for (TextureLayer& layer : result->layers) set_uv_mapping(layer);
    return result;
}

TexturePointer TextureReader::moved(const TexturePointer& texture, const Affine3d& old_from_new) {
    if (!is_positional(*texture) || old_from_new == Affine3d{}) return texture;
    auto result = std::make_shared<LayeredTexture>(*texture);
    move_texture(*result, old_from_new);
    return result;
}

MaterialParts TextureReader::read_material(const std::shared_ptr<const Block>& block) {
    ItemReader items(context_, *block);
    MaterialParts parts;
    while (!items.at_end()) {
        if (const auto base = items.take_block(Keyword::material)) {
            parts = read_material(base);
        } else if (const auto texture = items.take_block(Keyword::texture)) {
            parts.texture = layered(parts.texture, read(texture));
        } else if (const auto inner = items.take_block(Keyword::interior_texture)) {
            parts.interior_texture = layered(parts.interior_texture, read(inner));
        } else if (const auto interior = items.take_block(Keyword::interior)) {
            parts.interior = read_interior(*interior);
        } else if (const auto pigment = items.take_block(Keyword::pigment)) {
            parts.texture = changed(parts.texture, *pigment, *block);
        } else if (const auto finish = items.take_block(Keyword::finish)) {
            parts.texture = changed(parts.texture, *finish, *block);
        } else if (const auto normal = items.take_block(Keyword::normal)) {
            parts.texture = changed(parts.texture, *normal, *block);
        } else {
            Affine3d moved_from_old;
            if (!read_transform(items, moved_from_old)) {
                static constexpr std::array kValid{Keyword::texture,   Keyword::interior_texture, Keyword::interior,
                                                   Keyword::translate, Keyword::rotate,           Keyword::scale,
                                                   Keyword::matrix,    Keyword::transform};
                items.unexpected(kValid);
            }
            const Affine3d old_from_moved = inverse(moved_from_old);
            if (parts.texture) parts.texture = moved(parts.texture, old_from_moved);
            if (parts.interior_texture) parts.interior_texture = moved(parts.interior_texture, old_from_moved);
            if (parts.interior && parts.interior->media) {
                auto interior = std::make_shared<scene::Interior>(*parts.interior);
                move_interior(*interior, old_from_moved);
                parts.interior = std::move(interior);
            }
        }
    }
    return parts;
}

InteriorPointer TextureReader::read_interior(const Block& block) {
    const scene::Interior interior = pov::read_interior(context_, block);
    std::string key;
    if (interior.media) return std::make_shared<const scene::Interior>(interior);
    append_bytes(key, interior.ior, interior.dispersion, interior.caustics, interior.fade_distance, interior.fade_power,
                 interior.fade_color);
    InteriorPointer& known = interiors_[std::move(key)];
    if (!known) known = std::make_shared<const scene::Interior>(interior);
    return known;
}

InteriorPointer TextureReader::interior_of(const TexturePointer& texture) const {
    const auto known = old_interiors_.find(texture);
    return known == old_interiors_.end() ? nullptr : known->second;
}

}  // namespace sundog::pov
