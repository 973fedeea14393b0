// SPDX-License-Identifier: Apache-2.0
// Compiled once per width (SUNDOG_KERNEL_LANES), under the names SUNDOG_INTERSECT_SOLID and SUNDOG_OCCLUDED_BY_SOLID:
// exact solids against all lanes of a packet at once. Most rays that come through a solid's box pass it by, and are
// told so here; so are the hits of solids that are made of a few convex shapes.
#include <cstring>

#include "device/accel/primitive_facts.h"
#include "device/cpu/embree.h"
#include "device/cpu/geometry_data.h"
#include "device/cpu/quick_solid.h"
#include "device/cpu/quick_stretches.h"
#include "device/cpu/solid_callbacks.h"

namespace sundog::cpu {
namespace {

using namespace kernel;
using Role = QuickPart::Role;

/// Places so near to each other, relative to the distances in question, are compared by CompiledSolid, which takes
/// what is twenty times nearer for one place.
constexpr double kNear = 2e-9;

wide near_at(wide t, wide distance) { return wide(kNear) * (abs(t) + distance); }

WideRays rays_of(RTCRayN* rays, int half, float reach) {
    constexpr unsigned n = kLanes;
    WideRays out;
    out.origin = {half_of(RTCRayN_org_x(rays, n, 0), half), half_of(RTCRayN_org_y(rays, n, 0), half),
                  half_of(RTCRayN_org_z(rays, n, 0), half)};
    out.direction = {half_of(RTCRayN_dir_x(rays, n, 0), half), half_of(RTCRayN_dir_y(rays, n, 0), half),
                     half_of(RTCRayN_dir_z(rays, n, 0), half)};
    out.lower = half_of(RTCRayN_tnear(rays, n, 0), half);
    vhalf far;
    std::memcpy(&far, &RTCRayN_tfar(rays, n, 0) + half * kWideLanes, sizeof far);
    far = far * reach;  // in single precision, as for single rays
    out.upper = wide(__builtin_convertvector(far, vdouble));
    return out;
}

/// Lanes in which there is a ray that sees the geometry.
unsigned asking_lanes(const GeometryData& data, const int* valid, RTCRayN* rays) {
    vuint asked, seen;
    std::memcpy(&asked, valid, sizeof asked);
    std::memcpy(&seen, &RTCRayN_mask(rays, kLanes, 0), sizeof seen);
    return lane_bits(mask_and(word(asked) != word(0U), (word(seen) & word(data.visible_to)) != word(0U)));
}

/// What half of a packet is told.
struct Told {
    unsigned met = 0;     ///< Lanes whose first hit is known.
    unsigned unsure = 0;  ///< Lanes to be asked ray by ray.
    wide t, place, face;  ///< Of those that met, as QuickHits have them.
};

Told one_part(const QuickPart& part, const WideRays& rays, wide_mask asking) {
    WideStretch s;
    part_stretch(part, rays, s);
    const wide_mask lower_met = (s.lower > rays.lower) & (s.lower < rays.upper);
    const wide_mask upper_met = (s.upper > rays.lower) & (s.upper < rays.upper) & (s.lower < rays.upper);
    Told told;
    told.met = bits_of(asking & ~s.misses & ~s.unknown & (lower_met | upper_met));
    told.unsure = bits_of(asking & s.unknown);
    told.t = select(lower_met, s.lower, s.upper);
    told.place = select(lower_met, wide(0.0), wide(1.0));
    told.face = select(lower_met, s.lower_part, s.upper_part);
    return told;
}

Told several_parts(const QuickSolid& solid, const WideRays& rays, wide_mask asking) {
    std::array<WideStretch, kMaxExactParts> all;
    const std::size_t count = solid.parts.size();
    const wide distance = sqrt(dot(rays.origin, rays.origin) / dot(rays.direction, rays.direction));
    Told told;
    wide_mask alive = asking;
    wide_mask unknown = mask_of(0);
    wide lower = rays.lower;
    wide upper = rays.upper;
    for (std::size_t i = 0; i < count; ++i) {
        WideStretch& s = all[i];
        part_stretch(solid.parts[i], rays, s);
        unknown = unknown | s.unknown;
        if (solid.parts[i].role == Role::cut) continue;
        lower = max(lower, s.lower);
        upper = min(upper, s.upper);
        alive = alive & ~(s.misses & ~s.unknown) & ~(lower > upper + near_at(upper, distance));
        if (!any_lane(alive)) return told;
    }
    wide best(kEndless);
    wide first_unsure(kEndless);
    told.place = told.face = wide(0.0);
    for (std::size_t i = 0; i < count; ++i) {
        if (solid.parts[i].role == Role::clip) continue;
        const bool cuts = solid.parts[i].role == Role::cut;
        for (int end = 0; end < 2; ++end) {
            const WideStretch& own = all[i];
            const wide t = end == 0 ? own.lower : own.upper;
            wide_mask shows = alive & (t > rays.lower) & (t < rays.upper);
            if (cuts) shows = shows & ~own.misses;
            const wide near = near_at(t, distance);
            wide_mask sure = own.upper - own.lower > near;
            for (std::size_t k = 0; k < count && any_lane(shows); ++k) {
                if (k == i) continue;
                const WideStretch& other = all[k];
                const wide_mask well_inside = (t > other.lower + near) & (t < other.upper - near);
                const wide_mask well_outside = (t < other.lower - near) | (t > other.upper + near);
                if (solid.parts[k].role == Role::cut) {
                    shows = shows & ~(well_inside & ~other.misses);
                    sure = sure & (well_outside | other.misses);
                } else {
                    shows = shows & ~well_outside;
                    sure = sure & well_inside;
                }
            }
            const wide_mask nearer = shows & sure & (t < best);
            best = select(nearer, t, best);
            told.place = select(nearer, wide(2.0 * static_cast<double>(i) + end), told.place);
            told.face = select(nearer, end == 0 ? own.lower_part : own.upper_part, told.face);
            first_unsure = select(shows & ~sure & (t < first_unsure), t, first_unsure);
        }
    }
    told.t = best;
    const wide_mask unsure =
        alive &
        (unknown | ((first_unsure < wide(kEndless)) & ~(best < first_unsure - near_at(first_unsure, distance))));
    told.unsure = bits_of(unsure);
    told.met = bits_of(alive & ~unsure & (best < wide(kEndless)));
    return told;
}

/// A stretch of each ray, of which nothing is known off `lower` to `upper` but that the node isn't there.
struct WideHull {
    wide lower, upper;
};

// NOLINTNEXTLINE(misc-no-recursion): as deep as QuickSolid, of kMaxQuickNodes
void hull_of(const QuickSolid& solid, std::size_t index, const WideRays& rays, wide distance, WideHull& out) {
    const QuickNode& node = solid.nodes[index];
    out = {rays.lower, rays.upper};
    if (node.kind == QuickNode::Kind::anything) return;
    if (node.kind == QuickNode::Kind::part) {
        WideStretch s;
        part_stretch(solid.parts[node.first], rays, s);
        out.lower = select(s.unknown, rays.lower, select(s.misses, wide(kEndless), max(rays.lower, s.lower)));
        out.upper = select(s.unknown, rays.upper, select(s.misses, wide(-kEndless), min(rays.upper, s.upper)));
        return;
    }
    const bool joined = node.kind == QuickNode::Kind::joined;
    if (joined) out = {wide(kEndless), wide(-kEndless)};
    for (std::size_t i = node.first; i < node.first + node.count; ++i) {
        WideHull child;
        hull_of(solid, i, rays, distance, child);
        if (!joined) {
            out = {max(out.lower, child.lower), min(out.upper, child.upper)};
            if (!any_lane(out.lower <= out.upper + near_at(out.upper, distance))) return;
        } else {
            const wide_mask there = child.lower <= child.upper + near_at(child.upper, distance);
            out.lower = select(there, min(out.lower, child.lower), out.lower);
            out.upper = select(there, max(out.upper, child.upper), out.upper);
        }
    }
}

Told only_misses(const QuickSolid& solid, const WideRays& rays, wide_mask asking) {
    const wide distance = sqrt(dot(rays.origin, rays.origin) / dot(rays.direction, rays.direction));
    WideHull hull;
    hull_of(solid, 0, rays, distance, hull);
    Told told;
    // Endless ends differ by nothing that is a number.
    const wide_mask gone = (hull.lower > hull.upper + near_at(hull.upper, distance)) |
                           ((hull.lower == wide(kEndless)) & (hull.upper == wide(-kEndless)));
    told.unsure = bits_of(asking & ~gone);
    return told;
}

Told ask(const QuickSolid& solid, RTCRayN* rays, int half, float reach, unsigned asking) {
    const WideRays wide_rays = rays_of(rays, half, reach);
    const wide_mask lanes = mask_of(asking);
    if (!solid.exact) return only_misses(solid, wide_rays, lanes);
    return solid.parts.size() == 1 ? one_part(solid.parts[0], wide_rays, lanes)
                                   : several_parts(solid, wide_rays, lanes);
}

constexpr unsigned kHalf = (1U << kWideLanes) - 1U;

}  // namespace

void SUNDOG_INTERSECT_SOLID(const RTCIntersectFunctionNArguments* args) {
    const auto& data = *static_cast<const GeometryData*>(args->geometryUserPtr);
    if (args->N != kLanes || data.quick == nullptr) {
        intersect_solid(args);
        return;
    }
    RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, kLanes);
    const unsigned asking = asking_lanes(data, args->valid, rays);
    unsigned met = 0;
    unsigned unsure = 0;
    QuickHits hits;
    for (int half = 0; half < 2; ++half) {
        const int first = half * kWideLanes;
        if ((asking >> first & kHalf) == 0) continue;
        const Told told = ask(*data.quick, rays, half, 1 + accel::kCoincident, asking >> first & kHalf);
        met |= told.met << first;
        unsure |= told.unsure << first;
        if (told.met == 0) continue;
        std::memcpy(hits.t.data() + first, &told.t.v, sizeof told.t.v);
        std::memcpy(hits.place.data() + first, &told.place.v, sizeof told.place.v);
        std::memcpy(hits.face.data() + first, &told.face.v, sizeof told.face.v);
    }
    if (data.culling) unsure |= met, met = 0;
    if (met != 0) enter_quick_hits(args, met, hits);
    if (unsure != 0) intersect_solid_in(args, unsure);
}

void SUNDOG_OCCLUDED_BY_SOLID(const RTCOccludedFunctionNArguments* args) {
    const auto& data = *static_cast<const GeometryData*>(args->geometryUserPtr);
    if (args->N != kLanes || data.quick == nullptr) {
        occluded_by_solid(args);
        return;
    }
    const unsigned asking = asking_lanes(data, args->valid, args->ray);
    unsigned met = 0;
    unsigned unsure = 0;
    for (int half = 0; half < 2; ++half) {
        const int first = half * kWideLanes;
        if ((asking >> first & kHalf) == 0) continue;
        const Told told = ask(*data.quick, args->ray, half, 1, asking >> first & kHalf);
        met |= told.met << first;
        unsure |= told.unsure << first;
    }
    if (data.culling) unsure |= met, met = 0;
    for (unsigned left = met; left != 0; left &= left - 1)
        RTCRayN_tfar(args->ray, kLanes, static_cast<unsigned>(__builtin_ctz(left))) = -INFINITY;
    if (unsure != 0) occluded_by_solid_in(args, unsure);
}

}  // namespace sundog::cpu
