// SPDX-License-Identifier: Apache-2.0
// Light that photons bring, where geometry gives it in closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenes/scene_builder.h"

namespace sundog {
namespace {

using namespace test;
using scene::PhotonSwitch;

scene::ObjectPhotons shot_at(PhotonSwitch reflection, PhotonSwitch refraction) {
    scene::ObjectPhotons photons;
    photons.target = true;
    photons.reflection = reflection;
    photons.refraction = refraction;
    photons.collect = false;
    return photons;
}

/// Lets the share `clear` pass.
scene::Material glass(float clear, float ior) {
    scene::Material m;
    m.mtl->diffuse = {0, 0, 0};
    m.mtl->opacity = 1 - clear;
    m.mtl->ior = ior;
    m.mtl->illum = 6;
    return m;
}

/// Keeps what it is given.
class Keeper final : public PhotonStore {
public:
    void keep(const StoredPhotons& photons) const override { kept = photons; }
    mutable StoredPhotons kept;
};

/// A white wall across the view, 4 before the eye.
class PhotonScene : public testing::Test {
protected:
    PhotonScene() {
        scene_.photons.emplace();
        scene_.photons->count = 40000;
        const scene::Index wall = add_material(scene_, matt({1, 1, 1}));
        add_quad(scene_, {-50, 4, -50}, {50, 4, -50}, {50, 4, 50}, {-50, 4, 50}, wall);
    }

    [[nodiscard]] Film picture(int threads = 2, int lanes = 0) const {
        const std::unique_ptr<Device> device = make_cpu_device({.threads = threads, .lanes = lanes});
        return render_on(*device, scene_, size(32, 32)).film;
    }
    /// Light of the wall around its point (0, `middle_z`), over what `wanted` says at its x and z.
    template <class Function>
    static double mean_ratio(const Film& film, double reach, const Function& wanted, double middle_z = 0) {
        double sum = 0;
        int count = 0;
        for (int y = 0; y < 32; ++y) {
            for (int x = 0; x < 32; ++x) {
                const double wall_x = 4 * (x + 0.5 - 16) / 16, wall_z = 4 * (16 - y - 0.5) / 16;
                if (std::max(std::abs(wall_x), std::abs(wall_z - middle_z)) > reach) continue;
                sum += film.mean(x, y).y / wanted(wall_x, wall_z);
                ++count;
            }
        }
        return sum / count;
    }
    /// Of light 1 from `distance` before the wall: it doesn't grow dimmer on its way.
    static double cosine(double distance, double x, double z) {
        return distance / std::sqrt(distance * distance + x * x + z * z);
    }
    void add_mirror(float reflectance = 1) {
        const Vec3 r{reflectance, reflectance, reflectance};
        add_shape(scene_, scene::Box{{-1, -1.1F, -1}, {1, -1, 1}}, add_material(scene_, glowing_mirror({0, 0, 0}, r)));
        scene_.objects.back().photons = shot_at(PhotonSwitch::on, PhotonSwitch::unset);
    }
    void add_slab(const scene::Material& material) {
        add_shape(scene_, scene::Box{{-1.5F, 1, -1.5F}, {1.5F, 1.25F, 1.5F}}, add_material(scene_, material));
        scene_.objects.back().photons = shot_at(PhotonSwitch::unset, PhotonSwitch::on);
    }

