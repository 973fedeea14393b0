// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "film/scenes.h"
#include "stage/curves.h"
#include "stage/palettes.h"

namespace sundog::intro {

using namespace kernel;

namespace {

constexpr Air kLamplight{.bounces = 1,
                         .vignette = 0.6F,
                         .fog = 0.03F,
                         .fog_color = {0.03F, 0.02F, 0.024F},
                         .ambient_up = {0.07F, 0.07F, 0.09F},
                         .ambient_down = {0.07F, 0.045F, 0.03F},
                         .zenith = {0.006F, 0.006F, 0.012F},
                         .horizon = {0.035F, 0.022F, 0.025F}};
constexpr Texture kLog{.rings = 1.6F, .noise_scale = {0.06F, 0.06F, 0.012F}, .noise = 3.4F, .palette = kWood};

}  // namespace

void rings(World& world, const Moment& now) {
    Builder builder(world);
    const float t = now.seconds;
    world.air = kLamplight;
    const uint wooden = builder.polished(kLog);
    world.materials[wooden].mirror = vec3(0.03F, 0.03F, 0.03F);
    // A log sawn lengthwise: its axis lies almost in the table's face.
    const Pose log{vec3(0, 0, -0.4F), vec3(0, 0.995F, 0.1F), vec3(0, -0.1F, 0.995F), vec3(1, 0, 0)};
    builder.plane(vec3(0, 0, 1), 0, wooden, log);

    const uint gold = builder.metal(vec3(0.95F, 0.66F, 0.26F));
    const uint copper = builder.metal(vec3(0.92F, 0.44F, 0.28F));
    const uint steel = builder.metal(vec3(0.75F, 0.80F, 0.88F));

    // The gyroscope: each ring turns in the one around it.
    const vec3 middle(0, 0, 3.0F);
    const float turn = t * 0.6F + 0.4F * std::sin(t * 0.5F);
    builder.torus(turned(middle, 0, 1.5708F, turn * 0.5F), 2.5F, 0.14F, gold);
    builder.torus(turned(middle, 0, 1.5708F + turn, turn * 0.5F), 2.1F, 0.13F, copper);
    builder.torus(turned(middle, turn * 0.8F, 0.7F + turn * 1.3F, turn * 0.5F), 1.7F, 0.12F, steel);
    builder.carve({vec3(0, 0, 0)}, vec3(0, 0, 0.2F), 1.4F, wooden)
        .tube(2, vec3(0, 0, 0), 1.3F)
        .block(vec3(0, 0, 0.18F), vec3(2, 2, 0.18F))
        .without()
        .ball(vec3(0, 0, 2.7F), 2.5F);

    // In its middle a star, whose beat is the music's.
    const float bright = 0.75F + 0.6F * pulse(now.beats, 2.5F);
    builder.lantern(middle, 0.32F + 0.05F * pulse(now.beats, 2.5F), vec3(2.9F, 2.1F, 1.25F), bright, 3.4F,
                    0.018F * bright);
    // A cool light from a window far away.
    builder.spot(vec3(-9, -7, 11), vec3(0, 0.5F, 0), vec3(0.22F, 0.36F, 0.85F), 0.42F, 0.6F);

    // Onlookers: balls that roll around it, and a carved bowl.
    for (uint i = 0; i < 4; ++i) {
        const float around = t * 0.22F + static_cast<float>(i) * 1.5708F;
        const float radius = i % 2 == 0 ? 0.5F : 0.34F;
        const float far = i % 2 == 0 ? 4.4F : 3.6F;
        builder.sphere(vec3(far * std::cos(around), far * std::sin(around), radius), radius,
                       i % 2 == 0 ? steel : (i == 1 ? gold : copper));
    }
    constexpr Key kEye[] = {{0, vec3(5.5F, -7.5F, 7.5F)},
                            {5, vec3(7.5F, -4.5F, 2.8F)},
                            {10, vec3(0.5F, -7.6F, 1.4F)},
                            {16, vec3(-6.6F, -5.0F, 4.6F)}};
    constexpr Key kAt[] = {
        {0, vec3(0, 0, 1.6F)}, {5, vec3(0, 0, 2.5F)}, {10, vec3(0, 0, 2.8F)}, {16, vec3(0, 0, 2.4F)}};
    builder.camera(spline(kEye, t), spline(kAt, t), 1.25F, now.aspect, 0);
}

}  // namespace sundog::intro
