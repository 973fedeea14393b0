// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "film/scenes.h"
#include "stage/curves.h"
#include "stage/palettes.h"

namespace sundog::intro {

using namespace kernel;

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
    Texture clouds{};
    clouds.noise_scale = vec3(0.085F, 0.16F, 0.085F);
    clouds.noise = 1.15F;
    // The middle of the palette where noise is at its mean.
    clouds.stripes = vec3(0, 0, 0.5F / 3.1F);
    clouds.palette = kClouds;
    clouds.shift = vec3(now.seconds * 0.02F, now.seconds * 0.012F, 3.1F);
    world.sky.texture = builder.texture(clouds);

    Material water{};
    water.mirror = vec3(0.03F, 0.035F, 0.04F);
    water.mirror_edge = 1;
    water.emission = vec3(0.004F, 0.016F, 0.026F);
    water.waves = 0.4F;
    builder.plane(vec3(0, 0, 1), 0, builder.material(water));
    world.bounces = 2;
    world.vignette = 0.35F;
}

void sea(World& world, const Moment& now) {
    Builder builder(world);
    open_sea(builder, world, now);
    Sky& sky = world.sky;
    sky.zenith = vec3(0.10F, 0.20F, 0.42F);
    sky.horizon = vec3(0.95F, 0.58F, 0.36F);
    sky.sun_color = vec3(1.0F, 0.78F, 0.5F);
    sky.clouds = vec3(0.62F, 0.42F, 0.42F);
    sky.halo = ramp(3, 8, now.seconds);
    place_sun(sky, 0.0F, 0.16F);
    world.ambient_up = vec3(0.20F, 0.22F, 0.30F);
    world.ambient_down = vec3(0.10F, 0.07F, 0.06F);
    world.fog = 0.0012F;
    world.fog_color = vec3(0.80F, 0.50F, 0.34F);
    builder.sun(sky.sun_place, vec3(1.5F, 1.1F, 0.7F));
    builder.sun(vec3(-0.4F, -1, 0.45F), vec3(0.55F, 0.55F, 0.65F)).light.flags = 0;

    Material gold{};
    gold.diffuse = vec3(0.30F, 0.17F, 0.05F);
    gold.highlight = 0.9F;
    gold.shininess = 50;
    gold.mirror = vec3(0.62F, 0.42F, 0.18F);
    gold.mirror_edge = 0.9F;
    const uint golden = builder.material(gold);
    title(builder, vec3(0, 26, 1.75F), 3.2F, golden, ramp(4.5F, 11.5F, now.seconds), now.seconds);

    // Stones and buoys in front lead the eye to it.
    Material stone{};
    Texture marble{};
    marble.stripes = vec3(0.3F, 0.1F, 0.4F);
    marble.noise_scale = vec3(0.25F, 0.25F, 0.25F);
    marble.noise = 4;
    marble.palette = kBlackMarble;
    stone.texture = builder.texture(marble);
    stone.diffuse = vec3(1, 1, 1);
    stone.highlight = 0.5F;
    stone.shininess = 40;
    stone.mirror = vec3(0.04F, 0.04F, 0.04F);
    stone.mirror_edge = 0.6F;
    const uint dark = builder.material(stone);
    const float bob = 0.12F * std::sin(now.seconds * 1.1F);
    builder.sphere(vec3(-6.4F, 16, 0.3F + bob), 0.9F, dark);
    builder.sphere(vec3(7.6F, 19, 0.3F - bob), 1.2F, golden);
    builder.sphere(vec3(3.4F, 11, 0.12F + bob * 0.7F), 0.45F, dark);

    constexpr Key kEye[] = {{0, vec3(-3, -14, 5.2F)}, {6, vec3(-2, -4, 3.0F)}, {12, vec3(1.5F, 5, 2.1F)},
                            {16, vec3(0.5F, 10.5F, 2.6F)}};
    constexpr Key kAt[] = {{0, vec3(3, 40, 9)}, {6, vec3(0.5F, 26, 4.6F)}, {12, vec3(0, 26, 3.0F)},
                           {16, vec3(0, 26, 2.6F)}};
    builder.camera(spline(kEye, now.seconds), spline(kAt, now.seconds), 1.25F, now.aspect,
                   0.03F * std::sin(now.seconds * 0.7F));
}

