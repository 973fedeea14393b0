// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_image.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "fields/function_evaluator.h"
#include "fields/pigment_evaluator.h"
#include "import/pov/build_function.h"
#include "output/image.h"
#include "output/indices.h"
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

/// Between a file's name and what was changed in it.
constexpr std::string_view kChange = " with palette entry ";

/// Lets `amount` of the light through where the image has an entry of its palette.
void clear_palette_entry(BuildContext& context, scene::ImageMap& image, int entry, double amount) {
    scene::Texture texture = context.scene.textures[image.texture];
    const std::vector<std::uint8_t> numbers = palette_numbers(texture);
    const auto alpha = static_cast<std::uint32_t>(std::lround((1 - std::clamp(amount, 0.0, 1.0)) * 255));
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (numbers[i] == entry) texture.rgba8[i] = (texture.rgba8[i] & 0xffffffU) | alpha << 24U;
    texture.name += std::string(kChange) + std::to_string(entry) + " " + std::to_string(alpha);
    if (const auto known = find_texture(context.scene, texture.name, texture.srgb)) {
        image.texture = *known;
        return;
    }
    context.scene.textures.push_back(std::move(texture));
    image.texture = static_cast<scene::Index>(context.scene.textures.size() - 1);
}

/// filter and transmit: `all Amount`, `Index, Amount` for one entry of a palette, or (3.7) one amount for all.
void read_transparency(ItemReader& items, scene::ImageMap& image, bool transmits, PaletteFilters* filters) {
    float& all = transmits ? image.transmit_all : image.filter_all;
    if (items.take(Keyword::all)) {
        all = static_cast<float>(items.number("an amount"));
        return;
    }
    const double first = items.number("'all' or an index of the palette");
    const std::optional<double> amount = items.maybe_number();
    if (!amount) {
        all = static_cast<float>(first);
    } else if (transmits) {
        clear_palette_entry(items.context(), image, static_cast<int>(std::clamp(first, 0.0, 65535.0)), *amount);
    } else if (filters != nullptr && first >= 0 && first <= 255) {
        (*filters)[static_cast<std::uint8_t>(first)] = static_cast<float>(*amount);
    } else {
        items.context().warn_once("palette transparency", items.taken_where(),
                                  "a filter of single palette entries isn't drawn yet", "those colors stay opaque");
    }
}

/// 0..1 as a byte; what lies beyond comes round again, as in povray's pictures.
std::uint32_t byte_of(double value) {
    if (!std::isfinite(value)) return 0;
    const double kept = value >= 0 && value <= 1 ? value : value - std::floor(value);
    return static_cast<std::uint32_t>(std::lround(kept * 255));
}

/// `function Width, Height { … }`: its values over the unit square, the first row at y = 0.
scene::Index texture_of_function(BuildContext& context, ItemReader& items) {
    constexpr int kMostPixels = 8192;
    const int width = items.integer("a width in pixels", 1, kMostPixels);
    const int height = items.integer("a height in pixels", 1, kMostPixels);
    const std::shared_ptr<const FunctionExpression> function = items.take_function();
    if (!function) items.unexpected("a function");
    scene::Texture texture;
    texture.name = "function";
    texture.where = context.location(function->where);
    texture.width = static_cast<std::uint32_t>(width), texture.height = static_cast<std::uint32_t>(height);
    texture.srgb = false;
    texture.rgba8.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    // Row by row: many points together are quick, all of them are much memory.
    std::vector<Vec3d> places(static_cast<std::size_t>(width));
    const auto for_rows = [&](auto add_row) {
        for (int row = 0; row < height; ++row) {
            for (int column = 0; column < width; ++column)
                places[static_cast<std::size_t>(column)] = {static_cast<double>(column) / std::max(width - 1, 1),
                                                            static_cast<double>(row) / std::max(height - 1, 1), 0};
            add_row();
        }
    };
    if (function->kind == FunctionKind::pigment) {
        const std::array pigments{BlockPigments(context).pigment_of(function->block)};
        const fields::PigmentEvaluator evaluator(pigments, context.scene.textures);
        for_rows([&] {
            for (const std::array<double, 5>& c : evaluator.colors(0, places)) {
                const std::uint32_t opacity = byte_of(1 - std::clamp(c[3] + c[4], 0.0, 1.0));
                texture.rgba8.push_back(byte_of(c[0]) | byte_of(c[1]) << 8U | byte_of(c[2]) << 16U | opacity << 24U);
            }
        });
    } else {
        const auto flat = read_functions(context, std::array{function}, 3);
        const fields::FunctionEvaluator evaluator(flat, context.scene.textures);
        std::uint64_t budget = context.options.limits.steps;
        for_rows([&] {
            fields::PointsEvaluation evaluation(evaluator, places);
            for (std::size_t i = 0; i < places.size(); ++i) {
                const std::optional<double> value = evaluation.next(budget);
                if (!value) items.fail("the limit of steps was hit in a function");
                texture.rgba8.push_back(byte_of(*value) * 0x010101U | 0xff000000U);
            }
        });
    }
    context.scene.textures.push_back(std::move(texture));
    return static_cast<scene::Index>(context.scene.textures.size() - 1);
}

