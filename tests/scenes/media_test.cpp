// SPDX-License-Identifier: Apache-2.0
// Media where their radiance has a closed form, or povray's way of stepping gives the very number.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "scenes/media_builder.h"

namespace sundog {
namespace {

using namespace test;

class MediaScene : public testing::Test {
protected:
    float middle() {
        const std::unique_ptr<Device> device = make_cpu_device({.threads = 1});
        return render_on(*device, scene_, size(9, 9)).film.mean(4, 4).x;
    }
    void add_box(float y0, float y1, const scene::Material& material) {
        add_shape(scene_, scene::Box{{-50, y0, -50}, {50, y1, 50}}, add_material(scene_, material));
    }
    scene::Scene scene_ = [] {
        scene::Scene s = empty_scene();
        s.sky = {1, 1, 1};
        s.settings.max_depth = 20;
        return s;
    }();
};

// Beer's law through a box; catches a segment that is counted twice, or not, and a medium that goes on behind it.
TEST_F(MediaScene, ABoxAbsorbsByItsDepth) {
    add_box(2, 5, clear_material({absorbing(0.25F)}));
    EXPECT_NEAR(middle(), std::exp(-0.75F), 1e-4F);
}

// Where two insides overlap both absorb, whichever is left first.
TEST_F(MediaScene, OverlappingInsidesAddUp) {
    add_box(2, 5, clear_material({absorbing(0.25F)}));
    add_box(4, 8, clear_material({absorbing(0.5F)}));
    EXPECT_NEAR(middle(), std::exp(-0.75F - 2.0F), 1e-4F);
}

// The eye may be in a medium from the start.
TEST_F(MediaScene, TheEyeIsInsideABox) {
    add_box(-1, 3, clear_material({absorbing(0.5F)}));
    EXPECT_NEAR(middle(), std::exp(-1.5F), 1e-4F);
}

// No medium is in what isn't hollow: not the atmosphere, nor what it stands in, nor such an object's own.
TEST_F(MediaScene, WhatIsNotHollowDisplacesMedia) {
    scene_.sky = {0, 0, 0};
    scene_.atmosphere.push_back(absorbing(0.1F));
    scene::Material wall = matt({0, 0, 0});
    wall.mtl->emission = {1, 1, 1};
    add_quad(scene_, {-99, 9, -99}, {99, 9, -99}, {99, 9, 99}, {-99, 9, 99}, add_material(scene_, wall));
    EXPECT_NEAR(middle(), std::exp(-0.9F), 1e-4F);
    add_box(2, 5, clear_material({absorbing(7)}, false));
    EXPECT_NEAR(middle(), std::exp(-0.6F), 1e-4F);
    scene_.objects.pop_back();
    add_box(2, 5, clear_material({}, true));
    EXPECT_NEAR(middle(), std::exp(-0.9F), 1e-4F);
}

// Povray's third way of sampling takes 7 samples where 10 are asked for, and dims each stretch's light by the media
// before it alone: 0.3431 for 0.5 emitted and 1 absorbed (a picture of povray 3.7).
TEST_F(MediaScene, EmissionIsSteppedAsByPovray) {
    scene_.sky = {0, 0, 0};
    scene::Medium medium = emitting(0.5F);
    medium.absorption = {1, 1, 1};
    add_box(2, 3, clear_material({medium}));
    EXPECT_NEAR(middle(), 0.3431F, 1e-4F);
}

// By the second way, in the middles of even steps: 0.3152 of four.
TEST_F(MediaScene, TheSecondMethodStepsEvenly) {
    scene_.sky = {0, 0, 0};
    scene::Medium medium = emitting(0.5F);
    medium.absorption = {1, 1, 1};
    medium.method = 2;
    medium.samples = medium.samples_most = 4;
    add_box(2, 3, clear_material({medium}));
    EXPECT_NEAR(middle(), 0.3152F, 1e-4F);
}

// Random samples of the first way: as many as povray takes (by its statistics) until the variance of light that grows
// from 0 to 1 is small enough, all of them where it never is, and the least where all are the same. Catches samples
// that end too soon, or don't end; a mean over another number than was taken.
TEST_F(MediaScene, TheFirstMethodSamplesUntilItIsSure) {
    scene_.sky = {0, 0, 0};
    scene_.projection_camera.emplace();
    scene_.projection_camera->kind = scene::ProjectionCamera::Kind::orthographic;
    scene_.projection_camera->direction = {0, 1, 0};
    scene_.projection_camera->up = {0, 0, 1};
    add_light(scene_, scene::Light::Kind::sun, {0, 0, 1});
    constexpr int kSide = 32;
    const auto sampled = [&](float variance, bool varies) {
        scene::Medium medium;
        medium.scattering = {1, 1, 1};
        medium.extinction = 0;
        medium.method = 1;
        medium.samples = 4, medium.samples_most = 200;
        medium.variance = variance;
        auto density = std::make_shared<scene::Pigment>();
        density->kind = scene::Pigment::Kind::mapped;
        density->pattern.axis = {0, 1, 0};
        density->entries = {{0, {varies ? 0.0F : 0.5F, 0.5F, 0.5F, 0, 0}, {}},
                            {1, {varies ? 1.0F : 0.5F, 0.5F, 0.5F, 0, 0}, {}}};
        medium.densities.push_back(density);
        scene_.objects.clear();
        add_box(2, 3, clear_material({medium}));
        const Picture picture = render_on(*make_cpu_device({.threads = 2}), scene_, size(kSide, kSide));
        for (int i = 0; i < kSide; ++i) EXPECT_NEAR(picture.film.mean(i, i).x, 0.5F, 0.05F) << variance;
        return static_cast<double>(picture.stats.shadow_rays) / (kSide * kSide);
    };
    EXPECT_NEAR(sampled(0.08F, true), 17.1, 2);
    EXPECT_NEAR(sampled(0.0078125F, true), 49.4, 5);
    EXPECT_NEAR(sampled(0.001F, true), 130.8, 13);
    EXPECT_EQ(sampled(0.00001F, true), 201);
    EXPECT_EQ(sampled(0.001F, false), 4);
}

// Scattering types' shares of light that comes back at 180 degrees, at 90 and at 0, as povray's pictures have them.
TEST_F(MediaScene, LightIsScatteredByItsAngle) {
    scene_.sky = {0, 0, 0};
    const auto share = [&](int type, float eccentricity, Vec3 to_light) {
        scene_.objects.clear();
        scene_.lights.clear();
        add_light(scene_, scene::Light::Kind::sun, to_light);
        scene::Medium medium;
        medium.scattering_type = type;
        medium.scattering = {0.05F, 0.05F, 0.05F};
        medium.eccentricity = eccentricity;
        medium.extinction = 0;
        add_box(2, 3, clear_material({medium}));
        return middle() * 20;
    };
    const Vec3 back{0, -1, 0}, side{0, 0, 1}, ahead{0, 1, 0};
    EXPECT_NEAR(share(1, 0, side), 1, 1e-3F);
    EXPECT_NEAR(share(2, 0, back), 0.5766F, 1e-3F);
    EXPECT_NEAR(share(2, 0, side), 0.5968F, 1e-3F);
    EXPECT_NEAR(share(2, 0, ahead), 5.766F, 1e-2F);
    EXPECT_NEAR(share(3, 0, back), 0.4958F, 1e-3F);
    EXPECT_NEAR(share(3, 0, ahead), 25.28F, 2e-2F);
    EXPECT_NEAR(share(4, 0, back), 1.5988F, 1e-3F);
    EXPECT_NEAR(share(4, 0, side), 0.7994F, 1e-3F);
    EXPECT_NEAR(share(5, 0.3F, back), 0.4142F, 1e-3F);
    EXPECT_NEAR(share(5, 0.3F, side), 0.7994F, 1e-3F);
}

// Light on its way to a surface is dimmed by an object's media, but by the atmosphere's only if it asks for that.
TEST_F(MediaScene, ShadowRaysAreDimmed) {
    scene_.sky = {0, 0, 0};
    add_quad(scene_, {-99, 9, -99}, {99, 9, -99}, {99, 9, 99}, {-99, 9, 99}, add_material(scene_, matt({1, 1, 1})));
    add_light(scene_, scene::Light::Kind::lamp, {0, 1, 0});
    const float open = middle();
    EXPECT_GT(open, 0.5F);
    scene_.atmosphere.push_back(absorbing(0.1F));
    EXPECT_NEAR(middle(), open * std::exp(-0.9F), 1e-4F) << "the eye's ray alone";
    scene_.lights[0].media_attenuation = true;
    EXPECT_NEAR(middle(), open * std::exp(-0.9F - 0.8F), 1e-3F);
    scene_.atmosphere.clear();
    add_box(2, 5, clear_material({absorbing(0.25F)}));
    EXPECT_NEAR(middle(), open * std::exp(-1.5F), 1e-3F);
    scene_.lights[0].place = {0, 3, 0};  // within the box
    EXPECT_NEAR(middle(), open * std::exp(-0.75F), 1e-3F) << "as in povray, not by what light is in itself";
}

// What has no shadows isn't scattered, as in povray.
TEST_F(MediaScene, LightWithoutShadowsIsNotScattered) {
    scene_.sky = {0, 0, 0};
    add_light(scene_, scene::Light::Kind::sun, {0, 0, 1});
    scene::Medium medium;
    medium.scattering = {0.1F, 0.1F, 0.1F};
    medium.extinction = 0;
    add_box(2, 3, clear_material({medium}));
    EXPECT_GT(middle(), 0.09F);
    scene_.lights[0].shadows = false;
    EXPECT_EQ(middle(), 0);
}

// Turbulence thins a fog out by noise times turb_depth, and by no more than a share of e^(-d/distance), as pictures of
// povray 3.7 show.
TEST_F(MediaScene, TurbulenceThinsFogOut) {
    scene_.sky = {0, 0, 0};
    scene::Material wall = matt({0, 0, 0});
    wall.mtl->emission = {1, 1, 1};
    add_quad(scene_, {-99, 9, -99}, {99, 9, -99}, {99, 9, 99}, {-99, 9, 99}, add_material(scene_, wall));
    scene::Fog fog;
    fog.distance = 10;
    fog.turb_depth = 1e6F;
    scene_.fogs = {fog};
    EXPECT_NEAR(middle(), std::exp(-0.9F), 1e-4F) << "without turbulence";
    scene_.fogs[0].turbulence = {1, 1, 1};
    EXPECT_NEAR(middle(), std::exp(-0.9F * (1 - std::exp(-0.9F))), 1e-4F) << "at its thinnest";
    scene_.fogs[0].turb_depth = 0.1F;
    EXPECT_GT(middle(), std::exp(-0.9F) + 1e-4F);
    EXPECT_LT(middle(), std::exp(-0.9F * (1 - 0.25F * std::exp(-0.9F)))) << "noise is 1 at most, the sum of octaves 2";
}

// A spot's cone is found however narrow it is against the ray's length.
TEST_F(MediaScene, ASpotsConeIsSampledWhereItCrosses) {
    scene_.sky = {0, 0, 0};
    add_light(scene_, scene::Light::Kind::cylinder, {0, 500, 10});
    scene_.lights[0].point_at = {0, 500, 0};
    scene_.lights[0].radius = scene_.lights[0].falloff = 0.5F;
    scene::Medium medium;
    medium.scattering = {0.5F, 0.5F, 0.5F};
    medium.extinction = 0;
    scene_.atmosphere.push_back(medium);
    EXPECT_NEAR(middle(), 0.5F, 0.01F);
}

}  // namespace
}  // namespace sundog
