// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_object.h"

#include <algorithm>
#include <array>
#include <utility>

#include "import/pov/build_photons.h"
#include "import/pov/build_radiosity.h"
#include "import/pov/build_shape.h"
#include "import/pov/build_transform.h"

namespace sundog::pov {
namespace {

constexpr std::array kObjects{Keyword::bicubic_patch,
                              Keyword::blob,
                              Keyword::box,
                              Keyword::cone,
                              Keyword::cubic,
                              Keyword::cylinder,
                              Keyword::difference,
                              Keyword::disc,
                              Keyword::height_field,
                              Keyword::intersection,
                              Keyword::isosurface,
                              Keyword::julia_fractal,
                              Keyword::lathe,
                              Keyword::lemon,
                              Keyword::light_group,
                              Keyword::light_source,
                              Keyword::merge,
                              Keyword::mesh,
                              Keyword::mesh2,
                              Keyword::object,
                              Keyword::ovus,
                              Keyword::parametric,
                              Keyword::plane,
                              Keyword::poly,
                              Keyword::polygon,
                              Keyword::polynomial,
                              Keyword::prism,
                              Keyword::quadric,
                              Keyword::quartic,
                              Keyword::smooth_triangle,
                              Keyword::sor,
                              Keyword::sphere,
                              Keyword::sphere_sweep,
                              Keyword::superellipsoid,
                              Keyword::text,
                              Keyword::torus,
                              Keyword::triangle,
                              Keyword::union_,
                              Keyword::smooth_color_triangle};

/// Items that read_modifier() takes, for messages.
constexpr std::array kModifiers{Keyword::texture,
                                Keyword::pigment,
                                Keyword::normal,
                                Keyword::finish,
                                Keyword::interior,
                                Keyword::material,
                                Keyword::interior_texture,
                                Keyword::clipped_by,
                                Keyword::bounded_by,
                                Keyword::no_shadow,
                                Keyword::no_image,
                                Keyword::no_reflection,
                                Keyword::no_radiosity,
                                Keyword::inverse,
                                Keyword::hollow,
                                Keyword::sturm,
                                Keyword::hierarchy,
                                Keyword::photons,
                                Keyword::uv_mapping,
                                Keyword::double_illuminate,
                                Keyword::cutaway_textures,
                                Keyword::split_union,
                                Keyword::translate,
                                Keyword::rotate,
                                Keyword::scale,
                                Keyword::matrix,
                                Keyword::transform,
                                Keyword::open};

/// One object block while it is read.
class ObjectBlockReader {
public:
    ObjectBlockReader(ObjectReader& objects, const Block& block)
        : objects_(objects),
          context_(objects.context()),
          textures_(objects.textures()),
          block_(block),
          items_(context_, block) {}

    Node read() {
        node_.where = block_.where;
        node_.keyword = block_.keyword;
        read_start();
        node_.fallback = textures_.default_texture(block_);
        while (!items_.at_end())
            if (!read_transform(items_, placed_from_start_) && !read_surface() && !read_bounds() && !read_flag() &&
                !read_shape_item(items_, block_, node_.shape))
                items_.unexpected(kModifiers, "an object modifier");
        place();
        return std::move(node_);
    }

private:
    void read_start() {
        if (block_.keyword != Keyword::object) {
            node_.shape = read_shape(objects_, items_, block_);
            return;
        }
        const std::shared_ptr<const Block> base = items_.take_block();
        if (!base || !is_object(base->keyword)) items_.unexpected("an object");
        node_ = *objects_.read(base);
        node_.where = block_.where;
    }

    bool read_surface() {
        if (const auto texture = items_.take_block(Keyword::texture)) {
            settle_texture();
            set_texture(textures_.layered(node_.texture.texture, textures_.read(texture)));
        } else if (const auto inner = items_.take_block(Keyword::interior_texture)) {
            node_.interior_texture = {textures_.layered(node_.interior_texture.texture, textures_.read(inner)),
                                      inverse(placed_from_start_)};
        } else if (const auto pigment = items_.take_block(Keyword::pigment)) {
            change_texture(*pigment);
        } else if (const auto normal = items_.take_block(Keyword::normal)) {
            change_texture(*normal);
        } else if (const auto finish = items_.take_block(Keyword::finish)) {
            change_texture(*finish);
        } else if (const auto interior = items_.take_block(Keyword::interior)) {
            set_interior(textures_.read_interior(*interior));
        } else if (const auto material = items_.take_block(Keyword::material)) {
            take_material(textures_.read_material(material));
        } else {
            return false;
        }
        return true;
    }

    /// Brings the texture that the object has into the space as it is now, so that more can be laid over it.
    void settle_texture() {
        if (!node_.texture.texture) return;
        const Affine3d now_from_texture = placed_from_start_ * node_.texture.parent_from_texture;
        node_.texture.texture = textures_.moved(node_.texture.texture, inverse(now_from_texture));
    }

    void set_texture(TexturePointer texture) {
        if (InteriorPointer interior = textures_.interior_of(texture)) set_interior(std::move(interior));
        node_.texture = {std::move(texture), inverse(placed_from_start_)};
    }

    void set_interior(InteriorPointer interior) {
        node_.interior = std::move(interior);
        node_.parent_from_interior = inverse(placed_from_start_);
    }

    void change_texture(const Block& block) {
        settle_texture();
        set_texture(textures_.changed(node_.texture.texture, block, block_));
    }

