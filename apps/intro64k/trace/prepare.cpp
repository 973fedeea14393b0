// SPDX-License-Identifier: Apache-2.0
#include "trace/prepare.h"

#include "kernel/patterns/noise.h"
#include "trace/lanes.h"

namespace sundog::intro {

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
        sum = sum + weight * lattice_noise(hash, offset.x, offset.y, offset.z, NOISE_VALUE_SHARE);
    }
    return sum * (1.0f / (LATTICE_SCALE * NOISE_VALUE_SHARE));
}

}  // namespace sundog::intro

namespace sundog::intro {

void make_noise(uint* voxels, uint first, uint last) {
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
            uint* out = voxels + std::size_t{(z << kVolumeBits) + y} * kVolumeSide;
            for (uint x = 0u; x < kVolumeSide; x = x + 1u) out[x] = row[x] | row[x + 1u] << 16u;
        }
    }
}

void find_visible(const World& world, const Picture& picture, TileWork& work, uint tile_x, uint tile_y) {
    const Camera& camera = world.camera;
    // The tile's edges as planes through the eye: the picture's coordinates are linear in the direction.
    const float right2 = dot(camera.right, camera.right);
    const float up2 = dot(camera.up, camera.up);
    const float depth2 = dot(camera.center, camera.center);
    work.eye.count = 0;
    work.all.count = 0;
    for (auto& row : work.small)
        for (unsigned char& mark : row) mark = 0;
    for (uint i = 0; i < world.solid_count; ++i) {
        const Solid& s = world.solids[i];
        work.all.numbers[work.all.count++] = static_cast<unsigned char>(i);
        if (s.kind == SolidKind::kPlane) {
            work.eye.numbers[work.eye.count++] = static_cast<unsigned char>(i);
            continue;
        }
        const vec3 f = s.middle - camera.eye;
        const float depth = dot(f, camera.center) / depth2;
        const float reach = s.radius / sqrt(depth2);
        if (depth + reach <= 0.0f) continue;
        float left = -1e6f;
        float right = 1e6f;
        float top = -1e6f;
        float bottom = 1e6f;
        if (depth > reach * 1.05f) {
            // Bounds of the sphere's picture, generously: its radius over the depth of its near side.
            const float x = dot(f, camera.right) / right2 / depth;
            const float y = -dot(f, camera.up) / up2 / depth;
            const float skew = sqrt(1.0f + x * x * right2 / depth2 + y * y * up2 / depth2);
            const float rx = s.radius / sqrt(right2) * skew / (depth - reach);
            const float ry = s.radius / sqrt(up2) * skew / (depth - reach);
            const float half_width = static_cast<float>(picture.width) * 0.5f;
            const float half_height = static_cast<float>(picture.height) * 0.5f;
            left = (x - rx + 1.0f) * half_width - static_cast<float>(tile_x);
            right = (x + rx + 1.0f) * half_width - static_cast<float>(tile_x);
            top = (y - ry + 1.0f) * half_height - static_cast<float>(tile_y);
            bottom = (y + ry + 1.0f) * half_height - static_cast<float>(tile_y);
        }
        const float side = static_cast<float>(kTileSide);
        if (left > side || right < 0.0f || top > side || bottom < 0.0f) continue;
        work.eye.numbers[work.eye.count++] = static_cast<unsigned char>(i);
        if (right - left > 24.0f) continue;
        for (uint y = 0; y < 8; ++y)
            for (uint x = 0; x < 8; ++x) {
                const float sx = static_cast<float>(x * 8);
                const float sy = static_cast<float>(y * 8);
                if (left <= sx + 8.0f && right >= sx && top <= sy + 8.0f && bottom >= sy) work.small[y][x] = 1;
            }
    }
}

}  // namespace sundog::intro