void evening(World& world, const Moment& now) {
    Builder builder(world);
    open_sea(builder, world, now);
    const float dusk = ramp(0, 15, now.seconds);
    Sky& sky = world.sky;
    sky.zenith = mix(vec3(0.06F, 0.09F, 0.26F), vec3(0.012F, 0.02F, 0.07F), dusk);
    sky.horizon = mix(vec3(1.0F, 0.36F, 0.20F), vec3(0.42F, 0.14F, 0.22F), dusk);
    sky.sun_color = mix(vec3(1.0F, 0.55F, 0.28F), vec3(0.9F, 0.3F, 0.14F), dusk);
    sky.clouds = mix(vec3(0.50F, 0.24F, 0.28F), vec3(0.14F, 0.07F, 0.14F), dusk);
    sky.halo = 1 - 0.5F * dusk;
    place_sun(sky, 0.25F, 0.13F - 0.12F * dusk);
    world.ambient_up = mix(vec3(0.13F, 0.13F, 0.22F), vec3(0.05F, 0.05F, 0.11F), dusk);
    world.ambient_down = vec3(0.06F, 0.04F, 0.05F);
    world.fog = 0.0015F;
    world.fog_color = sky.horizon * 0.8F;
    builder.sun(sky.sun_place, mix(vec3(1.4F, 0.75F, 0.4F), vec3(0.6F, 0.2F, 0.1F), dusk));

    Material chrome{};
    chrome.diffuse = vec3(0.03F, 0.03F, 0.04F);
    chrome.mirror = vec3(0.78F, 0.80F, 0.84F);
    chrome.mirror_edge = 1;
    chrome.highlight = 1;
    chrome.shininess = 120;
    const uint silver = builder.material(chrome);
    Material jade{};
    Texture veins{};
    veins.stripes = vec3(0.5F, 0.2F, 0.6F);
    veins.noise_scale = vec3(0.2F, 0.2F, 0.2F);
    veins.noise = 5;
    veins.palette = kJade;
    jade.texture = builder.texture(veins);
    jade.diffuse = vec3(1, 1, 1);
    jade.highlight = 0.7F;
    jade.shininess = 60;
    jade.mirror = vec3(0.05F, 0.05F, 0.05F);
    jade.mirror_edge = 0.8F;
    const uint green = builder.material(jade);
    Material copper{};
    copper.diffuse = vec3(0.24F, 0.09F, 0.05F);
    copper.mirror = vec3(0.62F, 0.30F, 0.20F);
    copper.mirror_edge = 0.9F;
    copper.highlight = 0.8F;
    copper.shininess = 50;
    const uint red = builder.material(copper);

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
    Material lantern{};
    for (uint i = 0; i < 2; ++i) {
        const float around = t * 0.35F + static_cast<float>(i) * 3.14159F;
        const vec3 place(4.6F * std::cos(around), 11 + 3.6F * std::sin(around), 2.6F + 0.5F * std::sin(t * 0.8F));
        const vec3 color = i == 0 ? vec3(1.0F, 0.55F, 0.2F) : vec3(0.25F, 0.5F, 1.0F);
        lantern.emission = color * 2.5F;
        builder.sphere(place, 0.11F, builder.material(lantern));
        builder.shadowless();
        builder.lamp(place, color * (1.6F * ramp(1, 6, t)), 3.0F, 0.03F * ramp(1, 6, t));
    }

    constexpr Key kEye[] = {{0, vec3(-9, 0, 2.2F)}, {6, vec3(-3.5F, -1.5F, 1.7F)}, {11, vec3(2, -3, 2.4F)},
                            {16, vec3(1.5F, -9, 6.5F)}};
    constexpr Key kAt[] = {{0, vec3(-1, 12, 1.4F)}, {6, vec3(0, 12, 1.8F)}, {11, vec3(0.5F, 13, 2.3F)},
                           {16, vec3(2, 20, 5.5F)}};
    builder.camera(spline(kEye, t), spline(kAt, t), 1.2F, now.aspect, 0);
}

}  // namespace sundog::intro
