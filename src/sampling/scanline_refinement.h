// SPDX-License-Identifier: Apache-2.0
// Refinement along scan lines: a tile's picture from few of its rays, each line by itself. Freestanding. A relative of
// grid_refinement.h, to compare it with: on every line each kSquareSide-th pixel is traced at least.
#pragma once

#include "sampling/traced_grid.h"

namespace sundog::sampling {

/// Refines one tile at a time. Large: it doesn't belong on a stack of unknown size.
///
/// A Tracer has what GridRefinement asks of it and, for shade(),
///   void shade(const TilePlace* places, int count, const SeenPrimitive* seen, PointRecord* records)
/// which takes for granted what the eye sees at each place, instead of searching for it; at most TracedGrid::kBatch
/// places. Places may lie up to kSquareSide to the right of the picture.
class ScanlineRefinement {
public:
    /// Makes the pixels of a tile; returns how many points it traced. Spans of a line whose two ends agree are
    /// interpolated; others are halved where their midpoint is traced. `finest` as in GridRefinement::refine().
    template <class Tracer>
    int refine(Tracer& tracer, const TilePixels& pixels, const RefinementQuality& quality,
               const std::uint8_t* finest = nullptr, std::ptrdiff_t finest_stride = kSquaresAcross) {
        divide(
            tracer, pixels, quality, finest, finest_stride,
            [&](TilePlace at, int step) {
                return step > 2 ? grid_.ends_agree(at.x, at.y, step, quality)
                                : grid_.ends_agree_softly(at.x, at.y, quality);
            },
            [&](TilePlace at, int step) {
                if (grid_.surface(at.x, at.y) == 0) fill(at, step, pixels);
                else look(at, step, tracer, pixels);
            });
        look_waiting(tracer, pixels);
        grid_.trace_wanted(tracer, quality, pixels);
        return grid_.traced_count();
    }

    /// The same, but every pixel is shaded: between two ends whose eye rays hit the same primitive, those between are
    /// taken to hit it, too. Primitives are convex, so rays in one plane (a scan line's, unless the camera bends lines)
    /// do so unless something stands before it. Returns how many points it searched for what they see.
    template <class Tracer>
    int shade(Tracer& tracer, const TilePixels& pixels, const RefinementQuality& quality,
              const std::uint8_t* finest = nullptr, std::ptrdiff_t finest_stride = kSquaresAcross) {
        Remembering<Tracer> remembering{tracer, seen_};
        waiting_ = 0;
        divide(
            remembering, pixels, quality, finest, finest_stride,
            [&](TilePlace at, int step) {
                const SeenPrimitive &left = seen_at(at.x, at.y), &right = seen_at(at.x + step, at.y);
                return left.geometry != 0 && left.geometry == right.geometry && left.primitive == right.primitive;
            },
            [&](TilePlace at, int step) {
                if (waiting_ + step > TracedGrid::kBatch) shade_waiting(tracer, pixels);
                for (int x = at.x + 1; x < at.x + step && x < pixels.width; ++x) {
                    assumed_[waiting_] = seen_at(at.x, at.y);
                    places_[waiting_++] = {static_cast<std::uint8_t>(x), at.y};
                }
            });
        shade_waiting(tracer, pixels);
        return grid_.traced_count();
    }

private:
    /// A tracer that also notes what is seen where.
    template <class Tracer>
    struct Remembering {
        Tracer& tracer;
        SeenPrimitive* seen;
        void trace(const TilePlace* places, int count, PointRecord* records) {
            tracer.trace(places, count, records);
            for (int i = 0; i < count; ++i)
                seen[places[i].y * TracedGrid::kPointsAcross + places[i].x] = records[i].seen;
        }
    };
    [[nodiscard]] const SeenPrimitive& seen_at(int x, int y) const { return seen_[y * TracedGrid::kPointsAcross + x]; }

