// SPDX-License-Identifier: Apache-2.0
// Looking up the noise volume (trace/prepare.h).
#pragma once

#include "kernel/patterns/noise.h"
#include "trace/lanes.h"
#include "trace/tables.h"

namespace sundog::intro {

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

}  // namespace sundog::intro