    void take_material(MaterialParts parts) {
        if (parts.texture) {
            settle_texture();
            set_texture(textures_.layered(node_.texture.texture, parts.texture));
        }
        if (parts.interior_texture)
            node_.interior_texture = {std::move(parts.interior_texture), inverse(placed_from_start_)};
        if (parts.interior) set_interior(std::move(parts.interior));
    }

    bool read_bounds() {
        if (const auto bounds = items_.take_block(Keyword::bounded_by)) {
            ItemReader inside(context_, *bounds);
            if (inside.take(Keyword::clipped_by)) return true;
            node_.bounded_by.clear();
            for (NodePointer& node : read_children(objects_, inside))
                node_.bounded_by.push_back({std::move(node), inverse(placed_from_start_)});
            return true;
        }
        if (const auto clip = items_.take_block(Keyword::clipped_by)) {
            ItemReader inside(context_, *clip);
            if (inside.take(Keyword::bounded_by)) {
                node_.clipped_by.insert(node_.clipped_by.end(), node_.bounded_by.begin(), node_.bounded_by.end());
                return true;
            }
            for (NodePointer& node : read_children(objects_, inside))
                node_.clipped_by.push_back({std::move(node), inverse(placed_from_start_)});
            if (!inside.at_end()) inside.unexpected("an object to clip by");
            return true;
        }
        return false;
    }

    bool read_flag() {
        if (const auto photons = items_.take_block(Keyword::photons)) {
            node_.photons = read_object_photons(context_, *photons, *std::as_const(node_.photons));
            return true;
        }
        if (const auto radiosity = items_.take_block(Keyword::radiosity)) {
            read_importance(context_, *radiosity);
            return true;
        }
        const std::optional<Keyword> keyword = items_.peek_keyword();
        if (!keyword) return false;
        const auto take_flag = [&] {
            items_.skip();
            return items_.flag();
        };
        switch (*keyword) {
            case Keyword::global_lights:
                if (block_.keyword != Keyword::light_group) return false;
                node_.global_lights = take_flag();
                return true;
            case Keyword::no_shadow:
                node_.no_shadow = take_flag();
                return true;
            case Keyword::no_image:
                node_.no_image = take_flag();
                return true;
            case Keyword::no_reflection:
                node_.no_reflection = take_flag();
                return true;
            case Keyword::inverse:
                node_.inverted ^= take_flag();
                return true;
            case Keyword::hollow:
                node_.hollow = take_flag();
                return true;
            case Keyword::double_illuminate:
                node_.double_illuminate = take_flag();
                return true;
            case Keyword::cutaway_textures:
                node_.cutaway_textures = take_flag();
                return true;
            case Keyword::uv_mapping:
                uv_mapping_ = take_flag();
                return true;
            case Keyword::no_radiosity:
                node_.no_radiosity = take_flag();
                return true;
            case Keyword::split_union:
                node_.split_union = take_flag();
                return true;
            case Keyword::sturm:
            case Keyword::hierarchy:
                take_flag();
                return true;
            default:
                return false;
        }
    }

    /// Applies the block's transformations to all that the object consists of.
    void place() {
        const Affine3d& placed = placed_from_start_;
        if (uv_mapping_) node_.texture.texture = textures_.uv_mapped(node_.texture.texture);
        if (placed == Affine3d{}) return;
        node_.parent_from_shape = placed * node_.parent_from_shape;
        node_.parent_from_interior = placed * node_.parent_from_interior;
        node_.texture.parent_from_texture = placed * node_.texture.parent_from_texture;
        node_.interior_texture.parent_from_texture = placed * node_.interior_texture.parent_from_texture;
        for (std::vector<Node::Clip>* clips : {&node_.clipped_by, &node_.bounded_by})
            for (Node::Clip& clip : *clips) clip.parent_from_clip = placed * clip.parent_from_clip;
    }

    ObjectReader& objects_;
    BuildContext& context_;
    TextureReader& textures_;
    const Block& block_;
    ItemReader items_;
    Node node_;
    /// All transformations of the block so far. What was there at the start moves with all of them; what came in
    /// between is kept as it would have stood at the start.
    Affine3d placed_from_start_;
    bool uv_mapping_ = false;
};

}  // namespace

bool is_object(Keyword keyword) { return std::find(kObjects.begin(), kObjects.end(), keyword) != kObjects.end(); }

Node ObjectReader::read(const Block& block) { return ObjectBlockReader(*this, block).read(); }

NodePointer ObjectReader::read(const std::shared_ptr<const Block>& block) {
    // The parent's item and the caller hold an inline block; a declared one has more owners.
    if (block.use_count() <= 2) return std::make_shared<const Node>(read(*block));
    const auto known = read_before_.find(block);
    if (known != read_before_.end()) return known->second;
    auto node = std::make_shared<Node>(read(*block));
    node->declared = true;
    read_before_.emplace(block, node);
    return node;
}

std::vector<NodePointer> read_children(ObjectReader& objects, ItemReader& items) {
    std::vector<NodePointer> children;
    while (const Item* item = items.peek()) {
        const auto* found = std::get_if<std::shared_ptr<const Block>>(&item->content);
        if (!found || !is_object((*found)->keyword)) break;
        const std::shared_ptr<const Block> block = items.take_block();
        children.push_back(objects.read(block));
        if (std::holds_alternative<std::monostate>(children.back()->shape)) children.pop_back();
    }
    return children;
}

}  // namespace sundog::pov
