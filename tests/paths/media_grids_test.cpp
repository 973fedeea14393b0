// SPDX-License-Identifier: Apache-2.0
// Paths in media whose bounds have a grid, beside the same paths by one bound.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "scenes/media_builder.h"

namespace sundog {
namespace {

using namespace test;

/// A ragged ball of radius 0.4 about (0, 0.5, 0), no denser than 2.
scene::Medium ragged(scene::Medium medium) {
    auto density = std::make_shared<scene::Pigment>();
    density->kind = scene::Pigment::Kind::mapped;
    density->pattern.kind = scene::Pattern::Kind::spherical;
    density->pattern.turbulence = {0.4, 0.4, 0.4};
    density->pattern.octaves = 2;
    density->pattern.pattern_from_texture = {{2.5, 0, 0}, {0, 2.5, 0}, {0, 0, 2.5}, {0, -1.25, 0}};
    density->entries = {
        {0.2F, {0, 0, 0, 0, 0}, nullptr}, {0.5F, {1, 1, 1, 0, 0}, nullptr}, {1, {2, 2, 2, 0, 0}, nullptr}};
    medium.densities = {density};
    return medium;
}

scene::Scene box_of(std::vector<scene::Medium> media) {
    scene::Scene scene = empty_scene();
    scene.sky = {1, 1, 1};
    add_shape(scene, scene::Box{{-0.6F, 0.05F, -0.6F}, {0.6F, 0.95F, 0.6F}},
              add_material(scene, clear_material(std::move(media))));
    return scene;
}

FrameOptions path_options() {
    FrameOptions options = size(16, 16);
    options.integrator = kernel::INTEGRATOR_PATH;
    options.max_depth = 200;
    options.camera = narrow_camera(0.4F);
    return options;
}

/// Means of many pictures: red, green, blue and their squares.
struct Means {
    std::array<double, 3> mean{}, variance{};
};

Means means_of(Device& device, const scene::Scene& scene, bool grids) {
    constexpr int kPictures = 12;
    const auto compiled = compile(scene, {}, grids);
    device.load(compiled);
    std::array<double, 3> sum{}, squares{};
    for (std::uint32_t seed = 1; seed <= kPictures; ++seed) {
        FrameOptions options = path_options();
        options.seed = seed;
        const PixelRect all{0, 0, 16, 16};
        Film film(all, 0);
        device.render(make_frame(scene, *compiled, options), {all, 0, 8}, film, {});
        std::array<double, 3> picture{};
        for (int y = 0; y < 16; ++y) {
            for (int x = 0; x < 16; ++x) {
                const Vec3 c = film.mean(x, y);
                picture[0] += c.x / 256.0, picture[1] += c.y / 256.0, picture[2] += c.z / 256.0;
            }
        }
        for (std::size_t i = 0; i < 3; ++i) sum[i] += picture[i], squares[i] += picture[i] * picture[i];
    }
    Means out;
    for (std::size_t i = 0; i < 3; ++i) {
        out.mean[i] = sum[i] / kPictures;
        out.variance[i] = (squares[i] / kPictures - out.mean[i] * out.mean[i]) / (kPictures - 1);
    }
    return out;
}

bool has_grid(const scene::Scene& scene) {
    const auto with = compile(scene, {}), without = compile(scene, {}, false);
    return with->code.size() > without->code.size();
}

// Light that is scattered, absorbed in a colour, added and dimmed on its way to a lamp is as much with a grid as
// without one, within four standard deviations. Catches parts of media that walks never look at, and weights that are
// off where bounds change.
TEST(PathsThroughMediaGrids, AreAsBrightAsByOneBound) {
    scene::Medium cloud = ragged(scattering(0));
    cloud.scattering = {8, 4, 2};
    cloud.absorption = {0, 3, 2};
    scene::Medium glow = ragged(emitting(0));
    glow.emission = {0, 0.5F, 2};
    const std::array scenes{box_of({cloud}), box_of({cloud, glow}), box_of({ragged(absorbing(4))}), box_of({glow})};
    for (const scene::Scene& dark : scenes) {
        scene::Scene scene = dark;
        scene.sky = {0.5F, 0.5F, 0.5F};
        add_light(scene, scene::Light::Kind::lamp, {3, -4, 2}, {3, 3, 3});
        ASSERT_TRUE(has_grid(scene));
        const auto device = make_cpu_device({.threads = 2});
        const Means with = means_of(*device, scene, true), without = means_of(*device, scene, false);
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_LT(std::abs(with.mean[i] - without.mean[i]),
                      4 * std::sqrt(with.variance[i] + without.variance[i]) + 1e-5)
                << "channel " << i << ": " << with.mean[i] << " and " << without.mean[i];
    }
}

// A dense white cloud is invisible in even light. Catches light that is lost or won at the cells' sides, where it would
// add up from one scattering to the next.
TEST(PathsThroughMediaGrids, LeaveAWhiteCloudInvisible) {
    const scene::Scene scene = box_of({ragged(scattering(25))});
    ASSERT_TRUE(has_grid(scene));
    const auto device = make_cpu_device({.threads = 2});
    const Means means = means_of(*device, scene, true);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(means.mean[i], 1, 0.005);
}

// One thread draws the bits that four do, and the grid that four threads make is one thread's. Catches cells that are
// filled by who comes first.
TEST(PathsThroughMediaGrids, DontDependOnThreads) {
    const scene::Scene scene = box_of({ragged(scattering(10))});
    EXPECT_EQ(compile(scene, {})->code, compile(scene, {})->code);
    const auto draw = [&](int threads) {
        return render_on(*make_cpu_device({.threads = threads}), scene, path_options(), 8).film;
    };
    const Film a = draw(1), b = draw(4);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) ASSERT_EQ(a.mean(x, y), b.mean(x, y)) << x << ' ' << y;
}

}  // namespace
}  // namespace sundog
