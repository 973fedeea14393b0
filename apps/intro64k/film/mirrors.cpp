// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "film/scenes.h"
#include "stage/curves.h"
#include "stage/palettes.h"

namespace sundog::intro {

using namespace kernel;

void mirrors(World& world, const Moment& now) {
    Builder builder(world);
    const float t = now.seconds;
    world.bounces = 5;
    world.vignette = 0.5F;
    world.ambient_up = vec3(0.08F, 0.08F, 0.10F);
    world.ambient_down = vec3(0.06F, 0.06F, 0.08F);
    world.fog = 0.022F;
    world.fog_color = vec3(0.012F, 0.014F, 0.035F);
    world.sky.zenith = vec3(0.004F, 0.004F, 0.012F);
    world.sky.horizon = vec3(0.02F, 0.02F, 0.05F);

    // A floor of tiles between two mirrors that face each other.
    Texture tiles{};
    tiles.stripes = vec3(0.2F, 0.3F, 0);
    tiles.noise_scale = vec3(0.1F, 0.1F, 0.1F);
    tiles.noise = 3;
    tiles.tiles = 0.66F;
    tiles.palette = kMarbleTiles;
    Material floor{};
    floor.texture = builder.texture(tiles);
    floor.diffuse = vec3(0.85F, 0.85F, 0.85F);
    floor.highlight = 0.3F;
    floor.shininess = 60;
    builder.plane(vec3(0, 0, 1), 0, builder.material(floor));
    Material glass{};
    glass.diffuse = vec3(0.01F, 0.012F, 0.014F);
    glass.mirror = vec3(0.84F, 0.88F, 0.88F);
    glass.mirror_edge = 1;
    const uint mirror = builder.material(glass);
    Material frame{};
    frame.diffuse = vec3(0.36F, 0.2F, 0.07F);
    frame.mirror = vec3(0.3F, 0.2F, 0.08F);
    frame.mirror_edge = 0.7F;
    frame.highlight = 0.8F;
    frame.shininess = 40;
    const uint gilded = builder.material(frame);
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
    Material chrome{};
    chrome.diffuse = vec3(0.03F, 0.03F, 0.03F);
    chrome.mirror = vec3(0.80F, 0.80F, 0.82F);
    chrome.mirror_edge = 1;
    chrome.highlight = 1;
    chrome.shininess = 150;
    const uint silver = builder.material(chrome);
    const vec3 colors[] = {vec3(0.85F, 0.12F, 0.10F), vec3(0.95F, 0.55F, 0.10F), vec3(0.10F, 0.5F, 0.75F)};
    uint paints[3];
    for (uint i = 0; i < 3; ++i) {
        Material paint{};
        paint.diffuse = colors[i];
        paint.highlight = 0.8F;
        paint.shininess = 80;
        paint.mirror = vec3(0.05F, 0.05F, 0.05F);
        paint.mirror_edge = 0.8F;
        paints[i] = builder.material(paint);
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

    Material bulb{};
    const vec3 lights[] = {vec3(1.0F, 0.75F, 0.45F), vec3(0.3F, 0.55F, 1.0F)};
    for (uint i = 0; i < 2; ++i) {
        const float around = -t * 0.5F + static_cast<float>(i) * 3.1416F;
        const vec3 place(4.1F * std::cos(around), 3.4F * std::sin(around), 3.8F + 0.5F * std::sin(t + around));
        bulb.emission = lights[i] * 3;
        builder.sphere(place, 0.13F, builder.material(bulb));
        builder.shadowless();
        builder.lamp(place, lights[i] * (2.6F + 0.7F * pulse(now.beats, 3)), 4.2F, 0.008F);
    }
    constexpr Key kEye[] = {{0, vec3(3.8F, -4.6F, 3.4F)}, {5, vec3(1.6F, -5.3F, 2.2F)}, {10, vec3(-3.4F, -5.0F, 1.4F)},
                            {16, vec3(-4.4F, -3.4F, 3.2F)}};
    constexpr Key kAt[] = {{0, vec3(-0.5F, 3, 1.2F)}, {5, vec3(0, 6, 2.0F)}, {10, vec3(0.4F, 6, 1.9F)},
                           {16, vec3(1.2F, 6, 1.4F)}};
    builder.camera(spline(kEye, t), spline(kAt, t), 0.95F, now.aspect, 0.04F * std::sin(t * 0.6F));
}

}  // namespace sundog::intro
