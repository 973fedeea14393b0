// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_pattern.h"

#include <algorithm>
#include <array>

#include "import/pov/build_transform.h"

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

bool is_drawn(Kind kind) {
    switch (kind) {
        case Kind::object:
        case Kind::aoi:
        case Kind::average:
        case Kind::density_file:
        case Kind::facets:
        case Kind::fractal:
        case Kind::function:
        case Kind::image:
        case Kind::pavement:
        case Kind::pigment:
        case Kind::quilted:
        case Kind::slope:
        case Kind::tiling:
            return false;
        default:
            return true;
    }
}

void skip_values(ItemReader& items) {
    while (items.value_follows()) items.skip();
}

/// slope <direction> or slope { <direction> … }; what its parameters are doesn't matter until it is drawn.
void skip_block_or_values(ItemReader& items, Keyword keyword) {
    if (!items.take_block(keyword)) skip_values(items);
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
        case Keyword::tiling:
            skip_values(items);
            return;
        case Keyword::magnet:
            skip_values(items);
            if (items.take(Keyword::mandel) || items.take(Keyword::julia)) skip_values(items);
            return;
        case Keyword::density_file:
            items.take(Keyword::df3);
            items.text("the name of a density file");
            if (items.take(Keyword::interpolate)) items.number("the kind of interpolation");
            return;
        case Keyword::slope:
        case Keyword::aoi:
            skip_block_or_values(items, keyword);
            return;
        case Keyword::function:
            items.take_function();
            return;
        default:
            return;
    }
}

void warn_of_kind(ItemReader& items, Keyword keyword, Kind kind) {
    if (is_drawn(kind) || (kind == Kind::average && items.keyword() == Keyword::normal)) return;
    const std::string name(spelling(keyword));
    items.context().warn_once("pattern " + name, items.taken_where(), "pattern '" + name + "' isn't drawn yet",
                              "its surfaces get one colour of its map");
}

void set_kind(ItemReader& items, PatternParts& parts, Keyword keyword, Kind kind) {
    parts.pattern.kind = kind;
    parts.given = true;
    warn_of_kind(items, keyword, kind);
}

bool read_kind(ItemReader& items, PatternParts& parts) {
    for (const Keyword keyword : {Keyword::image_pattern, Keyword::pigment_pattern, Keyword::slope, Keyword::aoi}) {
        if (!items.take_block(keyword)) continue;
        const Kind kind = keyword == Keyword::image_pattern     ? Kind::image
                          : keyword == Keyword::pigment_pattern ? Kind::pigment
                          : keyword == Keyword::slope           ? Kind::slope
                                                                : Kind::aoi;
        set_kind(items, parts, keyword, kind);
        return true;
    }
    if (items.take_function()) {
        set_kind(items, parts, Keyword::function, Kind::function);
        return true;
    }
    const std::optional<Keyword> keyword = items.peek_keyword();
    if (!keyword) return false;
    const auto* const found =
        std::find_if(kKinds.begin(), kKinds.end(), [&](const NamedKind& named) { return named.keyword == *keyword; });
    if (found == kKinds.end()) return false;
    items.skip();
    set_kind(items, parts, *keyword, found->kind);
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

/// Parameters of patterns that aren't drawn yet, and of how they are computed.
bool skip_modifier(ItemReader& items, Keyword keyword) {
    switch (keyword) {
        case Keyword::control0:
        case Keyword::control1:
        case Keyword::coords:
        case Keyword::exponent:
        case Keyword::form:
        case Keyword::metric:
        case Keyword::offset:
        case Keyword::size:
        case Keyword::strength:
        case Keyword::interpolate:
        case Keyword::interior:
        case Keyword::exterior:
            items.skip();
            skip_values(items);
            return true;
        case Keyword::solid:
            items.skip();
            items.flag();
            return true;
        default:
            return false;
    }
}

bool read_modifier(ItemReader& items, scene::Pattern& pattern) {
    if (items.take_block(Keyword::warp)) {
        items.context().warn_once("warp", items.taken_where(), "warp { } isn't drawn yet",
                                  "patterns keep their regular shape");
        return true;
    }
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
            return skip_modifier(items, *keyword);
    }
}

}  // namespace

std::size_t choice_count(scene::Pattern::Kind kind) {
    switch (kind) {
        case Kind::checker:
        case Kind::brick:
        case Kind::object:
            return 2;
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
    return read_transform(items, parts.texture_from_pattern) || read_modifier(items, parts.pattern) ||
           read_kind(items, parts);
}

}  // namespace sundog::pov
