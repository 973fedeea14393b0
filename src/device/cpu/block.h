// SPDX-License-Identifier: Apache-2.0
// Blocks of pixels as units of the kernel trace them: their lanes, their rays, their sums and the film. Only units that
// hold a kernel include it, after an integrator.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "device/cpu/packet_traversal.h"
#include "device/cpu/tile_kernel.h"
#include "kernel/cameras/lens.h"
#include "kernel/cameras/pixel_samples.h"
#include "kernel/cameras/projections.h"
#include "kernel/integrators/path.h"
#include "kernel/materials/normal.h"

KERNEL_BEGIN

#if SUNDOG_KERNEL_LANES == 16
inline constexpr int kBlockWidth = 4, kBlockHeight = 4;
#elif SUNDOG_KERNEL_LANES == 8
inline constexpr int kBlockWidth = 4, kBlockHeight = 2;
#else
inline constexpr int kBlockWidth = 2, kBlockHeight = 2;
#endif

using cpu::TileWork;

/// Pixel coordinates of a block's lanes, row by row.
struct BlockPixels {
    vint x{}, y{};
    BlockPixels(int x0, int y0) {
        for (int lane = 0; lane < kLanes; ++lane) {
            x[lane] = x0 + lane % kBlockWidth;
            y[lane] = y0 + lane / kBlockWidth;
        }
    }
};

struct BlockResult {
    real3 radiance{real(0.0F)};  ///< Sums of samples times their weights, and of these.
    real weights{0.0F};
    RayCounts counts{word(0U), word(0U)};
    FirstHit first;
};

/// A block's sums in memory, lane by lane: picking lanes out of registers one at a time is slow.
struct StoredLanes {
    alignas(64) std::array<float, kLanes> r{}, g{}, b{}, weights{};
};

/// Calls visit(lane, place in the film) for those pixels of the block at (x0, y0) that the work may write.
template <class Visit>
[[gnu::always_inline]] inline void for_each_pixel(int x0, int y0, const TileWork& work, const Visit& visit) {
    const int first_column = std::max(work.region.x0 - x0, 0);
    const int columns = std::min(work.region.x1 - x0, kBlockWidth);
    const int first_row = std::max(work.region.y0 - y0, 0);
    const int rows = std::min(work.region.y1 - y0, kBlockHeight);
    for (int row = first_row; row < rows; ++row) {
        const std::size_t first = work.film.index(x0 + first_column, y0 + row);
        for (int column = first_column; column < columns; ++column) {
            const std::size_t i = first + static_cast<std::size_t>(column - first_column);
            if (work.wanted.empty() || work.wanted[i] != 0)
                visit(static_cast<std::size_t>(row * kBlockWidth + column), i);
        }
    }
}

/// All bits set in the lanes whose pixels are wanted.
inline vuint wanted_lanes(int x0, int y0, const TileWork& work) {
    vuint lanes{};
    for_each_pixel(x0, y0, work, [&](std::size_t lane, std::size_t) { lanes[lane] = ~0U; });
    return lanes;
}

/// What the film holds of a block so far. New samples are added to it one by one, as if there had been no break, so
/// that a picture's bits don't depend on how its samples are split into works.
inline void add_sums_so_far(int x0, int y0, const TileWork& work, BlockResult& block) {
    StoredLanes stored;
    for_each_pixel(x0, y0, work, [&](std::size_t lane, std::size_t i) {
        const std::array<float, 4>& sum = work.film.radiance[i];
        stored.r[lane] = sum[0], stored.g[lane] = sum[1], stored.b[lane] = sum[2], stored.weights[lane] = sum[3];
    });
    block.radiance =
        real3(real(lanes_of(stored.r.data())), real(lanes_of(stored.g.data())), real(lanes_of(stored.b.data())));
    block.weights = real(lanes_of(stored.weights.data()));
}

/// Bends rays by the camera's normals, which lie in the picture: x and y from -0.5 to 0.5.
[[gnu::noinline]] inline void bend_rays(const SceneView& view, std::uint32_t normals, real x, real y, Ray& ray) {
    PatternPoint at = free_point(real3(x - 0.5F, 0.5F - y, real(0.0F)));
    at.normal = ray.direction;
    ray.direction = perturbed_normal(view, normals, at, vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1));
}

