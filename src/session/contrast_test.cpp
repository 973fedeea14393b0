// SPDX-License-Identifier: Apache-2.0
#include "session/contrast.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kernel/shared.h"

namespace sundog {
namespace {

Film film_of(PixelRect bounds, auto color) {
    Film film(bounds);
    for (int y = bounds.y0; y < bounds.y1; ++y)
        for (int x = bounds.x0; x < bounds.x1; ++x) {
            const float value = color(x, y);
            film.radiance[film.index(x, y)] = {value, value, value, 1};
        }
    return film;
}

int holding(const std::vector<PixelRect>& regions, int x, int y) {
    int count = 0;
    for (const PixelRect& r : regions) count += x >= r.x0 && x < r.x1 && y >= r.y0 && y < r.y1 ? 1 : 0;
    return count;
}

// Catches edges that are missed, refined twice, or only on one side; and work where there is nothing to refine.
TEST(Contrast, EdgesAreCoveredOnce) {
    const PixelRect bounds{3, 5, 103, 77};
    const auto is_right = [](int x, int y) { return x + y / 2 >= 60; };
    const Film film = film_of(bounds, [&](int x, int y) { return is_right(x, y) ? 0.9F : 0.1F; });
    const auto [pixels, regions] = contrast_of(film, {});
    int covered = 0;
    for (int y = bounds.y0; y < bounds.y1; ++y)
        for (int x = bounds.x0; x < bounds.x1; ++x) {
            const bool at_edge = (x > bounds.x0 && is_right(x, y) != is_right(x - 1, y)) ||
                                 (x + 1 < bounds.x1 && is_right(x, y) != is_right(x + 1, y)) ||
                                 (y > bounds.y0 && is_right(x, y) != is_right(x, y - 1)) ||
                                 (y + 1 < bounds.y1 && is_right(x, y) != is_right(x, y + 1));
            const int count = holding(regions, x, y);
            ASSERT_LE(count, 1);
            ASSERT_TRUE(count == 1 || !at_edge) << x << " " << y;
            ASSERT_EQ(at_edge, pixels[film.index(x, y)] == 1) << x << " " << y;
            covered += count;
        }
    EXPECT_LT(covered, bounds.width() * bounds.height() / 3);
    for (const PixelRect& r : regions) {
        EXPECT_TRUE(r.x0 % 8 == 0 || r.x0 == bounds.x0);
        EXPECT_TRUE(r.y1 % 8 == 0 || r.y1 == bounds.y1);
    }
}

// Catches a threshold or a gamma that isn't looked at, and light brighter than white that counts as contrast.
TEST(Contrast, ThresholdAndGamma) {
    const PixelRect bounds{0, 0, 16, 16};
    const Film dark = film_of(bounds, [](int x, int) { return x < 8 ? 0.0F : 0.01F; });
    EXPECT_FALSE(contrast_of(dark, {}).regions.empty()) << "0.01 is 0.16 after gamma 2.5, three times";
    EXPECT_TRUE(contrast_of(dark, {.gamma = 1}).regions.empty());
    EXPECT_TRUE(contrast_of(dark, {.threshold = 0.5}).regions.empty());
    const Film bright = film_of(bounds, [](int x, int) { return x < 8 ? 1.0F : 90.0F; });
    EXPECT_TRUE(contrast_of(bright, {}).regions.empty());
    EXPECT_EQ(contrast_of(bright, {.threshold = 0}).regions.size(), 2U) << "0 refines everything";
}

// Catches planes that aren't looked at, two misses (infinitely far, both) that differ, and depths that differ by less
// than their ratio.
TEST(Contrast, ObjectsAndDepthsDiffer) {
    const PixelRect bounds{0, 0, 16, 8};
    Film film(bounds, kernel::AOV_OBJECT | kernel::AOV_DEPTH);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x) {
            const std::size_t i = film.index(x, y);
            film.radiance[i] = {0.5F, 0.5F, 0.5F, 1};
            film.object[i] = x < 4 ? 3 : 7;
            film.depth[i] = x < 10 ? 5.0F + 0.02F * static_cast<float>(x) : x < 13 ? 9 : INFINITY;
        }
    const auto marked = [](const Contrast& contrast) {
        std::vector<int> columns;
        for (int x = 0; x < 16; ++x)
            if (contrast.pixels[static_cast<std::size_t>(x)] != 0) columns.push_back(x);
        return columns;
    };
    EXPECT_EQ(marked(contrast_of(film, {})), std::vector<int>{});
    EXPECT_EQ(marked(contrast_of(film, {.by_object = true})), (std::vector<int>{3, 4}));
    EXPECT_EQ(marked(contrast_of(film, {.depth_ratio = 0.1F})), (std::vector<int>{9, 10, 12, 13}));
}

}  // namespace
}  // namespace sundog
