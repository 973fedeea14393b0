// SPDX-License-Identifier: Apache-2.0
#include "denoise/prepare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/srgb.h"
#include "denoise/smoothed.h"

namespace sundog::denoise {
namespace {

constexpr float kLeastAlbedo = 0.05F;

std::size_t place(const NoisyPicture& picture, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x);
}

float finite(float value) { return std::isfinite(value) ? value : 0; }
Vec3 finite(Vec3 v) { return {finite(v.x), finite(v.y), finite(v.z)}; }

Vec3 divided(Vec3 a, Vec3 b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }

/// A plane over the layout, of a function of pixels; the margin repeats the picture's border.
template <class Value>
Plane plane_of(const Layout& layout, const Value& value) {
    Plane plane(layout.size());
    for (int y = 0; y < layout.rows; ++y)
        for (int x = 0; x < layout.stride; ++x)
            plane[static_cast<std::size_t>(y) * static_cast<std::size_t>(layout.stride) + static_cast<std::size_t>(x)] =
                value(std::clamp(x - kMargin, 0, layout.width - 1), std::clamp(y - kMargin, 0, layout.height - 1));
    return plane;
}

/// How bright a pixel may be for its neighbours: as the second brightest of the eight.
float brightest_around(const NoisyPicture& picture, const std::vector<Vec3>& light, int x, int y) {
    float first = 0, second = 0;
    int counted = 0;
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, picture.height - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, picture.width - 1); ++i) {
            if (i == x && j == y) continue;
            const float value = luminance(light[place(picture, i, j)]);
            ++counted;
            if (value > first) second = std::exchange(first, value);
            else second = std::max(second, value);
        }
    return counted < 2 ? std::numeric_limits<float>::infinity() : second;
}

/// Of two neighbours' differences the smaller one, 0 where they point apart: a surface's slope where it ends, too.
float smaller_slope(float back, float ahead) {
    if (back * ahead <= 0) return 0;
    return std::abs(back) < std::abs(ahead) ? back : ahead;
}

}  // namespace

Vec3 divisor(Vec3 albedo) {
    albedo = finite(albedo);
    const float share = std::clamp(std::max({albedo.x, albedo.y, albedo.z}) / kLeastAlbedo - 1, 0.0F, 1.0F);
    Vec3 out;
    for (std::size_t c = 0; c < 3; ++c) out[c] = 1 + (std::max(albedo[c], kLeastAlbedo) - 1) * share;
    return out;
}

std::vector<Vec3> divisors(const NoisyPicture& picture) {
    std::vector<Vec3> out(picture.radiance.size(), {1, 1, 1});
    if (picture.albedo.empty()) return out;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = divisor(picture.albedo[i]);
    return out;
}

Light light_of(const NoisyPicture& picture, const std::vector<Vec3>& divisors, const Layout& layout) {
    const std::size_t pixels = picture.radiance.size();
    std::vector<Vec3> light(pixels);
    std::vector<float> variance(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        light[i] = divided(finite(picture.radiance[i]), divisors[i]);
        const Vec3 noise = divided(divided(finite(picture.variance[i]), divisors[i]), divisors[i]);
        variance[i] = std::max(noise.x + noise.y + noise.z, 0.0F);
    }
    std::vector<Vec3> calm = light;
    std::vector<float> calm_variance = variance;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const std::size_t i = place(picture, x, y);
            const float bright = luminance(light[i]);
            // What stands out of its neighbours by more than its noise explains stays.
            constexpr float kDeviations = 3;
            const float most =
                std::max(brightest_around(picture, light, x, y), bright - kDeviations * std::sqrt(variance[i]));
            if (bright <= most) continue;
            calm[i] *= most / bright;
            calm_variance[i] *= most / bright * most / bright;
        }
    Light out;
    // A few blocks of samples tell little of one pixel's variance, and more together with those around it.
    constexpr int kSmoothing = 2;
    const std::vector<float> around = smoothed(calm_variance, picture.width, picture.height, kSmoothing);
    for (std::size_t c = 0; c < 3; ++c)
        out.channels[c] = plane_of(layout, [&](int x, int y) { return calm[place(picture, x, y)][c]; });
    out.variance = plane_of(layout, [&](int x, int y) {
        const std::size_t i = place(picture, x, y);
        return 0.25F * calm_variance[i] + 0.75F * around[i];
    });
    return out;
}

Guides guides_of(const NoisyPicture& picture, const Layout& layout) {
    Guides guides;
    for (std::size_t c = 0; c < 3; ++c)
        guides.normal[c] = plane_of(layout, [&](int x, int y) {
            return picture.normal.empty() ? 0 : finite(picture.normal[place(picture, x, y)][c]);
        });
    std::vector<float> depths;
    for (const float depth : picture.depth)
        if (std::isfinite(depth) && depth > 0) depths.push_back(depth);
    float middle = 1;
    if (!depths.empty()) {
        const auto half = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
        std::nth_element(depths.begin(), half, depths.end());
        middle = *half;
    }
    constexpr float kNearest = 0.01F;  // Of the middle: what is nearer would drown all else.
    guides.nearness = plane_of(layout, [&](int x, int y) {
        if (picture.depth.empty()) return 0.0F;
        const float depth = picture.depth[place(picture, x, y)];
        return depth > 0 ? 1 / std::max(depth / middle, kNearest) : 0;  // 0 on a miss, and for NaN
    });
    const auto difference = [&](int x, int y, int dx, int dy) {
        const auto at = [&](int i, int j) { return guides.nearness[static_cast<std::size_t>(layout.at(i, j))]; };
        return smaller_slope(at(x, y) - at(x - dx, y - dy), at(x + dx, y + dy) - at(x, y));
    };
    guides.slope_x = plane_of(layout, [&](int x, int y) { return difference(x, y, 1, 0); });
    guides.slope_y = plane_of(layout, [&](int x, int y) { return difference(x, y, 0, 1); });
    guides.inside.assign(layout.size(), 0);
    for (int y = 0; y < layout.height; ++y)
        for (int x = 0; x < layout.width; ++x) guides.inside[static_cast<std::size_t>(layout.at(x, y))] = 1;
    return guides;
}

}  // namespace sundog::denoise
