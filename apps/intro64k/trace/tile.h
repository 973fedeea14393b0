// SPDX-License-Identifier: Apache-2.0
// One tile of the picture: which of its places are traced, and how the pixels between them are filled.
#pragma once

#include "trace/tile_work.h"
#include "trace/trace.h"

INTRO_LANES_BEGIN

inline uint spot_index(uint x, uint y) { return y * kSpotsAcross + x; }

/// 0xRRGGBB; `pattern` is added to hide steps.
FN word pixel_of(real3 tone, real pattern) {
    real most = real(255.0f);
    return (word_from_real(min(tone.x + pattern, most)) << 16u) | (word_from_real(min(tone.y + pattern, most)) << 8u) |
           word_from_real(min(tone.z + pattern, most));
}

/// Of samples that need not have one texture.
FN real3 mixed_tone(const Tables& tables, const World& world, const real* channels, word texture) {
    mask textured = texture != word(0u);
    real3 place = real3(channels[kPlace], channels[kPlace + 1], channels[kPlace + 2]);
    if (!any_lane(textured)) return place;
    real3 color = texture_colors(world, tables, texture, place * (1.0f / channels[kDepthShare]), textured);
    real3 radiance = real3(channels[kAdded], channels[kAdded + 1], channels[kAdded + 2]) +
                     real3(channels[kLight], channels[kLight + 1], channels[kLight + 2]) * color;
    return select(textured, tone_of(radiance), place);
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
    for (uint i = 0; i < static_cast<uint>(kLanes); ++i)
        work.wanted[count + i] = work.wanted[count > 0 ? count - 1 : 0];
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

[[gnu::noinline]] inline void want(TileWork& work, uint x, uint y) {
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
inline bool corners_agree(const Corners& c, uint size, float tolerance) {
    const auto all_have = [&c](uint Sample::*hash) {
        const uint first = c.s[0]->*hash;
        return c.s[1]->*hash == first && c.s[2]->*hash == first && c.s[3]->*hash == first;
    };
    // Edges of shadows and of faint reflections may be as soft as two pixels; outlines may not.
    if (!all_have(size <= 2 ? &Sample::outline : &Sample::signature)) return false;
    if (size <= 2) tolerance = tolerance * (c.s[0]->signature == c.s[3]->signature ? 3.0f : 8.0f);
    // All six channels by two overlapping fours.
    using Four = float __attribute__((vector_size(16)));
    for (int i = 0; i < kPlace; i += kPlace - 4) {
        Four v[4];
        for (int k = 0; k < 4; ++k) __builtin_memcpy(&v[k], c.s[k]->channels + i, sizeof(Four));
        const Four top_high = v[0] > v[1] ? v[0] : v[1];
        const Four top_low = v[0] > v[1] ? v[1] : v[0];
        const Four bottom_high = v[2] > v[3] ? v[2] : v[3];
        const Four bottom_low = v[2] > v[3] ? v[3] : v[2];
        const Four high = top_high > bottom_high ? top_high : bottom_high;
        const Four range = high - (top_low > bottom_low ? bottom_low : top_low);
        const Four bend = v[0] + v[3] - v[1] - v[2];
        const Four allowed = (high + 0.02f) * (tolerance * tolerance);
        const auto over = (range * range > 0.018f * allowed) | (bend * bend > 0.0010f * allowed);
        if (_mm_movemask_ps(std::bit_cast<__m128>(over)) != 0) return false;
        if (i + 4 >= kPlace) break;
    }
    return true;
}

/// 0, 1, 2, ... in the lanes.
FN word lane_numbers() {
    vuint numbers{};
    for (uint lane = 0; lane < static_cast<uint>(kLanes); ++lane) numbers[lane] = lane;
    return word(numbers);
}

/// Fills a square between its corners; all of it is of one texture.
[[gnu::noinline]] inline void fill_square(const View& view, const Picture& picture, const Corners& c, uint x0, uint y0,
                                          uint size) {
    const uint texture = c.s[0]->texture;
    const float step = 1.0f / static_cast<float>(size);
    float from[kChannels];
    float across[kChannels];
    float down[kChannels];
    float both[kChannels];
    const int first_channel = texture != 0u ? 0 : kTone;
    const int channel_count = texture != 0u ? kChannels : 3;
    for (int i = 0; i < channel_count; ++i) {
        const float v0 = c.s[0]->channels[first_channel + i];
        const float v1 = c.s[1]->channels[first_channel + i];
        const float v2 = c.s[2]->channels[first_channel + i];
        const float v3 = c.s[3]->channels[first_channel + i];
        from[i] = v0;
        across[i] = v1 - v0;
        down[i] = v2 - v0;
        both[i] = v3 - v1 - v2 + v0;
    }
    const bool whole = x0 + size <= picture.width && y0 + size <= picture.height;
    const uint bits = size == 8 ? 3 : size == 4 ? 2 : size == 2 ? 1 : 0;
    for (uint first = 0; first < size * size; first += static_cast<uint>(kLanes)) {
        const word number = lane_numbers() + word(first);
        const word px = number & word(size - 1);
        const word py = (number >> bits) & word(size - 1);
        const real fx = (real_from_word(px) + 0.5f) * step;
        const real fy = (real_from_word(py) + 0.5f) * step;
        real v[kChannels];
        for (int i = 0; i < 3; ++i) v[i] = from[i] + across[i] * fx + (down[i] + both[i] * fx) * fy;
        real3 tone = real3(v[0], v[1], v[2]);
        if (texture != 0u) {
            for (int i = 3; i < kChannels; ++i) v[i] = from[i] + across[i] * fx + (down[i] + both[i] * fx) * fy;
            const real3 place = real3(v[kPlace], v[kPlace + 1], v[kPlace + 2]) * (1.0f / v[kDepthShare]);
            const real3 color = texture_color(*view.tables, view.world->textures[texture], place);
            tone = tone_of(tone + real3(v[kLight], v[kLight + 1], v[kLight + 2]) * color);
        }
        const word pixel = pixel_of(tone, pattern_at(px + word(x0), py + word(y0)));
        uint* row = picture.pixels + static_cast<std::size_t>(y0 + (first >> bits)) * picture.pitch + x0;
        if (whole && size >= static_cast<uint>(kLanes)) {
            __builtin_memcpy(row + (first & (size - 1)), &pixel.v, sizeof pixel.v);
            continue;
        }
        uint values[kLanes];
        __builtin_memcpy(values, &pixel.v, sizeof values);
        for (uint i = first; i < min(first + static_cast<uint>(kLanes), size * size); ++i) {
            const uint x = i & (size - 1);
            const uint y = i >> bits;
            if (x0 + x < picture.width && y0 + y < picture.height)
                row[(y - (first >> bits)) * picture.pitch + x] = values[i - first];
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
            float values[kChannels][kLanes];
            uint textures[kLanes];
            for (uint lane = 0; lane < static_cast<uint>(kLanes); ++lane) {
                const Spot at = pixels[first + min(lane, lanes - 1)].at;
                const Sample& s = work.samples[spot_index(at.x, at.y) + corner];
                for (int i = 0; i < kChannels; ++i) values[i][lane] = s.channels[i];
                textures[lane] = s.texture;
            }
            real channels[kChannels];
            word texture;
            __builtin_memcpy(channels, values, sizeof channels);
            __builtin_memcpy(&texture, textures, sizeof texture);
            word pixel = pixel_of(mixed_tone(*view.tables, *view.world, channels, texture), real(0.5f));
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
