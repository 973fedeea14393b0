// SPDX-License-Identifier: Apache-2.0
#include "sampling/scanline_refinement.h"

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
    record.signature = record.outline = signature;
    record.seen = {signature, 7};
    return record;
}

struct FunctionTracer {
    const Picture& picture;
    int traced = 0, shaded = 0, wrongly_assumed = 0;
    void trace(const TilePlace* places, int count, PointRecord* records) {
        traced += count;
        for (int i = 0; i < count; ++i) records[i] = picture(places[i].x, places[i].y);
    }
    void shade(const TilePlace* places, int count, const SeenPrimitive* seen, PointRecord* records) {
        shaded += count;
        for (int i = 0; i < count; ++i) {
            records[i] = picture(places[i].x, places[i].y);
            if (records[i].seen.geometry != seen[i].geometry) ++wrongly_assumed;
        }
    }
};

struct Refined {
    int width;
    std::vector<std::array<float, 4>> pixels;
    int points = 0;
    Refined(int width_, int height)
        : width(width_), pixels(static_cast<std::size_t>(width_ * height), {-1, -1, -1, -1}) {}
    [[nodiscard]] const std::array<float, 4>& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y * width + x)];
    }
};

template <class Tracer>
Refined refine_by(Tracer& tracer, int width, int height, bool assume = false, const std::uint8_t* finest = nullptr) {
    Refined out(width, height);
    const auto refinement = std::make_unique<ScanlineRefinement>();
    const TilePixels pixels{out.pixels[0].data(), 4 * width, width, height};
    if constexpr (requires { tracer.shade(nullptr, 0, nullptr, nullptr); })
        out.points =
            assume ? refinement->shade(tracer, pixels, {}, finest) : refinement->refine(tracer, pixels, {}, finest);
    else out.points = refinement->refine(tracer, pixels, {}, finest);
    EXPECT_EQ(tracer.traced, out.points);
    return out;
}

Refined refine(const Picture& picture, int width, int height, const std::uint8_t* finest = nullptr) {
    FunctionTracer tracer{picture};
    return refine_by(tracer, width, height, false, finest);
}

// Catches spans that are halved for nothing, pixels that nobody fills, and slopes that don't meet the ends.
TEST(ScanlineRefinement, ASmoothPictureNeedsTheEndsOfSpansOnly) {
    const Refined ramp = refine(
        [](int x, int y) { return gray(0.3F + 0.001F * static_cast<float>(x) + 0.002F * static_cast<float>(y)); }, 64,
        64);
    EXPECT_EQ(9 * 64, ramp.points);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            EXPECT_NEAR(0.3 + 0.001 * x + 0.002 * y, static_cast<double>(ramp.at(x, y)[0]), 1e-6) << x << "," << y;
            EXPECT_EQ(1.0F, ramp.at(x, y)[3]);
        }
}

// Catches parts of the picture whose width no span fits, and spans that reach beyond a tile.
TEST(ScanlineRefinement, AnySizeIsFilled) {
    for (const auto& [width, height] : {std::pair{1, 1}, {13, 7}, {64, 3}, {9, 64}, {63, 57}}) {
        const Picture picture = [](int x, int y) { return gray(static_cast<float>(x + y) / 128); };
        for (const bool assume : {false, true}) {
            FunctionTracer tracer{picture};
            const Refined refined = refine_by(tracer, width, height, assume);
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    EXPECT_NEAR((x + y) / 128.0, static_cast<double>(refined.at(x, y)[0]), 1e-6);
                    EXPECT_EQ(1.0F, refined.at(x, y)[3]);
                }
        }
    }
}

// Catches edges that are blurred along lines, or from one line to the next.
TEST(ScanlineRefinement, EdgesAreExact) {
    for (const double angle : {0.0, 0.3, 0.8, 1.4, 1.57}) {
        const Picture picture = [&](int x, int y) {
            const bool right = std::cos(angle) * (x - 30.3) + std::sin(angle) * (y - 33.7) > 0;
            return right ? gray(0.8F, 2) : gray(0.2F, 1);
        };
        const Refined refined = refine(picture, 64, 64);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) EXPECT_EQ(picture(x, y).whole[0], refined.at(x, y)[0]) << x << "," << y;
        EXPECT_LE(refined.points, 9 * 64 + 3 * 64) << angle;
    }
}

