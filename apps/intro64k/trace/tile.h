// SPDX-License-Identifier: Apache-2.0
// One tile of the picture: which of its places are traced, and how the pixels between them are filled.
#pragma once

#include "trace/tile_work.h"
#include "trace/trace.h"

namespace sundog::intro {

/// 0xRRGGBB; `pattern` is added to hide steps.
FN word pixel_of(real3 tone, real pattern) {
    real most = real(255.0f);
    return (word_from_real(min(tone.x + pattern, most)) << 16u) | (word_from_real(min(tone.y + pattern, most)) << 8u) |
           word_from_real(min(tone.z + pattern, most));
}

/// Half a step of ordered noise, 0 to 1, for whole pixels (x, y).
FN real pattern_at(word x, word y) {
    word mixed = (x * word(5u) + y * word(3u) + ((x ^ y) << 2u)) & word(7u);
    return real_from_word(mixed) * 0.125f + 0.0625f;
}

inline uint point_index(uint x, uint y) { return y * kPointsAcross + x; }

/// Traces the points that sampling::TracedGrid asks for.
struct PointTracer {
    const View& view;
    TileWork& work;
    uint tile_x, tile_y;

    void trace(const sampling::TilePlace* places, int count, sampling::PointRecord* records) const {
        for (int first = 0; first < count; first += kLanes) {
            // The last packet is filled up with a place that is wanted anyway.
            const int last = count - first - 1;
            float x[kLanes];
            float y[kLanes];
            for (int lane = 0; lane < kLanes; ++lane) {
                const sampling::TilePlace place = places[first + (lane < last ? lane : last)];
                x[lane] = static_cast<float>(tile_x + place.x);
                y[lane] = static_cast<float>(tile_y + place.y);
            }
            real2 at;
            __builtin_memcpy(&at.x, x, sizeof x);
            __builtin_memcpy(&at.y, y, sizeof y);
            const Traced traced = trace_lanes(view, work.eye, work.all, at, work.counts);
            float values[16][kLanes];
            uint hashes[4][kLanes];
            __builtin_memcpy(values, &traced, sizeof values);
            __builtin_memcpy(hashes, &traced.signature, sizeof hashes);
            for (int lane = 0; lane <= last && lane < kLanes; ++lane) {
                sampling::PointRecord& record = records[first + lane];
                const uint point = point_index(places[first + lane].x, places[first + lane].y);
                sampling::Float4* const targets[4] = {&record.light, &record.shade, &work.tones[point],
                                                      &work.places[point]};
                for (int i = 0; i < 16; ++i) (*targets[i / 4])[i % 4] = values[i][lane];
                record.signature = hashes[0][lane];
                record.highlights = hashes[1][lane];
                record.surface = hashes[2][lane];
                record.outline = hashes[3][lane];
            }
        }
    }
};

/// 0, 1, 2, ... in the lanes.
FN word lane_numbers() {
    vuint numbers{};
    for (uint lane = 0; lane < static_cast<uint>(kLanes); ++lane) numbers[lane] = lane;
    return word(numbers);
}

/// Fills a square between its corners; all of it is of one texture.
[[gnu::noinline]] inline void fill_square(const View& view, const Picture& picture, const TileWork& work, uint tile_x,
                                          uint tile_y, sampling::TilePlace at, uint size) {
    const uint texture = work.grid.surface(at.x, at.y);
    const float step = 1.0f / static_cast<float>(size);
    const uint x0 = tile_x + at.x;
    const uint y0 = tile_y + at.y;
    // Channels in fours: tones alone, or light, shade and place.
    float from[12];
    float across[12];
    float down[12];
    float both[12];
    const uint fours = texture != 0u ? 3 : 1;
    for (uint i = 0; i < fours; ++i) {
        sampling::Float4 v[4];
        for (uint corner = 0; corner < 4; ++corner) {
            const uint x = at.x + (corner & 1) * size;
            const uint y = at.y + corner / 2 * size;
            const uint point = point_index(x, y);
            const int ix = static_cast<int>(x);
            const int iy = static_cast<int>(y);
            v[corner] = texture == 0u ? work.tones[point]
                        : i == 0      ? work.grid.light(ix, iy)
                        : i == 1      ? work.grid.shade(ix, iy)
                                      : work.places[point];
        }
        const sampling::Float4 ends[4] = {v[0], v[1] - v[0], v[2] - v[0], v[3] - v[1] - v[2] + v[0]};
        __builtin_memcpy(from + 4UL * i, &ends[0], sizeof ends[0]);
        __builtin_memcpy(across + 4UL * i, &ends[1], sizeof ends[1]);
        __builtin_memcpy(down + 4UL * i, &ends[2], sizeof ends[2]);
        __builtin_memcpy(both + 4UL * i, &ends[3], sizeof ends[3]);
    }
    const bool whole = x0 + size <= picture.width && y0 + size <= picture.height;
    const uint bits = size == 8 ? 3 : size == 4 ? 2 : size == 2 ? 1 : 0;
    for (uint first = 0; first < size * size; first += static_cast<uint>(kLanes)) {
        const word number = lane_numbers() + word(first);
        const word px = number & word(size - 1);
        const word py = (number >> bits) & word(size - 1);
        const real fx = (real_from_word(px) + 0.5f) * step;
        const real fy = (real_from_word(py) + 0.5f) * step;
        real v[12];
        for (uint i = 0; i < 4 * fours; ++i) v[i] = from[i] + across[i] * fx + (down[i] + both[i] * fx) * fy;
        real3 tone = real3(v[0], v[1], v[2]);
        if (texture != 0u) {
            const real3 place = real3(v[8], v[9], v[10]) * (1.0f / v[11]);
            const real3 color = texture_color(*view.tables, view.world->textures[texture], place);
            tone = tone_of(tone + real3(v[4], v[5], v[6]) * color);
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

/// Fills the four pixels of a divided square, each with the mean of its corners' colours.
inline void fill_divided(const Picture& picture, const TileWork& work, uint tile_x, uint tile_y,
                         sampling::TilePlace at) {
    for (uint i = 0; i < 4; ++i) {
        const uint x = at.x + (i & 1);
        const uint y = at.y + i / 2;
        if (tile_x + x >= picture.width || tile_y + y >= picture.height) continue;
        const sampling::Float4* first = work.tones + point_index(x, y);
        const sampling::Float4 mean =
            (first[0] + first[1] + first[kPointsAcross] + first[kPointsAcross + 1]) * 0.25f + 0.5f;
        const auto channel = [mean](int c) { return static_cast<uint>(static_cast<int>(mean[c])); };
        picture.pixels[(tile_y + y) * static_cast<std::size_t>(picture.pitch) + tile_x + x] =
            channel(0) << 16 | channel(1) << 8 | channel(2);
    }
}

}  // namespace sundog::intro
