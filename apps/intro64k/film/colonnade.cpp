// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "film/scenes.h"
#include "stage/curves.h"
#include "stage/palettes.h"

namespace sundog::intro {

using namespace kernel;

namespace {

constexpr Air kNight{.bounces = 2,
                     .vignette = 0.5F,
                     .fog = 0.02F,
                     .fog_color = {0.025F, 0.04F, 0.10F},
                     .ambient_up = {0.045F, 0.06F, 0.12F},
                     .ambient_down = {0.05F, 0.035F, 0.03F},
                     .zenith = {0.006F, 0.01F, 0.035F},
                     .horizon = {0.04F, 0.065F, 0.15F}};
constexpr Texture kTiles{.stripes = {0.35F, 0.21F, 0},
                         .noise_scale = {0.11F, 0.11F, 0.11F},
                         .noise = 4.5F,
                         .tiles = 0.5F,
                         .palette = kMarbleTiles};
constexpr Texture kMarble{
    .stripes = {0.5F, 0.3F, 0.22F}, .noise_scale = {0.14F, 0.14F, 0.09F}, .noise = 4, .palette = kWhiteMarble};
constexpr Texture kWall{
    .stripes = {0, 0, 0.8F}, .noise_scale = {0.2F, 0.2F, 0.4F}, .noise = 2.5F, .palette = kSandstone};
// Without a mirror: columns would show too much of each other.
constexpr Material kDull{.diffuse = {0.9F, 0.88F, 0.84F}, .highlight = 0.25F, .shininess = 40};
constexpr vec3 kWisps[] = {vec3(1.0F, 0.52F, 0.18F), vec3(0.22F, 0.46F, 1.0F), vec3(1.0F, 0.2F, 0.42F)};

}  // namespace

void colonnade(World& world, const Moment& now) {
    Builder builder(world);
    const float t = now.seconds;
    world.air = kNight;
    const uint floor = builder.polished(kTiles);
    world.materials[floor].mirror = vec3(0.10F, 0.10F, 0.10F);
    builder.plane(vec3(0, 0, 1), 0, floor);
    const uint column = builder.material(kDull);
    world.materials[column].texture = builder.texture(kMarble);
    const uint arches = builder.material(kDull);
    world.materials[arches].texture = builder.texture(kWall);

    // Two rows of columns under two walls, into which arches are cut.
    for (uint side = 0; side < 2; ++side) {
        const float x = side == 0 ? -4.0F : 4.0F;
        for (uint i = 0; i < 4; ++i) {
            const float y = static_cast<float>(i) * 6.0F;
            builder.cylinder(vec3(x, y, 0), 4.2F, 0.55F, column);
            builder.box(vec3(x, y, 0.15F), vec3(0.75F, 0.75F, 0.15F), column);
            builder.shadowless();
        }
        builder.carve({vec3(x, 9, 0)}, vec3(0, 0, 6), 12.6F, arches)
            .block(vec3(0, 0, 5.9F), vec3(0.62F, 12, 1.7F))
            .without()
            .tube(0, vec3(0, -6, 4.2F), 2.3F)
            .tube(0, vec3(0, 0, 4.2F), 2.3F)
            .tube(0, vec3(0, 6, 4.2F), 2.3F);
    }
    // At the end, a niche with a golden ball before a disc of light.
    const uint golden = builder.metal(vec3(0.94F, 0.64F, 0.28F));
    builder.cylinder(vec3(0, 18, 0), 1.0F, 0.9F, column);
    builder.sphere(vec3(0, 18, 1.9F + 0.08F * std::sin(t * 2)), 0.85F, golden);
    builder.torus(turned(vec3(0, 18, 1.9F), 0, 1.2F, t * 0.8F), 1.35F, 0.09F, golden);

    // Will-o'-the-wisps weave between the columns, brighter on the beat.
    for (uint i = 0; i < 3; ++i) {
        const float phase = t * 0.55F + static_cast<float>(i) * 2.1F;
        const vec3 place(5.2F * std::sin(phase), 9 + 9 * std::sin(phase * 0.53F + static_cast<float>(i)),
                         2.0F + 0.9F * std::sin(phase * 1.7F));
        const float bright = 1 + 0.5F * pulse(now.beats + static_cast<float>(i), 3);
        builder.lantern(place, 0.1F, kWisps[i], 3 * bright, 3.2F, 0.012F * bright);
    }

    constexpr Key kEye[] = {{0, vec3(-7.5F, -6, 2.0F)},
                            {4, vec3(-1.5F, -5, 1.2F)},
                            {8, vec3(1.6F, 1, 1.5F)},
                            {12, vec3(2.0F, 8, 2.9F)},
                            {16, vec3(-2.0F, 12.5F, 1.6F)}};
    constexpr Key kAt[] = {{0, vec3(0, 6, 2.4F)},
                           {4, vec3(0.5F, 12, 2.2F)},
                           {8, vec3(-0.5F, 18, 2.2F)},
                           {12, vec3(0, 18, 2.0F)},
                           {16, vec3(0, 18, 1.9F)}};
    builder.camera(spline(kEye, t), spline(kAt, t), 1.0F, now.aspect, 0.05F * std::sin(t * 0.45F));
}

}  // namespace sundog::intro
