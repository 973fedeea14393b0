// SPDX-License-Identifier: Apache-2.0
// Scan conversion of one side of the cube around a light: of whole cells, not of points. Only units of the rasteriser
// include it.
#pragma once

#include "device/cpu/light_cells.h"
#include "device/cpu/raster/scan_triangles.h"

namespace sundog::cpu::raster {
namespace {

/// A cell's half side, and a hundredth of a cell for what rounding does to the directions that are looked up.
constexpr float kHalfCell = 0.51F;

class CellScan {
public:
    CellScan(const CellsToScan& work, CellScratch& scratch)
        : work_(work), scratch_(scratch), cells_(static_cast<std::size_t>(work.side * (work.end - work.begin))) {
        scratch.low.assign(cells_, -INFINITY);
        scratch.high.assign(cells_, -INFINITY);
        scratch.others.assign(cells_, -INFINITY);
        scratch.nearest.assign(cells_, NONE);
        for (int lane = 0; lane < kLanes; ++lane) numbers_.v[lane] = static_cast<float>(lane) + 0.5F;
    }

    void scan_all() {
        for (const TriangleRun& run : work_.runs)
            for (std::uint32_t first = run.first; first < run.first + run.count; first += kLanes)
                scan_some(first, run.first + run.count);
    }

    void conclude() {
        const real zero(0.0F), nearest_end(work_.nearness_end);
        const std::uint32_t* const opaque = work_.opaque.data();
        for (std::size_t i = 0; i < cells_; i += kLanes) {
            const real low(lanes_at(&scratch_.low[i])), high(lanes_at(&scratch_.high[i]));
            const real others(lanes_at(&scratch_.others[i]));
            const word nearest(lanes_at(&scratch_.nearest[i]));
            const mask sure = mask_and(low > max(others, zero), high < nearest_end);
            const word blocks = load(opaque, sizeof(std::uint32_t), valid_index(sure, nearest));
            lanes_at(work_.cells + i) = select(sure, nearest | blocks, word(NONE)).v;
        }
        for (const PixelRect& r : work_.unknown)
            for (int y = std::max(r.y0, work_.begin); y < std::min(r.y1, work_.end); ++y)
                std::fill(work_.cells + (y - work_.begin) * work_.side + std::max(r.x0, 0),
                          work_.cells + (y - work_.begin) * work_.side + std::min(r.x1, work_.side), NONE);
    }

private:
    void scan_some(std::uint32_t first, std::uint32_t end) {
        const word number = numbers_from(first, end);
        const Corners corners = corners_of(work_.scene, work_.view, number);
        const ScreenBounds b = screen_bounds(work_.view, corners, sound_lanes(corners));
        if (!any_lane(b.seen)) return;
        const TriangleFunctions f = functions_of(work_.view, corners);
        const mask huge = huge_lanes(corners);
        const mask bounded = mask_and(b.bounded, mask_not(huge));
        const real zero(0.0F), last(static_cast<float>(work_.side - 1));
        const real top(static_cast<float>(work_.begin)), bottom(static_cast<float>(work_.end - 1));
        const real x0 = select(bounded, floor(b.x0 - 0.02F), zero), x1 = select(bounded, floor(b.x1 + 0.02F), last);
        const real y0 = select(bounded, floor(b.y0 - 0.02F), top), y1 = select(bounded, floor(b.y1 + 0.02F), bottom);
        const mask any =
            mask_and(mask_and(b.seen, mask_and(x0 <= last, y0 <= bottom)), mask_and(x1 >= zero, y1 >= top));
        const word cx0 = word_from_real(clamp(x0, zero, last)), cx1 = word_from_real(clamp(x1, zero, last));
        const word cy0 = word_from_real(clamp(y0, top, bottom)), cy1 = word_from_real(clamp(y1, top, bottom));
        const vint is_any = lane_ints(any), unsure = lane_ints(mask_or(f.edge_on, huge)), is_huge = lane_ints(huge);
        const StoredTriangles stored(f);
        const int count = static_cast<int>(std::min<std::uint32_t>(kLanes, end - first));
        for (int lane = 0; lane < count; ++lane) {
            if (is_any[lane] == 0) continue;
            const OneTriangle triangle(stored, static_cast<std::size_t>(lane), number.v[lane], INFINITY);
            const BlockRange range{static_cast<int>(cx0.v[lane]), static_cast<int>(cx1.v[lane]),
                                   static_cast<int>(cy0.v[lane]), static_cast<int>(cy1.v[lane])};
            scan(triangle, range, unsure[lane] != 0, is_huge[lane] != 0);
        }
    }

    void scan(const OneTriangle& t, const BlockRange& range, bool unsure, bool everywhere) {
        std::array<float, 3> reach{};
        for (std::size_t i = 0; i < 3; ++i)
            reach[i] = (std::abs(t.edges[i].x) + std::abs(t.edges[i].y)) * kHalfCell + t.rooms[i];
        const real slope((std::abs(t.nearness.x) + std::abs(t.nearness.y)) * kHalfCell);
        const real zero(0.0F);
        for (int y = range.y0; y <= range.y1; ++y)
            for (int x = range.x0 / kLanes * kLanes; x <= range.x1; x += kLanes) {
                const real px = numbers_ + static_cast<float>(x), py(static_cast<float>(y) + 0.5F);
                const std::size_t at = static_cast<std::size_t>((y - work_.begin) * work_.side + x);
                mask touched = mask(true), covered = mask(true), back = mask(true);
                for (std::size_t i = 0; i < 3; ++i) {
                    const real edge = t.edges[i].at(px, py);
                    touched = mask_and(touched, edge >= real(-reach[i]));
                    back = mask_and(back, edge <= real(reach[i]));
                    covered = mask_and(covered, edge > real(reach[i]));
                }
                real others(lanes_at(&scratch_.others[at]));
                if (unsure) {
                    const mask met = everywhere ? mask(true) : mask_or(touched, back);
                    lanes_at(&scratch_.others[at]) = select(met, real(INFINITY), others).v;
                    continue;
                }
                if (!any_lane(touched)) continue;
                const real nearness = t.nearness.at(px, py);
                const real room = (abs(nearness) + slope) * t.relative_room + t.far_room + slope;
                const real low = nearness - room, high = nearness + room;
                const mask possible = mask_and(touched, high > zero);
                const real low_before(lanes_at(&scratch_.low[at])), high_before(lanes_at(&scratch_.high[at]));
                const mask nearer = mask_and(mask_and(possible, covered), low > low_before);
                const real behind = select(nearer, high_before, select(possible, high, others));
                lanes_at(&scratch_.others[at]) = max(others, behind).v;
                lanes_at(&scratch_.low[at]) = select(nearer, low, low_before).v;
                lanes_at(&scratch_.high[at]) = select(nearer, high, high_before).v;
                const word nearest(lanes_at(&scratch_.nearest[at]));
                lanes_at(&scratch_.nearest[at]) = select(nearer, word(t.number), nearest).v;
            }
    }

    const CellsToScan& work_;
    CellScratch& scratch_;
    std::size_t cells_;
    real numbers_;
};

}  // namespace
}  // namespace sundog::cpu::raster
