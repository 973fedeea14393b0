// SPDX-License-Identifier: Apache-2.0
// One tile of the picture: which of its places are traced, and how the pixels between them are filled.
#pragma once

#include "trace/tile_work.h"
#include "trace/trace.h"

INTRO_LANES_BEGIN

inline uint spot_index(uint x, uint y) { return y * kSpotsAcross + x; }

/// 0xRRGGBB of radiance: a film's curve (Narkowicz, ACES Filmic Tone Mapping Curve, 2016), the square root in place of
/// the screen's own gamma, and an ordered pattern that hides steps.
FN word pixel_of(real3 c, real pattern) {
    real channels[3] = {c.x, c.y, c.z};
    word packed = word(0u);
    for (uint i = 0u; i < 3u; i = i + 1u) {
        real x = max(channels[i], real(0.0f));
        real y = x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f);
        y = sqrt(min(y, real(1.0f))) * 255.0f + pattern;
        packed = (packed << 8u) | word_from_real(min(y, real(255.0f)));
    }
    return packed;
}

FN real3 radiance_of(const Tables& tables, const World& world, const real* channels, word texture, bool textured) {
    real3 added = real3(channels[kAdded], channels[kAdded + 1], channels[kAdded + 2]);
    real3 light = real3(channels[kLight], channels[kLight + 1], channels[kLight + 2]);
    if (textured) {
        real3 place = real3(channels[kPlace], channels[kPlace + 1], channels[kPlace + 2]);
        place = place * (1.0f / channels[kDepthShare]);
        light = light * texture_colors(world, tables, texture, place, mask(true));
    }
    return added + light;
}

/// Half a step of ordered noise, 0 to 1, for whole pixels (x, y).
FN real pattern_at(word x, word y) {
    word mixed = (x * word(5u) + y * word(3u) + ((x ^ y) << 2u)) & word(7u);
    return real_from_word(mixed) * 0.125f + 0.0625f;
}

/// Lets what `wanted` names be traced.
inline void trace_wanted(const View& view, TileWork& work, uint tile_x, uint tile_y) {
    uint count = work.wanted_count;
    // The last packet is filled up with places that were wanted anyway.
    for (uint i = 0; i < static_cast<uint>(kLanes); ++i) work.wanted[count + i] = work.wanted[count > 0 ? count - 1 : 0];
    for (uint first = 0; first < count; first += static_cast<uint>(kLanes)) {
        vfloat x{};
        vfloat y{};
        for (int lane = 0; lane < kLanes; ++lane) {
            const Spot spot = work.wanted[first + static_cast<uint>(lane)];
            x[lane] = static_cast<float>(tile_x + spot.x);
            y[lane] = static_cast<float>(tile_y + spot.y);
        }
        Sample out[kLanes];
        trace_lanes(view, work.eye, work.all, real2(real(x), real(y)), out, work.counts);
        for (int lane = 0; lane < kLanes; ++lane) {
            const Spot spot = work.wanted[first + static_cast<uint>(lane)];
            work.samples[spot_index(spot.x, spot.y)] = out[lane];
        }
    }
    work.counts.samples += count;
    work.wanted_count = 0;
}

inline void want(TileWork& work, uint x, uint y) {
    unsigned char& known = work.known[spot_index(x, y)];
    if (known != 0) return;
    known = 1;
    work.wanted[work.wanted_count++] = {static_cast<unsigned char>(x), static_cast<unsigned char>(y)};
}

struct Corners {
    const Sample* s[4];  ///< Left upper, right upper, left lower, right lower.
};

inline Corners corners_of(const TileWork& work, Spot at, uint size) {
    const Sample* first = work.samples + spot_index(at.x, at.y);
    return {{first, first + size, first + size * kSpotsAcross, first + size * kSpotsAcross + size}};
}

