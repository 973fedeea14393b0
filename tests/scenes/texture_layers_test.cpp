// SPDX-License-Identifier: Apache-2.0
// Textures of layers, shaped lights and fog, where POV-Ray's reference gives the radiance in closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/scene_builder.h"

namespace sundog {
namespace {

using namespace test;

scene::TextureLayer layer(scene::PigmentColor color, const scene::Finish& finish) {
    auto pigment = std::make_shared<scene::Pigment>();
    pigment->color = color;
    return {pigment, finish};
}

/// Shows its pigment alone.
scene::Finish glowing(float reflection = 0) {
    scene::Finish finish;
    finish.ambient = {1, 1, 1};
    finish.diffuse = 0;
    finish.reflection_min = finish.reflection_max = {reflection, reflection, reflection};
    return finish;
}

scene::Finish diffuse(float share) {
    scene::Finish finish;
    finish.ambient = {0, 0, 0};
    finish.diffuse = share;
    return finish;
}

scene::Material textured(std::vector<scene::TextureLayer> layers, scene::Interior interior = {}) {
    scene::Material material;
    auto texture = std::make_shared<scene::LayeredTexture>();
    texture->layers = std::move(layers);
    material.patterned->texture = texture;
    material.patterned->interior = std::make_shared<const scene::Interior>(std::move(interior));
    return material;
}

/// A wall across the view at depth y.
void add_wall(scene::Scene& s, float y, const scene::Material& material) {
    const scene::Index m = add_material(s, material);
    add_quad(s, {-99, y, -99}, {99, y, -99}, {99, y, 99}, {-99, y, 99}, m);
}

class TextureLayers : public testing::Test {
protected:
    scene::Scene scene_ = [] {
        scene::Scene s = empty_scene();
        s.ambient = {1, 1, 1};
        s.sky = {0.8F, 0.6F, 0.4F};
        return s;
    }();
    Vec3 middle(FrameOptions options = size(9, 9)) {
        return render_on(*device_, scene_, options).film.mean(*options.width / 2, *options.height / 2);
    }
    void expect_middle(Vec3 want, float tolerance = 1e-5F) {
        const Vec3 got = middle();
        EXPECT_NEAR(got.x, want.x, tolerance);
        EXPECT_NEAR(got.y, want.y, tolerance);
        EXPECT_NEAR(got.z, want.z, tolerance);
    }

private:
    std::unique_ptr<Device> device_ = make_cpu_device({.threads = 2});
};

// A pigment c with filter f and transmit t over the sky s shows c(1-f-t) + s(cf + t). Catches filtered light that isn't
// tinted, or transmitted light that is.
TEST_F(TextureLayers, FilterTintsAndTransmitDoesNot) {
    add_wall(scene_, 4, textured({layer({0.5F, 0.2F, 0.1F, 0.6F, 0.3F}, glowing())}));
    expect_middle({0.05F + 0.8F * 0.6F, 0.02F + 0.6F * 0.42F, 0.01F + 0.4F * 0.36F});
}

// An opaque layer under one that lets 0.5*0.6+0.3 of red through. Catches layers in the wrong order.
TEST_F(TextureLayers, UpperLayersLieOverLowerOnes) {
    add_wall(scene_, 4,
             textured({layer({0.1F, 0.9F, 0.2F, 0, 0}, glowing()), layer({0.5F, 0.2F, 0.1F, 0.6F, 0.3F}, glowing())}));
    expect_middle({0.05F + 0.1F * 0.6F, 0.02F + 0.9F * 0.42F, 0.01F + 0.2F * 0.36F});
}

// Reflection adds to the surface's own light and to what passes, unless energy is conserved: then only 1 - r of what
// would pass does. Catches the classic mirror's convention (own light times 1 - r) applied to textures.
TEST_F(TextureLayers, ReflectionAddsUnlessEnergyIsConserved) {
    scene::Finish finish = glowing(0.5F);
    add_wall(scene_, 4, textured({layer({0.5F, 0.2F, 0.1F, 0, 0.6F}, finish)}));
    expect_middle({0.5F * 0.4F + 0.4F + 0.48F, 0.2F * 0.4F + 0.3F + 0.36F, 0.1F * 0.4F + 0.2F + 0.24F});
    finish.conserve_energy = true;
    scene_.materials[0] = textured({layer({0.5F, 0.2F, 0.1F, 0, 0.6F}, finish)});
    expect_middle({0.5F * 0.4F + 0.4F + 0.24F, 0.2F * 0.4F + 0.3F + 0.18F, 0.1F * 0.4F + 0.2F + 0.12F});
}

// A surface at the depth limit keeps its own light and nothing of what it reflects. Catches the classic convention (the
// last surface counts whole, and so brighter) and a lost own colour.
TEST_F(TextureLayers, TheDepthLimitCutsReflectionsOnly) {
    add_wall(scene_, 4, textured({layer({0.5F, 0.5F, 0.5F, 0, 0}, glowing(0.5F))}));
    FrameOptions options = size(9, 9);
    options.max_depth = 0;
    EXPECT_NEAR(middle(options).x, 0.5F, 1e-5F);
}

// Brilliance is an exponent of the cosine: 60 degrees and 3 give 1/8. Catches an exponent applied to the colour.
TEST_F(TextureLayers, BrillianceSharpensTheCosine) {
    scene::Finish finish = diffuse(0.8F);
    finish.brilliance = 3;
    add_wall(scene_, 4, textured({layer({1, 1, 1, 0, 0}, finish)}));
    add_light(scene_, scene::Light::Kind::sun, {0, -0.5F, std::sqrt(0.75F)});
    expect_middle({0.1F, 0.1F, 0.1F});
}

// Light fading: 2 / (1 + (d/fade_distance)^power), here d = 4, distance 2, power 2: 2/5. Catches falloff that starts at
// another distance.
TEST_F(TextureLayers, LightsFade) {
    add_wall(scene_, 4, textured({layer({1, 1, 1, 0, 0}, diffuse(1))}));
    add_light(scene_, scene::Light::Kind::lamp, {0, 0, 0});
    scene_.lights[0].fade_distance = 2;
    scene_.lights[0].fade_power = 2;
    expect_middle({0.4F, 0.4F, 0.4F});
}

// A spot of half angles 20 and 40 degrees: full on its axis, nothing at 45 degrees off it, and half way (in cosine)
// exactly half. Catches angles taken for whole ones, and an edge interpolated over the angle itself.
TEST_F(TextureLayers, SpotsFadeBetweenTheirCones) {
    add_wall(scene_, 4, textured({layer({1, 1, 1, 0, 0}, diffuse(1))}));
    add_light(scene_, scene::Light::Kind::spotlight, {0, 0, 0});
    scene_.lights[0].radius = 20;
    scene_.lights[0].falloff = 40;
    scene_.lights[0].point_at = {0, 1, 0};
    expect_middle({1, 1, 1});
    scene_.lights[0].point_at = {1, 1, 0};
    expect_middle({0, 0, 0});
    const float half = (std::cos(radians(20)) + std::cos(radians(40))) / 2;
    scene_.lights[0].point_at = {std::sqrt(1 - half * half), half, 0};
    expect_middle({0.5F, 0.5F, 0.5F}, 1e-4F);
}

// Fog of distance 4 before a glowing wall at 4: 1/e of the wall, 1 - 1/e of the fog. Catches a fog that dims but
// doesn't glow.
TEST_F(TextureLayers, FogDimsAndGlows) {
    add_wall(scene_, 4, textured({layer({1, 0.5F, 0, 0, 0}, glowing())}));
    scene::Fog fog;
    fog.distance = 4;
    fog.color = {0.2F, 0.3F, 0.4F, 0, 0};
    scene_.fogs.push_back(fog);
    const float clear = std::exp(-1.0F);
    expect_middle({clear + 0.2F * (1 - clear), 0.5F * clear + 0.3F * (1 - clear), 0.4F * (1 - clear)});
}

// A slab of clear, fading glass from 4 to 6: its far face is met from inside after 2 units, with fade_distance 2 and
// power 1: half. Catches fading counted from the eye, or outside of the glass.
TEST_F(TextureLayers, LightFadesInsideGlass) {
    scene::Interior interior;
    interior.fade_distance = 2;
    interior.fade_power = 1;
    const scene::Index glass = add_material(scene_, textured({layer({1, 1, 1, 1, 0}, diffuse(0))}, interior));
    add_shape(scene_, scene::Box{{-9, 4, -9}, {9, 6, 9}}, glass);
    expect_middle({0.4F, 0.3F, 0.2F});
}

// An area light of 4 by 1 lamps behind a screen that hides half of them: half of the light. Catches an area whose lamps
// all stand in its middle, or whose sum isn't a mean.
TEST_F(TextureLayers, AreaLightsAreHalfHidden) {
    add_wall(scene_, 4, textured({layer({1, 1, 1, 0, 0}, diffuse(1))}));
    add_light(scene_, scene::Light::Kind::lamp, {0, 0, 0});
    scene_.lights[0].area = scene::LightArea{{2, 0, 0}, {0, 0, 1}, 4, 1, -1, false, false, false};
    expect_middle({1, 1, 1});
    const scene::Index screen = add_material(scene_, matt({0, 0, 0}));
    add_shape(scene_, scene::Box{{-9, -1.5F, -9}, {-0.1F, 0.5F, 9}}, screen);
    scene_.objects.back().seen_by_camera = false;
    expect_middle({0.5F, 0.5F, 0.5F});
    scene_.lights[0].area->adaptive = 0;  // the corners disagree, so all are asked
    expect_middle({0.5F, 0.5F, 0.5F});
    scene_.objects.back().casts_shadow = false;
    expect_middle({1, 1, 1});
}

// A sky sphere's pigment is asked in the direction of the ray: a gradient along y at y = 1 after a quarter of its map.
// Catches a sky looked up by position.
TEST_F(TextureLayers, SkySpheresAreAskedByDirection) {
    auto pigment = std::make_shared<scene::Pigment>();
    pigment->kind = scene::Pigment::Kind::mapped;
    pigment->pattern.axis = {0, 1, 0};
    pigment->pattern.pattern_from_texture.y = {0, 0.25, 0};
    pigment->entries = {{0, {0, 0, 0, 0, 0}, {}}, {1, {1, 0.5F, 0, 0, 0}, {}}};
    scene::SkySphere sky;
    sky.pigments.push_back(pigment);
    scene_.sky_spheres.push_back(sky);
    scene_.camera.origin = {50, 60, 70};
    expect_middle({0.25F, 0.125F, 0});
}

// Each light's matt light is darkened by up to crand, evenly: by half of it in the mean, over many pixels, and by
// another amount in each. Catches grain that depends on the number of threads, that is the same everywhere, or that all
// lights share (the spread of two lights' sum is then twice one's).
TEST_F(TextureLayers, GrainDarkensMattLightAtRandom) {
    scene::Finish finish = diffuse(0.6F);
    finish.crand = 0.4F;
    add_wall(scene_, 4, textured({layer({1, 1, 1, 0, 0}, finish)}));
    add_light(scene_, scene::Light::Kind::sun, {0, -1, 0});
    add_light(scene_, scene::Light::Kind::sun, {0, -1, 0});
    const auto first = make_cpu_device({.threads = 1});
    const auto second = make_cpu_device({.threads = 3});
    const Picture a = render_on(*first, scene_, size(64, 64));
    const Picture b = render_on(*second, scene_, size(64, 64));
    double sum = 0, squares = 0;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const float value = a.film.mean(x, y).x;
            ASSERT_EQ(value, b.film.mean(x, y).x);
            sum += value, squares += static_cast<double>(value) * value;
        }
    }
    const double mean = sum / 4096;
    EXPECT_NEAR(mean, 2 * (0.6 - 0.2), 0.01);
    EXPECT_NEAR(std::sqrt(squares / 4096 - mean * mean), 0.4 * std::sqrt(2.0 / 12), 0.01);
}

