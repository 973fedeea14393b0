// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "film/scenes.h"
#include "stage/curves.h"

namespace sundog::intro {

using namespace kernel;

namespace {

/// Draws letters one unit high, strokes a fifth of it wide, scaled to `size`.
class Pen {
public:
    Pen(Builder& builder, float size, uint material) : builder_(builder), size_(size), material_(material) {}

    void at(vec3 origin, float turn) { pose_ = turned(origin, turn, 0, 0); }
    /// A slab's part: what is in [x0, x1] x [z0, z1].
    Builder& bar(float x0, float x1, float z0, float z1) {
        begin();
        return block(x0, x1, z0, z1);
    }
    /// A ring around (x, z), cut out later by `without`.
    Builder& disc(float x, float z, float radius) {
        begin();
        block(-1, 1, -1, 1);
        return builder_.tube(1, vec3(x, 0, z) * size_, radius * size_);
    }
    Builder& block(float x0, float x1, float z0, float z1, float depth = 0.16F) {
        return builder_.block(vec3((x0 + x1) * 0.5F, 0, (z0 + z1) * 0.5F) * size_,
                              vec3((x1 - x0) * 0.5F, depth, (z1 - z0) * 0.5F) * size_);
    }
    void hole(float x, float z, float radius) { builder_.without().tube(1, vec3(x, 0, z) * size_, radius * size_); }
    void hole_block(float x0, float x1, float z0, float z1) {
        builder_.without();
        block(x0, x1, z0, z1, 1);
    }
    Builder& side(float nx, float nz, float offset) { return builder_.half_space(vec3(nx, 0, nz), offset * size_); }

private:
    void begin() { builder_.carve(pose_, vec3(0, 0, 0), 0.73F * size_, material_); }

    Builder& builder_;
    float size_;
    uint material_;
    Pose pose_{};
};

void letter(Pen& pen, char which) {
    switch (which) {
        case 'S':
            pen.disc(0, 0.2F, 0.3F);
            pen.hole(0, 0.2F, 0.1F);
            pen.hole_block(0, 1, -0.1F, 0.2F);
            pen.disc(0, -0.2F, 0.3F);
            pen.hole(0, -0.2F, 0.1F);
            pen.hole_block(-1, 0, -0.2F, 0.1F);
            break;
        case 'U':
            pen.disc(0, -0.1F, 0.4F);
            pen.side(0, 1, -0.1F);
            pen.hole(0, -0.1F, 0.2F);
            pen.bar(-0.4F, 0.4F, -0.1F, 0.5F);
            pen.hole_block(-0.2F, 0.2F, -1, 1);
            break;
        case 'N':
            pen.bar(-0.4F, 0.4F, -0.5F, 0.5F);
            pen.hole_block(-0.2F, 0.2F, -1, 1);
            pen.bar(-0.2F, 0.2F, -0.5F, 0.5F);
            pen.side(0.8944F, 0.4472F, 0.105F);
            pen.side(-0.8944F, -0.4472F, 0.105F);
            break;
        case 'D':
            pen.disc(-0.1F, 0, 0.5F);
            pen.side(-1, 0, 0.1F);
            pen.hole(-0.1F, 0, 0.3F);
            pen.bar(-0.4F, -0.1F, -0.5F, 0.5F);
            pen.hole_block(-0.2F, 1, -0.3F, 0.3F);
            break;
        case 'O':
            pen.disc(0, 0, 0.5F);
            pen.hole(0, 0, 0.3F);
            break;
        default:
            pen.disc(0, 0, 0.5F);
            pen.hole(0, 0, 0.3F);
            pen.hole_block(0.1F, 1, 0, 0.32F);
            pen.bar(0.05F, 0.48F, -0.2F, 0);
            break;
    }
}

}  // namespace

void title(Builder& builder, vec3 place, float size, uint material, float risen, float sway) {
    constexpr char kWord[] = "SUNDOG";
    constexpr float kMiddles[] = {-2.3F, -1.42F, -0.42F, 0.57F, 1.5F, 2.72F};
    Pen pen(builder, size, material);
    for (uint i = 0; i < 6; ++i) {
        const auto number = static_cast<float>(i);
        const float up = ramp(number * 0.12F, 0.4F + number * 0.12F, risen);
        const float bob = 0.04F * std::sin(sway * 1.3F + number * 1.1F);
        pen.at(place + vec3(kMiddles[i], 0, (up - 1) * 1.35F + bob) * size, 0.05F * std::sin(sway * 0.9F + number));
        letter(pen, kWord[i]);
    }
}

}  // namespace sundog::intro
