// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "film/scenes.h"
#include "stage/curves.h"
#include "stage/palettes.h"

namespace sundog::intro {

using namespace kernel;

namespace {

constexpr Material kWater{
    .emission = {0.004F, 0.016F, 0.026F}, .mirror = {0.03F, 0.035F, 0.04F}, .mirror_edge = 1, .waves = 0.4F};
// The middle of the palette is where noise is at its mean.
constexpr Texture kCloudTexture{
    .stripes = {0, 0, 0.5F / 3.1F}, .noise_scale = {0.085F, 0.16F, 0.085F}, .noise = 1.2F, .palette = kClouds};
constexpr Texture kStone{
    .stripes = {0.3F, 0.1F, 0.4F}, .noise_scale = {0.25F, 0.25F, 0.25F}, .noise = 4, .palette = kBlackMarble};
constexpr Texture kVeins{
    .stripes = {0.5F, 0.2F, 0.6F}, .noise_scale = {0.2F, 0.2F, 0.2F}, .noise = 5, .palette = kJade};

constexpr Air kMorning{.bounces = 2,
                       .vignette = 0.35F,
                       .fog = 0.0012F,
                       .fog_color = {0.80F, 0.50F, 0.34F},
                       .ambient_up = {0.20F, 0.22F, 0.30F},
                       .ambient_down = {0.10F, 0.07F, 0.06F},
                       .zenith = {0.10F, 0.20F, 0.42F},
                       .horizon = {0.95F, 0.58F, 0.36F}};
constexpr Sky kMorningSky{.sun_color = {1.0F, 0.78F, 0.5F}, .clouds = {0.66F, 0.46F, 0.46F}};

constexpr Air kSunset{.bounces = 2,
                      .vignette = 0.35F,
                      .fog = 0.0015F,
                      .fog_color = {},
                      .ambient_up = {0.13F, 0.13F, 0.22F},
                      .ambient_down = {0.06F, 0.04F, 0.05F},
                      .zenith = {0.06F, 0.09F, 0.26F},
                      .horizon = {1.0F, 0.36F, 0.20F}};
constexpr Sky kSunsetSky{.sun_color = {1.0F, 0.55F, 0.28F}, .clouds = {0.62F, 0.26F, 0.28F}};

/// Turns a colour into another.
[[gnu::noinline]] void fade(vec3& color, vec3 other, float share) { color = mix(color, other, share); }

}  // namespace

void place_sun(Sky& sky, float azimuth, float elevation) {
    const auto direction = [elevation](float around) {
        return vec3(std::sin(around) * std::cos(elevation), std::cos(around) * std::cos(elevation),
                    std::sin(elevation));
    };
    // 22 degrees on the sky are more along the circle that is as high as the sun.
    const float aside = 0.384F / std::cos(elevation);
    sky.sun_place = direction(azimuth);
    sky.dogs[0] = direction(azimuth - aside);
    sky.dogs[1] = direction(azimuth + aside);
}

void open_sea(Builder& builder, World& world, const Moment& now) {
    world.sky.texture = builder.texture(kCloudTexture);
    world.textures[world.sky.texture].shift = vec3(now.seconds * 0.02F, now.seconds * 0.012F, 3.1F);
    builder.plane(vec3(0, 0, 1), 0, builder.material(kWater));
}

void sea(World& world, const Moment& now) {
    Builder builder(world);
    world.air = kMorning;
    world.sky = kMorningSky;
    Sky& sky = world.sky;
    open_sea(builder, world, now);
    sky.halo = ramp(3, 8, now.seconds);
    place_sun(sky, 0.0F, 0.16F);
    builder.sun(sky.sun_place, vec3(1.5F, 1.1F, 0.7F));
    builder.sun(vec3(-0.4F, -1, 0.45F), vec3(0.55F, 0.55F, 0.65F)).light.flags = 0;

    const uint golden = builder.metal(vec3(0.86F, 0.58F, 0.25F));
    title(builder, vec3(0, 26, 1.75F), 3.2F, golden, ramp(4.5F, 11.5F, now.seconds), now.seconds);

    // Stones and buoys in front lead the eye to it.
    const uint dark = builder.polished(kStone);
    const float bob = 0.12F * std::sin(now.seconds * 1.1F);
    builder.sphere(vec3(-6.4F, 16, 0.3F + bob), 0.9F, dark);
    builder.sphere(vec3(7.6F, 19, 0.3F - bob), 1.2F, golden);
    builder.sphere(vec3(3.4F, 11, 0.12F + bob * 0.7F), 0.45F, dark);

    constexpr Key kEye[] = {
        {0, vec3(-3, -14, 5.2F)}, {6, vec3(-2, -4, 3.0F)}, {12, vec3(1.5F, 5, 2.1F)}, {16, vec3(0.5F, 10.5F, 2.6F)}};
    constexpr Key kAt[] = {
        {0, vec3(3, 40, 9)}, {6, vec3(0.5F, 26, 4.6F)}, {12, vec3(0, 26, 3.0F)}, {16, vec3(0, 26, 2.6F)}};
    builder.camera(spline(kEye, now.seconds), spline(kAt, now.seconds), 1.25F, now.aspect,
                   0.03F * std::sin(now.seconds * 0.7F));
}

void evening(World& world, const Moment& now) {
    Builder builder(world);
    const float dusk = ramp(0, 15, now.seconds);
    world.air = kSunset;
    world.sky = kSunsetSky;
    Sky& sky = world.sky;
    open_sea(builder, world, now);
    fade(world.air.zenith, vec3(0.012F, 0.02F, 0.07F), dusk);
    fade(world.air.horizon, vec3(0.42F, 0.14F, 0.22F), dusk);
    fade(world.air.ambient_up, vec3(0.05F, 0.05F, 0.11F), dusk);
    fade(sky.sun_color, vec3(0.9F, 0.3F, 0.14F), dusk);
    fade(sky.clouds, vec3(0.20F, 0.08F, 0.16F), dusk);
    world.air.fog_color = world.air.horizon * 0.8F;
    sky.halo = 1 - 0.5F * dusk;
    place_sun(sky, 0.25F, 0.13F - 0.12F * dusk);
    builder.sun(sky.sun_place, mix(vec3(1.4F, 0.75F, 0.4F), vec3(0.6F, 0.2F, 0.1F), dusk));

    const uint silver = builder.metal(vec3(1.08F, 1.1F, 1.15F));
    const uint green = builder.polished(kVeins);
    const uint red = builder.metal(vec3(0.86F, 0.42F, 0.28F));

    // All that came before floats home.
    const float t = now.seconds;
    const auto bob = [t](float phase) { return 0.15F * std::sin(t * 0.9F + phase); };
    builder.torus(turned(vec3(-3.2F, 9, 1.2F + bob(0)), 0, 1.35F, 0.5F + 0.12F * t), 1.7F, 0.42F, red);
    builder.sphere(vec3(-3.2F, 9, 1.2F + bob(0)), 0.75F, silver);
    builder.carve(turned(vec3(3.4F, 10, 1.0F + bob(2)), 0.3F * t, 0.5F, 0.2F * t), vec3(0, 0, 0), 1.4F, green)
        .block(vec3(0, 0, 0), vec3(1, 1, 1))
        .ball(vec3(0, 0, 0), 1.32F)
        .without()
        .tube(0, vec3(0, 0, 0), 0.6F)
        .tube(1, vec3(0, 0, 0), 0.6F)
        .tube(2, vec3(0, 0, 0), 0.6F);
    builder.sphere(vec3(0.4F, 14, 1.4F + bob(4)), 1.5F, silver);
    builder.sphere(vec3(-8, 18, 1.2F + bob(5)), 1.6F, green);
    builder.sphere(vec3(9, 20, 1.5F + bob(1)), 1.9F, red);

    // Lanterns.
    for (uint i = 0; i < 2; ++i) {
        const float around = t * 0.35F + static_cast<float>(i) * 3.14159F;
        const vec3 place(4.6F * std::cos(around), 11 + 3.6F * std::sin(around), 2.6F + 0.5F * std::sin(t * 0.8F));
        const vec3 color = i == 0 ? vec3(1.0F, 0.55F, 0.2F) : vec3(0.25F, 0.5F, 1.0F);
        const float bright = 1.6F * ramp(1, 6, t);
        builder.lantern(place, 0.11F, color, bright, 3.0F, 0.019F);
    }

    constexpr Key kEye[] = {
        {0, vec3(-9, 0, 2.2F)}, {6, vec3(-3.5F, -1.5F, 1.7F)}, {11, vec3(2, -3, 2.4F)}, {16, vec3(1.5F, -9, 6.5F)}};
    constexpr Key kAt[] = {
        {0, vec3(-1, 12, 1.4F)}, {6, vec3(0, 12, 1.8F)}, {11, vec3(0.5F, 13, 2.3F)}, {16, vec3(2, 20, 5.5F)}};
    builder.camera(spline(kEye, t), spline(kAt, t), 1.2F, now.aspect, 0);
}

}  // namespace sundog::intro
