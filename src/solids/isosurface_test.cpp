// SPDX-License-Identifier: Apache-2.0
// Isosurfaces against shapes that are known otherwise.
#include <gtest/gtest.h>

#include <cmath>

#include "fields/function_builder.h"
#include "solids/test_solids.h"

namespace sundog::solids::tests {
namespace {

using fields::Number;

template <class Build>
scene::Isosurface isosurface_of(const Build& build) {
    fields::FunctionBuilder b(3);
    scene::Isosurface s;
    const Number f = build(b.input(0), b.input(1), b.input(2));
    s.function = std::make_shared<const scene::Function>(b.finish(std::array{f}));
    return s;
}
scene::Isosurface noisy_ball() {
    return isosurface_of([](Number x, Number y, Number z) {
        return sqrt(sqr(x) + sqr(y) + sqr(z)) - 0.8 + 0.4 * x.builder->noise(5 * x, 5 * y, 5 * z, 2);
    });
}

/// Both solids' surfaces along random rays are at the same places.
void expect_same_hits(const scene::Solid& found, const scene::Solid& wanted) {
    const auto a = compile_solid(found, 0), b = compile_solid(wanted, 0);
    RandomRays random(5);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const Ray ray = random.ray(3);
        const std::vector<Hit> x = all_hits(*a, ray), y = all_hits(*b, ray);
        ASSERT_EQ(x.size(), y.size()) << "ray " << i;
        for (std::size_t k = 0; k < x.size(); ++k) {
            ++hits;
            EXPECT_NEAR(x[k].t, y[k].t, 1e-7 * (1 + y[k].t)) << "ray " << i;
            EXPECT_GT(dot(x[k].normal, y[k].normal), 0.999) << "ray " << i;
        }
    }
    EXPECT_GT(hits, 200);
}

// A root that is missed, doubled or misplaced; a normal that isn't the gradient.
TEST(Isosurface, AgreesWithExactShapes) {
    expect_same_hits(
        solid_of(isosurface_of([](Number x, Number y, Number z) { return sqrt(sqr(x) + sqr(y) + sqr(z)) - 0.7; })),
        solid_of(scene::SolidSphere{{}, 0.7}));
    expect_same_hits(solid_of(isosurface_of([](Number x, Number y, Number z) {
                         return sqr(sqrt(sqr(x) + sqr(z)) - 0.6) + sqr(y) - 0.04;
                     })),
                     solid_of(scene::Torus{0.6, 0.2}));
    // Caps: what the container cuts is closed.
    expect_same_hits(solid_of(isosurface_of([](Number x, Number, Number) { return x - 0.25; })),
                     solid_of(scene::SolidBox{{-1, -1, -1}, {0.25, 1, 1}}));
}

// A thin slab that steps along the ray would pass over, however they are chosen.
TEST(Isosurface, ThinSlabsHaveNoHoles) {
    expect_same_hits(
        solid_of(isosurface_of([](Number x, Number y, Number) { return 1e6 * abs(x + 0.3 * y - 0.2) - 1; })), [] {
            const double tilt = std::sqrt(1.09);
            std::vector<SolidPointer> parts{
                pointer_to(scene::SolidBox{{-1, -1, -1}, {1, 1, 1}}),
                pointer_to(scene::HalfSpace{Vec3d{1, 0.3, 0} / tilt, (0.2 + 1e-6) / tilt}),
                pointer_to(scene::HalfSpace{Vec3d{-1, -0.3, 0} / tilt, (-0.2 + 1e-6) / tilt})};
            return *intersected(parts);
        }());
}

// Crossings that don't fit inside(), normals that point inwards, hits beyond the bounds.
TEST(Isosurface, KeepsThePropertiesOfSolids) {
    expect_solid_properties(solid_of(noisy_ball()), 11);
    expect_normals_agree(solid_of(noisy_ball()), 12);
    scene::Isosurface waves =
        isosurface_of([](Number x, Number y, Number z) { return y - 0.3 * sin(9 * x) * cos(7 * z); });
    waves.in_sphere = true;
    waves.radius = 0.9;
    expect_solid_properties(solid_of(waves), 13);
}

// A function that never settles, or has no value, must not hang the ray.
TEST(Isosurface, HostileFunctionsEnd) {
    const auto ends = [](const scene::Isosurface& s) {
        const auto solid = compile_solid(solid_of(s), 0);
        RandomRays random(3);
        for (int i = 0; i < 50; ++i) all_hits(*solid, random.ray(2));
    };
    ends(isosurface_of([](Number x, Number y, Number z) { return sin(1 / (x * y * z)); }));
    ends(isosurface_of([](Number x, Number y, Number) { return sqrt(x - 5) + y; }));
    ends(isosurface_of([](Number x, Number, Number) { return 0 * x; }));
}

}  // namespace
}  // namespace sundog::solids::tests
