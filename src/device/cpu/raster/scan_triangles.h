// SPDX-License-Identifier: Apache-2.0
// Scan conversion of one tile. Only units of the rasteriser include it.
#pragma once

#include "device/cpu/eye_hits.h"
#include "device/cpu/raster/bin_triangles.h"
#include "kernel/cameras/pixel_samples.h"

namespace sundog::cpu::raster {
namespace {

#if SUNDOG_KERNEL_LANES == 16
constexpr int kBlockWidth = 4, kBlockHeight = 4;
#elif SUNDOG_KERNEL_LANES == 8
constexpr int kBlockWidth = 4, kBlockHeight = 2;
#else
constexpr int kBlockWidth = 2, kBlockHeight = 2;
#endif
constexpr int kBlocksAcross = kTileSide / kBlockWidth;

vfloat& lanes_at(float* first) { return *reinterpret_cast<vfloat*>(first); }
vuint& lanes_at(std::uint32_t* first) { return *reinterpret_cast<vuint*>(first); }

struct StoredLinear {
    StoredLanes x, y, c;
    explicit StoredLinear(const Linear& f) : x(f.x), y(f.y), c(f.c) {}
};

/// Functions of as many triangles as there are lanes, to be scanned one by one.
struct StoredTriangles {
    explicit StoredTriangles(const TriangleFunctions& f)
        : edges{StoredLinear(f.edge0), StoredLinear(f.edge1), StoredLinear(f.edge2)},
          rooms{StoredLanes(f.room0), StoredLanes(f.room1), StoredLanes(f.room2)},
          nearness(f.nearness),
          relative_room(f.relative_room),
          far_room(f.far_room) {}
    std::array<StoredLinear, 3> edges;
    std::array<StoredLanes, 3> rooms;
    StoredLinear nearness;
    StoredLanes relative_room, far_room;
};

/// A linear function along pixels of a block.
struct Line {
    float x, y, c;
    Line(const StoredLinear& f, std::size_t lane) : x(f.x.at[lane]), y(f.y.at[lane]), c(f.c.at[lane]) {}
    [[nodiscard]] real at(const real& px, const real& py) const { return px * x + (py * y + c); }
    /// How far it is from its value in a block's middle at most, where rays are up to `slack` beside their place.
    [[nodiscard]] float reach(float slack) const {
        return std::abs(x) * (0.5F * (kBlockWidth - 1) + slack) + std::abs(y) * (0.5F * (kBlockHeight - 1) + slack);
    }
};

/// One of them.
struct OneTriangle {
    OneTriangle(const StoredTriangles& t, std::size_t lane, std::uint32_t number_, float highest_)
        : edges{Line(t.edges[0], lane), Line(t.edges[1], lane), Line(t.edges[2], lane)},
          rooms{t.rooms[0].at[lane], t.rooms[1].at[lane], t.rooms[2].at[lane]},
          nearness(t.nearness, lane),
          relative_room(t.relative_room.at[lane]),
          far_room(t.far_room.at[lane]),
          number(number_),
          highest(highest_) {}
    std::array<Line, 3> edges;
    std::array<float, 3> rooms;
    Line nearness;
    float relative_room, far_room;
    std::uint32_t number;
    float highest;  ///< No nearness of it is greater.
};

/// Blocks of the tile, inclusively.
struct BlockRange {
    int x0, x1, y0, y1;
};

class TileScan {
public:
    TileScan(const TileToRaster& tile, TileScratch& scratch) : tile_(tile), scratch_(scratch) {
        place_rays();
        // Whole blocks, since a packet's rays are traced together.
        constexpr int kUnit = 4;
        const auto down = [](int pixel) { return static_cast<float>(std::max(pixel, 0) / kUnit * kUnit); };
        const auto up = [](int pixel) {
            return static_cast<float>((std::min(pixel, kTileSide) + kUnit - 1) / kUnit * kUnit - 1);
        };
        first_x_ = real(down(tile.wanted.x0 - tile.x0)), last_x_ = real(up(tile.wanted.x1 - tile.x0));
        first_y_ = real(down(tile.wanted.y0 - tile.y0)), last_y_ = real(up(tile.wanted.y1 - tile.y0));
        std::fill_n(scratch.low, kTilePixels, -INFINITY);
        std::fill_n(scratch.high, kTilePixels, -INFINITY);
        std::fill_n(scratch.others, kTilePixels, -INFINITY);
        std::fill_n(scratch.nearest, kTilePixels, NONE);
    }

