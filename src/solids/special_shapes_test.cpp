// SPDX-License-Identifier: Apache-2.0
// Julia fractals, eggs, lemons, parametric surfaces, flat boxes.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fields/function_builder.h"
#include "solids/four_numbers.h"
#include "solids/test_solids.h"

namespace sundog::solids::tests {
namespace {

/// Where hits lie, and that rays find the same inside as points do.
void expect_consistent(const scene::Solid& shape, double reach, double flat) {
    const auto solid = compile_solid(shape, 0);
    RandomRays random(7);
    for (int i = 0; i < 300; ++i) {
        const Ray ray = random.ray(reach);
        const double end = 10;
        std::vector<Hit> hits = all_hits(*solid, ray, {0, end});
        bool inside = solid->inside(ray.origin);
        double from = 0;
        hits.push_back({end, {}, 0, 0, 0});
        for (const Hit& hit : hits) {
            if (hit.t - from > flat) {
                EXPECT_EQ(inside, solid->inside(ray.at(0.5 * (from + hit.t)))) << i;
            }
            inside = !inside;
            from = hit.t;
        }
    }
}

// Catches arcs that don't meet the spheres, and a top at the wrong height.
TEST(Ovus, ItsArcTouchesBothSpheres) {
    const scene::Solid egg = solid_of(scene::Ovus{1, 0.5});
    const auto solid = compile_solid(egg, 0);
    const std::vector<Hit> along = all_hits(*solid, {{0, -3, 0}, {0, 1, 0}});
    ASSERT_EQ(2U, along.size());
    EXPECT_NEAR(2, along[0].t, 1e-12);
    EXPECT_NEAR(4.5, along[1].t, 1e-12);
    // The arc: radius 2 about (-sqrt(1 - 1/64), -1/8).
    const double y = 0.7;
    const std::vector<Hit> across = all_hits(*solid, {{3, y, 0}, {-1, 0, 0}});
    ASSERT_EQ(2U, across.size());
    const double x = -std::sqrt(1 - 1.0 / 64) + std::sqrt(4 - (y + 0.125) * (y + 0.125));
    EXPECT_NEAR(3 - x, across[0].t, 1e-12);
    EXPECT_NEAR(0, length(across[0].normal - normalize(Vec3d{x + std::sqrt(1 - 1.0 / 64), y + 0.125, 0})), 1e-9);
    expect_consistent(egg, 2, 1e-6);
    expect_consistent(solid_of(scene::Ovus{0.6, 0.9}), 2, 1e-6);
}

// Catches an arc where the upper sphere holds the lower one.
TEST(Ovus, ALargeTopIsASphere) {
    const auto solid = compile_solid(solid_of(scene::Ovus{0.4, 1}), 0);
    const std::vector<Hit> hits = all_hits(*solid, {{3, 0.4, 0}, {-1, 0, 0}});
    ASSERT_EQ(2U, hits.size());
    EXPECT_NEAR(2, hits[0].t, 1e-12);
    EXPECT_NEAR(4, hits[1].t, 1e-12);
}

// Catches arcs on the wrong side, and caps of open lemons.
TEST(Lemon, IsAnArcBetweenTwoDiscs) {
    scene::Lemon lemon{{1, 0, 0}, {3, 0, 0}, 0, 0, 2, false};
    const auto pointed = compile_solid(solid_of(lemon), 0);
    const std::vector<Hit> across = all_hits(*pointed, {{2, 5, 0}, {0, -1, 0}});
    ASSERT_EQ(2U, across.size());
    EXPECT_NEAR(5 - (2 - std::sqrt(3.0)), across[0].t, 1e-12);
    expect_consistent(solid_of(lemon), 4, 1e-6);
    lemon.base_radius = 0.5, lemon.apex_radius = 0.3;
    const auto capped = compile_solid(solid_of(lemon), 0);
    const std::vector<Hit> along = all_hits(*capped, {{0, 0, 0.1}, {1, 0, 0}});
    ASSERT_EQ(2U, along.size());
    EXPECT_NEAR(1, along[0].t, 1e-12);
    EXPECT_NEAR(0, length(along[0].normal - Vec3d{-1, 0, 0}), 1e-12);
    expect_consistent(solid_of(lemon), 4, 1e-6);
    lemon.open = true;
    EXPECT_TRUE(all_hits(*compile_solid(solid_of(lemon), 0), {{0, 0, 0.1}, {1, 0, 0}}).empty());
}

// Catches iterations too many or too few: with p = 0 the inside is |h|^(2^n) <= 4.
TEST(JuliaFractal, PowersOfNothingAreBalls) {
    for (const int n : {1, 2, 5}) {
        scene::JuliaFractal fractal;
        fractal.max_iteration = n;
        const double radius = std::pow(4, std::pow(0.5, n));
        const Vec3d way = normalize(Vec3d{1, 2, -0.5});
        const std::vector<Hit> hits = all_hits(*compile_solid(solid_of(fractal), 0), {way * -5, way});
        ASSERT_EQ(2U, hits.size()) << n;
        EXPECT_NEAR(5 - radius, hits[0].t, 1e-9);
        EXPECT_NEAR(5 + radius, hits[1].t, 1e-9);
        EXPECT_NEAR(0, length(hits[0].normal + way), 1e-6);
    }
    scene::JuliaFractal cube;
    cube.max_iteration = 2;
    cube.function = scene::JuliaFractal::Function::cube;
    const std::vector<Hit> hits = all_hits(*compile_solid(solid_of(cube), 0), {{-5, 0, 0}, {1, 0, 0}});
    ASSERT_EQ(2U, hits.size());
    EXPECT_NEAR(5 - std::pow(4, 1.0 / 9), hits[0].t, 1e-9);
}

// Catches points a rounding beyond the ball of radius 4 that are taken for inside: specks all around.
TEST(JuliaFractal, NothingLiesOnTheBallAround) {
    scene::JuliaFractal fractal;
    fractal.parameter = {-0.745, 0, 0.113, 0.05};
    fractal.max_iteration = 9;
    fractal.hypercomplex = true;
    const auto solid = compile_solid(solid_of(fractal), 0);
    RandomRays random(7);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const Ray ray{{random.number(-4, 4), random.number(-4, 4), 6}, {0, 0, -1}};
        if (const std::optional<Hit> hit = solid->nearest(ray, {})) {
            ++hits;
            EXPECT_LT(length(ray.at(hit->t)), 3.5);
        }
    }
    EXPECT_GT(hits, 20);
}

// Catches a slice that isn't where its distance says, and an unscaled normal.
TEST(JuliaFractal, ASliceIsADistanceFromTheOrigin) {
    scene::JuliaFractal fractal;
    fractal.max_iteration = 1;
    fractal.slice = {0, 0, 0, 3};
    fractal.distance = 1;
    const std::vector<Hit> hits = all_hits(*compile_solid(solid_of(fractal), 0), {{0, -5, 0}, {0, 1, 0}});
    ASSERT_EQ(2U, hits.size());
    EXPECT_NEAR(5 - std::sqrt(3.0), hits[0].t, 1e-9);
}

// Catches signs of the two algebras' products.
TEST(JuliaFractal, NumbersMultiplyAsTheReferenceSays) {
    const FourNumber i{0, 1, 0, 0};
    const FourNumber j{0, 0, 1, 0};
    EXPECT_EQ((FourNumber{0, 0, 0, 1}), quaternion_product(i, j));
    EXPECT_EQ((FourNumber{0, 0, 0, -1}), quaternion_product(j, i));
    // Hypercomplex: ij = k, and the size of a pair is that of the number.
    const ComplexPair pi(i);
    const ComplexPair pj(j);
    const ComplexPair pk(FourNumber{0, 0, 0, 1});
    EXPECT_EQ(pk.u, pi.u * pj.u);
    EXPECT_EQ(pk.v, pi.v * pj.v);
    EXPECT_NEAR(30, ComplexPair(FourNumber{1, 2, 3, 4}).squared(), 1e-12);
}

// Catches wrong derivatives, by which normals are made.
TEST(JuliaFractal, SlopesAreThoseOfTheFunctions) {
    using Function = scene::JuliaFractal::Function;
    const std::complex<double> h(0.3, 0.4);
    const std::complex<double> exponent(1.5, 0.2);
    for (int f = 0; f <= static_cast<int>(Function::pwr); ++f) {
        const auto function = static_cast<Function>(f);
        const ComplexValue value = julia_function(function, h, exponent);
        const double step = 1e-6;
        const std::complex<double> rise =
            (julia_function(function, h + step, exponent).value - julia_function(function, h - step, exponent).value) /
            (2 * step);
        EXPECT_NEAR(0, std::abs(rise - value.slope), 1e-7) << f;
        EXPECT_NEAR(0, std::abs(value.value - julia_value(function, h, exponent)), 1e-14) << f;
    }
}

// Catches functions under each other's names, and branches other than the principal ones.
TEST(JuliaFractal, FunctionsAreThoseOfTheirNames) {
    using Function = scene::JuliaFractal::Function;
    using Complex = std::complex<double>;
    const Complex i(0, 1), exponent(1.5, 0.2);
    for (const Complex h : {Complex{0.3, 0.4}, {-0.7, 0.2}, {0.5, -1.1}}) {
        const auto f = [&](Function function, Complex at) { return julia_function(function, at, exponent).value; };
        const Complex e = f(Function::exp, h), ei = f(Function::exp, i * h);
        EXPECT_NEAR(std::abs(e), std::exp(h.real()), 1e-12);
        EXPECT_NEAR(std::arg(e), h.imag(), 1e-12);
        const auto same = [](Complex a, Complex b) { EXPECT_NEAR(std::abs(a - b), 0, 1e-12); };
        same(f(Function::sinh, h), (e - 1.0 / e) / 2.0);
        same(f(Function::cosh, h), (e + 1.0 / e) / 2.0);
        same(f(Function::tanh, h), (e - 1.0 / e) / (e + 1.0 / e));
        same(f(Function::sin, h), (ei - 1.0 / ei) / (2.0 * i));
        same(f(Function::cos, h), (ei + 1.0 / ei) / 2.0);
        same(f(Function::tan, h), (ei - 1.0 / ei) / (i * (ei + 1.0 / ei)));
        same(f(Function::reciprocal, h) * h, 1);
        same(f(Function::sqr, h), h * h);
        same(f(Function::cube, h), h * h * h);
        same(f(Function::pwr, h), f(Function::exp, exponent * f(Function::ln, h)));
        same(f(Function::exp, f(Function::ln, h)), h);
        same(f(Function::sin, f(Function::asin, h)), h);
        same(f(Function::cos, f(Function::acos, h)), h);
        same(f(Function::tan, f(Function::atan, h)), h);
        same(f(Function::sinh, f(Function::asinh, h)), h);
        same(f(Function::cosh, f(Function::acosh, h)), h);
        same(f(Function::tanh, f(Function::atanh, h)), h);
        EXPECT_LE(std::abs(f(Function::asin, h).real()), std::numbers::pi / 2);
        EXPECT_GE(f(Function::acosh, h).real(), 0);
    }
}

// Catches insides of another number of iterations, products of the other algebra, and parameters left out: a point is
// inside while its numbers, as two complex ones, stay within the ball of radius 4.
TEST(JuliaFractal, MembersDoNotEscape) {
    using Function = scene::JuliaFractal::Function;
    for (int number = static_cast<int>(Function::exp); number <= static_cast<int>(Function::pwr); ++number) {
        scene::JuliaFractal fractal;
        fractal.function = static_cast<Function>(number);
        fractal.hypercomplex = true;
        fractal.parameter = {0.3, -0.5, 0.4, 0.2};
        fractal.exponent = {1.7, 0.3};
        fractal.max_iteration = 4;
        const auto solid = compile_solid(solid_of(fractal), 0);
        RandomRays random(11);
        int members = 0;
        for (int k = 0; k < 400; ++k) {
            const Vec3d p{random.number(-2, 2), random.number(-2, 2), random.number(-2, 2)};
            std::complex<double> u(p.x, p.y - p.z), v(p.x, p.y + p.z);
            bool stays = true;
            for (int n = 0; n + 1 < fractal.max_iteration && stays; ++n) {
                const std::complex<double> exponent(1.7, 0.3);
                u = julia_function(fractal.function, u, exponent).value + std::complex<double>(0.3 + 0.2, -0.5 - 0.4);
                v = julia_function(fractal.function, v, exponent).value + std::complex<double>(0.3 - 0.2, -0.5 + 0.4);
                stays = (std::norm(u) + std::norm(v)) / 2 <= 16;
            }
            members += stays ? 1 : 0;
            EXPECT_EQ(solid->inside(p), stays) << number << " at " << p.x << ' ' << p.y << ' ' << p.z;
        }
        EXPECT_GT(members, 20) << number;
    }
}

scene::Parametric ball() {
    fields::FunctionBuilder builder(3);
    const fields::Number u = builder.input(0);
    const fields::Number v = builder.input(1);
    const std::array<fields::Number, 3> outputs{fields::sin(u) * fields::cos(v), fields::sin(u) * fields::sin(v),
                                                fields::cos(u)};
    scene::Parametric parametric;
    parametric.function = std::make_shared<scene::Function>(builder.finish(outputs));
    parametric.first = {0, 0};
    parametric.last = {std::numbers::pi, 2 * std::numbers::pi};
    parametric.lower = {-2, -2, -2}, parametric.upper = {2, 2, 2};
    return parametric;
}

// Catches holes between patches, hits counted by two of them, and wrong u and v.
TEST(Parametric, ABallHasTwoSidesEverywhere) {
    const auto solid = compile_solid(solid_of(ball()), 0);
    RandomRays random(3);
    for (int i = 0; i < 300; ++i) {
        const Vec3d from = normalize(random.point(1)) * 3;
        const Vec3d to = random.point(0.5);
        const Ray ray{from, to - from};
        const std::vector<Hit> hits = all_hits(*solid, ray);
        ASSERT_EQ(2U, hits.size()) << i;
        for (const Hit& hit : hits) {
            const Vec3d p = ray.at(hit.t);
            EXPECT_NEAR(1, length(p), 1e-8);
            EXPECT_NEAR(std::cos(hit.u), p.z, 1e-6);
            EXPECT_NEAR(1, std::abs(dot(hit.normal, p)), 1e-6);
        }
    }
}

// Catches surfaces that reach out of their container.
TEST(Parametric, ItsContainerCutsIt) {
    scene::Parametric half = ball();
    half.lower = {-2, -2, 0};
    const auto solid = compile_solid(solid_of(half), 0);
    EXPECT_EQ(1U, all_hits(*solid, {{0.1, 0.2, -5}, {0, 0, 1}}).size());
}

// Catches boxes without thickness that vanish when they are turned.
TEST(FlatBox, IsASurface) {
    scene::Solid box = solid_of(scene::SolidBox{{-1, -1, 0}, {1, 1, 0}});
    box.parent_from_shape = turned(normalize(Vec3d{1, 2, 3}), 0.7);
    const auto solid = compile_solid(box, 0);
    RandomRays random(5);
    for (int i = 0; i < 100; ++i) {
        const Vec3d target = transform_point(box.parent_from_shape, {random.number(-0.9, 0.9), 0.5, 0});
        const Vec3d from = normalize(random.point(1)) * 4;
        const std::vector<Hit> hits = all_hits(*solid, {from, target - from});
        ASSERT_EQ(1U, hits.size()) << i;
        EXPECT_NEAR(1, hits[0].t, 1e-9);
    }
}

}  // namespace
}  // namespace sundog::solids::tests
