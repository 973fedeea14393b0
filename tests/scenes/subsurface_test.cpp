// SPDX-License-Identifier: Apache-2.0
// Light below surfaces; each derivation stands with its test. Numbers "as in povray" are measured from its pictures of
// the same scenes.
#include <gtest/gtest.h>

#include <cmath>

#include "scenes/scene_builder.h"

namespace sundog {
namespace {

using namespace test;

/// The eye looks along +y; the light comes along it, too.
class SubsurfaceScene : public testing::Test {
protected:
    SubsurfaceScene() {
        scene_.subsurface.emplace();
        scene_.subsurface->samples = 400;
        scene_.subsurface->single_samples = 100;
        options_.camera = narrow_camera(0.02F);
    }
    static scene::Material wax(Vec3 color, Vec3 translucency, float ior = 1) {
        auto pigment = std::make_shared<scene::Pigment>();
        pigment->color = {color.x, color.y, color.z, 0, 0};
        auto texture = std::make_shared<scene::LayeredTexture>();
        texture->layers.push_back({pigment, {}});
        scene::Finish& finish = texture->layers[0].finish;
        finish.ambient = {0, 0, 0};
        finish.diffuse = 1;
        finish.translucency = translucency;
        scene::Material material;
        material.patterned->texture = texture;
        scene::Interior interior;
        interior.ior = ior;
        material.patterned->interior = std::make_shared<const scene::Interior>(interior);
        return material;
    }
    /// A block whose front is at y = 5, `thick` units thick.
    void add_block(Vec3 color, Vec3 translucency, float ior = 1, float thick = 20) {
        add_shape(scene_, scene::Box{{-20, 5, -20}, {20, 5 + thick, 20}},
                  add_material(scene_, wax(color, translucency, ior)));
    }
    void add_sun(Vec3 towards, Vec3 color = {1, 1, 1}) { add_light(scene_, scene::Light::Kind::sun, towards, color); }
    Film picture(Device& device) { return render_on(device, scene_, options_).film; }
    /// Over all pixels.
    Vec3 mean() {
        const Film film = picture(*device_);
        Vec3 sum{};
        for (int y = 0; y < film.bounds.height(); ++y)
            for (int x = 0; x < film.bounds.width(); ++x) sum += film.mean(x, y);
        return sum * (1.0F / static_cast<float>(film.bounds.width() * film.bounds.height()));
    }