    scene::Scene scene_ = empty_scene();
};

// A mirror behind a lamp shows a second lamp, which lights as the first does. Catches any factor in the power of
// photons, in how many are gathered or in the area that they are spread over, and a lost cosine.
TEST_F(PhotonScene, AFlatMirrorIsASecondLamp) {
    add_light(scene_, scene::Light::Kind::lamp, {0, 1, 0});
    add_mirror();
    const auto both = [](double x, double z) { return cosine(3, x, z) + cosine(7, x, z); };
    EXPECT_NEAR(mean_ratio(picture(), 2.5F, both), 1, 0.01);
    scene_.photons.reset();
    EXPECT_NEAR(mean_ratio(picture(), 2.5F, [](double x, double z) { return cosine(3, x, z); }), 1, 1e-4);
}

// The same by spacing, at every width of vectors, for a lamp that fades: by the length of the whole way.
TEST_F(PhotonScene, PhotonsFadeOverTheirWholeWay) {
    add_light(scene_, scene::Light::Kind::lamp, {0, 1, 0});
    scene_.lights[0].fade_distance = 2;
    scene_.lights[0].fade_power = 2;
    scene_.photons->spacing = 0.02F;
    scene_.photons->count = 0;
    add_mirror(0.5F);
    const auto faded = [](double distance, double x, double z) {
        const double square = distance * distance + x * x + z * z;
        return cosine(distance, x, z) * 2 / (1 + square / 4);
    };
    const auto both = [&](double x, double z) { return faded(3, x, z) + 0.5 * faded(7, x, z); };
    for (const int lanes : {4, 8}) EXPECT_NEAR(mean_ratio(picture(2, lanes), 2.5F, both), 1, 0.01) << lanes << " lanes";
}

// Catches a mirror that isn't found by its material, and one that is looked for where it was at first.
TEST_F(PhotonScene, AMirrorIsFoundWhereverItMoves) {
    add_light(scene_, scene::Light::Kind::lamp, {0, 1, 0});
    add_shape(scene_, scene::Box{{-1, -1.1F, 9}, {1, -1, 11}},
              add_material(scene_, glowing_mirror({0, 0, 0}, {1, 1, 1})));
    scene_.objects.back().motion->move_speed = {0, 0, 1};
    scene_.objects.back().motion->move_amplitude = {0, 0, -10 / std::sin(1.0F)};
    scene_.photons->find_targets = true;
    scene_.settings.freeze_s = 1;
    const auto both = [](double x, double z) { return cosine(3, x, z) + cosine(7, x, z); };
    EXPECT_NEAR(mean_ratio(picture(), 2.5F, both), 1, 0.01);
}

// Catches light that comes through glass twice: in full, for nothing is in the way of a light without shadows, and as
// photons.
TEST_F(PhotonScene, LightsWithoutShadowsNeedNoPhotons) {
    // Over the view, so that its shadow, with a wide caustic in it, is around (0, -0.8) on the wall.
    add_light(scene_, scene::Light::Kind::lamp, {0, 0.5F, 5});
    add_shape(scene_, scene::Sphere{{0, 1.7F, 3}, 0.5F}, add_material(scene_, glass(1, 1.5F)));
    scene_.photons->find_targets = true;
    const auto lamp = [](double x, double z) { return cosine(3.5, x, z - 5); };
    EXPECT_LT(mean_ratio(picture(), 0.5F, lamp, -0.8), 0.95);
    scene_.lights[0].shadows = false;
    EXPECT_NEAR(mean_ratio(picture(), 0.5F, lamp, -0.8), 1, 1e-4);
}

// Parallel light that a mirror throws back is as bright as before, and as wide as the mirror.
TEST_F(PhotonScene, ParallelLightStaysParallel) {
    // Over the wall, onto the mirror, and down onto the wall's front.
    scene_.objects.clear();
    add_quad(scene_, {-50, 4, -50}, {50, 4, -50}, {50, 4, 1}, {-50, 4, 1}, 0);
    add_light(scene_, scene::Light::Kind::sun, normalize(Vec3{0, 1, 0.5F}));
    add_mirror();
    const Film film = picture();
    const double wanted = 1 / std::sqrt(1.25);
    EXPECT_NEAR(mean_ratio(
                    film, 0.7, [&](double, double) { return wanted; }, -2.5),
                1, 0.02);
    EXPECT_LT(film.mean(2, 26).x, 0.01F);
}

// What comes through a clear slab is dimmed by its share alone. Catches light that comes twice: as filtered shadow and
// as photons (1.5), or not at all.
TEST_F(PhotonScene, AClearSlabLetsItsShareThrough) {
    add_light(scene_, scene::Light::Kind::lamp, {0, 0.5F, 0});
    add_slab(glass(0.5F, 1));
    // Half of it at each of its sides; the eye sees the wall through both, too.
    const auto behind = [](double x, double z) { return 0.0625 * cosine(3.5, x, z); };
    EXPECT_NEAR(mean_ratio(picture(), 3, behind), 1, 0.01);
    // Where photons aren't refracted, shadow rays bring the same.
    scene_.objects.back().photons->refraction = PhotonSwitch::off;
    EXPECT_NEAR(mean_ratio(picture(), 3, behind), 1, 0.001);
    scene_.objects.back().photons->refraction = PhotonSwitch::on;
    scene_.objects.front().photons->collect = false;
    EXPECT_NEAR(mean_ratio(picture(), 3, behind), 1, 0.001) << "the wall doesn't collect photons";
    // But the light's shadow is full where it does.
    scene_.objects.front().photons->collect = true;
    scene_.photons->loaded = std::make_shared<const StoredPhotons>();
    EXPECT_LT(mean_ratio(picture(), 3, behind), 1e-6);
}

// A lens of glass makes the middle brighter, and photons that are refracted are as many as those that are not: the
// light on the whole wall stays the same.
TEST_F(PhotonScene, ALensGathersLight) {
    add_light(scene_, scene::Light::Kind::lamp, {0, -4, 0});
    add_shape(scene_, scene::Sphere{{0, -1, 0}, 0.5F}, add_material(scene_, glass(1, 1.5F)));
    scene_.objects.back().photons = shot_at(PhotonSwitch::unset, PhotonSwitch::on);
    scene_.photons->gather_max = 40;
    const Film film = picture();
    const std::unique_ptr<Device> device = make_cpu_device({.threads = 2});
    float brightest = 0;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) brightest = std::max(brightest, film.mean(x, y).x);
    EXPECT_GT(brightest, 1.05F);
}

// Each of the switches that keep photons from being shot, thrown back or stored; catches one that isn't asked.
TEST_F(PhotonScene, SwitchesKeepPhotonsAway) {
    add_light(scene_, scene::Light::Kind::lamp, {0, 1, 0});
    add_mirror();
    const auto lamp = [](double x, double z) { return cosine(3, x, z); };
    scene::ObjectPhotons& mirror = *scene_.objects.back().photons;
    const auto brightness = [&] { return mean_ratio(picture(), 2, lamp); };
    EXPECT_GT(brightness(), 1.9);
    mirror.target = false;
    EXPECT_NEAR(brightness(), 1, 1e-4) << "no target";
    mirror.target = true;
    mirror.reflection = PhotonSwitch::unset;
    EXPECT_NEAR(brightness(), 1, 1e-4) << "nobody says that they are reflected";
    scene_.lights[0].photons.reflection = PhotonSwitch::on;
    EXPECT_GT(brightness(), 1.9) << "the light says so";
    mirror.reflection = PhotonSwitch::off;
    EXPECT_NEAR(brightness(), 1, 1e-4) << "the object denies it";
    mirror.reflection = PhotonSwitch::on;
    scene_.lights[0].photons.reflection = PhotonSwitch::off;
    EXPECT_NEAR(brightness(), 1, 1e-4) << "the light denies it";
    scene_.lights[0].photons.reflection = PhotonSwitch::unset;
    scene_.objects.front().photons->collect = false;
    EXPECT_NEAR(brightness(), 1, 1e-4) << "the wall doesn't collect";
    scene_.objects.front().photons->collect = true;
    scene_.photons->max_depth = 0;
    EXPECT_NEAR(brightness(), 1, 1e-4) << "they end where they are shot at";
    scene_.photons->max_depth.reset();
    scene_.photons->count = 0;
    EXPECT_NEAR(brightness(), 1, 1e-4) << "none are shot";
}

// An object in the way of photons stops them, unless they are told to pass it.
TEST_F(PhotonScene, PassThroughIsForTheWayToATarget) {
    add_light(scene_, scene::Light::Kind::lamp, {0, 1, 0});
    add_mirror();
    const scene::Index black = add_material(scene_, matt({0, 0, 0}));
    add_shape(scene_, scene::Box{{-2, -0.6F, -2}, {2, -0.5F, 2}}, black);
    const auto lamp = [](double x, double z) { return cosine(3, x, z); };
    const auto brightness = [&] { return mean_ratio(picture(), 2, lamp); };
    EXPECT_NEAR(brightness(), 1, 1e-4);
    scene_.objects.back().photons->pass_through = true;
    EXPECT_NEAR(brightness(), 1, 1e-4) << "behind the target it stops them";
    scene_.objects.back().photons->pass_through.reset();
    scene_.objects.back().casts_shadow = false;
    EXPECT_GT(brightness(), 1.9) << "it casts no shadow at all";
    scene_.objects.back().photons->pass_through = false;
    EXPECT_NEAR(brightness(), 1, 1e-4);
}

// Points of an area share the light's power.
TEST_F(PhotonScene, AreasShootFromAllOfTheirPoints) {
    add_light(scene_, scene::Light::Kind::lamp, {0, 1, 0});
    scene_.lights[0].area = scene::LightArea{{0.2F, 0, 0}, {0, 0, 0.2F}, 3, 2};
    scene_.lights[0].photons.area_light = true;
    add_mirror();
    const auto both = [](double x, double z) { return cosine(3, x, z) + cosine(7, x, z); };
    EXPECT_NEAR(mean_ratio(picture(), 2, both), 1, 0.02);
}

// In a thin medium that photons cross, each length of the way sends back the share that it scatters of them.
TEST_F(PhotonScene, MediaScatterPhotons) {
    auto pigment = std::make_shared<scene::Pigment>();
    pigment->color = {1, 1, 1, 0, 1};
    auto texture = std::make_shared<scene::LayeredTexture>();
    texture->layers.push_back({pigment, {}});
    scene::Medium medium;
    medium.scattering = {0.01F, 0.01F, 0.01F};
    medium.extinction = 0;
    scene::Material m;
    m.patterned->texture = texture;
    m.patterned->hollow = true;
    scene::Interior interior;
    interior.media = std::make_shared<const std::vector<scene::Medium>>(1, medium);
    m.patterned->interior = std::make_shared<const scene::Interior>(std::move(interior));
    scene_.objects.clear();
    add_shape(scene_, scene::Box{{-1, 2, -1}, {1, 3, 1}}, add_material(scene_, m));
    add_light(scene_, scene::Light::Kind::sun, {1, 0, 0});
    const float direct = picture().mean(16, 16).x;
    scene_.objects.back().photons = shot_at(PhotonSwitch::unset, PhotonSwitch::on);
    scene_.photons->media_steps = 100;
    EXPECT_NEAR(picture().mean(16, 16).x / direct, 1, 0.06);
    scene_.photons->media_steps = 0;
    EXPECT_EQ(picture().mean(16, 16).x, 0) << "the light is stopped, and no photons are stored";
}

// Catches photons whose number, order or sums depend on who shot them.
TEST_F(PhotonScene, BitsDontDependOnThreads) {
    add_light(scene_, scene::Light::Kind::lamp, {0.5F, 1, 0.2F});
    add_light(scene_, scene::Light::Kind::lamp, {-0.5F, 0, 0}, {0.5F, 0.3F, 0.1F});
    add_mirror();
    add_slab(glass(0.8F, 1.4F));
    for (const float autostop : {1.0F, 0.0F}) {
        scene_.photons->autostop = autostop;
        const Film one = picture(1);
        for (const int threads : {2, 3, 7}) EXPECT_TRUE(one.radiance == picture(threads).radiance) << threads;
    }
}

// What was shot is handed over once, and taken instead of shooting; photons far off light nothing.
TEST_F(PhotonScene, KeptPhotonsMakeTheSamePicture) {
    add_light(scene_, scene::Light::Kind::lamp, {0, 1, 0});
    add_mirror();
    const auto keeper = std::make_shared<Keeper>();
    scene_.photons->store = keeper;
    const Film shot = picture();
    EXPECT_GT(keeper->kept.surface.size(), 10000U);
    scene_.photons->store.reset();
    scene_.photons->loaded = std::make_shared<const StoredPhotons>(keeper->kept);
    scene_.photons->count = 0;
    EXPECT_TRUE(shot.radiance == picture().radiance);
}

// A pattern that stops at the first ring which misses shoots less at a small thing in a large box, with the same
// light. Catches one that stops before it has met anything.
TEST_F(PhotonScene, AutostopLeavesOutEmptyRings) {
    add_light(scene_, scene::Light::Kind::lamp, {0, 1, 0});
    // The mirror, and specks far off that are parts of the same target.
    add_mirror();
    scene_.objects.back().photons->whole = 1;
    for (const float x : {-3.0F, 2.9F}) {
        add_shape(scene_, scene::Box{{x, -1.1F, -0.03F}, {x + 0.1F, -1, 0.03F}}, scene_.objects[1].material);
        scene_.objects.back().photons = scene_.objects[1].photons;
    }
    scene_.photons->spacing = 0.02F;
    scene_.photons->count = 0;
    const auto keeper = std::make_shared<Keeper>();
    scene_.photons->store = keeper;
    const auto shot = [&](float autostop) {
        scene_.photons->autostop = autostop;
        static_cast<void>(picture());
        return keeper->kept.surface.size();
    };
    const std::size_t all = shot(1), some = shot(0);
    EXPECT_LT(some, all);
    EXPECT_GT(static_cast<double>(some), 0.5 * static_cast<double>(all));
}

// More photons than memory can hold are refused before they are shot.
TEST_F(PhotonScene, TooManyPhotonsAreAnError) {
    add_light(scene_, scene::Light::Kind::lamp, {0, 1, 0});
    add_mirror();
    scene_.photons->spacing = 1e-9F;
    try {
        static_cast<void>(picture());
        FAIL();
    } catch (const DeviceError& error) {
        EXPECT_NE(std::string(error.what()).find("photons; at most 1000000000 can be shot"), std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace sundog