/// True where all four corners saw the same, in much the same light: then what is between them is, too. Differences
/// count as the eye sees them, by the square root of the light; a bend more than a slope, which interpolation follows.
inline bool corners_agree(const Corners& c, float tolerance) {
    const uint signature = c.s[0]->signature;
    if (c.s[1]->signature != signature || c.s[2]->signature != signature || c.s[3]->signature != signature) return false;
    for (int i = 0; i < kPlace; ++i) {
        const float v0 = c.s[0]->channels[i];
        const float v1 = c.s[1]->channels[i];
        const float v2 = c.s[2]->channels[i];
        const float v3 = c.s[3]->channels[i];
        const float high = max(max(v0, v1), max(v2, v3));
        const float low = min(min(v0, v1), min(v2, v3));
        const float range = high - low;
        const float bend = v0 + v3 - v1 - v2;
        const float allowed = tolerance * tolerance * (max(high, -low) + 0.02f);
        if (range * range > 0.018f * allowed || bend * bend > 0.0010f * allowed) return false;
    }
    return true;
}

/// Fills a square between its corners; all of it is of one texture.
inline void fill_square(const View& view, const Picture& picture, const Corners& c, uint x0, uint y0, uint size) {
    const bool textured = c.s[0]->texture != 0u;
    const float step = 1.0f / static_cast<float>(size);
    for (uint first = 0; first < size * size; first += static_cast<uint>(kLanes)) {
        vuint px{};
        vuint py{};
        for (uint lane = 0; lane < static_cast<uint>(kLanes); ++lane) {
            px[lane] = (first + lane) & (size - 1);
            py[lane] = ((first + lane) / size) & (size - 1);
        }
        real fx = (real_from_word(word(px)) + 0.5f) * step;
        real fy = (real_from_word(word(py)) + 0.5f) * step;
        real fxy = fx * fy;
        real channels[kChannels];
        const int needed = textured ? kChannels : kPlace;
        for (int i = 0; i < needed; ++i) {
            const float v0 = c.s[0]->channels[i];
            const float v1 = c.s[1]->channels[i] - v0;
            const float v2 = c.s[2]->channels[i] - v0;
            const float v3 = c.s[3]->channels[i] - v0 - v1 - v2;
            channels[i] = v0 + v1 * fx + v2 * fy + v3 * fxy;
        }
        real3 color = radiance_of(*view.tables, *view.world, channels, word(c.s[0]->texture), textured);
        word pixel = pixel_of(color, pattern_at(word(px) + word(x0), word(py) + word(y0)));
        const uint lanes = min(static_cast<uint>(kLanes), size * size - first);
        for (uint lane = 0; lane < lanes; ++lane) {
            const uint x = x0 + px[lane];
            const uint y = y0 + py[lane];
            if (x < picture.width && y < picture.height) picture.pixels[y * picture.pitch + x] = pixel.v[lane];
        }
    }
}

/// Colours of single pixels whose corners don't agree: the mean of the four, each looked up by itself.
inline void fill_pixels(const View& view, const Picture& picture, const TileWork& work, const Square* pixels,
                        uint count, uint tile_x, uint tile_y) {
    const uint corner_offset[4] = {0, 1, kSpotsAcross, kSpotsAcross + 1};
    for (uint first = 0; first < count; first += static_cast<uint>(kLanes)) {
        const uint lanes = min(static_cast<uint>(kLanes), count - first);
        word sum[3] = {word(0u), word(0u), word(0u)};
        for (const uint corner : corner_offset) {
            real channels[kChannels];
            word texture;
            for (uint lane = 0; lane < static_cast<uint>(kLanes); ++lane) {
                const Spot at = pixels[first + min(lane, lanes - 1)].at;
                const Sample& s = work.samples[spot_index(at.x, at.y) + corner];
                for (int i = 0; i < kChannels; ++i) channels[i].v[lane] = s.channels[i];
                texture.v[lane] = s.texture;
            }
            word pixel = pixel_of(radiance_of(*view.tables, *view.world, channels, texture, true), real(0.5f));
            for (uint i = 0; i < 3; ++i) sum[i] = sum[i] + ((pixel >> (8 * i)) & word(255u));
        }
        word mean = word(0u);
        for (uint i = 3; i-- > 0;) mean = (mean << 8u) | ((sum[i] + word(2u)) >> 2u);
        for (uint lane = 0; lane < lanes; ++lane) {
            const Spot at = pixels[first + lane].at;
            const uint x = tile_x + at.x;
            const uint y = tile_y + at.y;
            if (x < picture.width && y < picture.height) picture.pixels[y * picture.pitch + x] = mean.v[lane];
        }
    }
}

INTRO_LANES_END