    void scan_all() {
        const std::span<const std::uint32_t> all = tile_.triangles;
        for (std::size_t first = 0; first < all.size(); first += kLanes) scan_some(all.subspan(first));
    }

    /// Turns what is known of the rays into what is sure of them.
    void conclude() {
        const real end_low(tile_.view.end_low), end_high(tile_.view.end_high);
        for (int i = 0; i < kTilePixels; i += kLanes) {
            const real low(lanes_at(scratch_.low + i)), high(lanes_at(scratch_.high + i));
            const real others(lanes_at(scratch_.others + i));
            const word nearest(lanes_at(scratch_.nearest + i));
            const mask hit = low > max(others, end_high);
            const mask none = max(high, others) <= end_low;
            const word triangle = select(hit, nearest, select(none, word(NONE), word(EYE_UNKNOWN)));
            lanes_at(scratch_.nearest + i) = triangle.v;
        }
    }

    /// Where a plane is so near to what was found that rounding decides which comes first.
    void ask_at_planes() {
        for (uint i = 0; i < tile_.scene.frame.plane_count; ++i) {
            const Plane& plane = tile_.scene.planes[i];
            const float size = sum_of_sizes(plane.normal);
            const float height = plane.offset - dot(plane.normal, tile_.view.eye);
            const float height_room = kRounding * (std::abs(plane.offset) + size * sum_of_sizes(tile_.view.eye));
            // Seen edge-on, or moving: anything may be.
            const bool known =
                std::abs(height) > 4 * height_room && tile_.scene.geometries[plane.geometry].instance == NONE;
            const float inverse = known ? 1 / height : 0;
            const vec3 across = tile_.view.across, down = tile_.view.down, base = tile_.view.base;
            const float fx = dot(plane.normal, across) * inverse, fy = dot(plane.normal, down) * inverse;
            const float fc = dot(plane.normal, base) * inverse;
            const float relative = height_room * std::abs(inverse) + kRounding;
            const float far = kRounding * size * tile_.view.spread * std::abs(inverse);
            for (int block = 0; block < kTilePixels / kLanes; ++block) {
                const int at = block * kLanes;
                const real nearness = pixel_x(block) * fx + (pixel_y(block) * fy + fc);
                const real room = abs(nearness) * relative + far;
                const real low(lanes_at(scratch_.low + at)), high(lanes_at(scratch_.high + at));
                const word nearest(lanes_at(scratch_.nearest + at));
                mask near = mask_and(nearness + room >= low, nearness - room <= high);
                if (!known) near = mask_or(near, mask_not(near));
                near = mask_and(near, nearest != word(NONE));
                lanes_at(scratch_.nearest + at) = select(near, word(EYE_UNKNOWN), nearest).v;
            }
        }
    }

    /// Where something else may be seen.
    void ask_at(const PixelRect& r) {
        const int x0 = std::max(r.x0 - tile_.x0, 0), x1 = std::min(r.x1 - tile_.x0, kTileSide);
        const int y0 = std::max(r.y0 - tile_.y0, 0), y1 = std::min(r.y1 - tile_.y0, kTileSide);
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) {
                const int block = y / kBlockHeight * kBlocksAcross + x / kBlockWidth;
                scratch_.nearest[block * kLanes + y % kBlockHeight * kBlockWidth + x % kBlockWidth] = EYE_UNKNOWN;
            }
    }

private:
    /// Where the rays of the tile's pixels go: in all pixels the same way, or anywhere in them.
    void place_rays() {
        const PixelSampling& sampling = tile_.sampling;
        const PixelSample first =
            pixel_sample(sampling, word(static_cast<uint>(tile_.x0)), word(static_cast<uint>(tile_.y0)), tile_.sample);
        if (sampling.pattern == SAMPLES_R2 || sampling.pattern == SAMPLES_REGULAR)
            sample_x_ = first.x.v[0], sample_y_ = first.y.v[0], slack_ = 0;
        vuint column{}, row{};
        for (int lane = 0; lane < kLanes; ++lane) {
            column[lane] = static_cast<uint>(tile_.x0 + lane % kBlockWidth);
            row[lane] = static_cast<uint>(tile_.y0 + lane / kBlockWidth);
            middles_.v[lane] = static_cast<float>(lane * kBlockWidth) + 0.5F * (kBlockWidth - 1) + sample_x_;
        }
        for (int block = 0; block < kTilePixels / kLanes; ++block) {
            const word x = word(column) + word(static_cast<uint>(block % kBlocksAcross * kBlockWidth));
            const word y = word(row) + word(static_cast<uint>(block / kBlocksAcross * kBlockHeight));
            const PixelSample at = slack_ > 0 ? pixel_sample(sampling, x, y, tile_.sample) : first;
            lanes_at(scratch_.x + block * kLanes) = (real_from_word(x) + at.x).v;
            lanes_at(scratch_.y + block * kLanes) = (real_from_word(y) + at.y).v;
        }
    }
    [[nodiscard]] real pixel_x(int block) const { return real(lanes_at(scratch_.x + block * kLanes)); }
    [[nodiscard]] real pixel_y(int block) const { return real(lanes_at(scratch_.y + block * kLanes)); }

