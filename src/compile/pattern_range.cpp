// SPDX-License-Identifier: Apache-2.0
#include "compile/pattern_range.h"

#include <cmath>
#include <numbers>

#include "fields/pigment_code.h"

namespace sundog {
namespace {

using scene::Pattern;
using Kind = Pattern::Kind;

/// More than a few steps in single precision may be off, relatively.
constexpr double kRounding = 2e-6;
/// What the kernel may have for a number, instead of what it should have. Rounding changes no sign: what falls to 0 in
/// a distance is 0 there, and doesn't begin anew at 1.
Range loosened(Range r) {
    const double lower = r.lower - kRounding * (1 + std::abs(r.lower));
    const double upper = r.upper + kRounding * (1 + std::abs(r.upper));
    return {r.lower >= 0 ? std::max(lower, 0.0) : lower, r.upper <= 0 ? std::min(upper, 0.0) : upper};
}

RangeBox scaled(const RangeBox& box, double s) { return {box[0] * s, box[1] * s, box[2] * s}; }

RangeBox transformed(const Affine3d& m, const RangeBox& box) {
    if (m == Affine3d{}) return box;
    RangeBox out;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Range sum = box[0] * m.x[axis] + box[1] * m.y[axis] + box[2] * m.z[axis];
        const double size = box[0].most() * std::abs(m.x[axis]) + box[1].most() * std::abs(m.y[axis]) +
                            box[2].most() * std::abs(m.z[axis]) + std::abs(m.t[axis]);
        out[axis] = {sum.lower + m.t[axis] - kRounding * size, sum.upper + m.t[axis] + kRounding * size};
    }
    return out;
}

int octaves_of(int octaves) { return std::clamp(octaves, 1, 10); }

/// turbulence_vector()
std::array<Range, 3> turbulence_over(const RangeBox& box, int octaves, double lambda, double omega) {
    std::array<Range, 3> sum{};
    double frequency = 1, weight = 1;
    for (int i = 0; i < octaves; ++i, frequency *= lambda, weight *= omega) {
        const std::array<Range, 3> noise = noise_vector_over(scaled(box, frequency));
        for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] = sum[axis] + noise[axis] * weight;
    }
    return {loosened(sum[0]), loosened(sum[1]), loosened(sum[2])};
}

/// turbulence_sum()
Range turbulence_sum_over(const RangeBox& box, const Pattern& pattern) {
    const std::uint32_t generator = fields::noise_generator_of(pattern);
    Range sum;
    double frequency = 1, weight = 1;
    for (int i = 0; i < octaves_of(pattern.octaves); ++i, frequency *= pattern.lambda, weight *= pattern.omega) {
        Range noise = noise_over(scaled(box, frequency), generator);
        if (generator != 1) noise = noise * 2 + Range{-0.5, -0.5};
        if (i == 0) noise = clamped(noise, 0, 1);
        sum = sum + noise * weight;
    }
    return loosened(sum);
}

/// A box whose points were moved by turbulence, of what amount in each direction.
RangeBox stirred(const RangeBox& box, Vec3d amount, int octaves, double lambda, double omega) {
    const std::array<Range, 3> noise = turbulence_over(box, octaves_of(octaves), lambda, omega);
    RangeBox out;
    for (std::size_t axis = 0; axis < 3; ++axis) out[axis] = box[axis] + noise[axis] * amount[axis];
    return out;
}

/// stirred_point(), in the way of the pattern's kind.
RangeBox stirred(const RangeBox& box, const Pattern& pattern) {
    const Vec3d amount = pattern.turbulence;
    if (amount == Vec3d{}) return box;
    if (pattern.kind == Kind::marble) return {box[0] + turbulence_sum_over(box, pattern) * amount.x, box[1], box[2]};
    if (pattern.kind == Kind::wood) return {box[0] + Range{-1.01, 1.01}, box[1] + Range{-1.01, 1.01}, box[2]};
    RangeBox out = stirred(box, amount, pattern.octaves, pattern.lambda, pattern.omega);
    if (pattern.kind == Kind::spiral1 || pattern.kind == Kind::spiral2)
        out[2] = out[2] + turbulence_sum_over(box, pattern) * amount.x;
    return out;
}

/// Distances from the origin, as far as the axes named count.
Range length_over(std::initializer_list<Range> axes) {
    double least = 0, most = 0;
    for (const Range& r : axes) {
        const Range size = size_of(r);
        least += size.lower * size.lower, most += size.upper * size.upper;
    }
    return {std::sqrt(least), std::sqrt(most)};
}

/// 1 less a distance, 0 from there on.
Range falling(Range distance) { return {std::max(1 - distance.upper, 0.0), std::max(1 - distance.lower, 0.0)}; }

