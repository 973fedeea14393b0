// SPDX-License-Identifier: Apache-2.0
// The tracer of grid refinement, in units that hold a kernel: after packet_traversal.h and the integrator.
#pragma once

#include <algorithm>
#include <array>

#include "device/cpu/grid_kernel.h"
#include "device/cpu/packet_traversal.h"
#include "device/cpu/tracing.h"
#include "kernel/cameras/projections.h"
#include "kernel/integrators/whitted.h"

namespace sundog::cpu {
namespace {

using namespace kernel;
using sampling::Float4;
using sampling::PointRecord;
using sampling::SurfaceLook;
using sampling::TilePlace;

struct StoredReal {
    alignas(64) std::array<float, kLanes> at;
    explicit StoredReal(real x) { lanes_of(at.data()) = x.v; }
};
struct StoredWord {
    alignas(64) std::array<unsigned, kLanes> at;
    explicit StoredWord(word x) { lanes_of(at.data()) = x.v; }
};
struct StoredColor {
    StoredReal r, g, b;
    explicit StoredColor(const real3& c) : r(c.x), g(c.y), b(c.z) {}
    [[nodiscard]] Float4 of(std::size_t lane, float fourth) const {
        return Float4{r.at[lane], g.at[lane], b.at[lane], fourth};
    }
};

/// sampling::GridRefinement's tracer.
class Tracer {
public:
    Tracer(const SceneView& view, const GridWork& work) : view_(view), work_(work) {}

    void trace(const TilePlace* places, int count, PointRecord* records) {
        for (int begin = 0; begin < count; begin += kLanes) {
            const int here = std::min(kLanes, count - begin);
            Ray ray;
            const mask alive = rays_through(places + begin, here, ray);
            FirstHit first;
            RayCounts counts{word(0U), word(0U)};
            const StoredColor whole(radiance_along(view_, ray, alive, counts, first));
            counts_.rays = counts_.rays + counts.rays;
            counts_.shadow_rays = counts_.shadow_rays + counts.shadow_rays;
            const PathRecord& record = first.record;
            const StoredColor rest(record.rest), shade(record.shade);
            const StoredReal beyond(record.beyond);
            const StoredWord signature(select(record.unlike != word(0U), word(0U), record.signature | word(1U)));
            const StoredWord highlights(record.highlights), surface(record.surface);
            for (std::size_t lane = 0; lane < static_cast<std::size_t>(here); ++lane) {
                PointRecord& to = records[static_cast<std::size_t>(begin) + lane];
                to.whole = whole.of(lane, 1);
                to.signature = signature.at[lane];
                to.highlights = highlights.at[lane];
                to.surface = surface.at[lane];
                to.light = to.surface != 0 ? rest.of(lane, beyond.at[lane]) : whole.of(lane, beyond.at[lane]);
                to.shade = to.surface != 0 ? shade.of(lane, 0) : Float4{};
            }
            if ((work_.film.aovs & AOV_COST) != 0) add_cost(places + begin, here, counts.rays);
        }
    }

    void look(const TilePlace* places, int count, SurfaceLook* looks) {
        for (int begin = 0; begin < count; begin += kLanes) {
            const int here = std::min(kLanes, count - begin);
            Ray ray;
            const mask alive = rays_through(places + begin, here, ray);
            word numbers;
            const real3 colors = texture_along(view_, ray, alive, numbers);
            counts_.rays = counts_.rays + select(alive, word(1U), word(0U));
            SurfaceLook* const some = looks + begin;
            for (int c = 0; c < 3; ++c) {
                alignas(64) std::array<float, kLanes> light{}, shade{};
                for (int lane = 0; lane < here; ++lane)
                    light[static_cast<std::size_t>(lane)] = some[lane].light[c],
                    shade[static_cast<std::size_t>(lane)] = some[lane].shade[c];
                real& color = c == 0 ? seen_.x : c == 1 ? seen_.y : seen_.z;
                const real& texture = c == 0 ? colors.x : c == 1 ? colors.y : colors.z;
                color = real(lanes_of(light.data())) + real(lanes_of(shade.data())) * texture;
            }
            const StoredColor whole(linear_light(view_, seen_));
            const StoredWord surface(numbers);
            for (std::size_t lane = 0; lane < static_cast<std::size_t>(here); ++lane) {
                some[lane].whole = whole.of(lane, 1);
                some[lane].surface = surface.at[lane];
            }
        }
    }

    [[nodiscard]] GridRays rays() const { return {sum_lanes(counts_.rays), sum_lanes(counts_.shadow_rays), 0}; }

private:
    mask rays_through(const TilePlace* places, int count, Ray& ray) const {
        // Lanes beyond the last repeat it, so that packets stay narrow.
        alignas(64) std::array<float, kLanes> x, y;
        for (int lane = 0; lane < kLanes; ++lane) {
            const TilePlace& place = places[std::min(lane, count - 1)];
            x[static_cast<std::size_t>(lane)] = static_cast<float>(work_.region.x0 + place.x);
            y[static_cast<std::size_t>(lane)] = static_cast<float>(work_.region.y0 + place.y);
        }
        const vec2 offset = pixel_sample(0);
        ray = camera_ray(view_.frame,
                         (real(lanes_of(x.data())) + offset.x) * (1.0F / static_cast<float>(view_.frame.width)),
                         (real(lanes_of(y.data())) + offset.y) * (1.0F / static_cast<float>(view_.frame.height)));
        vuint active{};
        for (int lane = 0; lane < count; ++lane) active[lane] = ~0U;
        return mask_and(word(active) != word(0U), ray.t_max > ray.t_min);
    }

    void add_cost(const TilePlace* places, int count, word rays) const {
        for (int lane = 0; lane < count; ++lane) {
            const int x = work_.region.x0 + places[lane].x, y = work_.region.y0 + places[lane].y;
            if (x < work_.region.x1 && y < work_.region.y1)
                work_.film.cost[work_.film.index(x, y)] = static_cast<float>(rays.v[lane]);
        }
    }

    const SceneView& view_;
    const GridWork& work_;
    RayCounts counts_{word(0U), word(0U)};
    real3 seen_{real(0.0F)};
};

GridRays refine_grid_tile(const GridWork& work) {
    SceneView view = view_of(work.scene, work.frame, work.traversal);
    view.records = true;
    view.indirect = work.indirect;
    view.photons = work.photons;
    Tracer tracer(view, work);
    Film& film = work.film;
    const PixelRect& region = work.region;
    if ((film.aovs & AOV_COST) != 0)
        for (int y = region.y0; y < region.y1; ++y)
            std::fill_n(film.cost.begin() + static_cast<std::ptrdiff_t>(film.index(region.x0, y)), region.width(),
                        0.0F);
    const sampling::TilePixels pixels{film.radiance[film.index(region.x0, region.y0)].data(),
                                      std::ptrdiff_t{4} * film.bounds.width(), region.width(), region.height()};
    const int points = work.refinement.refine(tracer, pixels, work.quality, work.finest);
    GridRays rays = tracer.rays();
    rays.points = static_cast<std::uint64_t>(points);
    return rays;
}

}  // namespace
}  // namespace sundog::cpu