    void scan_some(std::span<const std::uint32_t> triangles) {
        const int count = static_cast<int>(std::min<std::size_t>(kLanes, triangles.size()));
        vuint numbers{};
        for (int lane = 0; lane < kLanes; ++lane)
            numbers[lane] = triangles[static_cast<std::size_t>(std::min(lane, count - 1))];
        const word number(numbers);
        const Corners corners = corners_of(tile_.scene, tile_.view, number);
        const mask every = number == number;
        const ScreenBounds b = screen_bounds(tile_.view, corners, every);
        const TriangleFunctions f = functions_of(tile_.view, corners);
        const mask huge = huge_lanes(corners);
        const mask bounded = mask_and(b.bounded, mask_not(huge));
        // Pixels whose samples lie within.
        const real left(static_cast<float>(tile_.x0)), top(static_cast<float>(tile_.y0));
        const float slack = slack_;
        const real x0 = select(bounded, -floor(left + (sample_x_ + slack) - b.x0), first_x_);
        const real x1 = select(bounded, floor(b.x1 - (sample_x_ - slack) - left), last_x_);
        const real y0 = select(bounded, -floor(top + (sample_y_ + slack) - b.y0), first_y_);
        const real y1 = select(bounded, floor(b.y1 - (sample_y_ - slack) - top), last_y_);
        const mask any = mask_and(mask_and(x0 <= x1, y0 <= y1), mask_and(mask_and(x1 >= first_x_, y1 >= first_y_),
                                                                         mask_and(x0 <= last_x_, y0 <= last_y_)));
        const word bx0 = word_from_real(clamp(x0, first_x_, last_x_));
        const word bx1 = word_from_real(clamp(x1, first_x_, last_x_));
        const word by0 = word_from_real(clamp(y0, first_y_, last_y_));
        const word by1 = word_from_real(clamp(y1, first_y_, last_y_));
        const vint is_any = lane_ints(any), is_edge_on = lane_ints(f.edge_on), is_huge = lane_ints(huge);
        const StoredTriangles stored(f);
        const StoredLanes highest(
            select(bounded, b.inverse * (1.0F + kRounding) * (1.0F + f.relative_room) + f.far_room, real(INFINITY)));
        for (int lane = 0; lane < count; ++lane) {
            if (is_any[lane] == 0) continue;
            const auto side = [&](const word& pixel, int block) { return static_cast<int>(pixel.v[lane]) / block; };
            const BlockRange range{side(bx0, kBlockWidth), side(bx1, kBlockWidth), side(by0, kBlockHeight),
                                   side(by1, kBlockHeight)};
            const OneTriangle triangle(stored, static_cast<std::size_t>(lane), number.v[lane],
                                       highest.at[static_cast<std::size_t>(lane)]);
            if (is_huge[lane] != 0) give_up(range);
            else if (is_edge_on[lane] != 0) scan_edge_on(triangle, range);
            else if ((range.x1 - range.x0 + 1) * (range.y1 - range.y0 + 1) <= 4) scan_small(triangle, range);
            else scan_large(triangle, range);
        }
    }

    void scan_small(const OneTriangle& triangle, const BlockRange& range) {
        for (int y = range.y0; y <= range.y1; ++y)
            for (int x = range.x0; x <= range.x1; ++x) scan_block<false>(triangle, y * kBlocksAcross + x);
    }

