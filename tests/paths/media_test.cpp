// SPDX-License-Identifier: Apache-2.0
// Paths in media, where their radiance is known in closed form; each derivation stands with its test.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "scenes/media_builder.h"

namespace sundog {
namespace {

using namespace test;

/// A density that rises from 0 at y = 0 to `most` at y = 1.
scene::Medium rising(scene::Medium medium, float most) {
    auto density = std::make_shared<scene::Pigment>();
    density->kind = scene::Pigment::Kind::mapped;
    density->pattern.kind = scene::Pattern::Kind::gradient;
    density->pattern.axis = {0, 1, 0};
    density->entries = {{0, {0, 0, 0, 0, 0}, nullptr}, {1, {most, most, most, 0, 0}, nullptr}};
    medium.densities = {density};
    return medium;
}

/// A grid of densities from 0 to 1 over the unit cube, with a hole.
scene::Medium gridded(scene::Medium medium) {
    auto density = std::make_shared<scene::Pigment>();
    density->kind = scene::Pigment::Kind::mapped;
    density->pattern.kind = scene::Pattern::Kind::density_file;
    density->pattern.interpolation = 1;
    auto grid = std::make_shared<scene::DensityGrid>();
    grid->size = {3, 3, 3};
    grid->values.assign(27, 1.0F);
    grid->values[13] = 0;
    density->pattern.density = grid;
    density->entries = {{0, {0, 0, 0, 0, 0}, nullptr}, {1, {1, 1, 1, 0, 0}, nullptr}};
    medium.densities = {density};
    return medium;
}

class PathsInMedia : public testing::Test {
protected:
    PathsInMedia() {
        options_.integrator = kernel::INTEGRATOR_PATH;
        options_.max_depth = 200;
        options_.camera = narrow_camera(0.05F);
    }
    void add_box(Vec3 lower, Vec3 upper, std::vector<scene::Medium> media) {
        add_shape(scene_, scene::Box{lower, upper}, add_material(scene_, clear_material(std::move(media))));
    }
    float mean(std::uint32_t samples) {
        const Film film = render_on(*device_, scene_, options_, samples).film;
        double sum = 0;
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x) sum += film.mean(x, y).x;
        return static_cast<float>(sum / 256);
    }

