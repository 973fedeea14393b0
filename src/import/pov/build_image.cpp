// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_image.h"

#include <algorithm>
#include <array>

#include "output/image.h"
#include "scene/files.h"
#include "scene/stand_in.h"

namespace sundog::pov {
namespace {

constexpr std::array kFileKinds{Keyword::gif,  Keyword::tga,  Keyword::png, Keyword::pgm, Keyword::ppm,
                                Keyword::jpeg, Keyword::tiff, Keyword::sys, Keyword::exr, Keyword::hdr};

/// Textures with fewer pixels on file than in a scene's memory are read once, however often a scene names them.
std::optional<scene::Index> find_texture(const scene::Scene& scene, const std::string& name, bool srgb) {
    const auto it = std::find_if(scene.textures.begin(), scene.textures.end(),
                                 [&](const scene::Texture& t) { return t.srgb == srgb && t.name == name; });
    if (it == scene.textures.end()) return std::nullopt;
    return static_cast<scene::Index>(it - scene.textures.begin());
}

scene::Index texture_of(BuildContext& context, const ImageName& image, bool srgb) {
    const std::filesystem::path file = context.find_file(image.name, image.where);
    if (file.empty()) {
        context.warn(image.where, "missing image file '" + image.name + "', magenta squares stand in for it",
                     context.why_not_found(image.name, image.where));
        return scene::missing_texture(context.scene);
    }
    const std::string name = file.string();
    if (const auto known = find_texture(context.scene, name, srgb)) return *known;
    try {
        output::Rgba8 pixels = output::read_rgba8(file);
        scene::add_file(context.scene, file);
        context.scene.textures.push_back(
            {name, context.location(image.where), pixels.width, pixels.height, std::move(pixels.pixels), srgb});
    } catch (const InputError& error) {
        context.warn(image.where, "image file '" + image.name + "': " + error.diagnostic().message,
                     "magenta squares stand in for it");
        return scene::missing_texture(context.scene);
    }
    return static_cast<scene::Index>(context.scene.textures.size() - 1);
}

/// filter and transmit: `all Amount`, `Index, Amount` for one entry of a palette, or (3.7) one amount for all.
float read_amount_for_all(ItemReader& items, float before) {
    if (items.take(Keyword::all)) return static_cast<float>(items.number("an amount"));
    const double first = items.number("'all' or an index of the palette");
    if (items.maybe_number()) {
        items.context().warn_once("palette transparency", items.taken_where(),
                                  "transparency of single palette entries isn't drawn yet", "those colors stay opaque");
        return before;
    }
    return static_cast<float>(first);
}

bool is_srgb(const BuildContext& context, const Block& block, const ImageName& image) {
    if (context.stored_colors(block.version)) return false;
    return !image.gamma || *image.gamma > 1.5;
}

}  // namespace

ImageName read_image_name(ItemReader& items) {
    for (const Keyword kind : kFileKinds)
        if (items.take(kind)) break;
    ImageName image;
    image.where = items.where();
    image.name = items.text("the name of an image file in quotes");
    while (!items.at_end()) {
        if (items.take(Keyword::gamma)) {
            image.gamma = items.take(Keyword::srgb) ? 2.2 : items.number("a gamma");
        } else if (items.take(Keyword::premultiplied)) {
            items.flag();
        } else {
            break;
        }
    }
    return image;
}

bool read_image_modifier(ItemReader& items, scene::ImageMap& image) {
    const std::optional<Keyword> keyword = items.peek_keyword();
    if (!keyword) return false;
    switch (*keyword) {
        case Keyword::once:
            items.skip();
            image.once = items.flag();
            return true;
        case Keyword::map_type:
            items.skip();
            image.map_type = items.integer("a map_type", 0, 7);
            return true;
        case Keyword::interpolate:
            items.skip();
            image.smooth = items.integer("a kind of interpolation", 0, 4) >= 2;
            return true;
        case Keyword::filter:
            items.skip();
            image.filter_all = read_amount_for_all(items, image.filter_all);
            return true;
        case Keyword::transmit:
            items.skip();
            image.transmit_all = read_amount_for_all(items, image.transmit_all);
            return true;
        case Keyword::use_index:
        case Keyword::use_color:
        case Keyword::use_alpha:
            items.skip();
            return true;
        default:
            return false;
    }
}

scene::ImageMap read_image_map(BuildContext& context, const Block& block, ImageUse use) {
    ItemReader items(context, block);
    scene::ImageMap image;
    if (const auto base = items.take_block(block.keyword)) {
        image = read_image_map(context, *base, use);
    } else if (items.value_follows() || items.take_function()) {
        while (items.value_follows() || items.take_function())
            if (items.value_follows()) items.skip();
        context.warn_once("function image", block.where, "images made of functions aren't drawn yet",
                          "magenta squares stand in for them");
        image.texture = scene::missing_texture(context.scene);
    } else {
        const ImageName name = read_image_name(items);
        image.texture = texture_of(context, name, use == ImageUse::color && is_srgb(context, block, name));
    }
    while (!items.at_end()) {
        static constexpr std::array kValid{Keyword::once,     Keyword::map_type,  Keyword::interpolate, Keyword::filter,
                                           Keyword::transmit, Keyword::use_index, Keyword::use_color,   Keyword::gamma};
        if (!read_image_modifier(items, image)) items.unexpected(kValid);
    }
    return image;
}

}  // namespace sundog::pov
