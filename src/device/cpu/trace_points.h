// SPDX-License-Identifier: Apache-2.0
// Points of grid refinement through the kernel, as many at a time as it has lanes. Only units that hold one include it.
#pragma once

#include <algorithm>
#include <array>

#include "device/cpu/assumed_hits.h"
#include "device/cpu/packet_traversal.h"
#include "device/cpu/point_kernel.h"
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

/// The rays through up to kLanes places from number `begin` on, and in which lanes there is one.
mask rays_through(const PointBatch& points, int begin, Ray& ray) {
    // Lanes beyond the last repeat it, so that packets stay narrow.
    alignas(64) std::array<float, kLanes> x, y;
    vuint active{};
    for (int lane = 0; lane < kLanes; ++lane) {
        const TilePlace& place = points.places[std::min(begin + lane, points.count - 1)];
        x[static_cast<std::size_t>(lane)] = static_cast<float>(points.x0 + place.x);
        y[static_cast<std::size_t>(lane)] = static_cast<float>(points.y0 + place.y);
        if (begin + lane < points.count) active[lane] = ~0U;
    }
    const FrameParams& frame = points.scene.frame;
    ray = camera_ray(frame, (real(lanes_of(x.data())) + 0.5F) * (1.0F / static_cast<float>(frame.width)),
                     (real(lanes_of(y.data())) + 0.5F) * (1.0F / static_cast<float>(frame.height)));
    return mask_and(word(active) != word(0U), ray.t_max > ray.t_min);
}

BatchRays trace_points(const PointBatch& points, PointRecord* records) {
    RayCounts all{word(0U), word(0U)};
    const PointView view(points.scene);
    for (int begin = 0; begin < points.count; begin += kLanes) {
        Ray ray;
        const mask alive = rays_through(points, begin, ray);
        FirstHit first;
        PathRecord record;
        RayCounts counts{word(0U), word(0U)};
        Hit known;
        if (points.seen != nullptr) {
            known = assumed_hits(view, points.seen + begin, points.count - begin, ray, alive, counts);
            view.next_hit = &known;
        }
        const StoredColor whole(recorded_radiance(view, ray, alive, counts, first, record));
        all.rays = all.rays + counts.rays;
        all.shadow_rays = all.shadow_rays + counts.shadow_rays;
        const StoredColor rest(record.rest), shade(record.shade);
        const StoredReal beyond(record.beyond);
        const StoredWord signature(select(record.unlike != word(0U), word(0U), record.signature | word(1U)));
        const StoredWord outline(record.outline), highlights(record.highlights), surface(record.surface);
        const StoredWord rays(counts.rays), geometry(first.geometry), primitive(first.primitive);
        const auto here = static_cast<std::size_t>(std::min(kLanes, points.count - begin));
        for (std::size_t lane = 0; lane < here; ++lane) {
            PointRecord& to = records[static_cast<std::size_t>(begin) + lane];
            to.whole = whole.of(lane, 1);
            to.signature = signature.at[lane];
            to.outline = outline.at[lane];
            to.highlights = highlights.at[lane];
            to.surface = surface.at[lane];
            to.rays = rays.at[lane];
            to.seen = seen_primitive(view, geometry.at[lane], primitive.at[lane]);
            to.light = to.surface != 0 ? rest.of(lane, beyond.at[lane]) : whole.of(lane, beyond.at[lane]);
            to.shade = to.surface != 0 ? shade.of(lane, 0) : Float4{};
        }
    }
    return {sum_lanes(all.rays), sum_lanes(all.shadow_rays)};
}

#ifdef SUNDOG_LOOK_KERNEL
BatchRays look_at_points(const PointBatch& points, SurfaceLook* looks) {
    const PointView view(points.scene);
    for (int begin = 0; begin < points.count; begin += kLanes) {
        Ray ray;
        const mask alive = rays_through(points, begin, ray);
        word numbers;
        const real3 colors = texture_along(view, ray, alive, numbers);
        const auto here = static_cast<std::size_t>(std::min(kLanes, points.count - begin));
        SurfaceLook* const some = looks + begin;
        const auto lit = [&](int channel, const real& texture) {
            alignas(64) std::array<float, kLanes> light{}, shade{};
            for (std::size_t lane = 0; lane < here; ++lane)
                light[lane] = some[lane].light[channel], shade[lane] = some[lane].shade[channel];
            return real(lanes_of(light.data())) + real(lanes_of(shade.data())) * texture;
        };
        const real3 seen(lit(0, colors.x), lit(1, colors.y), lit(2, colors.z));
        const StoredColor whole(linear_light(view, seen));
        const StoredWord surface(numbers);
        for (std::size_t lane = 0; lane < here; ++lane) {
            some[lane].whole = whole.of(lane, 1);
            some[lane].surface = surface.at[lane];
        }
    }
    return {static_cast<std::uint64_t>(points.count), 0};
}
#endif

}  // namespace
}  // namespace sundog::cpu