    scene::Scene scene_ = [] {
        scene::Scene s = empty_scene();
        s.sky = {1, 1, 1};
        return s;
    }();
    FrameOptions options_ = size(16, 16);
    std::unique_ptr<Device> device_ = make_cpu_device({.threads = 2});
};

// Beer's law where density is the same everywhere, to rounding. Catches a way that is counted twice.
TEST_F(PathsInMedia, AbsorbByTheWay) {
    add_box({-50, 2, -50}, {50, 5, 50}, {absorbing(0.25F)});
    EXPECT_NEAR(mean(1), std::exp(-0.75F), 2e-3F);
}

// A density that rises from 0 to 4 over a way of 1 is 2 on average. Catches a bound of densities that is too low, and
// tracking that is biased.
TEST_F(PathsInMedia, AbsorbByTheMeanOfWhatVaries) {
    add_box({-5, 0.001F, -5}, {5, 0.999F, 5}, {rising(absorbing(0.5F), 4)});
    EXPECT_NEAR(mean(256), std::exp(-1.0F), 0.01F);
}

// Along the way s of a medium that shines with e and absorbs a: e (1 - exp(-a s)) / a.
TEST_F(PathsInMedia, ShineAndAbsorb) {
    scene_.sky = {0, 0, 0};
    scene::Medium medium = absorbing(0.5F);
    medium.emission = {2, 2, 2};
    add_box({-50, 2, -50}, {50, 5, 50}, {medium});
    const float want = 2 * (1 - std::exp(-1.5F)) / 0.5F;
    EXPECT_NEAR(mean(256), want, 0.01F * want);
}

// One that absorbs nothing: e s.
TEST_F(PathsInMedia, ShineAlone) {
    scene_.sky = {0, 0, 0};
    add_box({-50, 2, -50}, {50, 5, 50}, {emitting(0.7F)});
    EXPECT_NEAR(mean(256), 2.1F, 0.02F);
}

// A white furnace: what scatters all light and loses none is invisible before an even sky, whatever its phase function
// and density. Catches particles that gain or lose light, directions that are drawn by another law than counted with,
// and light that is scattered but once.
TEST_F(PathsInMedia, WhiteParticlesAreInvisibleInEvenLight) {
    const scene::Medium all[] = {
        scattering(3),          scattering(3, 2),        scattering(3, 3),         scattering(3, 4),
        scattering(3, 5, 0.6F), scattering(3, 5, -0.4F), rising(scattering(2), 3), gridded(scattering(6))};
    for (const scene::Medium& medium : all) {
        scene_.objects.clear();
        scene_.materials.clear();
        add_box({-0.6F, 0.1F, -0.6F}, {0.6F, 0.95F, 0.6F}, {medium});
        EXPECT_NEAR(mean(64), 1, 0.01F) << "type " << medium.scattering_type;
    }
}

// The same inside of a shining ball, which is aimed at from each particle through the medium's own boundary. Catches
// light that is both aimed at and met, through surfaces that don't bend it, and counted twice or not at all.
TEST_F(PathsInMedia, WhiteParticlesAreInvisibleInAShiningBall) {
    scene_.sky = {0, 0, 0};
    scene::Material shell = matt({0, 0, 0});
    shell.mtl->emission = {1, 1, 1};
    add_shape(scene_, scene::Sphere{{0, 0.5F, 0}, 5}, add_material(scene_, shell));
    for (const scene::Medium& medium : {scattering(3), scattering(3, 5, 0.6F), gridded(scattering(6))}) {
        add_box({-0.6F, 0.1F, -0.6F}, {0.6F, 0.95F, 0.6F}, {medium});
        EXPECT_NEAR(mean(64), 1, 0.01F) << "type " << medium.scattering_type;
        scene_.objects.pop_back();
    }
}

// Colours of their own: red is scattered, green absorbed, blue passes. In even light that is 1, exp(-s) and 1. Catches
// colours that share a path and aren't weighed each by its own chance.
TEST_F(PathsInMedia, ColorsGoTheirOwnWays) {
    scene::Medium medium;
    medium.scattering = {1, 0, 0};
    medium.absorption = {0, 0.5F, 0};
    add_box({-20, 1, -20}, {20, 3, 20}, {medium});
    const Film film = render_on(*device_, scene_, options_, 256).film;
    Vec3 sum{0, 0, 0};
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) sum = sum + film.mean(x, y) * (1 / 256.0F);
    EXPECT_NEAR(sum.x, 1, 0.02F);
    EXPECT_NEAR(sum.y, std::exp(-1.0F), 0.02F);
    EXPECT_NEAR(sum.z, 1, 0.02F);
}

// In thin media light is scattered once. A lamp's is then what Whitted's integrator has, over four times the mean of
// povray's phase function, which isn't normalised. Catches a phase function whose measure is another, and lamps that
// reach particles through none or all of the medium.
TEST_F(PathsInMedia, ThinOnesAreThoseOfWhitted) {
    scene_.sky = {0, 0, 0};
    add_light(scene_, scene::Light::Kind::lamp, {3, 4, 2}, {50, 50, 50});
    const std::array means{1.0F, 1.1533F, 1.2468F, 1.0658F, 1.0F};
    for (const int type : {1, 2, 3, 4, 5}) {
        scene_.objects.clear();
        scene_.materials.clear();
        scene::Medium medium = scattering(0.01F, type, 0.5F);
        medium.method = 2;
        medium.samples = medium.samples_most = 100;
        add_box({-2, 2, -2}, {2, 6, 2}, {medium});
        options_.integrator = kernel::INTEGRATOR_WHITTED;
        const float whitted = mean(1);
        options_.integrator = kernel::INTEGRATOR_PATH;
        const float want = whitted / (4 * means.at(static_cast<std::size_t>(type - 1)));
        EXPECT_NEAR(mean(1024), want, 0.04F * want) << type;
    }
}

}  // namespace
}  // namespace sundog
