// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/grid_tile.h"

#include <algorithm>

namespace sundog::cpu {
namespace {

/// The tracer of sampling::GridRefinement and ScanlineRefinement.
class Tracer {
public:
    explicit Tracer(const GridWork& work) : work_(work) {}

    void trace(const sampling::TilePlace* places, int count, sampling::PointRecord* records) {
        add(work_.trace(batch(places, count), records));
        if ((work_.film.aovs & kernel::AOV_COST) == 0) return;
        for (int i = 0; i < count; ++i) {
            const int x = work_.region.x0 + places[i].x, y = work_.region.y0 + places[i].y;
            if (x < work_.region.x1 && y < work_.region.y1)
                work_.film.cost[work_.film.index(x, y)] = static_cast<float>(records[i].rays);
        }
    }
    /// What is shaded without a search has no cost: rays didn't go to find what the pixel sees.
    void shade(const sampling::TilePlace* places, int count, const sampling::SeenPrimitive* seen,
               sampling::PointRecord* records) {
        PointBatch some = batch(places, count);
        some.seen = seen;
        add(work_.trace(some, records));
    }
    void look(const sampling::TilePlace* places, int count, sampling::SurfaceLook* looks) {
        add(work_.look(batch(places, count), looks));
    }
    [[nodiscard]] const GridRays& rays() const { return rays_; }

private:
    [[nodiscard]] PointBatch batch(const sampling::TilePlace* places, int count) const {
        return {work_.scene, work_.region.x0, work_.region.y0, places, count};
    }
    void add(const BatchRays& some) {
        rays_.rays += some.rays;
        rays_.shadow_rays += some.shadow_rays;
    }

    const GridWork& work_;
    GridRays rays_;
};

int refine(const GridWork& work, Tracer& tracer, const sampling::TilePixels& pixels) {
    RefinementMemory& memory = work.memory;
    if (work.method == RefinementMethod::grid) {
        if (!memory.grid) memory.grid = std::make_unique<sampling::GridRefinement>();
        return memory.grid->refine(tracer, pixels, work.quality, work.finest, work.finest_stride);
    }
    if (!memory.scanline) memory.scanline = std::make_unique<sampling::ScanlineRefinement>();
    return work.method == RefinementMethod::scanline
               ? memory.scanline->refine(tracer, pixels, work.quality, work.finest, work.finest_stride)
               : memory.scanline->shade(tracer, pixels, work.quality, work.finest, work.finest_stride);
}

}  // namespace

GridRays refine_tile(const GridWork& work) {
    Film& film = work.film;
    const PixelRect& region = work.region;
    if ((film.aovs & kernel::AOV_COST) != 0)
        for (int y = region.y0; y < region.y1; ++y)
            std::fill_n(film.cost.begin() + static_cast<std::ptrdiff_t>(film.index(region.x0, y)), region.width(),
                        0.0F);
    const sampling::TilePixels pixels{film.radiance[film.index(region.x0, region.y0)].data(),
                                      std::ptrdiff_t{4} * film.bounds.width(), region.width(), region.height()};
    Tracer tracer(work);
    const int points = refine(work, tracer, pixels);
    GridRays rays = tracer.rays();
    rays.points = static_cast<std::uint64_t>(points);
    return rays;
}

}  // namespace sundog::cpu
