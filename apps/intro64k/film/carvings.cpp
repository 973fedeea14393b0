// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "film/scenes.h"
#include "stage/curves.h"
#include "stage/palettes.h"

namespace sundog::intro {

using namespace kernel;

void carvings(World& world, const Moment& now) {
    Builder builder(world);
    const float t = now.seconds;
    world.bounces = 2;
    world.vignette = 0.45F;
    world.ambient_up = vec3(0.13F, 0.15F, 0.22F);
    world.ambient_down = vec3(0.14F, 0.10F, 0.08F);
    world.fog = 0.02F;
    world.fog_color = vec3(0.50F, 0.27F, 0.21F);
    world.sky.zenith = vec3(0.05F, 0.08F, 0.16F);
    world.sky.horizon = vec3(0.80F, 0.42F, 0.30F);

    Material ground{};
    ground.diffuse = vec3(0.17F, 0.15F, 0.17F);
    ground.mirror = vec3(0.09F, 0.09F, 0.09F);
    ground.mirror_edge = 0.6F;
    builder.plane(vec3(0, 0, 1), 0, builder.material(ground));

    const auto polished = [&builder](uint palette, vec3 stripes, float scale, float noise, float rings) {
        Texture x{};
        x.stripes = stripes;
        x.rings = rings;
        x.noise_scale = vec3(scale, scale, rings > 0 ? scale * 0.25F : scale);
        x.noise = noise;
        x.palette = palette;
        Material m{};
        m.texture = builder.texture(x);
        m.diffuse = vec3(0.95F, 0.95F, 0.95F);
        m.highlight = 0.6F;
        m.shininess = 70;
        m.mirror = vec3(0.04F, 0.04F, 0.04F);
        m.mirror_edge = 0.6F;
        return builder.material(m);
    };
    const uint jade = polished(kJade, vec3(0.6F, 0.3F, 0.5F), 0.2F, 5, 0);
    const uint wood = polished(kWood, vec3(0, 0, 0), 0.12F, 2.2F, 4.5F);
    const uint white = polished(kWhiteMarble, vec3(0.6F, 0.4F, 0.3F), 0.22F, 5, 0);
    const uint black = polished(kBlackMarble, vec3(0.5F, 0.2F, 0.6F), 0.2F, 5, 0);

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
    Material core{};
    core.emission = vec3(2.6F, 1.5F, 0.5F) * (0.6F + 0.5F * pulse(now.beats, 3));
    builder.sphere(vec3(0, 0, 2.35F + lift(0)), 0.4F, builder.material(core));
    builder.shadowless();
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
    Builder& cube = builder.carve(turned(vec3(3.1F, -1.2F, 1.0F + lift(0.25F)), 0.3F, turn(0.5F), 0.5F), zero, 1.05F, white);
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
    builder.lamp(vec3(0, 0, 2.35F), vec3(1.6F, 0.85F, 0.3F) * (0.6F + 0.6F * pulse(now.beats, 3)), 1.8F, 0.03F);

    const float orbit = 0.25F * t - 1.9F;
    const vec3 eye(7.4F * std::cos(orbit), 7.4F * std::sin(orbit), 3.0F + 1.4F * std::sin(t * 0.35F));
    builder.camera(eye, vec3(0, 0, 1.35F), 1.25F, now.aspect, 0);
}

}  // namespace sundog::intro