// Jittered lights of an area stand anywhere in their cells: under an edge across the light, neighbours see different
// shares of it, and the mean is that of the light as a whole. Catches steps, and lights that leave the area's cells.
TEST_F(TextureLayers, JitteredAreasMakeGrain) {
    add_wall(scene_, 4, textured({layer({1, 1, 1, 0, 0}, diffuse(1))}));
    const scene::Index black = add_material(scene_, textured({layer({0, 0, 0, 0, 0}, diffuse(0))}));
    add_quad(scene_, {0, 3, -99}, {99, 3, -99}, {99, 3, 99}, {0, 3, 99}, black);
    scene_.objects.back().seen_by_camera = false;
    add_light(scene_, scene::Light::Kind::sun, {0, -1, 0});
    scene_.lights[0].area = scene::LightArea{{0.5F, 0, 0}, {0, 0, 0.5F}, 2, 2};
    scene_.lights[0].area->jitter = true;
    // Lights at x = -1/4 and 1/4 of the distance 1, moved by up to 1/4: at x = 0 half of their light passes.
    FrameOptions options = size(64, 64);
    const Picture picture = render_on(*make_cpu_device({.threads = 2}), scene_, options);
    int different = 0;
    double sum = 0;
    for (int y = 0; y < 64; ++y) {
        different += picture.film.mean(33, y).x != picture.film.mean(33, y / 2).x;
        for (const int x : {31, 32}) sum += picture.film.mean(x, y).x;
    }
    EXPECT_GT(different, 8);
    EXPECT_NEAR(sum / 128, 0.5, 0.1);
}

