// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "film/scenes.h"
#include "stage/curves.h"
#include "stage/palettes.h"

namespace sundog::intro {

using namespace kernel;

namespace {

constexpr Air kDark{.bounces = 5,
                    .vignette = 0.5F,
                    .fog = 0.022F,
                    .fog_color = {0.012F, 0.014F, 0.035F},
                    .ambient_up = {0.08F, 0.08F, 0.10F},
                    .ambient_down = {0.06F, 0.06F, 0.08F},
                    .zenith = {0.004F, 0.004F, 0.012F},
                    .horizon = {0.02F, 0.02F, 0.05F}};
constexpr Texture kTiles{
    .stripes = {0.2F, 0.3F, 0}, .noise_scale = {0.1F, 0.1F, 0.1F}, .noise = 3, .tiles = 0.66F, .palette = kMarbleTiles};
constexpr Material kFloor{.diffuse = {0.85F, 0.85F, 0.85F}, .highlight = 0.3F, .shininess = 60};
constexpr Material kMirror{.diffuse = {0.01F, 0.012F, 0.014F}, .mirror = {0.84F, 0.88F, 0.88F}, .mirror_edge = 1};
constexpr Material kPaint{.highlight = 0.8F, .shininess = 80, .mirror = {0.05F, 0.05F, 0.05F}, .mirror_edge = 0.8F};
constexpr vec3 kPaints[] = {vec3(0.85F, 0.12F, 0.10F), vec3(0.95F, 0.55F, 0.10F), vec3(0.10F, 0.5F, 0.75F)};
constexpr vec3 kLights[] = {vec3(1.0F, 0.75F, 0.45F), vec3(0.3F, 0.55F, 1.0F)};

}  // namespace

void mirrors(World& world, const Moment& now) {
    Builder builder(world);
    const float t = now.seconds;
    world.air = kDark;

    // A floor of tiles between two mirrors that face each other.
    const uint floor = builder.material(kFloor);
    world.materials[floor].texture = builder.texture(kTiles);
    builder.plane(vec3(0, 0, 1), 0, floor);
    const uint mirror = builder.material(kMirror);
    const uint gilded = builder.metal(vec3(0.5F, 0.3F, 0.12F));
    for (uint side = 0; side < 2; ++side) {
        const float y = side == 0 ? -6.0F : 6.0F;
        builder.box(vec3(0, y, 2.6F), vec3(5, 0.05F, 2.4F), mirror);
        builder.shadowless();
        builder.carve({vec3(0, y, 2.6F)}, vec3(0, 0, 0), 6.2F, gilded)
            .block(vec3(0, 0, 0), vec3(5.3F, 0.16F, 2.6F))
            .without()
            .block(vec3(0, 0, 0.0F), vec3(4.9F, 1, 2.25F));
    }

    // Balls that jump with the bar, each a beat after its neighbour.
    const uint silver = builder.metal(vec3(1.1F, 1.1F, 1.12F));
    uint paints[3];
    for (uint i = 0; i < 3; ++i) {
        paints[i] = builder.material(kPaint);
        world.materials[paints[i]].diffuse = kPaints[i];
    }
    for (uint i = 0; i < 5; ++i) {
        const auto number = static_cast<float>(i);
        float beat = now.beats * 0.5F + number * 0.2F;
        beat -= std::floor(beat);
        const float height = 4 * beat * (1 - beat) * (i == 2 ? 0.5F : 1.5F);
        const float radius = i == 2 ? 1.1F : 0.6F;
        const float around = t * 0.25F + number * 1.5708F;
        const vec3 place = i == 2 ? vec3(0, 0, radius + height)
                                  : vec3(2.7F * std::cos(around), 2.7F * std::sin(around), radius + height);
        builder.sphere(place, radius, i == 2 ? silver : paints[i % 3]);
    }

    for (uint i = 0; i < 2; ++i) {
        const float around = -t * 0.5F + static_cast<float>(i) * 3.1416F;
        const vec3 place(4.1F * std::cos(around), 3.4F * std::sin(around), 3.8F + 0.5F * std::sin(t + around));
        builder.lantern(place, 0.13F, kLights[i], 2.6F + 0.7F * pulse(now.beats, 3), 4.2F, 0.008F);
    }
    constexpr Key kEye[] = {{0, vec3(3.8F, -4.6F, 3.4F)},
                            {5, vec3(1.6F, -5.3F, 2.2F)},
                            {10, vec3(-3.4F, -5.0F, 1.4F)},
                            {16, vec3(-4.4F, -3.4F, 3.2F)}};
    constexpr Key kAt[] = {
        {0, vec3(-0.5F, 3, 1.2F)}, {5, vec3(0, 6, 2.0F)}, {10, vec3(0.4F, 6, 1.9F)}, {16, vec3(1.2F, 6, 1.4F)}};
    builder.camera(spline(kEye, t), spline(kAt, t), 0.95F, now.aspect, 0.04F * std::sin(t * 0.6F));
}

}  // namespace sundog::intro
