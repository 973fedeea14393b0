// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "film/scenes.h"
#include "stage/curves.h"
#include "stage/palettes.h"

namespace sundog::intro {

using namespace kernel;

namespace {

constexpr Air kStudio{.bounces = 2,
                      .vignette = 0.45F,
                      .fog = 0.02F,
                      .fog_color = {0.50F, 0.27F, 0.21F},
                      .ambient_up = {0.13F, 0.15F, 0.22F},
                      .ambient_down = {0.14F, 0.10F, 0.08F},
                      .zenith = {0.05F, 0.08F, 0.16F},
                      .horizon = {0.80F, 0.42F, 0.30F}};
constexpr Material kGround{.diffuse = {0.17F, 0.15F, 0.17F}, .mirror = {0.09F, 0.09F, 0.09F}, .mirror_edge = 0.6F};
constexpr Texture kGreen{
    .stripes = {0.6F, 0.3F, 0.5F}, .noise_scale = {0.2F, 0.2F, 0.2F}, .noise = 5, .palette = kJade};
constexpr Texture kBrown{.rings = 4.5F, .noise_scale = {0.12F, 0.12F, 0.03F}, .noise = 2.2F, .palette = kWood};
constexpr Texture kWhite{
    .stripes = {0.6F, 0.4F, 0.3F}, .noise_scale = {0.22F, 0.22F, 0.22F}, .noise = 5, .palette = kWhiteMarble};
constexpr Texture kBlack{
    .stripes = {0.5F, 0.2F, 0.6F}, .noise_scale = {0.2F, 0.2F, 0.2F}, .noise = 5, .palette = kBlackMarble};

}  // namespace

void carvings(World& world, const Moment& now) {
    Builder builder(world);
    const float t = now.seconds;
    world.air = kStudio;
    builder.plane(vec3(0, 0, 1), 0, builder.material(kGround));
    const uint jade = builder.polished(kGreen);
    const uint wood = builder.polished(kBrown);
    const uint white = builder.polished(kWhite);
    const uint black = builder.polished(kBlack);

    // Each turns half round on its own bar.
    const auto turn = [&now](float offset) {
        const float bars = now.beats * 0.25F + offset;
        const float whole = std::floor(bars);
        return 1.5708F * (whole + ramp(0, 0.45F, bars - whole));
    };
    const auto lift = [&now](float offset) { return 0.25F * pulse(now.beats * 0.5F + offset, 2.5F); };
    const vec3 zero(0, 0, 0);

    // The classic: a cube and a ball have this in common, without three tubes.
    builder.carve(turned(vec3(0, 0, 2.35F + lift(0)), turn(0), 0.6F, 0.4F + 0.2F * t), zero, 1.5F, jade)
        .block(zero, vec3(1.12F, 1.12F, 1.12F))
        .ball(zero, 1.46F)
        .without()
        .tube(0, zero, 0.7F)
        .tube(1, zero, 0.7F)
        .tube(2, zero, 0.7F);
    builder.lantern(vec3(0, 0, 2.35F + lift(0)), 0.4F, vec3(1.6F, 0.85F, 0.3F), 0.6F + 0.6F * pulse(now.beats, 3), 1.8F,
                    0.03F);
    builder.carve({vec3(0, 0, 0)}, vec3(0, 0, 0.25F), 1.7F, black)
        .tube(2, zero, 1.6F)
        .block(vec3(0, 0, 0.25F), vec3(2, 2, 0.25F))
        .without()
        .ball(vec3(0, 0, 2.35F), 2.0F);

    // A bowl, dice, a wheel and a lens around it.
    builder.carve(turned(vec3(-3.4F, 0.6F, 1.0F), 0, 0.25F, t * 0.4F), zero, 1.05F, wood)
        .ball(zero, 1.0F)
        .half_space(vec3(0, 0, 1), 0.25F)
        .without()
        .ball(vec3(0, 0, 0.1F), 0.86F);
    builder.sphere(vec3(-3.4F, 0.6F, 0.75F + lift(0.5F)), 0.42F, white);

    const float die = 0.72F;
    const float pip = 0.17F;
    Builder& cube =
        builder.carve(turned(vec3(3.1F, -1.2F, 1.0F + lift(0.25F)), 0.3F, turn(0.5F), 0.5F), zero, 1.05F, white);
    cube.block(zero, vec3(die, die, die)).ball(zero, 1.02F).without();
    cube.ball(vec3(0, 0, die + 0.05F), pip * 1.5F);
    for (uint i = 0; i < 4; ++i) {
        const float a = i % 2 == 0 ? 0.36F : -0.36F;
        const float b = i < 2 ? 0.36F : -0.36F;
        cube.ball(vec3(a, -die - 0.05F, b), pip * 1.2F);
        if (i < 2) cube.ball(vec3(die + 0.05F, a, a), pip * 1.2F);
    }
    builder.carve(turned(vec3(2.6F, 2.4F, 1.3F), t * 0.9F, 1.5708F, 0.7F), zero, 1.36F, wood)
        .tube(2, zero, 1.3F)
        .block(zero, vec3(2, 2, 0.28F))
        .without()
        .tube(2, zero, 0.34F)
        .tube(2, vec3(0.78F, 0, 0), 0.3F)
        .tube(2, vec3(-0.39F, 0.675F, 0), 0.3F)
        .tube(2, vec3(-0.39F, -0.675F, 0), 0.3F);
    builder.carve(turned(vec3(-2.2F, -2.6F, 0.9F + lift(0.75F)), t * 0.5F, turn(0.25F) + 0.3F, 0.2F), zero, 0.9F, black)
        .ball(vec3(0, 0, 0.55F), 1.0F)
        .ball(vec3(0, 0, -0.55F), 1.0F)
        .without()
        .tube(2, zero, 0.3F);

    builder.spot(vec3(-6, -6, 10), vec3(0, 0, 0.5F), vec3(1.7F, 1.45F, 1.1F), 0.46F, 0.35F);
    const float around = t * 0.5F;
    builder.lamp(vec3(6.5F * std::cos(around), 6.5F * std::sin(around), 4.2F), vec3(0.35F, 0.5F, 1.1F), 7, 0.02F);

    const float orbit = 0.25F * t - 1.9F;
    const vec3 eye(7.4F * std::cos(orbit), 7.4F * std::sin(orbit), 3.0F + 1.4F * std::sin(t * 0.35F));
    builder.camera(eye, vec3(0, 0, 1.35F), 1.25F, now.aspect, 0);
}

}  // namespace sundog::intro
