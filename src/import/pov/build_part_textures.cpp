// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_part_textures.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "solids/shape.h"

namespace sundog::pov {
namespace {

using Field = std::function<double(Vec3d)>;

/// The part that some fields have of the sum of all, which count by their size, as povray's pictures show; one with
/// `has_rest` has all where that is none.
class ShareOfFields final : public scene::ShareOfPoint {
public:
    ShareOfFields(std::shared_ptr<const std::vector<Field>> fields, std::vector<std::size_t> numbers, bool has_rest)
        : fields_(std::move(fields)), numbers_(std::move(numbers)), has_rest_(has_rest) {}

    [[nodiscard]] double at(Vec3d point) const override {
        double all = 0;
        double share = 0;
        auto next = numbers_.begin();
        for (std::size_t i = 0; i < fields_->size(); ++i) {
            const double field = std::abs((*fields_)[i](point));
            all += field;
            if (next == numbers_.end() || *next != i) continue;
            share += field;
            ++next;
        }
        if (!(all > 0)) return has_rest_ ? 1 : 0;
        return share / all;
    }

private:
    std::shared_ptr<const std::vector<Field>> fields_;
    std::vector<std::size_t> numbers_;  // Ascending.
    bool has_rest_;
};

}  // namespace

std::optional<scene::LayeredTexture> blob_texture(const NodeBlob& blob, const TexturePointer& own,
                                                  const SourceLocation& where) {
    std::vector<Field> fields;
    std::vector<TexturePointer> textures;
    std::vector<std::vector<std::size_t>> components;  // Of each texture.
    for (std::size_t i = 0; i < blob.textures.size(); ++i) {
        fields.push_back(solids::component_field(blob.blob.components[i]));
        const TexturePointer& texture = blob.textures[i] ? blob.textures[i] : own;
        const auto known = std::find(textures.begin(), textures.end(), texture);
        if (known == textures.end()) {
            textures.push_back(texture);
            components.push_back({i});
        } else {
            components[static_cast<std::size_t>(known - textures.begin())].push_back(i);
        }
    }
    const auto all = std::make_shared<const std::vector<Field>>(std::move(fields));
    std::vector<SharedTexture> shared;
    for (std::size_t i = 0; i < textures.size(); ++i)
        shared.push_back({std::make_shared<const ShareOfFields>(all, std::move(components[i]), i == 0), textures[i]});
    return textures_by_shares(shared, where);
}

std::vector<TexturedPart> textured_parts(const NodeGroup& group) {
    std::vector<TexturedPart> parts;
    using Nodes = std::vector<TexturedPart::PlacedNode>;
    const std::function<void(const NodeGroup&, const Affine3d&, const PlacedTexture&, const Nodes&)> collect =
        [&](const NodeGroup& inner, const Affine3d& group_from_inner, const PlacedTexture& around,
            const Nodes& within) {
            for (const NodePointer& child : inner.children) {
                if (child->inverted) continue;
                PlacedTexture texture = around;
                if (child->texture.texture)
                    texture = {child->texture.texture, group_from_inner * child->texture.parent_from_texture};
                Nodes nodes = within;
                const auto* grand = std::get_if<NodeGroup>(&child->shape);
                // Who is inside of a union's part is inside of the union.
                const bool adds_nothing =
                    grand != nullptr && grand->kind == scene::SolidGroup::Kind::combined && child->clipped_by.empty();
                if (!adds_nothing) nodes.push_back({child, group_from_inner});
                if (grand != nullptr) collect(*grand, group_from_inner * child->parent_from_shape, texture, nodes);
                else if (texture.texture || &inner != &group)
                    parts.push_back({texture.texture, texture.parent_from_texture, std::move(nodes)});
            }
        };
    collect(group, {}, {}, {});
    return parts;
}

std::optional<scene::LayeredTexture> cutaway_texture(
    const std::vector<TexturedPart>& parts, const std::vector<std::shared_ptr<const scene::InsideTest>>& insides,
    const SourceLocation& where) {
    std::vector<Field> fields;
    for (const auto& test : insides)
        fields.emplace_back([test](Vec3d p) { return test && test->inside(p) ? 1.0 : 0.0; });
    const auto all = std::make_shared<const std::vector<Field>>(std::move(fields));
    std::vector<SharedTexture> shared;
    std::vector<std::size_t> bare;
    const bool some_bare = std::any_of(parts.begin(), parts.end(), [](const auto& part) { return !part.texture; });
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (!parts[i].texture) {
            bare.push_back(i);
            continue;
        }
        auto placed = std::make_shared<scene::LayeredTexture>(*parts[i].texture);
        move_texture(*placed, inverse(parts[i].group_from_texture));
        shared.push_back(
            {std::make_shared<const ShareOfFields>(all, std::vector<std::size_t>{i}, shared.empty() && !some_bare),
             std::move(placed)});
    }
    if (!bare.empty()) {
        auto black = std::make_shared<scene::LayeredTexture>();
        scene::Finish dark;
        dark.ambient = {0, 0, 0}, dark.diffuse = 0;
        black->layers.push_back({std::make_shared<const scene::Pigment>(), dark});
        shared.push_back({std::make_shared<const ShareOfFields>(all, std::move(bare), true), std::move(black)});
    }
    return textures_by_shares(shared, where);
}

}  // namespace sundog::pov
