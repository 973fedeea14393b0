// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_pattern.h"

#include <algorithm>
#include <array>

#include "import/pov/build_density.h"
#include "import/pov/build_function.h"
#include "import/pov/build_image.h"
#include "import/pov/build_pigment.h"
#include "import/pov/build_transform.h"
#include "import/pov/build_warp.h"
#include "import/pov/function_lowering.h"

namespace sundog::pov {
namespace {

using Kind = scene::Pattern::Kind;
using Wave = scene::Pattern::Wave;

struct NamedKind {
    Keyword keyword;
    Kind kind;
};
/// Patterns whose keyword is all there is to read, or whose parameters are read by read_parameters().
constexpr std::array kKinds{
    NamedKind{Keyword::agate, Kind::agate},
    NamedKind{Keyword::aoi, Kind::aoi},
    NamedKind{Keyword::average, Kind::average},
    NamedKind{Keyword::boxed, Kind::boxed},
    NamedKind{Keyword::bozo, Kind::bozo},
    NamedKind{Keyword::brick, Kind::brick},
    NamedKind{Keyword::bumps, Kind::bumps},
    NamedKind{Keyword::cells, Kind::cells},
    NamedKind{Keyword::checker, Kind::checker},
    NamedKind{Keyword::crackle, Kind::crackle},
    NamedKind{Keyword::cubic, Kind::cubic},
    NamedKind{Keyword::cylindrical, Kind::cylindrical},
    NamedKind{Keyword::density_file, Kind::density_file},
    NamedKind{Keyword::dents, Kind::dents},
    NamedKind{Keyword::facets, Kind::facets},
    NamedKind{Keyword::function, Kind::function},
    NamedKind{Keyword::gradient, Kind::gradient},
    NamedKind{Keyword::granite, Kind::granite},
    NamedKind{Keyword::hexagon, Kind::hexagon},
    NamedKind{Keyword::julia, Kind::fractal},
    NamedKind{Keyword::leopard, Kind::leopard},
    NamedKind{Keyword::magnet, Kind::fractal},
    NamedKind{Keyword::mandel, Kind::fractal},
    NamedKind{Keyword::marble, Kind::marble},
    NamedKind{Keyword::onion, Kind::onion},
    NamedKind{Keyword::pavement, Kind::pavement},
    NamedKind{Keyword::planar, Kind::planar},
    NamedKind{Keyword::quilted, Kind::quilted},
    NamedKind{Keyword::radial, Kind::radial},
    NamedKind{Keyword::ripples, Kind::ripples},
    NamedKind{Keyword::slope, Kind::slope},
    NamedKind{Keyword::spherical, Kind::spherical},
    NamedKind{Keyword::spiral1, Kind::spiral1},
    NamedKind{Keyword::spiral2, Kind::spiral2},
    NamedKind{Keyword::spotted, Kind::spotted},
    NamedKind{Keyword::square, Kind::square},
    NamedKind{Keyword::tiling, Kind::tiling},
    NamedKind{Keyword::triangular, Kind::triangular},
    NamedKind{Keyword::waves, Kind::waves},
    NamedKind{Keyword::wood, Kind::wood},
    NamedKind{Keyword::wrinkles, Kind::wrinkles},
};

/// slope <direction>, low, high [altitude <direction>, low, high], or with point_at; within a block or not.
void read_slope(ItemReader& items, scene::SlopeForm& slope) {
    slope = {};
    slope.toward_point = items.take(Keyword::point_at);
    slope.direction = items.vector("the direction of a slope");
    const auto range = [&](double& low, double& high) {
        if (const auto first = items.maybe_number()) {
            low = *first;
            high = items.number("the end of a range");
        }
    };
    range(slope.low, slope.high);
    if (items.take(Keyword::altitude)) {
        slope.altitude = items.vector("the direction of an altitude");
        range(slope.low_altitude, slope.high_altitude);
    }
}

std::array<double, 2> complex_number(ItemReader& items) { return items.vector2("a complex number"); }

void read_fractal(ItemReader& items, Keyword keyword, scene::FractalForm& fractal) {
    using Formula = scene::FractalForm::Formula;
    fractal = {};
    Keyword kind = keyword;
    if (keyword == Keyword::magnet) {
        fractal.formula =
            items.integer("the type of a magnet, 1 or 2", 1, 2) == 1 ? Formula::magnet1 : Formula::magnet2;
        if (items.take(Keyword::julia)) kind = Keyword::julia;
        else if (!items.take(Keyword::mandel)) items.unexpected("mandel or julia");
    }
    fractal.julia = kind == Keyword::julia;
    if (fractal.julia) fractal.c = complex_number(items);
    fractal.iterations = items.integer("a number of iterations", 1, 1'000'000);
}

void read_parameters(ItemReader& items, Keyword keyword, scene::Pattern& pattern) {
    switch (keyword) {
        case Keyword::gradient:
            pattern.axis = items.vector("the vector along which the gradient runs");
            if (length(pattern.axis) == 0) {
                items.warn("a gradient along no direction; x is taken");
                pattern.axis = {1, 0, 0};
            }
            return;
        case Keyword::spiral1:
        case Keyword::spiral2:
            pattern.arms = items.integer("the number of arms", -1000000, 1000000);
            return;
        case Keyword::julia:
        case Keyword::mandel:
        case Keyword::magnet:
            read_fractal(items, keyword, pattern.fractal);
            return;
        case Keyword::tiling:
            pattern.tiling = items.integer("the number of a tiling", 1, 27);
            if (pattern.tiling > 24)
                items.context().warn_once("tiling", items.taken_where(), "tilings without a period aren't drawn yet",
                                          "their surfaces get one colour of the map");
            return;
        case Keyword::pavement:
            pattern.pavement = {};
            pattern.pavement.sides = 3;
            return;
        case Keyword::density_file:
            items.take(Keyword::df3);
            pattern.density = read_density_file(items);
            return;
        case Keyword::slope:
            read_slope(items, pattern.slope);
            return;
        default:
            return;
    }
}

void set_kind(ItemReader& items, PatternParts& parts, Kind kind) {
    parts.pattern.kind = kind;
    parts.given = true;
    if (parts.pattern.noise_generator == 0) parts.pattern.noise_generator = items.context().noise_generator;
}

/// A pattern that is a block: image_pattern { }, pigment_pattern { }, object { }, slope { }, aoi { }.
bool read_kind_block(ItemReader& items, PatternParts& parts) {
    BuildContext& context = items.context();
    if (const auto image = items.take_block(Keyword::image_pattern)) {
        auto pigment = std::make_shared<scene::Pigment>();
        pigment->where = context.location(image->where);
        pigment->kind = scene::Pigment::Kind::image;
        pigment->image = read_image_map(context, *image, ImageUse::data);
        parts.pattern.uses_alpha = std::any_of(image->items.begin(), image->items.end(), [](const Item& item) {
            const auto* const word = std::get_if<Keyword>(&item.content);
            return word != nullptr && *word == Keyword::use_alpha;
        });
        parts.pattern.pigment = std::move(pigment);
        set_kind(items, parts, Kind::image);
    } else if (const auto pigment = items.take_block(Keyword::pigment_pattern)) {
        parts.pattern.pigment = std::make_shared<const scene::Pigment>(read_pigment(context, *pigment, {}));
        parts.pattern.uses_alpha = false;
        set_kind(items, parts, Kind::pigment);
    } else if (const auto slope = items.take_block(Keyword::slope)) {
        ItemReader inside(context, *slope);
        read_slope(inside, parts.pattern.slope);
        if (!inside.at_end()) inside.unexpected("'}'");
        set_kind(items, parts, Kind::slope);
    } else if (const auto object = items.take_block(Keyword::object)) {
        ItemReader inside(context, *object);
        const auto solid = inside.take_block();
        if (!solid) inside.unexpected("an object");
        parts.pattern.inside_of = context.inside_test ? context.inside_test(solid) : nullptr;
        auto list = std::make_shared<Block>(*object);
        list->items.erase(list->items.begin());
        parts.list = std::move(list);
        set_kind(items, parts, Kind::object);
    } else if (items.take_block(Keyword::aoi)) {
        set_kind(items, parts, Kind::aoi);
    } else {
        return false;
    }
    return true;
}

bool read_kind(ItemReader& items, PatternParts& parts) {
    if (read_kind_block(items, parts)) return true;
    if (const auto function = items.take_function()) {
        if (const FunctionExpression* unknown = unknown_internal_function(*function)) {
            items.warn("a pattern of internal(" + std::to_string(unknown->internal_number) +
                       "), a function that Sundog doesn't have; it is 0 everywhere");
            parts.pattern.function = nullptr;
        } else {
            parts.pattern.function = read_functions(items.context(), std::array{function}, 3);
        }
        set_kind(items, parts, Kind::function);
        return true;
    }
    const std::optional<Keyword> keyword = items.peek_keyword();
    if (!keyword) return false;
    const auto* const found =
        std::find_if(kKinds.begin(), kKinds.end(), [&](const NamedKind& named) { return named.keyword == *keyword; });
    if (found == kKinds.end() || found->kind == Kind::function) return false;
    items.skip();
    set_kind(items, parts, found->kind);
    read_parameters(items, *keyword, parts.pattern);
    return true;
}

std::optional<Wave> wave_of(Keyword keyword) {
    switch (keyword) {
        case Keyword::ramp_wave:
            return Wave::ramp;
        case Keyword::triangle_wave:
            return Wave::triangle;
        case Keyword::sine_wave:
            return Wave::sine;
        case Keyword::scallop_wave:
            return Wave::scallop;
        case Keyword::cubic_wave:
            return Wave::cubic;
        case Keyword::poly_wave:
            return Wave::poly;
        default:
            return std::nullopt;
    }
}

bool read_pavement_modifier(ItemReader& items, Keyword keyword, scene::PavementForm& pavement) {
    const auto take = [&](int& number, const char* what, int least, int most) {
        items.skip();
        number = items.integer(what, least, most);
        return true;
    };
    switch (keyword) {
        case Keyword::number_of_sides:
            take(pavement.sides, "a number of sides: 3, 4 or 6", 3, 6);
            if (pavement.sides == 5) items.unexpected("a number of sides: 3, 4 or 6");
            return true;
        case Keyword::number_of_tiles:
            return take(pavement.tiles, "a number of tiles", 1, 6);
        case Keyword::pattern:
            return take(pavement.pattern, "the number of a pavement", 1, 35);
        case Keyword::exterior:
            return take(pavement.exterior, "a look of corners", 0, 2);
        case Keyword::interior:
            return take(pavement.interior, "a look of corners", 0, 2);
        case Keyword::form:
            return take(pavement.form, "a look of corners", 0, 3);
        default:
            return false;
    }
}

/// Parameters of single patterns, wherever they stand among the modifiers.
bool read_own_modifier(ItemReader& items, Keyword keyword, scene::Pattern& pattern) {
    const auto taken = [&](auto read) {
        items.skip();
        read();
        return true;
    };
    const auto coloring = [&](int& type, double& factor) {
        type = items.integer("how a fractal is coloured", 0, 8);
        if (const auto number = items.maybe_number()) factor = *number;
    };
    if (pattern.kind == Kind::pavement && read_pavement_modifier(items, keyword, pattern.pavement)) return true;
    switch (keyword) {
        case Keyword::control0:
            return taken([&] { pattern.control0 = items.number("a control value"); });
        case Keyword::control1:
            return taken([&] { pattern.control1 = items.number("a control value"); });
        case Keyword::coords:
            return taken([&] { pattern.facet_coords = items.number("a size of facets"), pattern.facet_size = 0; });
        case Keyword::size:
            return taken([&] { pattern.facet_size = items.number("a size of facets"), pattern.facet_coords = 0; });
        case Keyword::exponent:
            return taken([&] { pattern.fractal.exponent = items.integer("an exponent", 2, 33); });
        case Keyword::form:
            return taken([&] { pattern.crackle.form = items.vector("factors of three distances"); });
        case Keyword::metric:
            return taken([&] { pattern.crackle.metric = std::max(items.number("a metric"), 1e-3); });
        case Keyword::offset:
            return taken([&] { pattern.crackle.offset = items.number("an offset"); });
        case Keyword::solid:
            return taken([&] { pattern.crackle.solid = items.flag(); });
        case Keyword::interpolate:
            return taken([&] { pattern.interpolation = items.integer("a kind of interpolation", 0, 2); });
        case Keyword::interior:
            return taken([&] { coloring(pattern.fractal.interior_type, pattern.fractal.interior_factor); });
        case Keyword::exterior:
            return taken([&] { coloring(pattern.fractal.exterior_type, pattern.fractal.exterior_factor); });
        default:
            return false;
    }
}

bool read_modifier(ItemReader& items, scene::Pattern& pattern) {
    const std::optional<Keyword> keyword = items.peek_keyword();
    if (!keyword) return false;
    if (const std::optional<Wave> wave = wave_of(*keyword)) {
        items.skip();
        pattern.wave = *wave;
        if (*wave == Wave::poly) pattern.exponent = items.maybe_number().value_or(1);
        return true;
    }
    switch (*keyword) {
        case Keyword::frequency:
            items.skip();
            pattern.frequency = items.number("a frequency");
            return true;
        case Keyword::phase:
            items.skip();
            pattern.phase = items.number("a phase");
            return true;
        case Keyword::turbulence:
            items.skip();
            pattern.turbulence = items.vector("an amount of turbulence");
            return true;
        case Keyword::agate_turb:
            items.skip();
            pattern.agate_turbulence = items.number("an amount of turbulence");
            return true;
        case Keyword::noise_generator:
            items.skip();
            pattern.noise_generator = items.integer("a noise generator", 1, 3);
            return true;
        case Keyword::octaves:
            items.skip();
            pattern.octaves = items.integer("a number of octaves", -1000, 1000);
            return true;
        case Keyword::lambda:
            items.skip();
            pattern.lambda = items.number("lambda");
            return true;
        case Keyword::omega:
            items.skip();
            pattern.omega = items.number("omega");
            return true;
        case Keyword::brick_size:
            items.skip();
            pattern.brick_size = items.vector("the size of a brick");
            return true;
        case Keyword::mortar:
            items.skip();
            pattern.mortar = items.number("the width of the mortar");
            return true;
        default:
            return read_own_modifier(items, *keyword, pattern);
    }
}

}  // namespace

std::size_t choice_count(scene::Pattern::Kind kind) {
    switch (kind) {
        case Kind::checker:
        case Kind::brick:
        case Kind::object:
            return 2;
        case Kind::material:  // As many as there are textures.
            return 256;
        case Kind::hexagon:
            return 3;
        case Kind::square:
            return 4;
        case Kind::triangular:
        case Kind::cubic:
            return 6;
        default:
            return 0;
    }
}

bool read_pattern_item(ItemReader& items, PatternParts& parts) {
    if (const auto warp = items.take_block(Keyword::warp)) {
        parts.warps.push_back({parts.texture_from_pattern, read_warp(items.context(), *warp)});
        parts.texture_from_pattern = {};
        return true;
    }
    return read_transform(items, parts.texture_from_pattern) || read_modifier(items, parts.pattern) ||
           read_kind(items, parts);
}

}  // namespace sundog::pov
