// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_material_map.h"

#include <array>
#include <cstdint>

#include "import/pov/build_image.h"

namespace sundog::pov {
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
    pigment->image.texture = numbered_texture(context, pigment->image.texture);
    result.pattern.kind = scene::Pattern::Kind::material;
    result.pattern.choices = static_cast<int>(result.textures.size());
    result.pattern.pigment = std::move(pigment);
    return result;
}

}  // namespace sundog::pov