/// True if a file says how its numbers are encoded; false for one that can't be read, too.
bool tells_encoding(const std::filesystem::path& file) {
    try {
        return !file.empty() && output::tells_encoding(file);
    } catch (const InputError&) {
        return false;
    }
}

/// Whether an image's numbers are sRGB-encoded. As povray's pictures show: before version 3.7, files that don't say so
/// hold numbers as a scene does; from then on, all but PNM and TIFF files are sRGB-encoded.
bool is_srgb(const BuildContext& context, const Block& block, const ImageName& image) {
    if (context.stored_colors(block.version)) return false;
    if (image.gamma) return *image.gamma > 1.5;
    const std::filesystem::path file = context.find_file(image.name, image.where);
    if (block.version < 370) return tells_encoding(file);
    std::string kind = file.extension().string();
    for (char& c : kind) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return kind != ".ppm" && kind != ".pgm" && kind != ".tif" && kind != ".tiff";
}

}  // namespace

std::vector<std::uint8_t> palette_numbers(const scene::Texture& texture) {
    const std::filesystem::path file = texture.name.substr(0, texture.name.find(kChange));
    try {
        std::error_code none;
        if (!std::filesystem::is_regular_file(file, none)) return {};
        auto indexed = output::read_indices(file);
        if (indexed && indexed->indices.size() == texture.rgba8.size()) return std::move(indexed->indices);
    } catch (const InputError&) {
        // The file has changed since its pixels were read.
    }
    return {};
}

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

scene::Index numbered_texture(BuildContext& context, scene::Index index) {
    const std::vector<std::uint8_t> numbers = palette_numbers(context.scene.textures[index]);
    if (numbers.empty()) return index;
    scene::Texture texture = context.scene.textures[index];
    texture.name += " (numbers)";
    texture.srgb = false;
    for (std::size_t i = 0; i < numbers.size(); ++i) texture.rgba8[i] = numbers[i] | 0xff000000U;
    context.scene.textures.push_back(std::move(texture));
    return static_cast<scene::Index>(context.scene.textures.size() - 1);
}

bool read_image_modifier(ItemReader& items, scene::ImageMap& image, PaletteFilters* filters) {
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
            read_transparency(items, image, false, filters);
            return true;
        case Keyword::transmit:
            items.skip();
            read_transparency(items, image, true, filters);
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

scene::ImageMap read_image_map(BuildContext& context, const Block& block, ImageUse use, PaletteFilters* filters) {
    ItemReader items(context, block);
    scene::ImageMap image;
    if (const auto base = items.take_block(block.keyword)) {
        image = read_image_map(context, *base, use, filters);
    } else if (items.take(Keyword::function)) {
        image.texture = texture_of_function(context, items);
    } else {
        const ImageName name = read_image_name(items);
        image.texture = texture_of(context, name, use == ImageUse::color && is_srgb(context, block, name));
    }
    while (!items.at_end()) {
        static constexpr std::array kValid{Keyword::once,     Keyword::map_type,  Keyword::interpolate, Keyword::filter,
                                           Keyword::transmit, Keyword::use_index, Keyword::use_color,   Keyword::gamma};
        if (!read_image_modifier(items, image, filters)) items.unexpected(kValid);
    }
    return image;
}

}  // namespace sundog::pov
