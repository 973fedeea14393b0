// SPDX-License-Identifier: Apache-2.0
// Light that surfaces send each other, where geometry gives it in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "scenes/scene_builder.h"

namespace sundog {
namespace {

using namespace test;

/// Sends back `matt` of the light that arrives, and `glow` of its own.
scene::Material surface(Vec3 matt_share, Vec3 glow = {}) {
    scene::Material m = matt(matt_share);
    m.mtl->emission = glow;
    return m;
}

class RadiosityScene : public testing::Test {
protected:
    RadiosityScene() { scene_.radiosity.emplace(); }

    [[nodiscard]] Film picture(int threads = 2, FrameOptions options = size(64, 48)) const {
        const std::unique_ptr<Device> device = make_cpu_device({.threads = threads});
        return render_on(*device, scene_, options).film;
    }

    /// A wall that glows, 1 high, at the far end of an endless floor with its edge along x.
    void add_corner(float count) {
        const scene::Index wall = add_material(scene_, surface({0, 0, 0}, {1, 1, 1}));
        const scene::Index floor = add_material(scene_, surface({1, 1, 1}));
        add_quad(scene_, {-500, 3, -0.5F}, {500, 3, -0.5F}, {500, 3, 0.5F}, {-500, 3, 0.5F}, wall);
        add_quad(scene_, {-500, -500, -0.5F}, {500, -500, -0.5F}, {500, 3, -0.5F}, {-500, 3, -0.5F}, floor);
        scene_.radiosity->count = static_cast<int>(count);
    }

    scene::Scene scene_ = empty_scene();
};

// In a closed room whose walls glow with e and send back the share d, each bounce adds its power of d: e (1 + d + d^2 +
// d^3) after three. Catches a lost or doubled bounce, and light that leaks out of the room (black outside).
TEST_F(RadiosityScene, AClosedRoomSumsItsBounces) {
    const scene::Index walls = add_material(scene_, surface({0.5F, 0.5F, 0.8F}, {0.1F, 0.1F, 0.1F}));
    add_shape(scene_, scene::Box{{-2, -3, -1}, {4, 5, 1.5F}}, walls);
    scene_.radiosity->recursion_limit = 3;
    const Film film = picture();
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            EXPECT_NEAR(film.mean(x, y).x, 0.1F * 1.875F, 1e-5F);
            EXPECT_NEAR(film.mean(x, y).z, 0.1F * (1 + 0.8F + 0.64F + 0.512F), 1e-5F);
        }
    }
}

// A floor at the distance d from a wall of height h that glows with 1 gets the share (1 - d / sqrt(d^2 + h^2)) / 2 of
// it (a strip's form factor). Catches samples whose reach is too long at the corner, and directions that aren't spread
// by the cosine.
TEST_F(RadiosityScene, ACornerIsLitByItsFormFactor) {
    add_corner(400);
    scene_.radiosity->error_bound = 0.2F;
    scene_.radiosity->pretrace_end = 0.01F;
    const Film film = picture();
    double sum_of_squares = 0;
    int count = 0;
    for (int y = 25; y < 48; ++y) {
        // A ray through the row's middle meets the floor, half below the eye, at this depth; the window is two high.
        const double down = (y + 0.5 - 24) / 24;
        const double d = 3 - 0.5 / down;
        if (d < 0.03) continue;  // the wall, and the row across the edge
        const double wanted = (1 - d / std::sqrt(d * d + 1)) / 2;
        for (int x = 8; x < 56; x += 8) {
            const double off = film.mean(x, y).x - wanted;
            EXPECT_LT(std::abs(off), 0.05) << "at a distance of " << d << ", column " << x;
            sum_of_squares += off * off;
            ++count;
        }
    }
    EXPECT_LT(std::sqrt(sum_of_squares / count), 0.015);
}

// Catches samples whose number, order or sums depend on who computed them.
TEST_F(RadiosityScene, BitsDontDependOnThreads) {
    add_corner(40);
    const scene::Index ball = add_material(scene_, surface({0.9F, 0.4F, 0.1F}));
    add_shape(scene_, scene::Sphere{{0.4F, 2, -0.2F}, 0.3F}, ball);
    const Film one = picture(1);
    for (const int threads : {2, 3, 7}) EXPECT_TRUE(one.radiance == picture(threads).radiance) << threads << " threads";
}

// A sky of one colour lights what is open to it by that colour; no_radiosity objects don't stand in its way. Catches a
// hidden object that gathering rays meet, or one that the eye no longer sees.
TEST_F(RadiosityScene, HiddenObjectsKeepNoLightAway) {
    scene_.sky = {0.5F, 0.25F, 1};
    const scene::Index floor = add_material(scene_, surface({0.5F, 0.5F, 0.5F}));
    const scene::Index lid = add_material(scene_, surface({0, 0, 0}));
    add_shape(scene_, scene::Plane{{0, 0, 1}, -1}, floor);
    add_shape(scene_, scene::Box{{-90, -90, 2}, {90, 90, 3}}, lid);
    const auto floor_light = [&] { return picture().mean(32, 47).z; };
    const float shaded = floor_light();
    EXPECT_LT(shaded, 0.2F);
    scene_.objects.back().seen_by_radiosity = false;
    EXPECT_NEAR(floor_light(), 0.5F, 1e-5F);
    EXPECT_LT(picture().mean(32, 0).z, 1e-5F) << "the eye sees the lid";
}