/// What is left of values beyond a whole number.
Range fraction_of(Range r) {
    const Range loose = loosened(r);
    const double whole = std::floor(loose.lower);
    return std::floor(loose.upper) == whole ? Range{r.lower - whole, r.upper - whole} : Range{0, 1};
}

/// `octaves` noises, each twice as fine and half as strong as the one before, from a frequency on; folded at their
/// middle or not.
Range octaves_over(const RangeBox& at, int octaves, double frequency, std::uint32_t generator, bool folded) {
    Range sum;
    double weight = 1;
    for (int i = 0; i < octaves; ++i, frequency *= 2, weight *= 0.5) {
        const Range noise = noise_over(scaled(at, frequency), generator) + Range{-0.5, -0.5};
        sum = sum + (folded ? size_of(noise) : noise) * weight;
    }
    return sum;
}

/// The voxels that may count in a box, and 0 where it reaches out of the grid.
Range grid_over(const Pattern& pattern, const RangeBox& at) {
    if (!pattern.density || pattern.density->values.empty()) return {0, 0};
    const scene::DensityGrid& grid = *pattern.density;
    std::array<std::int64_t, 3> first{}, count{};
    bool leaves = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (at[axis].upper < 0 || at[axis].lower >= 1) return {0, 0};
        leaves = leaves || at[axis].lower < 0 || at[axis].upper >= 1;
        const auto size = static_cast<std::int64_t>(grid.size[axis]);
        const auto voxel = [&](double place) {
            return std::clamp<std::int64_t>(
                static_cast<std::int64_t>(std::floor(std::clamp(place, 0.0, 1.0) * static_cast<double>(size))), 0,
                size - 1);
        };
        first[axis] = voxel(at[axis].lower) - (pattern.interpolation == 2 ? 1 : 0);
        const std::int64_t last = voxel(at[axis].upper) + pattern.interpolation;
        count[axis] = std::min(last - first[axis] + 1, size);
    }
    const auto wrapped = [&](std::int64_t i, std::size_t axis) {
        const auto size = static_cast<std::int64_t>(grid.size[axis]);
        return static_cast<std::size_t>((i % size + size) % size);
    };
    float least = INFINITY, most = -INFINITY;
    for (std::int64_t z = 0; z < count[2]; ++z) {
        for (std::int64_t y = 0; y < count[1]; ++y) {
            const std::size_t row = (wrapped(first[2] + z, 2) * grid.size[1] + wrapped(first[1] + y, 1)) * grid.size[0];
            for (std::int64_t x = 0; x < count[0]; ++x) {
                const float value = grid.values[row + wrapped(first[0] + x, 0)];
                least = std::min(least, value), most = std::max(most, value);
            }
        }
    }
    Range out{static_cast<double>(least), static_cast<double>(most)};
    if (pattern.interpolation == 2) {
        // A cubic's weights that are negative add up to at most 1/8 along an axis, so all sizes to 5/4.
        const double over = 0.5 * (1.25 * 1.25 * 1.25 - 1) * (out.upper - out.lower);
        out = {out.lower - over, out.upper + over};
    }
    out = clamped(out, 0, 1);
    return leaves ? either(out, {0, 0}) : out;
}

bool is_triangle_by_default(Kind kind) {
    return kind == Kind::marble || kind == Kind::wood || kind == Kind::spiral1 || kind == Kind::spiral2;
}

/// A function over a range within which it rises to a crest and falls behind it.
template <class Function>
Range hill_over(Range r, double crest, Function f) {
    const Range ends = either({f(r.lower), f(r.lower)}, {f(r.upper), f(r.upper)});
    return r.lower <= crest && crest <= r.upper ? Range{ends.lower, std::max(ends.upper, f(crest))} : ends;
}

}  // namespace

RangeBox pattern_box(const Pattern& pattern, const RangeBox& box) {
    RangeBox at = box;
    for (const scene::WarpStep& step : pattern.warps) {
        at = transformed(step.warp_from_before, at);
        const scene::Warp& warp = step.warp;
        if (warp.kind != scene::Warp::Kind::turbulence) at = kEverywhere;
        else if (!(warp.turbulence == Vec3d{}))
            at = stirred(at, warp.turbulence, warp.octaves, warp.lambda, warp.omega);
    }
    return stirred(transformed(pattern.pattern_from_texture, at), pattern);
}

