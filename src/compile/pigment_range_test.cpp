// SPDX-License-Identifier: Apache-2.0
// Bounds of pigments over boxes against the kernel's own colours at random points in them.
#include "compile/pigment_range.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "fields/pigment_evaluator.h"

namespace sundog {
namespace {

using scene::Pattern;
using scene::Pigment;
using Kind = Pattern::Kind;

/// A map that rises from nothing, jumps and falls again.
std::vector<scene::PigmentEntry> cloud_map() {
    return {{0.3F, {0, 0.5F, 0, 0, 0}, nullptr},
            {0.5F, {1, 0.25F, -1, 0, 0}, nullptr},
            {0.5F, {2, 0.75F, 0, 0, 0}, nullptr},
            {0.9F, {0, 1, 3, 0, 0}, nullptr}};
}

Pigment mapped(Kind kind) {
    Pigment pigment;
    pigment.kind = Pigment::Kind::mapped;
    pigment.pattern.kind = kind;
    pigment.entries = cloud_map();
    return pigment;
}

scene::WarpStep warp(scene::Warp::Kind kind) {
    scene::WarpStep step;
    step.warp.kind = kind;
    step.warp.turbulence = {0.3, 0.2, 0.6};
    step.warp.repeat = {1, 0, 0};
    step.warp_from_before.t = {0.25, 0, 0};
    return step;
}

std::shared_ptr<const scene::DensityGrid> voxels() {
    auto grid = std::make_shared<scene::DensityGrid>();
    grid->size = {5, 4, 3};
    std::mt19937 random(7);
    std::uniform_real_distribution<float> number(0, 1);
    for (int i = 0; i < 60; ++i) grid->values.push_back(std::max(number(random) * 2 - 1, 0.0F));
    return grid;
}

/// x times noise, with a root that isn't everywhere.
std::shared_ptr<const scene::Function> function() {
    using Op = scene::FunctionOp;
    auto f = std::make_shared<scene::Function>();
    f->input_count = 3;
    const auto x = static_cast<std::uint32_t>(f->first_input()), result = static_cast<std::uint32_t>(f->first_result());
    scene::FunctionInstruction noise, product, root;
    noise.op = Op::noise, noise.index = 2, noise.a = x, noise.b = x + 1, noise.c = x + 2;
    root.op = Op::square_root, root.a = x;
    product.op = Op::multiply, product.a = result, product.b = result + 1;
    f->code = {noise, root, product};
    f->outputs = {result + 2};
    return f;
}

void expect_within(const Pigment& pigment, const std::string& name, std::mt19937& random) {
    const auto shared = std::make_shared<const Pigment>(pigment);
    const fields::PigmentEvaluator colors(std::array{shared}, {});
    const PigmentRange range(*shared, {});
    std::uniform_real_distribution<double> number(0, 1);
    const ColorRange all = range.over(kEverywhere);
    for (int box = 0; box < 60; ++box) {
        RangeBox at;
        const double size = std::pow(10, -2.5 + 3 * number(random));
        for (Range& r : at) r.lower = -2 + 4 * number(random), r.upper = r.lower + size * number(random);
        const ColorRange bounds = range.over(at);
        for (int point = 0; point < 60; ++point) {
            Vec3d p;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                // Corners, too: extremes of much lie there.
                const double share = point < 8 ? static_cast<double>(point >> axis & 1) : number(random);
                p[axis] = std::clamp(
                    static_cast<double>(static_cast<float>(at[axis].lower + share * (at[axis].upper - at[axis].lower))),
                    at[axis].lower, at[axis].upper);
            }
            const std::array<double, 5> color = colors.color(0, p.x, p.y, p.z);
            for (std::size_t i = 0; i < 3; ++i) {
                const double slack = 1e-5 * (1 + bounds[i].most());
                ASSERT_GE(color[i], bounds[i].lower - slack) << name << " at " << p.x << ' ' << p.y << ' ' << p.z;
                ASSERT_LE(color[i], bounds[i].upper + slack) << name << " at " << p.x << ' ' << p.y << ' ' << p.z;
                ASSERT_LE(bounds[i].upper, all[i].upper + slack) << name;
            }
        }
    }
}

constexpr std::array kFields{Kind::gradient, Kind::agate,       Kind::boxed,   Kind::bozo,    Kind::cells,
                             Kind::crackle,  Kind::cylindrical, Kind::dents,   Kind::granite, Kind::leopard,
                             Kind::marble,   Kind::onion,       Kind::planar,  Kind::quilted, Kind::radial,
                             Kind::ripples,  Kind::spherical,   Kind::spiral1, Kind::spiral2, Kind::waves,
                             Kind::wood,     Kind::wrinkles,    Kind::slope};

// Catches a bound that some point exceeds: paths through such a medium would be too bright there, or too dark.
TEST(PigmentRange, HoldsAllColorsOfABox) {
    std::mt19937 random(1);
    for (const Kind kind : kFields) {
        Pigment pigment = mapped(kind);
        expect_within(pigment, "field " + std::to_string(static_cast<int>(kind)), random);
        pigment.pattern.turbulence = {0.4, 0.3, 0.5};
        pigment.pattern.octaves = 4;
        pigment.pattern.pattern_from_texture = {{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 2}, {0.1, 0.2, 0.3}};
        expect_within(pigment, "stirred field " + std::to_string(static_cast<int>(kind)), random);
    }
}

// Catches a wave form that is bent the wrong way, or whose end isn't where the kernel has it.
TEST(PigmentRange, HoldsAllWaveForms) {
    using Wave = Pattern::Wave;
    std::mt19937 random(2);
    for (const Wave wave : {Wave::ramp, Wave::triangle, Wave::sine, Wave::scallop, Wave::cubic, Wave::poly}) {
        for (const double frequency : {1.0, 2.5, -1.5, 0.0}) {
            Pigment pigment = mapped(Kind::spherical);
            pigment.pattern.wave = wave;
            pigment.pattern.exponent = 1.7;
            pigment.pattern.frequency = frequency;
            pigment.pattern.phase = 0.3;
            expect_within(pigment, "wave " + std::to_string(static_cast<int>(wave)), random);
        }
    }
}

// Catches points that a warp moves out of the box that is asked, voxels that are left out at a box's ends or weighed
// negatively, and functions without a value.
TEST(PigmentRange, HoldsWarpsGridsFunctionsAndMaps) {
    std::mt19937 random(3);
    Pigment pigment = mapped(Kind::bozo);
    pigment.pattern.warps = {warp(scene::Warp::Kind::turbulence)};
    expect_within(pigment, "warp turbulence", random);
    pigment.pattern.warps.push_back(warp(scene::Warp::Kind::repeat));
    expect_within(pigment, "warp repeat", random);

    for (const int interpolation : {0, 1, 2}) {
        pigment = mapped(Kind::density_file);
        pigment.pattern.density = voxels();
        pigment.pattern.interpolation = interpolation;
        expect_within(pigment, "grid " + std::to_string(interpolation), random);
    }

    pigment = mapped(Kind::function);
    pigment.pattern.function = function();
    expect_within(pigment, "function", random);

    Pigment outer = mapped(Kind::gradient);
    outer.entries[0].pigment = std::make_shared<const Pigment>(mapped(Kind::granite));
    outer.entries[2].pigment = std::make_shared<const Pigment>(mapped(Kind::boxed));
    expect_within(outer, "map of pigments", random);
    outer.pattern.kind = Kind::average;
    expect_within(outer, "average", random);
    outer.pattern.kind = Kind::checker;
    outer.kind = Pigment::Kind::choice;
    expect_within(outer, "checker", random);

    pigment = mapped(Kind::pigment);
    pigment.pattern.pigment = std::make_shared<const Pigment>(mapped(Kind::spherical));
    expect_within(pigment, "pigment pattern", random);
}

// Catches bounds that are sound and of no use: a stirred ball is empty far outside, and noise in a small box is not all
// that noise can be.
TEST(PigmentRange, IsTightWhereItCanBe) {
    Pigment ball = mapped(Kind::spherical);
    ball.entries = {{0, {0, 0, 0, 0, 0}, nullptr}, {1, {1, 1, 1, 0, 0}, nullptr}};
    ball.pattern.turbulence = {0.2, 0.2, 0.2};
    EXPECT_EQ(PigmentRange(ball, {}).over({Range{2, 3}, Range{0, 1}, Range{0, 1}})[0].upper, 0);

    Pigment noise = ball;
    noise.pattern.kind = Kind::bozo;
    noise.pattern.turbulence = {};
    const Range range = PigmentRange(noise, {}).over({Range{0.4, 0.45}, Range{0.4, 0.45}, Range{0.4, 0.45}})[0];
    EXPECT_LT(range.upper - range.lower, 0.1);
}

}  // namespace
}  // namespace sundog
