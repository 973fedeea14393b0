// SPDX-License-Identifier: Apache-2.0
// Blobs (POV-Ray reference, section 3.4.5.1.1 "Blob").
#include <algorithm>
#include <array>

#include "import/pov/build_shape.h"
#include "import/pov/build_transform.h"

namespace sundog::pov {
namespace {

/// A blob's component: `sphere { … }` or `cylinder { … }`.
class ComponentReader {
public:
    ComponentReader(ObjectReader& objects, const Block& block)
        : textures_(objects.textures()), block_(block), items_(objects.context(), block) {}

    scene::BlobComponent read() {
        scene::BlobComponent component;
        component.is_cylinder = block_.keyword == Keyword::cylinder;
        component.center = items_.vector("the center of a component");
        component.end = component.is_cylinder ? items_.vector("the other end of a component") : component.center;
        component.radius = items_.number("the radius of a component");
        items_.take(Keyword::strength);
        component.strength = items_.number("the strength of a component");
        while (!items_.at_end())
            if (!read_transform(items_, placed_) && !read_texture()) items_.unexpected(kValid);
        component.blob_from_component = placed_;
        settle();
        return component;
    }

    /// Null: none of its own.
    [[nodiscard]] const TexturePointer& texture() const { return texture_; }

private:
    static constexpr std::array kValid{Keyword::texture, Keyword::pigment,   Keyword::normal, Keyword::finish,
                                       Keyword::rotate,  Keyword::translate, Keyword::scale,  Keyword::matrix};

    bool read_texture() {
        if (const auto texture = items_.take_block(Keyword::texture)) {
            settle();
            texture_ = textures_.layered(texture_, textures_.read(texture));
            return true;
        }
        for (const Keyword keyword : {Keyword::pigment, Keyword::normal, Keyword::finish}) {
            if (const auto part = items_.take_block(keyword)) {
                settle();
                texture_ = textures_.changed(texture_, *part, block_);
                return true;
            }
        }
        return false;
    }

    /// Moves the texture by what has moved the component since it was read.
    void settle() {
        if (texture_) texture_ = textures_.moved(texture_, inverse(placed_ * texture_from_start_));
        texture_from_start_ = inverse(placed_);
    }

    TextureReader& textures_;
    const Block& block_;
    ItemReader items_;
    Affine3d placed_, texture_from_start_;
    TexturePointer texture_;
};

}  // namespace

NodeShape read_blob(ObjectReader& objects, ItemReader& items) {
    NodeBlob out;
    scene::Blob& blob = out.blob;
    const auto add = [&](const Block& block) {
        ComponentReader reader(objects, block);
        blob.components.push_back(reader.read());
        out.textures.push_back(reader.texture());
    };
    while (!items.at_end()) {
        if (const auto sphere = items.take_block(Keyword::sphere)) {
            add(*sphere);
        } else if (const auto cylinder = items.take_block(Keyword::cylinder)) {
            add(*cylinder);
        } else if (items.take(Keyword::threshold)) {
            blob.threshold = items.number("a threshold");
        } else if (items.take(Keyword::component)) {
            scene::BlobComponent component;
            component.strength = items.number("the strength of a component");
            component.radius = items.number("the radius of a component");
            component.center = items.vector("the center of a component");
            component.end = component.center;
            blob.components.push_back(component);
            out.textures.emplace_back();
        } else if (!items.take(Keyword::sturm) && !items.take(Keyword::hierarchy)) {
            break;
        } else {
            items.flag();
        }
    }
    if (blob.components.empty()) {
        items.warn("a blob without components; left out");
        return {};
    }
    const auto is_own = [](const TexturePointer& texture) { return texture != nullptr; };
    if (std::none_of(out.textures.begin(), out.textures.end(), is_own)) out.textures.clear();
    return out;
}

}  // namespace sundog::pov
