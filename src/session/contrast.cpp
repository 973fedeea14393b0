// SPDX-License-Identifier: Apache-2.0
#include "session/contrast.h"

#include <algorithm>
#include <cmath>

#include "session/marked_regions.h"

namespace sundog {

ColorContrast::ColorContrast(double threshold, double gamma)
    : threshold_(threshold), power_(static_cast<float>(gamma > 0 ? 1 / gamma : 1)) {}

Vec3 ColorContrast::compared(Vec3 linear) const {
    const auto one = [&](float x) { return std::pow(std::clamp(x, 0.0F, 1.0F), power_); };
    return {one(linear.x), one(linear.y), one(linear.z)};
}

bool ColorContrast::differ(Vec3 a, Vec3 b) const {
    return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z) >= threshold_;
}

Contrast contrast_of(const Film& film, const AdaptiveSampling& sampling) {
    const PixelRect& bounds = film.bounds;
    const ColorContrast contrast_rule(sampling.threshold, sampling.gamma);
    const auto see_different_things = [&](std::size_t a, std::size_t b) {
        if (sampling.by_object && film.object[a] != film.object[b]) return true;
        if (!(sampling.depth_ratio > 0)) return false;
        const auto [nearer, farther] = std::minmax(film.depth[a], film.depth[b]);
        // Written so that two misses, both infinitely far, are alike.
        return farther > nearer * (1 + sampling.depth_ratio);
    };
    Contrast contrast{std::vector<std::uint8_t>(film.radiance.size()), {}};
    const auto mark = [&](int x, int y) { contrast.pixels[film.index(x, y)] = 1; };
    const auto row = static_cast<std::size_t>(bounds.width());
    std::vector<Vec3> above(row);
    for (int y = bounds.y0; y < bounds.y1; ++y) {
        Vec3 left;
        for (int x = bounds.x0; x < bounds.x1; ++x) {
            const Vec3 here = contrast_rule.compared(film.mean(x, y));
            const std::size_t i = film.index(x, y);
            Vec3& upper = above[static_cast<std::size_t>(x - bounds.x0)];
            if (x > bounds.x0 && (contrast_rule.differ(here, left) || see_different_things(i, i - 1))) {
                mark(x, y);
                mark(x - 1, y);
            }
            if (y > bounds.y0 && (contrast_rule.differ(here, upper) || see_different_things(i, i - row))) {
                mark(x, y);
                mark(x, y - 1);
            }
            left = upper = here;
        }
    }
    contrast.regions = marked_regions(bounds, contrast.pixels);
    return contrast;
}

}  // namespace sundog