// A film's thickness under turbulence t is stirred to 1 + t s times what is written, with s of the mean 0.98 and the
// standard deviation 0.59 of povray's pictures (of a plane of 300 by 300 units, 600 pixels wide). Catches films that
// turbulence leaves even, or stirs by another amount.
TEST_F(TextureLayers, TurbulenceStirsFilms) {
    scene::Finish finish = diffuse(1);
    finish.irid = 0.5F, finish.irid_thickness = 0.02F, finish.irid_turbulence = 0.4F;
    scene_.projection_camera.emplace();
    scene_.projection_camera->kind = scene::ProjectionCamera::Kind::orthographic;
    scene_.projection_camera->location = {0, 0, 0};
    scene_.projection_camera->direction = {0, 1, 0};
    scene_.projection_camera->right = {300, 0, 0};
    scene_.projection_camera->up = {0, 0, 300};
    add_shape(scene_, scene::Plane{{0, -1, 0}, -4},
              add_material(scene_, textured({layer({0.5F, 0.5F, 0.5F, 0, 0}, finish)})));
    add_light(scene_, scene::Light::Kind::sun, {0, -1, 0});
    constexpr int kSide = 200;
    const Film film = render_on(*make_cpu_device({.threads = 2}), scene_, size(kSide, kSide)).film;
    double sum = 0;
    double squares = 0;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            // Blue light's phase shift, and from that the thickness.
            const double cosine = std::clamp((static_cast<double>(film.mean(x, y).z) / 0.5 - 1) / 0.5, -1.0, 1.0);
            const double stirred = (std::acos(cosine) / (2 * std::numbers::pi * 2 * 0.02 / 0.48) - 1) / 0.4;
            sum += stirred, squares += stirred * stirred;
        }
    }
    const double mean = sum / (kSide * kSide);
    EXPECT_NEAR(mean, 0.983, 0.02);
    EXPECT_NEAR(std::sqrt(squares / (kSide * kSide) - mean * mean), 0.592, 0.02);
}

// The spectrum's colours add up to white, however many there are: what is behind a plane sheet keeps its colour.
// Catches light that is lost or counted twice where it splits.
TEST_F(TextureLayers, DispersedColorsAddUpToWhite) {
    scene::Interior interior;
    interior.ior = 1.4F;
    interior.dispersion = 1.3F;
    for (const int samples : {2, 7, 50}) {
        interior.dispersion_samples = samples;
        scene::Scene s = scene_;
        s.sky = {0.8F, 0.6F, 0.4F};
        add_shape(s, scene::Box{{-9, 4, -9}, {9, 5, 9}},
                  add_material(s, textured({layer({1, 1, 1, 0, 1}, glowing())}, interior)));
        FrameOptions options = size(9, 9);
        const Vec3 seen = render_on(*make_cpu_device({.threads = 1}), s, options).film.mean(2, 4);
        EXPECT_NEAR(seen.x, 0.8F, 1e-4F) << samples;
        EXPECT_NEAR(seen.y, 0.6F, 1e-4F) << samples;
        EXPECT_NEAR(seen.z, 0.4F, 1e-4F) << samples;
    }
}

}  // namespace
}  // namespace sundog
