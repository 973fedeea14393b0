// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_material_map.h"

#include <array>
#include <cstdint>

#include "import/pov/build_image.h"

namespace sundog::pov {
namespace {

/// The picture's texture with palette numbers for red, where it has a palette.
scene::Index numbered(BuildContext& context, scene::Index index) {
    const std::vector<std::uint8_t> numbers = palette_numbers(context.scene.textures[index]);
    if (numbers.empty()) return index;
    scene::Texture texture = context.scene.textures[index];
    texture.name += " (numbers)";
    texture.srgb = false;
    for (std::size_t i = 0; i < numbers.size(); ++i) texture.rgba8[i] = numbers[i] | 0xff000000U;
    context.scene.textures.push_back(std::move(texture));
    return static_cast<scene::Index>(context.scene.textures.size() - 1);
}

}  // namespace

MaterialMap read_material_map(BuildContext& context, const Block& block) {
    MaterialMap result;
    Block image = block;
    image.items.clear();
    ItemReader items(context, block);
    while (!items.at_end()) {
        if (auto texture = items.take_block(Keyword::texture)) {
            result.textures.push_back(std::move(texture));
        } else {
            image.items.push_back(*items.peek());
            items.skip();
        }
    }
    if (result.textures.empty()) context.fail(block.where, "a material_map without textures", "expected texture { }");
    auto pigment = std::make_shared<scene::Pigment>();
    pigment->where = context.location(block.where);
    pigment->kind = scene::Pigment::Kind::image;
    pigment->image = read_image_map(context, image, ImageUse::data);
    pigment->image.texture = numbered(context, pigment->image.texture);
    result.pattern.kind = scene::Pattern::Kind::material;
    result.pattern.choices = static_cast<int>(result.textures.size());
    result.pattern.pigment = std::move(pigment);
    return result;
}

}  // namespace sundog::pov