// Catches lights, highlights and what mirrors show not being looked at: colours alone would agree.
TEST(ScanlineRefinement, WhatEndsRememberCounts) {
    const auto points = [](const Picture& picture) { return refine(picture, 64, 64).points; };
    const auto right = [](int x) { return x > 30; };
    EXPECT_GT(points([&](int x, int) { return gray(0.5F, right(x) ? 2 : 1); }), 9 * 64);
    EXPECT_GT(points([&](int x, int) {
                  PointRecord record = gray(0.5F);
                  record.highlights = right(x) ? 1 : 0;
                  return record;
              }),
              9 * 64);
    EXPECT_GT(points([&](int x, int) { return gray(right(x) ? 0.05F : 0.0F); }), 9 * 64);
    EXPECT_EQ(65 * 64, points([](int, int) { return gray(0.5F, 0); }));  // like nothing
    EXPECT_EQ(65 * 64, points([](int, int) { return gray(std::numeric_limits<float>::quiet_NaN()); }));
}

// Catches what lies between ends being lost although it was marked.
TEST(ScanlineRefinement, MarkedSquaresAreDivided) {
    const Picture picture = [](int x, int y) { return x == 19 && y == 21 ? gray(1, 2) : gray(0, 1); };
    std::array<std::uint8_t, 64> finest;
    finest.fill(8);
    EXPECT_EQ(0.0F, refine(picture, 64, 64, finest.data()).at(19, 21)[0]);
    finest[2 * 8 + 2] = 1;
    EXPECT_EQ(1.0F, refine(picture, 64, 64, finest.data()).at(19, 21)[0]);
}

// Catches pixels that are taken to see another thing than both ends do, are interpolated, or searched for needlessly.
TEST(ScanlineRefinement, BetweenEndsOfOneThingPixelsAreShaded) {
    const Picture picture = [](int x, int y) {
        const bool right = 0.9 * (x - 30.3) + 0.4 * (y - 33.7) > 0;
        return gray(x * y % 7 == 0 ? 0.9F : 0.1F, right ? 2 : 1);  // like no interpolation
    };
    FunctionTracer tracer{picture};
    const Refined refined = refine_by(tracer, 64, 64, true);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) EXPECT_EQ(picture(x, y).whole[0], refined.at(x, y)[0]) << x << "," << y;
    EXPECT_LE(tracer.traced, 9 * 64 + 3 * 64);
    EXPECT_EQ(64 * 65, tracer.traced + tracer.shaded);
    EXPECT_EQ(0, tracer.wrongly_assumed);

    const Picture unknown = [](int, int) { return gray(0.5F, 0); };
    FunctionTracer searching{unknown};
    refine_by(searching, 64, 64, true);
    EXPECT_EQ(0, searching.shaded);
}

/// Stripes under light that falls off: what a texture makes of a smooth picture; one pixel shows something else.
struct StripedTracer {
    int traced = 0, looked = 0;
    static float light_at(float x) { return 1 - x * 0.005F; }
    static float stripe_at(int x) { return x % 3 == 0 ? 0.9F : 0.1F; }
    static bool is_hole(TilePlace at) { return at.x == 21 && at.y == 21; }
    void trace(const TilePlace* places, int count, PointRecord* records) {
        traced += count;
        for (int i = 0; i < count; ++i) {
            const bool hole = is_hole(places[i]);
            const float shade = light_at(static_cast<float>(places[i].x));
            const float value = hole ? 0.77F : shade * stripe_at(places[i].x) + 0.01F;
            records[i] = {};
            records[i].whole = Float4{value, value, value, 1};
            records[i].light = Float4{0.01F, 0.01F, 0.01F, 0};
            records[i].shade = Float4{shade, shade, shade, 0};
            records[i].surface = records[i].signature = records[i].outline = hole ? 9 : 5;
        }
    }
    void look(const TilePlace* places, int count, SurfaceLook* looks) {
        looked += count;
        for (int i = 0; i < count; ++i) {
            const float stripe = stripe_at(places[i].x);
            looks[i].whole = looks[i].light + looks[i].shade * Float4{stripe, stripe, stripe, 0};
            looks[i].surface = is_hole(places[i]) ? 9 : 5;
        }
    }
};

// Catches textures that are interpolated, and objects in front of them that only a look finds.
TEST(ScanlineRefinement, TexturesAreLookedUpForEachPixel) {
    StripedTracer tracer;
    const Refined refined = refine_by(tracer, 64, 64);
    EXPECT_EQ(tracer.looked, 64 * 64 - 8 * 64);
    EXPECT_EQ(tracer.traced, 9 * 64 + 1);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            if (x == 21 && y == 21) continue;
            const double wanted = StripedTracer::light_at(static_cast<float>(x)) * StripedTracer::stripe_at(x) + 0.01F;
            EXPECT_NEAR(wanted, static_cast<double>(refined.at(x, y)[0]), 1e-5) << x << "," << y;
        }
    EXPECT_EQ(0.77F, refined.at(21, 21)[0]);
}

}  // namespace
}  // namespace sundog::sampling
