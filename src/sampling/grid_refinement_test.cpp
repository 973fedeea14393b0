// SPDX-License-Identifier: Apache-2.0
#include "sampling/grid_refinement.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace sundog::sampling {
namespace {

/// A picture as a function of its pixels.
using Picture = std::function<PointRecord(int x, int y)>;

PointRecord gray(float value, std::uint32_t signature = 1) {
    PointRecord record;
    record.whole = Float4{value, value, value, 1};
    record.light = Float4{value, value, value, 0};
    record.signature = signature;
    return record;
}

struct FunctionTracer {
    const Picture& picture;
    int traced = 0;
    void trace(const TilePlace* places, int count, PointRecord* records) {
        traced += count;
        for (int i = 0; i < count; ++i) records[i] = picture(places[i].x, places[i].y);
    }
};

struct Refined {
    std::vector<std::array<float, 4>> pixels;
    int points = 0;
    [[nodiscard]] const std::array<float, 4>& at(int x, int y, int width) const {
        return pixels[static_cast<std::size_t>(y * width + x)];
    }
};

template <class Tracer>
Refined refine_by(Tracer& tracer, int width, int height, const RefinementQuality& quality = {},
                  const std::uint8_t* finest = nullptr) {
    Refined out;
    out.pixels.assign(static_cast<std::size_t>(width * height), {-1, -1, -1, -1});
    const auto refinement = std::make_unique<GridRefinement>();
    out.points = refinement->refine(tracer, {out.pixels[0].data(), 4 * width, width, height}, quality, finest);
    return out;
}

Refined refine(const Picture& picture, int width, int height, const RefinementQuality& quality = {},
               const std::uint8_t* finest = nullptr) {
    FunctionTracer tracer{picture};
    Refined out = refine_by(tracer, width, height, quality, finest);
    EXPECT_EQ(tracer.traced, out.points);
    return out;
}

// Catches squares that are divided for nothing, and pixels that nobody fills.
TEST(GridRefinement, ASmoothPictureNeedsItsCornersOnly) {
    const Refined flat = refine([](int, int) { return gray(0.25F); }, 64, 64);
    EXPECT_EQ(81, flat.points);
    for (const auto& pixel : flat.pixels) EXPECT_EQ((std::array<float, 4>{0.25F, 0.25F, 0.25F, 1}), pixel);

    const Refined ramp = refine(
        [](int x, int y) { return gray(0.3F + 0.001F * static_cast<float>(x) + 0.002F * static_cast<float>(y)); }, 64,
        64);
    EXPECT_EQ(81, ramp.points);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            EXPECT_NEAR(0.3 + 0.001 * x + 0.002 * y, static_cast<double>(ramp.at(x, y, 64)[0]), 1e-6) << x << "," << y;
}

// Catches parts of the picture whose sides no square fits, and squares that reach beyond a tile.
TEST(GridRefinement, AnySizeIsFilled) {
    for (const auto& [width, height] : {std::pair{1, 1}, {13, 7}, {64, 3}, {9, 64}, {63, 57}}) {
        const Refined refined =
            refine([](int x, int y) { return gray(static_cast<float>(x + y) / 128); }, width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                EXPECT_NEAR((x + y) / 128.0, static_cast<double>(refined.at(x, y, width)[0]), 1e-6);
                EXPECT_EQ(1.0F, refined.at(x, y, width)[3]);
            }
    }
}

// Catches edges that are blurred: between points that met different things every pixel beside the edge is traced.
TEST(GridRefinement, EdgesAreExact) {
    for (const double angle : {0.0, 0.3, 0.8, 1.4}) {
        const Picture picture = [&](int x, int y) {
            const bool right = std::cos(angle) * (x - 30.3) + std::sin(angle) * (y - 33.7) > 0;
            return right ? gray(0.8F, 2) : gray(0.2F, 1);
        };
        const Refined refined = refine(picture, 64, 64);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) EXPECT_EQ(picture(x, y).whole[0], refined.at(x, y, 64)[0]) << x << "," << y;
        EXPECT_LT(refined.points, 64 * 64 / 7) << angle;
    }
}