/// Rays number `number` of CameraRays for samples `sample` in the lanes of `asked`, and in which of them there is one.
inline mask host_rays(const CameraRays& camera, const FrameParams& frame, const BlockPixels& pixels,
                      const PixelSample& at, word sample, uint number, mask asked, Ray& ray) {
    CameraRays::Place place{.ray = number};
    const vint lanes = lane_ints(asked);
    vuint made{};
    ray.origin = real3(real(0.0F));
    ray.direction = real3(real(0.0F), real(0.0F), real(1.0F));
    ray.t_min = real(0.0F);
    ray.t_max = real(0.0F);
    for (int lane = 0; lane < kLanes; ++lane) {
        if (lanes[lane] == 0) continue;
        place.x = static_cast<std::uint32_t>(pixels.x[lane]), place.y = static_cast<std::uint32_t>(pixels.y[lane]);
        place.dx = at.x.v[lane], place.dy = at.y.v[lane];
        place.sample = sample.v[lane];
        const std::optional<CameraRays::Ray> one = camera.ray(frame, place);
        if (!one) continue;
        made[lane] = ~0U;
        ray.origin.x.v[lane] = one->origin.x;
        ray.origin.y.v[lane] = one->origin.y;
        ray.origin.z.v[lane] = one->origin.z;
        ray.direction.x.v[lane] = one->direction.x;
        ray.direction.y.v[lane] = one->direction.y;
        ray.direction.z.v[lane] = one->direction.z;
        ray.t_max.v[lane] = one->reach;
    }
    return word(made) != word(0U);
}

/// AOVs of one pixel: the first sample's, and the sum of costs.
inline void add_aovs(Film& film, std::size_t i, const BlockResult& block, int lane, bool fresh) {
    if (film.aovs & AOV_COST)
        film.cost[i] = (fresh ? 0.0F : film.cost[i]) + static_cast<float>(block.counts.rays.v[lane]);
    if (!fresh) return;
    const bool missed = block.first.geometry.v[lane] == NONE;
    const auto vec = [&](const real3& v) { return Vec3{v.x.v[lane], v.y.v[lane], v.z.v[lane]}; };
    if (film.aovs & AOV_DEPTH) film.depth[i] = missed ? INFINITY : block.first.t.v[lane];
    if (film.aovs & AOV_NORMAL) film.normal[i] = vec(block.first.normal);
    if (film.aovs & AOV_ALBEDO) film.albedo[i] = vec(block.first.albedo);
    if (film.aovs & AOV_OBJECT) {
        film.object[i] = block.first.geometry.v[lane];
        film.primitive[i] = block.first.primitive.v[lane];
        film.material[i] = block.first.material.v[lane];
    }
}

/// Puts a block's sums and AOVs into the film.
inline void store_block(int x0, int y0, const BlockResult& block, const TileWork& work) {
    Film& film = work.film;
    StoredLanes stored;
    lanes_of(stored.r.data()) = block.radiance.x.v;
    lanes_of(stored.g.data()) = block.radiance.y.v;
    lanes_of(stored.b.data()) = block.radiance.z.v;
    lanes_of(stored.weights.data()) = block.weights.v;
    const bool fresh = work.first_sample == 0;
    for_each_pixel(x0, y0, work, [&](std::size_t lane, std::size_t i) {
        film.radiance[i] = {stored.r[lane], stored.g[lane], stored.b[lane], stored.weights[lane]};
        if (film.aovs != 0) add_aovs(film, i, block, static_cast<int>(lane), fresh);
    });
}

/// Calls trace(x, y, lanes in the picture) for each block of pixels of a work, and stores its BlockResult. Blocks are
/// aligned to the image, whatever the region: a lane's bits can depend on the lanes beside it (Embree may trace a thin
/// packet another way), so those must always be the same ones.
template <class Trace>
[[gnu::always_inline]] inline cpu::TileRays render_blocks(const TileWork& work, const FrameParams& frame,
                                                          const Trace& trace) {
    const vint width = vint{} + static_cast<int>(frame.width);
    const vint height = vint{} + static_cast<int>(frame.height);
    RayCounts counts{word(0U), word(0U)};
    for (int y = work.region.y0 / kBlockHeight * kBlockHeight; y < work.region.y1; y += kBlockHeight) {
        for (int x = work.region.x0 / kBlockWidth * kBlockWidth; x < work.region.x1; x += kBlockWidth) {
            const BlockPixels pixels(x, y);
            vuint inside = std::bit_cast<vuint>(pixels.x < width) & std::bit_cast<vuint>(pixels.y < height);
            if (!work.wanted.empty()) {
                const vuint wanted = wanted_lanes(x, y, work);
                inside &= wanted;
                if (sum_lanes(word(wanted)) == 0) continue;
            }
            const BlockResult block = trace(x, y, word(inside) != word(0U));
            counts.rays = counts.rays + block.counts.rays;
            counts.shadow_rays = counts.shadow_rays + block.counts.shadow_rays;
            store_block(x, y, block, work);
        }
    }
    return {sum_lanes(counts.rays), sum_lanes(counts.shadow_rays)};
}

KERNEL_END