    scene::Scene scene_ = empty_scene();
    FrameOptions options_ = size(16, 16);
    std::unique_ptr<Device> device_ = make_cpu_device({.threads = 2});
};

/// The reduced albedo of a medium without a boundary that reflects this much in all (its integral over the plane).
double albedo_of(double reflectance) {
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
        const double albedo = (low + high) / 2, s = std::sqrt(3 * (1 - albedo));
        (albedo / 2 * (1 + std::exp(-4.0 / 3 * s)) * std::exp(-s) < reflectance ? low : high) = albedo;
    }
    return low;
}

// Under even light a thick block reflects its colour diffusely, however far light goes below it, and a 24th of its
// albedo by single scattering head-on: povray's picture has 0.2306, 0.5392, 0.9413. Catches densities of samples that
// aren't theirs, light that is lost or counted twice, and a finish that shines on its own beside it.
TEST_F(SubsurfaceScene, AThickBlockReflectsItsColor) {
    const Vec3 color{0.2F, 0.5F, 0.9F};
    add_block(color, {0.5F, 0.5F, 0.5F});
    add_sun({0, -1, 0});
    const Vec3 even = mean();
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(even[c], color[c] + albedo_of(color[c]) / 24, 0.01F * color[c]) << c;
    scene_.objects.clear();
    // Channels of their own depths: each samples for the others, too.
    add_block(color, {0.2F, 0.5F, 2});
    const Vec3 mixed = mean();
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(mixed[c], color[c] + albedo_of(color[c]) / 24, 0.03F * color[c]) << c;
}

// A denser inside takes Fresnel's share at the way in and at the way out: 0.96 each at 1.5. In povray's picture 0.2131
// and 0.8663 for 0.2 and 0.9. Catches a boundary that counts once, and one that changes the total.
TEST_F(SubsurfaceScene, TheBoundaryTakesItsShareTwice) {
    add_block({0.02F, 0.2F, 0.9F}, {0.5F, 0.5F, 0.5F}, 1.5F);
    add_sun({0, -1, 0});
    const Vec3 light = mean();
    EXPECT_NEAR(light.x, 0.0252F, 0.001F);
    EXPECT_NEAR(light.y, 0.2131F, 0.002F);
    EXPECT_NEAR(light.z, 0.8663F, 0.009F);
}

// Light at 45 degrees: povray's picture has 0.147 and 0.6033. Catches angles that are taken on the wrong side.
TEST_F(SubsurfaceScene, SlantingLightIsRefracted) {
    add_block({0.02F, 0.2F, 0.9F}, {0.5F, 0.5F, 0.5F}, 1.5F);
    add_sun({0, -1, 1});
    const Vec3 light = mean();
    EXPECT_NEAR(light.y, 0.147F, 0.0015F);
    EXPECT_NEAR(light.z, 0.6033F, 0.007F);
}

// Behind the edge of a shadow, light that entered beside it comes out: in povray's picture of a medium of 0.1 units,
// colour 0.9 and no boundary 0.3146 and 0.1775 at 0.065 and 0.185 units from it. Catches lengths in other units, or of
// another meaning.
TEST_F(SubsurfaceScene, LightGoesIntoShadows) {
    add_block({0.9F, 0.9F, 0.9F}, {1, 1, 1});
    add_shape(scene_, scene::Box{{-20, 4, -20}, {0, 4.1F, 20}}, add_material(scene_, matt({0, 0, 0})));
    scene_.objects.back().seen_by_camera = false;
    add_sun({0, -1, 0});
    scene_.subsurface->samples = 3000;
    for (const auto& [away, expected] : {std::pair{0.065F, 0.3146F}, {0.185F, 0.1775F}}) {
        options_.camera->eye = {-away, 0, 0};
        options_.camera->right = {0.0002F, 0, 0};
        EXPECT_NEAR(mean().x, expected, 0.05F * expected) << away;
    }
}

// A white ball under even light from all sides reflects no more than it gets. Catches weights that make light.
TEST_F(SubsurfaceScene, ABallReflectsNoMoreThanItGets) {
    constexpr int kSuns = 60;
    for (int i = 0; i < kSuns; ++i) {
        const double z = 1 - (2 * i + 1.0) / kSuns, around = i * 2.399963, across = std::sqrt(1 - z * z);
        add_sun({static_cast<float>(across * std::cos(around)), static_cast<float>(across * std::sin(around)),
                 static_cast<float>(z)},
                Vec3{4, 4, 4} * (1.0F / kSuns));
    }
    scene_.subsurface->samples = 100;
    scene_.subsurface->single_samples = 20;
    options_.camera = narrow_camera(0.19F);
    add_shape(scene_, scene::Sphere{{0, 5, 0}, 1}, add_material(scene_, wax({1, 1, 1}, {0.3F, 3, 30}, 1.4F)));
    const Vec3 light = mean();
    for (std::size_t c = 0; c < 3; ++c) EXPECT_LE(light[c], 1) << c;
    EXPECT_GT(light.x, 0.7F);
    EXPECT_GT(light.y, 0.3F);
}

// A thin sheet that is lit on its back shines on its front, the more the thinner it is; a thick one doesn't. Catches
// rays that only look at one side.
TEST_F(SubsurfaceScene, LightComesThroughThinThings) {
    add_sun({0, 1, 0});
    float before = 0;
    for (const float thick : {5.0F, 0.2F, 0.1F}) {
        scene_.objects.clear();
        add_block({0.9F, 0.9F, 0.9F}, {1, 1, 1}, 1.3F, thick);
        const float light = mean().x;
        EXPECT_GE(light, before);
        before = light;
        if (thick > 1) {
            EXPECT_LT(light, 0.02F);
        }
    }
    EXPECT_GT(before, 0.1F);
    EXPECT_LT(before, 0.9F);
}

// What comes through a sheet of thickness d without a boundary: the dipole's integral over the back, whose places are
// sqrt(r^2 + d^2) away, and what is scattered once, albedo / 8 exp(-d/l) (1 - exp(-d/l)). Catches places that are cut
// off or are too near where a wall is thinner than the mean free path l.
TEST_F(SubsurfaceScene, ThinSheetsPassWhatTheDipoleSays) {
    scene_.subsurface->samples = 4000;
    add_sun({0, 1, 0});
    const double albedo = albedo_of(0.9), length = 0.1 * albedo, fading = std::sqrt(3 * (1 - albedo)) / length;
    for (const float thick : {0.1F, 0.02F}) {
        scene_.objects.clear();
        add_block({0.9F, 0.9F, 0.9F}, {1, 1, 1}, 1, thick);
        double expected = albedo / 8 * std::exp(-thick / length) * (1 - std::exp(-thick / length));
        constexpr double kStep = 1.01;
        for (double r = 1e-4; r < 100; r *= kStep) {
            double value = 0;
            for (const double source : {length, length * 7 / 3}) {
                const double way = std::sqrt(r * r * kStep + thick * thick + source * source);
                value += source * (1 + fading * way) * std::exp(-fading * way) / (way * way * way);
            }
            expected += albedo / 4 * value * r * r * (kStep * kStep - 1);
        }
        EXPECT_NEAR(mean().x, expected, 0.03 * expected) << thick;
    }
}

// Four times as large in a scene whose units are a quarter as long: the same picture, but for noise. Catches lengths
// that don't follow one of the two.
TEST_F(SubsurfaceScene, ScaleIsNothingButUnits) {
    add_sun({0, -1, 1});
    options_.camera = narrow_camera(0.19F);
    scene_.subsurface->samples = 800;
    add_shape(scene_, scene::Sphere{{0, 5, 0}, 1}, add_material(scene_, wax({0.9F, 0.7F, 0.4F}, {9, 3, 1}, 1.4F)));
    const Vec3 small = mean();
    scene_.objects.clear();
    add_shape(scene_, scene::Sphere{{0, 20, 0}, 4}, add_material(scene_, wax({0.9F, 0.7F, 0.4F}, {9, 3, 1}, 1.4F)));
    scene_.mm_per_unit /= 4;
    const Vec3 large = mean();
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(small[c], large[c], 0.01F * small[c]) << c;
    scene_.mm_per_unit *= 4;
    EXPECT_GT(std::fabs(mean().x - small.x), 0.02F * small.x) << "the picture says nothing of lengths";
}

// A surface that no other side closes is twice as bright, as in povray: a plane, a sheet. Catches rays that are counted
// though they found nothing.
TEST_F(SubsurfaceScene, OpenSurfacesAreTwiceAsBright) {
    add_shape(scene_, scene::Plane{{0, -1, 0}, -5}, add_material(scene_, wax({0.2F, 0.2F, 0.2F}, {0.5F, 0.5F, 0.5F})));
    add_sun({0, -1, 0});
    EXPECT_NEAR(mean().x, 0.4307F, 0.004F);
}

// What isn't asked for isn't there: by the frame, or a finish's translucency in a scene that has no `subsurface`.
// Catches surfaces that are black instead.
TEST_F(SubsurfaceScene, IsThereOnlyWhereTheSceneAsksForIt) {
    add_block({0.2F, 0.5F, 0.9F}, {0.5F, 0.5F, 0.5F}, 1.5F);
    add_sun({0, -1, 0});
    options_.subsurface = false;
    EXPECT_NEAR(mean().z, 0.9F, 1e-5F);
    options_.subsurface = true;
    scene_.subsurface.reset();
    EXPECT_NEAR(mean().z, 0.9F, 1e-5F);
    EXPECT_EQ(compile(scene_, {})->features & kernel::FEATURE_SUBSURFACE, 0U);
}

// Two sheets of a mesh, whose rims nothing closes, are all but a solid. Catches sides that are told from the winding of
// triangles.
TEST_F(SubsurfaceScene, MeshesOfAnyWinding) {
    const scene::Index material = add_material(scene_, wax({0.2F, 0.5F, 0.9F}, {0.5F, 0.5F, 0.5F}));
    for (const bool turned : {false, true}) {
        scene_.objects.clear();
        scene::Mesh mesh;
        mesh.positions = {{-20, 5, -20},    {20, 5, -20},    {20, 5, 20},    {-20, 5, 20},
                          {-20, 5.5F, -20}, {20, 5.5F, -20}, {20, 5.5F, 20}, {-20, 5.5F, 20}};
        constexpr scene::Index n = scene::kNone;
        for (const scene::Index first : {0U, 4U})
            for (const std::array<scene::Index, 3>& t : {std::array<scene::Index, 3>{0, 1, 2}, {0, 2, 3}}) {
                const bool flip = turned != (first == 4);
                mesh.triangles.push_back(
                    {{first + t[0], first + t[flip ? 2 : 1], first + t[flip ? 1 : 2]}, {n, n, n}, {n, n, n}, material});
            }
        add_shape(scene_, mesh, material);
        scene_.lights.clear();
        add_sun({0, -1, 0});
        EXPECT_NEAR(mean().y, 0.5F + static_cast<float>(albedo_of(0.5)) / 24, 0.02F) << turned;
    }
}

// Paths bring the same light, but that at the boundary they take the mean of all directions for the share that comes
// in: light at 60 degrees, where that is nearly so. Catches weights of paths that aren't those of their choices.
TEST_F(SubsurfaceScene, PathsBringTheSameLight) {
    add_block({0.1F, 0.5F, 0.9F}, {0.3F, 0.5F, 1}, 1.4F);
    add_sun({0, -0.5F, 0.866F});
    const Vec3 whitted = mean();
    options_.integrator = kernel::INTEGRATOR_PATH;
    options_.max_depth = 1;
    const Film film = render_on(*device_, scene_, options_, 256).film;
    Vec3 paths{};
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) paths += film.mean(x, y) * (1.0F / 256);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(paths[c], whitted[c], 0.04F * whitted[c]) << c;
}

