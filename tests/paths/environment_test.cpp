// SPDX-License-Identifier: Apache-2.0
// Light from a picture of all directions.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/environment.h"
#include "scenes/scene_builder.h"

namespace sundog {
namespace {

using namespace test;

/// A dim sky with a bright patch of one pixel's size `elevation` rows over the horizon, straight ahead and a little to
/// the right.
scene::Environment sky_with_a_sun(float dim, float bright, std::uint32_t column, std::uint32_t row) {
    scene::Environment e;
    e.width = 64;
    e.height = 32;
    e.radiance.assign(64 * 32, Vec3{dim, dim, dim});
    e.radiance[row * 64 + column] = {bright, bright, bright};
    return e;
}

double mean_red(const Film& film) {
    double sum = 0;
    for (int y = film.bounds.y0; y < film.bounds.y1; ++y)
        for (int x = film.bounds.x0; x < film.bounds.x1; ++x) sum += film.mean(x, y).x;
    return sum / (film.bounds.width() * film.bounds.height());
}

scene::Scene floor_under(const scene::Environment& environment) {
    scene::Scene s = empty_scene();
    scene::hang(environment, 0, s);
    add_shape(s, scene::Plane{{0, 0, 1}, -1}, add_material(s, matt({1, 1, 1})));
    return s;
}

FrameOptions looking_down(std::uint32_t integrator) {
    FrameOptions options = size(16, 16);
    options.integrator = integrator;
    options.max_depth = 1;
    kernel::Camera down{};
    down.center = {0, 0, -1};
    down.right = {0.1F, 0, 0};
    down.up = {0, 0.1F, 0};
    options.camera = down;
    return options;
}

// Rays that miss see the picture where it hangs, with both integrators. Catches pictures that are mirrored or turned.
TEST(EnvironmentLight, IsSeenWhereItHangs) {
    scene::Scene s = empty_scene();
    const scene::Environment picture = sky_with_a_sun(0.25F, 9, 36, 14);
    scene::hang(picture, 0, s);
    const Vec3 toward = scene::direction_in(*s.environment, 36.5F / 64, 14.5F / 32);
    const auto device = make_cpu_device({.threads = 1});
    for (const std::uint32_t integrator : {kernel::INTEGRATOR_WHITTED, kernel::INTEGRATOR_PATH}) {
        FrameOptions options = size(1, 1);
        options.integrator = integrator;
        kernel::Camera at{};
        at.center = {toward.x, toward.y, toward.z};
        at.right = {1e-5F, 0, 0};
        at.up = {0, 0, 1e-5F};
        options.camera = at;
        EXPECT_NEAR(render_on(*device, s, options).film.mean(0, 0).x, 9, 0.05F);
        at.center = {-toward.x, toward.y, toward.z};
        options.camera = at;
        EXPECT_NEAR(render_on(*device, s, options).film.mean(0, 0).x, 0.25F, 1e-4F);
    }
}

// A white floor under it: radiance is the integral of what is over the horizon, by the cosine, over pi. The bright
// pixel is aimed at, the rest mostly met. Catches densities that don't belong to the directions drawn.
TEST(EnvironmentLight, LightsAFloorAsItsIntegralSays) {
    const scene::Environment picture = sky_with_a_sun(0.25F, 4000, 40, 6);
    const scene::Scene s = floor_under(picture);
    // Between the middles of pixels radiance is interpolated: the bright one's share is that of a pyramid.
    double want = 0;
    constexpr int kSteps = 2000;
    for (int row = 0; row < kSteps; ++row) {
        const double down = (row + 0.5) / kSteps * 1.57079633;
        const double y = down / 3.14159265 * 32 - 0.5;
        const double tall = std::max(0.0, 1 - std::abs(y - 6));
        // Over all columns: the pyramid's width is one pixel.
        const double around = 0.25 * 6.28318531 + (4000 - 0.25) * tall * 6.28318531 / 64;
        want += around * std::cos(down) * std::sin(down) * 1.57079633 / kSteps;
    }
    want /= 3.14159265;
    const auto device = make_cpu_device({.threads = 2});
    const Film film = render_on(*device, s, looking_down(kernel::INTEGRATOR_PATH), 256).film;
    EXPECT_NEAR(mean_red(film), want, 0.01 * want);
}

}  // namespace
}  // namespace sundog
