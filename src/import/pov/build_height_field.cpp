// SPDX-License-Identifier: Apache-2.0
// Height fields (POV-Ray reference, section 3.4.5.1.5 "Height Field").
#include <algorithm>
#include <cmath>

#include "fields/function_evaluator.h"
#include "import/pov/build_function.h"
#include "import/pov/build_image.h"
#include "import/pov/build_shape.h"
#include "output/image.h"
#include "output/indices.h"
#include "scene/files.h"

namespace sundog::pov {
namespace {

/// The number that a file of sRGB pixels stores, 0 to 1, from its linear value.
double stored(float linear) {
    return linear <= 0.0031308F ? linear * 12.92 : 1.055 * std::pow(static_cast<double>(linear), 1 / 2.4) - 0.055;
}

/// Heights of an image: its grey, or 256 * red + green where it has colours.
scene::HeightField heights_of(const output::Image& image) {
    const bool gray =
        std::all_of(image.pixels.begin(), image.pixels.end(), [](Vec3 p) { return p.x == p.y && p.y == p.z; });
    auto heights = std::make_shared<std::vector<float>>();
    heights->reserve(image.pixels.size());
    for (const Vec3 p : image.pixels) {
        const double height = gray ? stored(p.x) : (stored(p.x) * 256 + stored(p.y)) / 257;
        heights->push_back(static_cast<float>(height));
    }
    scene::HeightField field;
    field.width = static_cast<std::uint32_t>(image.width);
    field.height = static_cast<std::uint32_t>(image.height);
    field.heights = std::move(heights);
    return field;
}

/// Heights of a picture with a palette: the numbers of its colours. A Fractint potential has their high bytes in the
/// left half and the low ones in the right.
scene::HeightField heights_of(const output::IndexedImage& image, bool potential) {
    scene::HeightField field;
    field.width = potential ? image.width / 2 : image.width;
    field.height = image.height;
    auto heights = std::make_shared<std::vector<float>>();
    heights->reserve(std::size_t{field.width} * field.height);
    for (std::size_t row = 0; row < field.height; ++row) {
        const std::uint8_t* const pixels = image.indices.data() + row * image.width;
        for (std::size_t column = 0; column < field.width; ++column)
            heights->push_back(potential
                                   ? static_cast<float>(pixels[column] * 256 + pixels[column + field.width]) / 65535
                                   : static_cast<float>(pixels[column]) / 255);
    }
    field.heights = std::move(heights);
    return field;
}

/// `function Width, Height { … }`: its values at x and y from 0 in the first column and row to 1 in the last, as with
/// images of functions.
NodeShape heights_of_function(ItemReader& items) {
    BuildContext& context = items.context();
    constexpr int kMostPixels = 16384;
    const int width = items.integer("a width in pixels", 2, kMostPixels);
    const int height = items.integer("a height in pixels", 2, kMostPixels);
    const std::shared_ptr<const FunctionExpression> function = items.take_function();
    if (!function) items.unexpected("a function");
    auto heights = std::make_shared<std::vector<float>>();
    const auto flat = read_functions(context, std::array{function}, 3);
    const fields::FunctionEvaluator evaluator(flat, context.scene.textures);
    std::uint64_t budget = context.options.limits.steps;
    std::vector<Vec3d> row_places(static_cast<std::size_t>(width));
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column)
            row_places[static_cast<std::size_t>(column)] = {column / (width - 1.0), row / (height - 1.0), 0};
        fields::PointsEvaluation evaluation(evaluator, row_places);
        for (int column = 0; column < width; ++column) {
            const std::optional<double> value = evaluation.next(budget);
            if (!value) items.fail("the limit of steps was hit in a function");
            // What doesn't fit into a pixel wraps around.
            heights->push_back(static_cast<float>(*value >= 0 && *value <= 1 ? *value : *value - std::floor(*value)));
        }
    }
    return scene::HeightField{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), std::move(heights),
                              false, 0};
}

}  // namespace

NodeShape read_height_field(ObjectReader& objects, ItemReader& items) {
    BuildContext& context = objects.context();
    if (items.take(Keyword::function)) return heights_of_function(items);
    bool potential = false;
    if (!items.take(Keyword::iff)) potential = items.take(Keyword::pot);
    const ImageName name = read_image_name(items);
    const std::filesystem::path file = context.find_file(name.name, name.where);
    if (file.empty()) {
        context.warn(name.where, "missing image file '" + name.name + "', its height_field is left out",
                     context.why_not_found(name.name, name.where));
        return {};
    }
    try {
        scene::add_file(context.scene, file);
        if (const auto indexed = output::read_indices(file);
            indexed && indexed->width >= (potential ? 4U : 2U) && indexed->height >= 2)
            return heights_of(*indexed, potential);
        const output::Image image = output::read_image(file);
        if (image.width >= 2 && image.height >= 2) return heights_of(image);
        context.warn(name.where, "image file '" + name.name + "' has less than 2 by 2 pixels; height_field left out");
    } catch (const InputError& error) {
        context.warn(name.where,
                     "image file '" + name.name + "': " + error.diagnostic().message + "; height_field left out");
    }
    return {};
}

}  // namespace sundog::pov