// Highlights are on top of what comes from below, by paths as well. Catches one of the two drawn with the other's odds.
TEST_F(SubsurfaceScene, PathsKeepTheHighlight) {
    scene::Material shiny = wax({0.5F, 0.5F, 0.5F}, {0.5F, 0.5F, 0.5F}, 1.4F);
    auto texture = std::make_shared<scene::LayeredTexture>(*shiny.patterned->texture);
    texture->layers[0].finish.specular = 0.4F;
    texture->layers[0].finish.roughness = 0.02F;
    shiny.patterned->texture = texture;
    add_shape(scene_, scene::Box{{-20, 5, -20}, {20, 25, 20}}, add_material(scene_, shiny));
    add_sun({0, -1, 0});
    const Vec3 whitted = mean();
    options_.integrator = kernel::INTEGRATOR_PATH;
    options_.max_depth = 1;
    const Film film = render_on(*device_, scene_, options_, 256).film;
    float paths = 0;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) paths += film.mean(x, y).x / 256;
    EXPECT_GT(whitted.x, 0.8F);
    EXPECT_NEAR(paths, whitted.x, 0.05F * whitted.x);
}

// Catches random numbers that depend on who draws them.
TEST_F(SubsurfaceScene, BitsDontDependOnThreads) {
    add_shape(scene_, scene::Sphere{{0, 5, 0}, 1}, add_material(scene_, wax({0.9F, 0.7F, 0.4F}, {9, 3, 1}, 1.4F)));
    add_sun({0, -1, 1});
    options_ = size(96, 80);
    options_.camera = narrow_camera(0.25F);
    scene_.subsurface->samples = 20;
    const auto one = make_cpu_device({.threads = 1}), four = make_cpu_device({.threads = 4});
    const Film a = picture(*one), b = picture(*four);
    EXPECT_EQ(a.radiance, b.radiance);
}

}  // namespace
}  // namespace sundog
