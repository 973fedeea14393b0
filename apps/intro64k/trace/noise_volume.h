// SPDX-License-Identifier: Apache-2.0
// Noise made once and looked up ever after: a cube of octaves of the kernel's lattice noise that repeats without seams.
#pragma once

#include "kernel/patterns/noise.h"
#include "trace/lanes.h"
#include "trace/tables.h"

INTRO_LANES_BEGIN

/// lattice_sum() of kernel/patterns/noise.h with a period of `period` cells (a power of two) along each axis.
FN real periodic_noise(real3 p, uint period, uint seed) {
    real3 cell = real3(floor(p.x), floor(p.y), floor(p.z));
    real3 f = p - cell;
    word wrap = word(period - 1u);
    real sx = f.x * f.x * (3.0f - 2.0f * f.x);
    real sy = f.y * f.y * (3.0f - 2.0f * f.y);
    real sz = f.z * f.z * (3.0f - 2.0f * f.z);
    word x = word_from_real(cell.x);
    word y = word_from_real(cell.y);
    word z = word_from_real(cell.z);
    real sum = real(0.0f);
    for (uint corner = 0u; corner < 8u; corner = corner + 1u) {
        uint dx = corner & 1u;
        uint dy = (corner >> 1u) & 1u;
        uint dz = corner >> 2u;
        word hash = lattice_hash((x + word(dx)) & wrap, (y + word(dy)) & wrap, ((z + word(dz)) & wrap) + word(seed));
        real3 offset = real3(f.x - float(dx), f.y - float(dy), f.z - float(dz));
        real weight = (dx == 1u ? sx : 1.0f - sx) * (dy == 1u ? sy : 1.0f - sy) * (dz == 1u ? sz : 1.0f - sz);
        sum = sum + weight * lattice_noise(hash, offset, NOISE_SLOPE_SHARE, 1.0f);
    }
    return sum;
}

/// Fills the slices [first, last) of the volume: 16 bits a voxel, those of its neighbour along x above them.
inline void make_noise_slices(uint* voxels, uint first, uint last) {
    for (uint z = first; z < last; z = z + 1u) {
        for (uint y = 0u; y < kVolumeSide; y = y + 1u) {
            uint row[kVolumeSide + kLanes];
            for (uint x = 0u; x < kVolumeSide; x = x + kLanes) {
                vfloat along{};
                for (int lane = 0; lane < kLanes; ++lane)
                    along[lane] = static_cast<float>(x) + static_cast<float>(lane);
                real3 p = real3(real(along), real(float(y)), real(float(z))) * real(4.0f / kVolumeSide);
                real sum = real(0.0f);
                float weight = 0.5f;
                uint period = 4u;
                for (uint octave = 0u; octave < 5u; octave = octave + 1u) {
                    sum = sum + periodic_noise(p, period, octave * 977u) * weight;
                    p = p * real(2.0f);
                    weight = weight * 0.5f;
                    period = period * 2u;
                }
                word scaled = word_from_real(clamp(0.5f + sum * 0.62f, real(0.0f), real(1.0f)) * 65535.0f);
                for (int lane = 0; lane < kLanes; ++lane) row[x + static_cast<uint>(lane)] = scaled.v[lane];
            }
            row[kVolumeSide] = row[0];
            uint* out = voxels + ((z << kVolumeBits) + y) * kVolumeSide;
            for (uint x = 0u; x < kVolumeSide; x = x + 1u) out[x] = row[x] | row[x + 1u] << 16u;
        }
    }
}

/// The eight voxels around a place, and where it lies among them.
struct Voxels {
    real3 f;
    real near[4], far[4];  ///< Along x: at (y, z) = (0, 0), (1, 0), (0, 1), (1, 1). 0 to 65535.
};

FN Voxels voxels_at(const uint* voxels, real3 p) {
    real3 q = p * real(float(kVolumeSide));
    real3 cell = real3(floor(q.x), floor(q.y), floor(q.z));
    const float positive = 4194304.0f;  // a multiple of the period
    word wrap = word(kVolumeSide - 1u);
    word x = word_from_real(cell.x + positive) & wrap;
    word y0 = word_from_real(cell.y + positive) & wrap;
    word z0 = word_from_real(cell.z + positive) & wrap;
    word y1 = (((y0 + word(1u)) & wrap) << kVolumeBits) + x;
    word z1 = ((z0 + word(1u)) & wrap) << (2u * kVolumeBits);
    y0 = (y0 << kVolumeBits) + x;
    z0 = z0 << (2u * kVolumeBits);
    word corner[4] = {y0 + z0, y1 + z0, y0 + z1, y1 + z1};
    Voxels v;
    v.f = q - cell;
    for (uint i = 0u; i < 4u; i = i + 1u) {
        word pair = gather_lanes(voxels, 1, corner[i]);
        v.near[i] = real_from_word(pair & word(0xffffu));
        v.far[i] = real_from_word(pair >> 16u);
    }
    return v;
}

/// The noise at p, 0 to 1 with mean 0.5; it repeats along each axis with period 1.
[[gnu::noinline]] inline real noise_at(const uint* voxels, const real3& p) {
    Voxels v = voxels_at(voxels, p);
    real value[4];
    for (uint i = 0u; i < 4u; i = i + 1u) value[i] = v.near[i] + (v.far[i] - v.near[i]) * v.f.x;
    real front = value[0] + (value[1] - value[0]) * v.f.y;
    real back = value[2] + (value[3] - value[2]) * v.f.y;
    return (front + (back - front) * v.f.z) * (1.0f / 65535.0f);
}

/// How fast noise, smoothed within voxels, changes along x and y, per side of a voxel.
[[gnu::noinline]] inline real2 noise_slopes(const uint* voxels, const real3& p) {
    Voxels v = voxels_at(voxels, p);
    real sx = v.f.x * v.f.x * (3.0f - 2.0f * v.f.x);
    real sy = v.f.y * v.f.y * (3.0f - 2.0f * v.f.y);
    real near0 = v.near[0] + (v.near[2] - v.near[0]) * v.f.z;
    real near1 = v.near[1] + (v.near[3] - v.near[1]) * v.f.z;
    real far0 = v.far[0] + (v.far[2] - v.far[0]) * v.f.z;
    real far1 = v.far[1] + (v.far[3] - v.far[1]) * v.f.z;
    real rise_x = far0 - near0 + (far1 - near1 - far0 + near0) * sy;
    real rise_y = near1 - near0 + (far1 - far0 - near1 + near0) * sx;
    const float scale = 6.0f / 65535.0f;
    return real2(rise_x * v.f.x * (1.0f - v.f.x) * scale, rise_y * v.f.y * (1.0f - v.f.y) * scale);
}

INTRO_LANES_END
