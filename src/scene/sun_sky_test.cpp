// SPDX-License-Identifier: Apache-2.0
#include "scene/sun_sky.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/srgb.h"

namespace sundog::scene {
namespace {

constexpr Vec3 kUp{0, 0, 1}, kNorth{0, 1, 0};

Vec3 towards(float azimuth_deg, float elevation_deg) { return direction_at({}, azimuth_deg, elevation_deg); }

// Catches holes in the sky: black or infinite places at any haze, above all near the horizon and with the sun there.
TEST(SunSky, HasLightEverywhere) {
    for (const float turbidity : {kLeastTurbidity, 3.0F, 6.0F, kMostTurbidity})
        for (const float sun_elevation : {0.0F, 1.0F, 10.0F, 45.0F, 90.0F}) {
            const Environment sky = make_sky({towards(30, sun_elevation), turbidity}, kUp, kNorth, 32);
            ASSERT_EQ(sky.radiance.size(), 64U * 32U);
            for (const Vec3 radiance : sky.radiance) {
                ASSERT_TRUE(is_finite(radiance));
                ASSERT_GT(luminance(radiance), 0) << turbidity << " " << sun_elevation;
                ASSERT_GE(std::min({radiance.x, radiance.y, radiance.z}), 0);
            }
        }
}

// Catches a sun on the wrong side, and a picture that doesn't lie where direction_in() says.
TEST(SunSky, IsBrightestNearTheSun) {
    const Vec3 to_sun = towards(130, 35);
    const Environment sky = make_sky({to_sun, 3}, kUp, kNorth, 64);
    std::size_t brightest = 0;
    for (std::size_t i = 0; i < sky.radiance.size(); ++i)
        if (luminance(sky.radiance[i]) > luminance(sky.radiance[brightest])) brightest = i;
    const auto x = static_cast<float>(brightest % sky.width), y = static_cast<float>(brightest / sky.width);
    const Vec3 there = direction_in(sky, (x + 0.5F) / 128, (y + 0.5F) / 64);
    EXPECT_GT(dot(there, to_sun), std::cos(radians(4)));
}

// Catches chromaticities in the wrong order: away from the sun a clear sky is blue, and more so than near it.
TEST(SunSky, IsBluerAwayFromTheSun) {
    const Daylight daylight{towards(0, 35), 2.5F};
    const auto blueness = [&](Vec3 direction) {
        const Vec3 color = sky_radiance(daylight, kUp, direction);
        return color.z / color.x;
    };
    EXPECT_GT(blueness(towards(180, 55)), 1.5F);
    EXPECT_GT(blueness(towards(180, 55)), blueness(towards(3, 37)) * 1.3F);
}

// Catches azimuths that enter the model by more than their distance from the sun.
TEST(SunSky, IsSymmetricAboutTheSunsMeridian) {
    const Daylight daylight{towards(70, 25), 4};
    for (const float aside : {5.0F, 40.0F, 120.0F})
        for (const float elevation : {2.0F, 30.0F, 80.0F}) {
            const Vec3 left = sky_radiance(daylight, kUp, towards(70 - aside, elevation));
            const Vec3 right = sky_radiance(daylight, kUp, towards(70 + aside, elevation));
            for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(left[i], right[i], 1e-4F * luminance(left) + 1e-6F);
        }
}

// Catches an air mass that shrinks towards the horizon, and haze that lets more through.
TEST(SunSky, TheSunIsRedderAndDimmerNearTheHorizon) {
    float redness = 0, light = 10;
    for (const float elevation : {90.0F, 60.0F, 30.0F, 15.0F, 5.0F, 2.0F}) {
        const Vec3 color = sun_color({towards(0, elevation), 3}, kUp);
        EXPECT_GT(color.x / color.y, redness) << elevation;
        EXPECT_LT(luminance(color), light) << elevation;
        redness = color.x / color.y;
        light = luminance(color);
    }
    EXPECT_GT(redness, 2);
    EXPECT_LT(luminance(sun_color({towards(0, 30), 8}, kUp)), luminance(sun_color({towards(0, 30), 2}, kUp)));
}

// Catches a scale that makes noon too dark or too bright to be seen, and ground that isn't lit by the sky over it.
TEST(SunSky, WhiteUnderTheNoonSkyIsAboutOne) {
    const Daylight noon{towards(180, 60), 3};
    const Environment sky = make_sky(noon, kUp, kNorth, 128);
    const Vec3 ground = sky.radiance.back();
    EXPECT_NEAR(luminance(ground) / 0.2F, 1, 0.2F);
    EXPECT_GT(luminance(sky_radiance(noon, kUp, towards(0, 45))), 0.03F);
    EXPECT_LT(luminance(sky_radiance(noon, kUp, towards(0, 45))), 0.5F);
}

// Catches a scene that keeps its own sun beside the sky's, or loses its lamps.
TEST(SunSky, ReplacesTheScenesSuns) {
    Scene scene;
    scene.lights.resize(2);
    scene.lights[0].kind = Light::Kind::sun;
    scene.lights[1].kind = Light::Kind::lamp;
    put_under_sky(90, 0, 3, scene);
    ASSERT_EQ(scene.lights.size(), 2U);
    EXPECT_EQ(scene.lights[0].kind, Light::Kind::lamp);
    EXPECT_EQ(scene.lights[1].kind, Light::Kind::sun);
    EXPECT_NEAR(scene.lights[1].place.x, 1, 1e-6) << "east is right of north";
    ASSERT_TRUE(scene.environment.has_value());
    EXPECT_EQ(scene.environment->radiance.size(), 1024U * 512U);
}

}  // namespace
}  // namespace sundog::scene
