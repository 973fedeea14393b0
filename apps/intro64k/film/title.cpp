// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdint>

#include "film/scenes.h"
#include "stage/curves.h"

namespace sundog::intro {

using namespace kernel;

namespace {

/// What a letter is carved of. kDisc and kBar begin a new solid.
enum class Tool : std::int8_t { kDisc, kBar, kSide, kHole, kCut, kEnd };

/// In hundredths of a letter's height, around its middle. kDisc, kHole: x, z, radius. kBar, kCut: from x to x, from z
/// to z. kSide: a half-space's normal in x and z, and its distance.
struct Stroke {
    Tool tool;
    std::int8_t a, b, c, d;
};

constexpr Stroke kWord[] = {
    // S
    {Tool::kDisc, 0, 20, 30, 0},
    {Tool::kHole, 0, 20, 10, 0},
    {Tool::kCut, 0, 100, -10, 20},
    {Tool::kDisc, 0, -20, 30, 0},
    {Tool::kHole, 0, -20, 10, 0},
    {Tool::kCut, -100, 0, -20, 10},
    {Tool::kEnd, 0, 0, 0, 0},
    // U
    {Tool::kDisc, 0, -10, 40, 0},
    {Tool::kSide, 0, 100, -10, 0},
    {Tool::kHole, 0, -10, 20, 0},
    {Tool::kBar, -40, 40, -10, 50},
    {Tool::kCut, -20, 20, -100, 100},
    {Tool::kEnd, 0, 0, 0, 0},
    // N
    {Tool::kBar, -40, 40, -50, 50},
    {Tool::kCut, -20, 20, -100, 100},
    {Tool::kBar, -20, 20, -50, 50},
    {Tool::kSide, 89, 45, 10, 0},
    {Tool::kSide, -89, -45, 10, 0},
    {Tool::kEnd, 0, 0, 0, 0},
    // D
    {Tool::kDisc, -10, 0, 50, 0},
    {Tool::kSide, -100, 0, 10, 0},
    {Tool::kHole, -10, 0, 30, 0},
    {Tool::kBar, -40, -10, -50, 50},
    {Tool::kCut, -20, 100, -30, 30},
    {Tool::kEnd, 0, 0, 0, 0},
    // O
    {Tool::kDisc, 0, 0, 50, 0},
    {Tool::kHole, 0, 0, 30, 0},
    {Tool::kEnd, 0, 0, 0, 0},
    // G
    {Tool::kDisc, 0, 0, 50, 0},
    {Tool::kHole, 0, 0, 30, 0},
    {Tool::kCut, 10, 100, 0, 32},
    {Tool::kBar, 5, 48, -20, 0},
    {Tool::kEnd, 0, 0, 0, 0},
};

}  // namespace

void title(Builder& builder, vec3 place, float size, uint material, float risen, float sway) {
    constexpr float kMiddles[] = {-2.3F, -1.42F, -0.42F, 0.57F, 1.5F, 2.72F};
    const float unit = size * 0.01F;
    const Stroke* stroke = kWord;
    for (uint i = 0; i < 6; ++i, ++stroke) {
        const auto number = static_cast<float>(i);
        const float up = ramp(number * 0.12F, 0.4F + number * 0.12F, risen);
        const float bob = 0.04F * std::sin(sway * 1.3F + number * 1.1F);
        const Pose pose = turned(place + vec3(kMiddles[i], 0, (up - 1) * 1.35F + bob) * size,
                                 0.05F * std::sin(sway * 0.9F + number), 0, 0);
        for (; stroke->tool != Tool::kEnd; ++stroke) {
            const float a = static_cast<float>(stroke->a) * unit;
            const float b = static_cast<float>(stroke->b) * unit;
            const float c = static_cast<float>(stroke->c) * unit;
            const float d = static_cast<float>(stroke->d) * unit;
            const Tool tool = stroke->tool;
            if (tool < Tool::kSide) builder.carve(pose, vec3(0, 0, 0), 0.73F * size, material);
            if (tool > Tool::kSide) builder.without();
            if (tool == Tool::kSide) {
                builder.half_space(normalize(vec3(a, 0, b)), c);
            } else if (tool == Tool::kBar || tool == Tool::kCut) {
                builder.block(vec3((a + b) * 0.5F, 0, (c + d) * 0.5F),
                              vec3((b - a) * 0.5F, tool == Tool::kBar ? 0.16F * size : size, (d - c) * 0.5F));
            } else {
                if (tool == Tool::kDisc) builder.block(vec3(0, 0, 0), vec3(size, 0.16F * size, size));
                builder.tube(1, vec3(a, 0, b), c);
            }
        }
    }
}

}  // namespace sundog::intro