Range field_over(const Pattern& pattern, const RangeBox& at) {
    const std::uint32_t generator = fields::noise_generator_of(pattern);
    switch (pattern.kind) {
        case Kind::gradient: {
            const Vec3d axis = normalize(pattern.axis);
            const Range sum = at[0] * axis.x + at[1] * axis.y + at[2] * axis.z;
            const double slack = kRounding * (at[0].most() * std::abs(axis.x) + at[1].most() * std::abs(axis.y) +
                                              at[2].most() * std::abs(axis.z));
            const Range along = sum + Range{-slack, slack};
            // Beyond 1 only the fraction counts.
            if (along.upper <= 1) return along;
            return along.lower > 1 ? fraction_of(along) : Range{std::min(along.lower, 0.0), 1};
        }
        case Kind::onion:
            return fraction_of(length_over({at[0], at[1], at[2]}));
        case Kind::spherical:
            return falling(length_over({at[0], at[1], at[2]}));
        case Kind::cylindrical:
            return falling(length_over({at[0], at[2]}));
        case Kind::planar:
            return falling(size_of(at[1]));
        case Kind::boxed: {
            const Range x = size_of(at[0]), y = size_of(at[1]), z = size_of(at[2]);
            return falling({std::max({x.lower, y.lower, z.lower}), std::max({x.upper, y.upper, z.upper})});
        }
        case Kind::wood:
            return length_over({at[0], at[1]});
        case Kind::marble:
            return at[0];
        case Kind::bozo:
        case Kind::bumps:
        case Kind::spotted:
            return noise_over(at, generator);
        case Kind::dents: {
            const Range n = noise_over(at, generator);
            return {n.lower * n.lower * n.lower, n.upper * n.upper * n.upper};
        }
        case Kind::granite:
            return clamped(octaves_over(at, 6, 4, generator, true) * 1.95, 0, 1);
        case Kind::wrinkles:
            return clamped(octaves_over(at, 10, 1, generator, false) * 0.97 + Range{0.5, 0.5}, 0, 1);
        case Kind::density_file:
            return grid_over(pattern, at);
        default:
            return kAnyValue;
    }
}

Range wave_over(const Pattern& pattern, Range value) {
    using Wave = Pattern::Wave;
    const bool as_it_is = pattern.frequency == 0;
    const double phase = as_it_is ? 0 : pattern.phase;
    Range v = loosened(value * (as_it_is ? 1 : pattern.frequency));
    if (phase != 0) {
        // A difference may be on either side of 0.
        const double slack = kRounding * (v.most() + std::abs(phase));
        v = v + Range{phase - slack, phase + slack};
    }
    const double period = 1.00001;
    const double turns = std::floor(v.lower / period);
    const Range turn = std::floor(v.upper / period) == turns
                           ? loosened({v.lower - turns * period, v.upper - turns * period})
                           : loosened({0, period});
    Wave wave = pattern.wave;
    if (wave == Wave::standard) wave = is_triangle_by_default(pattern.kind) ? Wave::triangle : Wave::ramp;
    constexpr double kPi = std::numbers::pi;
    switch (wave) {
        case Wave::triangle:
            return loosened(hill_over(turn, 0.5, [](double x) { return 1 - std::abs(2 * x - 1); }));
        case Wave::sine: {
            if (turn.lower <= 0.75 && turn.upper >= 0.75)
                return loosened({0, turn.lower <= 0.25 ? 1
                                                       : std::max(0.5 + 0.5 * std::sin(2 * kPi * turn.lower),
                                                                  0.5 + 0.5 * std::sin(2 * kPi * turn.upper))});
            return loosened(hill_over(turn, 0.25, [](double x) { return 0.5 + 0.5 * std::sin(2 * kPi * x); }));
        }
        case Wave::scallop:
            return loosened(hill_over(turn, 0.5, [](double x) { return std::sin(kPi * x); }));
        case Wave::cubic: {
            const Range t = clamped(turn, 0, 1);
            return loosened({t.lower * t.lower * (3 - 2 * t.lower), t.upper * t.upper * (3 - 2 * t.upper)});
        }
        case Wave::poly:
            // Powers are computed by logarithms, and are 0 for 0.
            if (!(pattern.exponent > 0)) return {0, 1e30};
            return loosened({std::pow(std::max(turn.lower, 0.0), pattern.exponent) * 0.9999,
                             std::pow(std::max(turn.upper, 0.0), pattern.exponent) * 1.0001});
        case Wave::standard:
        case Wave::ramp:
            break;
    }
    return turn;
}

int pattern_cost(const Pattern& pattern) {
    int cost = 1;
    switch (pattern.kind) {
        case Kind::granite:
            cost = 6;
            break;
        case Kind::wrinkles:
            cost = 10;
            break;
        case Kind::agate:
            cost = octaves_of(pattern.octaves);
            break;
        case Kind::crackle:
        case Kind::density_file:
        case Kind::fractal:
        case Kind::function:
        case Kind::object:
        case Kind::ripples:
        case Kind::share:
        case Kind::waves:
            cost = 8;
            break;
        default:
            break;
    }
    if (!(pattern.turbulence == Vec3d{})) cost += 3 * octaves_of(pattern.octaves);
    for (const scene::WarpStep& step : pattern.warps)
        cost += step.warp.kind == scene::Warp::Kind::turbulence ? 3 * octaves_of(step.warp.octaves) : 1;
    return cost;
}

}  // namespace sundog
