// SPDX-License-Identifier: Apache-2.0
// Sorting triangles into tiles. Only units of the rasteriser include it.
#pragma once

#include <algorithm>
#include <array>

#include "device/cpu/raster/raster_kernel.h"
#include "device/cpu/raster/triangle_setup.h"

namespace sundog::cpu::raster {
namespace {

using namespace kernel;

struct StoredLanes {
    alignas(64) std::array<float, kLanes> at;
    explicit StoredLanes(real x) { *reinterpret_cast<vfloat*>(at.data()) = x.v; }
};

/// `first` + 0, 1, 2, …; the last again beyond `end`.
word numbers_from(std::uint32_t first, std::uint32_t end) {
    vuint n{};
    for (int lane = 0; lane < kLanes; ++lane) n[lane] = std::min(first + static_cast<std::uint32_t>(lane), end - 1);
    return word(n);
}

/// Lanes whose corners are numbers that Embree takes.
mask sound_lanes(const Corners& c) {
    const real most(1.844e18F);
    const auto sound = [&](const real3& v) {
        return mask_and(mask_and(abs(v.x) < most, abs(v.y) < most), abs(v.z) < most);
    };
    return mask_and(mask_and(sound(c.v0), sound(c.v1)), sound(c.v2));
}

/// What edge functions of larger triangles are would be beyond the numbers of floats.
mask huge_lanes(const Corners& c) {
    const real most(1e11F);
    return mask_not(
        mask_and(mask_and(sum_of_sizes(c.v0) < most, sum_of_sizes(c.v1) < most), sum_of_sizes(c.v2) < most));
}

void bin_triangles(const SceneView& scene, const EyeView& view, TriangleRun run, BinScratch& scratch, Bins& bins) {
    const int across = (static_cast<int>(view.width) + kTileSide - 1) / kTileSide;
    const int down = (static_cast<int>(view.height) + kTileSide - 1) / kTileSide;
    scratch.entries.clear();
    bins.unbounded.clear();
    bins.begins.assign(static_cast<std::size_t>(across * down) + 1, 0);
    const real zero(0.0F), last_x(view.width - 1), last_y(view.height - 1);
    const std::uint32_t end = run.first + run.count;
    for (std::uint32_t first = run.first; first < end; first += kLanes) {
        const word number = numbers_from(first, end);
        const Corners corners = corners_of(scene, view, number);
        const ScreenBounds b = screen_bounds(view, corners, sound_lanes(corners));
        const mask bounded = mask_and(b.bounded, mask_not(huge_lanes(corners)));
        const mask inside =
            mask_and(mask_and(b.x1 >= zero, b.x0 < real(view.width)), mask_and(b.y1 >= zero, b.y0 < real(view.height)));
        const mask binned = mask_and(b.seen, mask_and(bounded, inside));
        const vint is_binned = lane_ints(binned);
        const vint is_unbounded = lane_ints(mask_and(b.seen, mask_not(bounded)));
        const real tile(1.0F / kTileSide);
        const word x0 = word_from_real(clamp(b.x0, zero, last_x) * tile);
        const word x1 = word_from_real(clamp(b.x1, zero, last_x) * tile);
        const word y0 = word_from_real(clamp(b.y0, zero, last_y) * tile);
        const word y1 = word_from_real(clamp(b.y1, zero, last_y) * tile);
        const int count = static_cast<int>(std::min<std::uint32_t>(kLanes, end - first));
        for (int lane = 0; lane < count; ++lane) {
            if (is_unbounded[lane] != 0) bins.unbounded.push_back(number.v[lane]);
            if (is_binned[lane] == 0) continue;
            const BinScratch::Entry entry{
                number.v[lane], static_cast<std::uint16_t>(x0.v[lane]), static_cast<std::uint16_t>(x1.v[lane]),
                static_cast<std::uint16_t>(y0.v[lane]), static_cast<std::uint16_t>(y1.v[lane])};
            scratch.entries.push_back(entry);
            for (int y = entry.y0; y <= entry.y1; ++y)
                for (int x = entry.x0; x <= entry.x1; ++x) ++bins.begins[static_cast<std::size_t>(y * across + x) + 1];
        }
    }
    for (std::size_t i = 1; i < bins.begins.size(); ++i) bins.begins[i] += bins.begins[i - 1];
    bins.triangles.resize(bins.begins.back());
    // From the last to the first, each list grows from its end down to its begin, where the counts then stand.
    for (auto entry = scratch.entries.rbegin(); entry != scratch.entries.rend(); ++entry)
        for (int y = entry->y0; y <= entry->y1; ++y)
            for (int x = entry->x0; x <= entry->x1; ++x)
                bins.triangles[--bins.begins[static_cast<std::size_t>(y * across + x) + 1]] = entry->triangle;
    // Entry i + 1 is now where tile i begins.
    bins.begins.erase(bins.begins.begin());
    bins.begins.push_back(static_cast<std::uint32_t>(bins.triangles.size()));
}

}  // namespace
}  // namespace sundog::cpu::raster
