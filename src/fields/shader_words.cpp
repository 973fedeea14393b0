// SPDX-License-Identifier: Apache-2.0
#include "fields/shader_words.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "fields/function_words.h"
#include "fields/pavement.h"
#include "kernel/shared.h"

namespace sundog::fields {
namespace {

using scene::Pattern;
using scene::Warp;

/// Words one after the other: whole numbers as they are, others as floats.
class Words {
public:
    Words& whole(std::uint32_t value) {
        words_.push_back(value);
        return *this;
    }
    Words& number(double value) { return whole(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }
    Words& vector(const Vec3d& v) { return number(v.x).number(v.y).number(v.z); }
    [[nodiscard]] std::vector<std::uint32_t> take() { return std::move(words_); }

private:
    std::vector<std::uint32_t> words_;
};

std::vector<std::uint32_t> slope_words(const scene::SlopeForm& slope) {
    const double altitude = length(slope.altitude);
    const auto range = [](Words& words, double low, double high) {
        if (high == low) words.number(0).number(1);
        else words.number(low).number(high - low);
    };
    Words words;
    words.vector(slope.direction).whole(slope.toward_point ? 1 : 0);
    range(words, slope.low, slope.high);
    words.vector(altitude > 0 ? slope.altitude / altitude : Vec3d{}).number(altitude);
    range(words, slope.low_altitude, slope.high_altitude);
    return words.take();
}

std::vector<std::uint32_t> pavement_words(const scene::PavementForm& form) {
    const Arrangement& tiles = arrangement_of(form);
    Words words;
    words.whole(static_cast<std::uint32_t>(tiles.sides));
    for (const int kind : {form.exterior, form.interior, form.form}) words.whole(static_cast<std::uint32_t>(kind));
    for (const int count : {tiles.width, tiles.height, tiles.shift}) words.whole(static_cast<std::uint32_t>(count));
    constexpr std::size_t kOfWord = 8, kBits = 4;
    for (std::size_t first = 0; first < tiles.borders.size(); first += kOfWord) {
        std::uint32_t word = 0;
        for (std::size_t i = first; i < std::min(first + kOfWord, tiles.borders.size()); ++i)
            word |= static_cast<std::uint32_t>(tiles.borders[i] - '0') << kBits * (i - first);
        words.whole(word);
    }
    return words.take();
}

std::vector<std::uint32_t> fractal_words(const scene::FractalForm& form) {
    Words words;
    words.whole(static_cast<std::uint32_t>(form.formula)).whole(form.julia ? 1 : 0);
    words.number(form.c[0]).number(form.c[1]);
    words.whole(static_cast<std::uint32_t>(std::max(form.iterations, 0)));
    words.whole(static_cast<std::uint32_t>(std::max(form.exponent, 1)));
    // Types beyond those that there are count as the last.
    words.whole(static_cast<std::uint32_t>(std::max(form.exterior_type, 0))).number(form.exterior_factor);
    words.whole(static_cast<std::uint32_t>(std::max(form.interior_type, 0))).number(form.interior_factor);
    return words.take();
}

std::vector<std::uint32_t> repeat_words(const Warp& warp) {
    std::uint32_t axis = 0, flip = 0;
    for (std::uint32_t i = 0; i < 3; ++i) {
        if (std::abs(warp.repeat[i]) > std::abs(warp.repeat[axis])) axis = i;
        if (warp.flip[i] != 0) flip |= 1U << i;
    }
    return Words().whole(axis).number(warp.repeat[axis]).whole(flip).vector(warp.offset).take();
}

std::vector<std::uint32_t> black_hole_words(const Warp& warp) {
    Vec3d center = warp.center, block;
    for (std::size_t i = 0; i < 3; ++i) {
        if (warp.repeat[i] == 0) continue;
        center[i] = std::max(center[i], warp.radius);
        block[i] = std::max(warp.repeat[i], center[i] + warp.radius + warp.turbulence[i]);
    }
    const bool strays = !(block == Vec3d{}) && !(warp.turbulence == Vec3d{});
    Words words;
    words.vector(center).number(warp.radius).number(warp.falloff).number(warp.strength);
    words.vector(block).whole(warp.inverse ? 1 : 0).whole(strays ? 1 : 0).vector(warp.turbulence);
    return words.take();
}

std::uint32_t mapping_of(Warp::Kind kind) {
    switch (kind) {
        case Warp::Kind::cylindrical:
            return kernel::MAPPING_CYLINDRICAL;
        case Warp::Kind::spherical:
            return kernel::MAPPING_SPHERICAL;
        case Warp::Kind::toroidal:
            return kernel::MAPPING_TOROIDAL;
        case Warp::Kind::cubic:
            return kernel::MAPPING_CUBIC;
        default:
            return kernel::MAPPING_PLANAR;
    }
}

}  // namespace

std::optional<ShaderField> shader_field(const Pattern& pattern) {
    const auto of_kind = [](std::uint32_t kind, std::vector<std::uint32_t> words) {
        return ShaderField{kind, std::move(words), 1U << kind};
    };
    switch (pattern.kind) {
        case Pattern::Kind::aoi:
            return of_kind(kernel::FIELD_AOI, {});
        case Pattern::Kind::fractal:
            return of_kind(kernel::FIELD_FRACTAL, fractal_words(pattern.fractal));
        case Pattern::Kind::function:
            if (pattern.function)
                if (std::optional<FunctionWords> function = function_words(*pattern.function))
                    return ShaderField{kernel::FIELD_FUNCTION, std::move(function->words),
                                       1U << kernel::FIELD_FUNCTION | function->fields};
            return std::nullopt;
        case Pattern::Kind::pavement:
            return of_kind(kernel::FIELD_PAVEMENT, pavement_words(pattern.pavement));
        case Pattern::Kind::quilted:
            return of_kind(kernel::FIELD_QUILTED, Words().number(pattern.control0).number(pattern.control1).take());
        case Pattern::Kind::slope:
            return of_kind(kernel::FIELD_SLOPE, slope_words(pattern.slope));
        default:
            return std::nullopt;
    }
}

std::vector<std::uint32_t> voxel_words(const scene::DensityGrid& grid) {
    constexpr float kMost = 65535;
    std::vector<std::uint32_t> words((grid.values.size() + 1) / 2);
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
        const long voxel = std::lround(std::clamp(grid.values[i], 0.0F, 1.0F) * kMost);
        words[i / 2] |= static_cast<std::uint32_t>(voxel) << (i % 2 == 0 ? 0U : 16U);
    }
    return words;
}

ShaderWarp shader_warp(const Warp& warp) {
    if (warp.kind == Warp::Kind::repeat) return {kernel::OP_REPEAT, repeat_words(warp)};
    if (warp.kind == Warp::Kind::black_hole) return {kernel::OP_BLACK_HOLE, black_hole_words(warp)};
    const double size = length(warp.orientation);
    const Vec3d outwards = size > 0 ? warp.orientation / size : Vec3d{0, 0, 1};
    return {kernel::OP_MAPPING, Words()
                                    .whole(mapping_of(warp.kind))
                                    .vector(outwards)
                                    .number(warp.distance)
                                    .number(warp.distance_exponent)
                                    .number(warp.major_radius)
                                    .take()};
}

}  // namespace sundog::fields