    /// Asks of as many blocks as there are lanes whether the triangle may reach into them, and whether it covers them.
    void scan_large(const OneTriangle& triangle, const BlockRange& range) {
        for (int y = range.y0; y <= range.y1; ++y) {
            const real middle_y(static_cast<float>(tile_.y0 + y * kBlockHeight) + 0.5F * (kBlockHeight - 1) +
                                sample_y_);
            for (int first = range.x0 / kLanes * kLanes; first <= range.x1; first += kLanes) {
                const real middle_x = middles_ + static_cast<float>(tile_.x0 + first * kBlockWidth);
                mask touched = mask(true), covered = mask(true);
                for (std::size_t i = 0; i < 3; ++i) {
                    const real edge = triangle.edges[i].at(middle_x, middle_y);
                    const float reach = triangle.edges[i].reach(slack_);
                    touched = mask_and(touched, edge >= real(-triangle.rooms[i] - reach));
                    covered = mask_and(covered, edge > real(triangle.rooms[i] + reach));
                }
                const unsigned within = (2U << std::min(range.x1 - first, 30)) - (1U << std::max(range.x0 - first, 0));
                const unsigned all = lane_bits(covered);
                for (unsigned some = lane_bits(touched) & within; some != 0; some &= some - 1) {
                    const int x = __builtin_ctz(some);
                    const int block = y * kBlocksAcross + first + x;
                    if ((all >> x & 1U) != 0) scan_block<true>(triangle, block);
                    else scan_block<false>(triangle, block);
                }
            }
        }
    }

    template <bool covered>
    [[gnu::always_inline]] void scan_block(const OneTriangle& triangle, int block) {
        const int at = block * kLanes;
        const real low_before(lanes_at(scratch_.low + at));
        // Behind what all of the block's rays surely meet: nothing changes.
        if (all_lanes(low_before > real(triangle.highest))) return;
        const real px = pixel_x(block), py = pixel_y(block);
        mask possible = mask(true), sure = mask(true);
        if constexpr (!covered) {
            for (std::size_t i = 0; i < 3; ++i) {
                const real edge = triangle.edges[i].at(px, py);
                possible = mask_and(possible, edge >= real(-triangle.rooms[i]));
                sure = mask_and(sure, edge > real(triangle.rooms[i]));
            }
            if (!any_lane(possible)) return;
        }
        const real nearness = triangle.nearness.at(px, py);
        const real room = abs(nearness) * triangle.relative_room + triangle.far_room;
        const real low = nearness - room, high = nearness + room;
        possible = mask_and(possible, high > real(tile_.view.end_low));
        const real high_before(lanes_at(scratch_.high + at));
        const real others(lanes_at(scratch_.others + at));
        const mask nearer = mask_and(mask_and(possible, sure), low > low_before);
        const real behind = select(nearer, high_before, select(possible, high, others));
        lanes_at(scratch_.others + at) = max(others, behind).v;
        lanes_at(scratch_.low + at) = select(nearer, low, low_before).v;
        lanes_at(scratch_.high + at) = select(nearer, high, high_before).v;
        const word nearest(lanes_at(scratch_.nearest + at));
        lanes_at(scratch_.nearest + at) = select(nearer, word(triangle.number), nearest).v;
    }

    /// Where the triangle may be met at all, whichever side it shows.
    void scan_edge_on(const OneTriangle& triangle, const BlockRange& range) {
        for (int y = range.y0; y <= range.y1; ++y)
            for (int x = range.x0; x <= range.x1; ++x) {
                const int block = y * kBlocksAcross + x;
                const real px = pixel_x(block), py = pixel_y(block);
                mask front = mask(true), back = mask(true);
                for (std::size_t i = 0; i < 3; ++i) {
                    const real edge = triangle.edges[i].at(px, py);
                    front = mask_and(front, edge >= real(-triangle.rooms[i]));
                    back = mask_and(back, edge <= real(triangle.rooms[i]));
                }
                ask_in(block, mask_or(front, back));
            }
    }

    void give_up(const BlockRange& range) {
        for (int y = range.y0; y <= range.y1; ++y)
            for (int x = range.x0; x <= range.x1; ++x) ask_in(y * kBlocksAcross + x, mask(true));
    }

    void ask_in(int block, mask lanes) {
        float* const others = scratch_.others + static_cast<std::ptrdiff_t>(block) * kLanes;
        lanes_at(others) = select(lanes, real(INFINITY), real(lanes_at(others))).v;
    }

    const TileToRaster& tile_;
    TileScratch& scratch_;
    float sample_x_ = 0.5F, sample_y_ = 0.5F;  ///< About where in its pixel a ray goes, …
    float slack_ = 0.5F;                       ///< … and how far beside that at most.
    real middles_;
    real first_x_, last_x_, first_y_, last_y_;  ///< Pixels of the tile that are scanned.
};

}  // namespace
}  // namespace sundog::cpu::raster