// Catches lights, highlights and what mirrors show not being looked at: colours alone would agree.
TEST(GridRefinement, WhatCornersRememberCounts) {
    const auto points = [](const Picture& picture) { return refine(picture, 64, 64).points; };
    const auto right = [](int x) { return x > 30; };
    EXPECT_GT(points([&](int x, int) { return gray(0.5F, right(x) ? 2 : 1); }), 81);
    EXPECT_GT(points([&](int x, int) {
                  PointRecord record = gray(0.5F);
                  record.highlights = right(x) ? 1 : 0;
                  return record;
              }),
              81);
    EXPECT_GT(points([&](int x, int) {
                  PointRecord record = gray(0.5F);
                  record.light[3] = right(x) ? 0.4F : 0.1F;  // the same colour, by way of a mirror
                  return record;
              }),
              81);
    EXPECT_EQ(65 * 65, points([](int, int) { return gray(0.5F, 0); }));  // like nothing
    EXPECT_EQ(65 * 65, points([](int, int) { return gray(std::numeric_limits<float>::quiet_NaN()); }));
}

// Catches a tolerance that isn't one of the eye's: the same step shows in the dark and not in the light.
TEST(GridRefinement, ColorsCompareForTheEye) {
    const auto points = [](float left, float right, float gain) {
        return refine([&](int x, int) { return gray(x > 30 ? right : left); }, 64, 64, {0.1F, gain}).points;
    };
    EXPECT_GT(points(0.0F, 0.05F, 1), 81);
    EXPECT_EQ(81, points(0.8F, 0.85F, 1));
    EXPECT_EQ(81, points(2.0F, 4.0F, 1));     // white in any case
    EXPECT_GT(points(2.0F, 4.0F, 0.1F), 81);  // unless the picture is darkened
}

// Catches what lies between corners being lost although it was marked.
TEST(GridRefinement, MarkedSquaresAreDivided) {
    const Picture picture = [](int x, int y) { return x == 19 && y == 21 ? gray(1, 2) : gray(0, 1); };
    EXPECT_EQ(0.0F, refine(picture, 64, 64).at(19, 21, 64)[0]);
    std::array<std::uint8_t, 64> finest;
    finest.fill(8);
    finest[2 * 8 + 2] = 1;
    const Refined found = refine(picture, 64, 64, {}, finest.data());
    EXPECT_EQ(1.0F, found.at(19, 21, 64)[0]);
    EXPECT_LT(found.points, 200);
}

/// Stripes under light that falls off: what a texture makes of a smooth picture.
struct StripedTracer {
    int traced = 0, looked = 0;
    static float light_at(float x) { return 1 - x * 0.005F; }
    static float stripe_at(int x) { return x % 3 == 0 ? 0.9F : 0.1F; }
    void trace(const TilePlace* places, int count, PointRecord* records) {
        traced += count;
        for (int i = 0; i < count; ++i) {
            const int x = places[i].x, y = places[i].y;
            const bool hole = x == 21 && y == 21;
            const float shade = light_at(static_cast<float>(x));
            const float value = hole ? 0.77F : shade * stripe_at(x) + 0.01F;
            records[i] = {};
            records[i].whole = Float4{value, value, value, 1};
            records[i].light = Float4{0.01F, 0.01F, 0.01F, 0};
            records[i].shade = Float4{shade, shade, shade, 0};
            records[i].surface = hole ? 9 : 5;
            records[i].signature = hole ? 9 : 5;
        }
    }
    void look(const TilePlace* places, int count, SurfaceLook* looks) {
        looked += count;
        for (int i = 0; i < count; ++i) {
            const float stripe = stripe_at(places[i].x);
            looks[i].whole = looks[i].light + looks[i].shade * Float4{stripe, stripe, stripe, 0};
            looks[i].surface = places[i].x == 21 && places[i].y == 21 ? 9 : 5;
        }
    }
};

// Catches textures that are interpolated, and objects in front of them that only a look finds.
TEST(GridRefinement, TexturesAreLookedUpForEachPixel) {
    StripedTracer tracer;
    const Refined refined = refine_by(tracer, 64, 64);
    EXPECT_LT(tracer.traced, 100);
    EXPECT_GT(tracer.looked, 3900);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            if (x == 21 && y == 21) continue;
            const double wanted = StripedTracer::light_at(static_cast<float>(x)) * StripedTracer::stripe_at(x) + 0.01F;
            EXPECT_NEAR(wanted, static_cast<double>(refined.at(x, y, 64)[0]), 1e-5) << x << "," << y;
        }
    EXPECT_EQ(0.77F, refined.at(21, 21, 64)[0]);
}

}  // namespace
}  // namespace sundog::sampling
