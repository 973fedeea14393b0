// SPDX-License-Identifier: Apache-2.0
// What the eye may see through a tile of the picture, found from the solids' bounding spheres.
#pragma once

#include "trace/tile.h"

INTRO_LANES_BEGIN

/// Lists the solids that rays through the tile at (tile_x, tile_y) may meet, and marks the squares of 8 pixels in which
/// a solid so small that it could hide between a square's corners may be seen.
inline void find_visible(const View& view, TileWork& work, uint tile_x, uint tile_y) {
    const World& world = *view.world;
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
            const float half_width = view.width * 0.5f;
            const float half_height = view.height * 0.5f;
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

INTRO_LANES_END