// Ambient light stands for what radiosity computes: with it, ambient is off, but for scenes from before version 3.7.
TEST_F(RadiosityScene, AmbientLightIsOff) {
    scene_.ambient = {1, 1, 1};
    scene::Material m = surface({0, 0, 0});
    m.mtl->ambient = Vec3{0.25F, 0.25F, 0.25F};
    const scene::Index wall = add_material(scene_, m);
    add_quad(scene_, {-99, 4, -99}, {99, 4, -99}, {99, 4, 99}, {-99, 4, 99}, wall);
    EXPECT_FLOAT_EQ(picture().mean(32, 24).x, 0);
    FrameOptions without = size(64, 48);
    without.radiosity = false;
    EXPECT_FLOAT_EQ(picture(2, without).mean(32, 24).x, 0.25F);
    scene_.radiosity->keeps_ambient = true;
    EXPECT_FLOAT_EQ(picture().mean(32, 24).x, 0.25F);
}

// brightness multiplies each bounce, gray_threshold mixes in the light's grey, max_sample dims bright rays and keeps
// their hue. Catches a factor applied once, and a grey that isn't luma's.
TEST_F(RadiosityScene, ItsLightIsAdjusted) {
    scene_.sky = {0.5F, 0.25F, 0.75F};
    add_shape(scene_, scene::Plane{{0, 0, 1}, -1}, add_material(scene_, surface({1, 1, 1})));
    const auto floor_light = [&] { return picture().mean(32, 47); };
    scene_.radiosity->brightness = 1.5F;
    EXPECT_NEAR(floor_light().x, 0.75F, 1e-5F);
    scene_.radiosity->brightness = 1;
    scene_.radiosity->gray_threshold = 1;
    EXPECT_NEAR(floor_light().x, 0.38125F, 1e-5F);
    scene_.radiosity->gray_threshold = 0;
    scene_.radiosity->max_sample = 0.25F;
    EXPECT_NEAR(floor_light().x, 0.25F * 0.5F / 0.75F, 1e-5F);
}

// Fog of distance D before a sky that glows with e lets e exp(-r/D) of it through from r away, if radiosity sees it.
// Catches fog that is left out, or that is there though `media` is off.
TEST_F(RadiosityScene, FogDimsWhatIsGathered) {
    const scene::Index dome = add_material(scene_, surface({0, 0, 0}, {0.8F, 0.8F, 0.8F}));
    const scene::Index dot = add_material(scene_, surface({1, 1, 1}));
    add_shape(scene_, scene::Sphere{{0, 0, 0}, 20}, dome);
    // Small in the dome's middle: all of that is 20 away, whatever side is lit.
    add_shape(scene_, scene::Sphere{{0, 0.2F, 0}, 0.05F}, dot);
    scene::Fog fog;
    fog.distance = 40;
    scene_.fogs.push_back(fog);
    const auto light = [&] { return picture().mean(32, 24).x; };
    EXPECT_NEAR(light(), 0.8F, 0.01F);
    scene_.radiosity->media = true;
    EXPECT_NEAR(light(), 0.8F * std::exp(-0.5F), 0.01F);
}

// Coarse passes take one sample where many are asked for; with always_sample the picture's own pass takes the rest, and
// errors fall. Catches a switch without effect.
TEST_F(RadiosityScene, AlwaysSampleTakesMore) {
    add_corner(100);
    scene_.radiosity->error_bound = 0.5F;
    scene_.radiosity->nearest_count = 12;
    scene_.radiosity->pretrace_start = scene_.radiosity->pretrace_end = 0.25F;
    const auto rays = [&](bool always) {
        scene_.radiosity->always_sample = always;
        return render_on(*make_cpu_device({.threads = 2}), scene_, size(64, 48)).stats.rays;
    };
    EXPECT_GT(rays(true), 2 * rays(false));
}

/// Keeps samples in memory.
class KeptRadiosity final : public RadiosityStore {
public:
    void keep(const StoredRadiosity& samples) const override { *samples_ = samples; }
    [[nodiscard]] std::shared_ptr<const StoredRadiosity> samples() const { return samples_; }

private:
    std::shared_ptr<StoredRadiosity> samples_ = std::make_shared<StoredRadiosity>();
};

// What one picture gathered makes the same picture again, to the bit, with the eye's rays alone; more than the scene's
// bounces are of no use. Catches samples that are lost on the way, or gathered though they are known.
TEST_F(RadiosityScene, LoadedSamplesMakeTheSamePicture) {
    add_corner(60);
    scene_.radiosity->recursion_limit = 3;
    const auto kept = std::make_shared<const KeptRadiosity>();
    scene_.radiosity->store = kept;
    const Picture gathered = render_on(*make_cpu_device({.threads = 2}), scene_, size(64, 48));
    ASSERT_GT(kept->samples()->size(), 20U);
    scene_.radiosity->store = nullptr;
    scene_.radiosity->loaded = kept->samples();
    const Picture loaded = render_on(*make_cpu_device({.threads = 3}), scene_, size(64, 48));
    EXPECT_TRUE(loaded.film.radiance == gathered.film.radiance);
    EXPECT_LT(loaded.stats.rays, gathered.stats.rays / 4);
    scene_.radiosity->recursion_limit = 1;
    EXPECT_TRUE(render_on(*make_cpu_device({}), scene_, size(64, 48)).film.radiance == gathered.film.radiance);
}

}  // namespace
}  // namespace sundog