    /// Halves spans, beginning with those of kSquareSide, until agree(first pixel, length) is true, and then calls
    /// make(first pixel, length) for what lies between their ends; their ends are traced.
    template <class Tracer, class Agree, class Make>
    void divide(Tracer& tracer, const TilePixels& pixels, const RefinementQuality& quality, const std::uint8_t* finest,
                std::ptrdiff_t finest_stride, const Agree& agree, const Make& make) {
        grid_.clear();
        waiting_ = 0;
        int count = 0;
        // Columns of spans, so that points that are traced one after the other lie close together.
        for (int x = 0; x < pixels.width; x += kSquareSide)
            for (int y = 0; y < pixels.height; ++y) {
                spans_[0][count++] = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y)};
                grid_.want(x, y);
            }
        const int end = (pixels.width + kSquareSide - 1) / kSquareSide * kSquareSide;
        for (int y = 0; y < pixels.height; ++y) grid_.want(end, y);
        int list = 0;
        for (int step = kSquareSide; step > 1; step /= 2, list = 1 - list) {
            grid_.trace_wanted(tracer, quality, pixels);
            const int half = step / 2;
            int halves = 0;
            for (int i = 0; i < count; ++i) {
                const TilePlace at = spans_[list][i];
                const bool forced =
                    finest != nullptr && step > finest[at.y / kSquareSide * finest_stride + at.x / kSquareSide];
                if (!forced && agree(at, step)) {
                    make(at, step);
                    continue;
                }
                grid_.want(at.x + half, at.y);
                if (half == 1) continue;
                spans_[1 - list][halves++] = at;
                spans_[1 - list][halves++] = {static_cast<std::uint8_t>(at.x + half), at.y};
            }
            count = halves;
        }
        grid_.trace_wanted(tracer, quality, pixels);
    }

    void fill(TilePlace at, int step, const TilePixels& pixels) const {
        Float4 first = grid_.light(at.x, at.y), last = grid_.light(at.x + step, at.y);
        first[3] = last[3] = 1;
        const Float4 slope = (last - first) * (1.0F / static_cast<float>(step));
        StoredFloat4* const line = pixels.row(at.y);
        for (int x = 1; x < step && at.x + x < pixels.width; ++x)
            line[at.x + x] = first + slope * static_cast<float>(x);
    }

    /// Interpolates the light on a textured surface, for look_waiting().
    template <class Tracer>
    void look(TilePlace at, int step, Tracer& tracer, const TilePixels& pixels) {
        if (waiting_ + step > kSquareSide * kSquareSide) look_waiting(tracer, pixels);
        const Float4 shade = grid_.shade(at.x, at.y), light = grid_.light(at.x, at.y);
        const Float4 shade_slope = grid_.shade(at.x + step, at.y) - shade;
        const Float4 light_slope = grid_.light(at.x + step, at.y) - light;
        for (int x = 1; x < step && at.x + x < pixels.width; ++x, ++waiting_) {
            const float part = static_cast<float>(x) / static_cast<float>(step);
            places_[waiting_] = {static_cast<std::uint8_t>(at.x + x), at.y};
            surfaces_[waiting_] = grid_.surface(at.x, at.y);
            looks_[waiting_].shade = shade + shade_slope * part;
            looks_[waiting_].light = light + light_slope * part;
        }
    }
    template <class Tracer>
    void look_waiting(Tracer& tracer, const TilePixels& pixels) {
        if constexpr (requires { tracer.look(places_, 0, looks_); }) {
            if (waiting_ > 0) tracer.look(places_, waiting_, looks_);
            for (int i = 0; i < waiting_; ++i) {
                if (looks_[i].surface != surfaces_[i]) grid_.want(places_[i].x, places_[i].y);
                else pixels.row(places_[i].y)[places_[i].x] = looks_[i].whole;
            }
        }
        waiting_ = 0;
    }

    template <class Tracer>
    void shade_waiting(Tracer& tracer, const TilePixels& pixels) {
        if (waiting_ > 0) tracer.shade(places_, waiting_, assumed_, records_);
        for (int i = 0; i < waiting_; ++i) pixels.row(places_[i].y)[places_[i].x] = records_[i].whole;
        waiting_ = 0;
    }

    static constexpr int kSpans = kRefinedTileSide * kRefinedTileSide / 2;  // of two pixels
    static_assert(TracedGrid::kBatch == kSquareSide * kSquareSide);

    TracedGrid grid_;
    TilePlace spans_[2][kSpans];
    SeenPrimitive seen_[TracedGrid::kPoints];
    // Pixels that wait for others, to be looked up or shaded together.
    int waiting_ = 0;
    TilePlace places_[TracedGrid::kBatch];
    SurfaceLook looks_[TracedGrid::kBatch];
    std::uint32_t surfaces_[TracedGrid::kBatch];  ///< What a look should find.
    SeenPrimitive assumed_[TracedGrid::kBatch];
    PointRecord records_[TracedGrid::kBatch];
};

}  // namespace sundog::sampling
