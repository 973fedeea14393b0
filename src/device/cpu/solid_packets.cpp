// SPDX-License-Identifier: Apache-2.0
// Compiled once per width (SUNDOG_KERNEL_LANES), under the names SUNDOG_INTERSECT_SOLID and SUNDOG_OCCLUDED_BY_SOLID:
// exact solids against all lanes of a packet at once. Most rays that come through a solid's box pass it by, and are
// told so here; so are the hits of solids that are made of a few convex shapes.
#include <cstring>
#include <utility>

#include "device/cpu/coincidence.h"
#include "device/cpu/embree.h"
#include "device/cpu/geometry_data.h"
#include "device/cpu/quick_solid.h"
#include "device/cpu/quick_stretches.h"
#include "device/cpu/solid_callbacks.h"

namespace sundog::cpu {
namespace {

using namespace kernel;

/// Places so near to each other, relative to the distances in question, are compared by CompiledSolid, which takes
/// what is twenty times nearer for one place.
constexpr double kNear = 2e-9;
/// Half of a packet's lanes.
constexpr unsigned kHalf = (1U << kWideLanes) - 1U;

/// Lanes of a packet that are told together, no more than half of all.
struct Group {
    unsigned lanes;  ///< Their bits in the packet.
    int half;        ///< Which half of it they are in; -1 where they are in both, and packed.

    [[nodiscard]] bool packed() const { return half < 0; }
    /// Their bits in the group.
    [[nodiscard]] unsigned slots() const {
        return packed() ? (1U << __builtin_popcount(lanes)) - 1U : lanes >> (half * kWideLanes);
    }
    /// Calls visit(slot, lane) for the slots whose bits are set.
    template <class Visit>
    FN void for_each(unsigned slots, const Visit& visit) const {
        if (!packed()) {
            for (; slots != 0; slots &= slots - 1) {
                const int slot = __builtin_ctz(slots);
                visit(slot, static_cast<unsigned>(slot + half * kWideLanes));
            }
            return;
        }
        unsigned rest = lanes;
        for (int slot = 0; slots >> slot != 0; ++slot, rest &= rest - 1)
            if ((slots >> slot & 1U) != 0) visit(slot, static_cast<unsigned>(__builtin_ctz(rest)));
    }
    [[nodiscard]] unsigned lanes_of_slots(unsigned slots) const {
        unsigned out = 0;
        for_each(slots, [&](int, unsigned lane) { out |= 1U << lane; });
        return out;
    }
};

/// Calls visit(group) for one group or two that hold the lanes.
template <class Visit>
FN void for_each_group(unsigned lanes, const Visit& visit) {
    const unsigned low = lanes & kHalf;
    const unsigned high = lanes & ~kHalf;
    if (low != 0 && high != 0 && __builtin_popcount(lanes) <= kWideLanes) return visit(Group{lanes, -1});
    if (low != 0) visit(Group{low, 0});
    if (high != 0) visit(Group{high, 1});
}

WideRays rays_of(RTCRayN* rays, const Group& group, float reach) {
    constexpr unsigned n = kLanes;
    const auto of = [&](const float& first) {
        return group.packed() ? packed_of(first, group.lanes) : half_of(first, group.half);
    };
    WideRays out;
    out.origin = {of(RTCRayN_org_x(rays, n, 0)), of(RTCRayN_org_y(rays, n, 0)), of(RTCRayN_org_z(rays, n, 0))};
    out.direction = {of(RTCRayN_dir_x(rays, n, 0)), of(RTCRayN_dir_y(rays, n, 0)), of(RTCRayN_dir_z(rays, n, 0))};
    out.lower = of(RTCRayN_tnear(rays, n, 0));
    // In single precision, as for single rays.
    out.upper = rounded(of(RTCRayN_tfar(rays, n, 0)) * wide(reach));
    out.asking = mask_of(group.slots());
    return out;
}

/// Lanes in which there is a ray that sees the geometry.
unsigned asking_lanes(const GeometryData& data, const int* valid, RTCRayN* rays) {
    vuint asked, seen;
    std::memcpy(&asked, valid, sizeof asked);
    std::memcpy(&seen, &RTCRayN_mask(rays, kLanes, 0), sizeof seen);
    return lane_bits(mask_and(word(asked) != word(0U), (word(seen) & word(data.visible_to)) != word(0U)));
}

/// What a group is told.
struct Told {
    unsigned met = 0;     ///< Slots whose first hit is known.
    unsigned unsure = 0;  ///< Slots to be asked ray by ray.
    wide t, place, face;  ///< Of those that met, as QuickHit has them.
};

Told one_part(const QuickPart& part, const WideRays& rays, wide_mask asking) {
    WideStretch s;
    shape_stretch(part, rays, s);
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

/// A solid on a group's rays.
class Asked {
public:
    Asked(const QuickSolid& solid, const WideRays& rays)
        : solid_(solid),
          rays_(rays),
          distance_(sqrt(dot(rays.origin, rays.origin) / dot(rays.direction, rays.direction))) {}

    Told tell(wide_mask asking) {
        const Hull hull = hull_of(0);
        // Endless ends differ by nothing that is a number.
        const wide_mask gone = (hull.lower > hull.upper + near_at(hull.upper)) |
                               ((hull.lower == wide(kEndless)) & (hull.upper == wide(-kEndless)));
        Told told;
        wide_mask alive = asking & ~gone;
        if (!solid_.complete || !any_lane(alive)) {
            told.unsure = bits_of(alive);
            return told;
        }
        wide_mask unknown = mask_of(0);
        for (std::size_t i = 0; i < solid_.parts.size(); ++i) unknown = unknown | stretch(i).unknown;
        unknown = unknown & alive;
        alive = alive & ~unknown;
        if (any_lane(alive)) find_first(alive, told);
        told.unsure |= bits_of(unknown);
        return told;
    }

private:
    /// A stretch of each ray, of which nothing is known but that the node isn't there beside it; from infinity to its
    /// negative where the node is nowhere.
    struct Hull {
        wide lower, upper;
    };
    /// Where the ray is inside or outside of a node beyond doubt.
    struct State {
        wide_mask inside, outside;
    };

    [[nodiscard]] wide near_at(wide t) const { return wide(kNear) * (abs(t) + distance_); }

    const WideStretch& stretch(std::size_t part) {
        if ((known_ >> part & 1U) == 0) {
            part_stretch(solid_.parts[part], rays_, stretches_[part]);
            known_ |= 1U << part;
        }
        return stretches_[part];
    }

    FN Hull hull_of(std::size_t index) {
        const QuickNode& node = solid_.nodes[index];
        Hull out{rays_.lower, rays_.upper};
        if (node.inverted || node.kind == QuickNode::Kind::anything) return out;
        if (node.kind != QuickNode::Kind::part) {
            hull_of_group(node, out);
            return out;
        }
        const WideStretch& s = stretch(node.first);
        const wide_mask anywhere = solid_.parts[node.first].exact ? s.unknown | s.outer : s.outer;
        out.lower = select(anywhere, rays_.lower, select(s.misses, wide(kEndless), max(rays_.lower, s.lower)));
        out.upper = select(anywhere, rays_.upper, select(s.misses, wide(-kEndless), min(rays_.upper, s.upper)));
        return out;
    }

    // NOLINTNEXTLINE(misc-no-recursion): as deep as QuickSolid, of kMaxQuickNodes
    [[gnu::noinline]] void hull_of_group(const QuickNode& node, Hull& out) {
        const bool joined = node.kind == QuickNode::Kind::joined;
        if (joined) out = {wide(kEndless), wide(-kEndless)};
        for (std::size_t i = node.first; i < node.first + node.count; ++i) {
            if (!joined && solid_.nodes[i].inverted) continue;
            const Hull child = hull_of(i);
            if (!joined) {
                out = {max(out.lower, child.lower), min(out.upper, child.upper)};
                if (!any_lane((out.lower <= out.upper) & rays_.asking) &&
                    !any_lane((out.lower <= out.upper + near_at(out.upper)) & rays_.asking))
                    return;
            } else {
                const wide_mask there = child.lower <= child.upper + near_at(child.upper);
                out.lower = select(there, min(out.lower, child.lower), out.lower);
                out.upper = select(there, max(out.upper, child.upper), out.upper);
            }
        }
    }

    FN State state_at(std::size_t index, const wide& t, const wide& near) {
        const QuickNode& node = solid_.nodes[index];
        State out;
        if (node.kind == QuickNode::Kind::part) {
            const WideStretch& s = stretch(node.first);
            const wide_mask between = (t > s.lower + near) & (t < s.upper - near);
            const wide_mask beside = (t < s.lower - near) | (t > s.upper + near);
            out.inside = ((between & ~s.outer) | (beside & s.outer)) & ~s.misses;
            out.outside = (beside & ~s.outer) | (between & s.outer) | s.misses;
        } else {
            state_of_group(node, t, near, out);
        }
        if (node.inverted) std::swap(out.inside, out.outside);
        return out;
    }

    // NOLINTNEXTLINE(misc-no-recursion): as deep as QuickSolid, of kMaxQuickNodes
    [[gnu::noinline]] void state_of_group(const QuickNode& node, const wide& t, const wide& near, State& out) {
        const bool joined = node.kind == QuickNode::Kind::joined;
        out = {mask_of(joined ? 0 : kHalf), mask_of(joined ? kHalf : 0)};
        for (std::size_t i = node.first; i < node.first + node.count; ++i) {
            const State child = state_at(i, t, near);
            out.inside = joined ? out.inside | child.inside : out.inside & child.inside;
            out.outside = joined ? out.outside & child.outside : out.outside | child.outside;
        }
    }

    /// The first end of a part's stretch at which the nodes beside it let it be seen. Where one is near to another's,
    /// the lane is unsure.
    void find_first(wide_mask alive, Told& told) {
        wide best(kEndless);
        wide first_unsure(kEndless);
        wide_mask shared = mask_of(0);  // another one is at the best one's place
        told.place = told.face = wide(0.0);
        for (std::size_t i = 0; i < solid_.parts.size(); ++i) {
            const QuickPart& part = solid_.parts[i];
            if (!part.shows) continue;
            const WideStretch& own = stretch(i);
            const wide_mask there = alive & ~own.misses;
            if (!any_lane(there)) continue;
            for (int end = 0; end < 2; ++end) {
                const wide& t = end == 0 ? own.lower : own.upper;
                const wide& face = end == 0 ? own.lower_part : own.upper_part;
                wide_mask shows = there & (t > rays_.lower) & (t < rays_.upper);
                if (!part.all_shows) shows = shows & (face == wide(0.0));
                const wide near = near_at(t);
                wide_mask sure = own.upper - own.lower > near;
                for (const QuickCondition& condition : part.conditions) {
                    if (!any_lane(shows)) break;
                    const State state = state_at(condition.node, t, near);
                    shows = shows & ~(condition.inside ? state.outside : state.inside);
                    sure = sure & (condition.inside ? state.inside : state.outside);
                }
                if (!any_lane(shows)) continue;
                first_unsure = select(shows & ~sure & (t < first_unsure), t, first_unsure);
                const wide_mask nearer = shows & sure & (t < best);
                const wide_mask close = shows & sure & (abs(t - best) <= near);
                shared = (shared & ~(nearer & ~close)) | close;
                best = select(nearer, t, best);
                const wide_mask leaves = end == 0 ? own.outer : ~own.outer;
                const double place = 2.0 * static_cast<double>(i);
                told.place = select(nearer, select(leaves, wide(place + 1), wide(place)), told.place);
                told.face = select(nearer, face, told.face);
            }
        }
        told.t = best;
        const wide_mask none_unsure = first_unsure == wide(kEndless);
        const wide_mask sure = none_unsure | (best < first_unsure - near_at(first_unsure));
        told.unsure = bits_of(alive & (~sure | shared));
        told.met = bits_of(alive & sure & ~shared & (best < wide(kEndless)));
    }

    const QuickSolid& solid_;
    const WideRays& rays_;
    wide distance_;
    unsigned known_ = 0;  ///< Which stretches have been found.
    std::array<WideStretch, kMaxQuickParts> stretches_;
};

Told ask(const QuickSolid& solid, const WideRays& rays) {
    const bool alone = solid.complete && solid.parts.size() == 1 && solid.parts[0].all_shows &&
                       solid.parts[0].kind != QuickPart::Kind::quadric;
    return alone ? one_part(solid.parts[0], rays, rays.asking) : Asked(solid, rays).tell(rays.asking);
}

/// Normals of hits, and what is met there.
struct Surfaces {
    wide3 normal{wide(0.0), wide(0.0), wide(0.0)};
    std::array<std::uint32_t, kWideLanes> material;
    unsigned bad = 0;  ///< Slots that it can't tell of.
};

void find_surfaces(const QuickSolid& solid, const WideRays& rays, const Told& told, Surfaces& out) {
    for (unsigned left = told.met; left != 0;) {
        const auto index = static_cast<std::uint32_t>(told.place.v[__builtin_ctz(left)]) / 2;
        const QuickPart& part = solid.parts[index];
        const wide enters_at(2.0 * index);
        const wide_mask enters = told.place == enters_at;
        const wide_mask of_part = enters | (told.place == enters_at + wide(1.0));
        wide_mask fine;
        const wide_mask faces_ray = part.flips ? ~enters : enters;
        const wide3 n = part_normal(part, rays, told.t, told.face, faces_ray, fine);
        out.normal = {select(of_part, n.x, out.normal.x), select(of_part, n.y, out.normal.y),
                      select(of_part, n.z, out.normal.z)};
        const unsigned here = bits_of(of_part) & left;
        out.bad |= here & ~bits_of(fine);
        for (unsigned slots = here; slots != 0; slots &= slots - 1) {
            const int slot = __builtin_ctz(slots);
            out.material[slot] = (bits_of(faces_ray) >> slot & 1U) != 0 ? part.front_material : part.back_material;
        }
        left &= ~here;
    }
}

/// Enters hits of a group whose slots' bits are set, where no material looks at texture coordinates.
void enter_plain(const RTCIntersectFunctionNArguments* args, const Group& group, unsigned slots, const Told& told,
                 const Surfaces& surfaces) {
    alignas(64) std::array<float, kWideLanes> t, x, y, z;
    store_half(told.t, t.data(), 0);
    store_half(surfaces.normal.x, x.data(), 0);
    store_half(surfaces.normal.y, y.data(), 0);
    store_half(surfaces.normal.z, z.data(), 0);
    RTCHitN* hits = RTCRayHitN_HitN(args->rayhit, kLanes);
    group.for_each(slots, [&](int slot, unsigned lane) {
        if (!enter_hit(args, lane, t[slot], x[slot], y[slot], z[slot])) return;
        RTCHitN_u(hits, kLanes, lane) = 0;
        RTCHitN_v(hits, kLanes, lane) = 0;
        RTCHitN_primID(hits, kLanes, lane) = surfaces.material[slot];
    });
}

}  // namespace

void SUNDOG_INTERSECT_SOLID(const RTCIntersectFunctionNArguments* args) {
    const auto& data = *static_cast<const GeometryData*>(args->geometryUserPtr);
    if (args->N != kLanes || data.quick == nullptr) {
        intersect_solid(args);
        return;
    }
    RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, kLanes);
    unsigned unsure = 0;
    for_each_group(asking_lanes(data, args->valid, rays), [&](const Group& group) {
        const WideRays wide_rays = rays_of(rays, group, 1 + kCoincident);
        Told told = ask(*data.quick, wide_rays);
        if (data.culling) told.unsure |= told.met, told.met = 0;
        if (told.met != 0 && data.quick->plain) {
            Surfaces surfaces;
            find_surfaces(*data.quick, wide_rays, told, surfaces);
            enter_plain(args, group, told.met & ~surfaces.bad, told, surfaces);
            told.unsure |= surfaces.bad;
        } else if (told.met != 0) {
            group.for_each(told.met, [&](int slot, unsigned lane) {
                enter_quick_hit(args, lane,
                                {told.t.v[slot], static_cast<std::uint32_t>(told.place.v[slot]),
                                 static_cast<std::uint32_t>(told.face.v[slot])});
            });
        }
        unsure |= group.lanes_of_slots(told.unsure);
    });
    if (unsure != 0) intersect_solid_in(args, unsure);
}

void SUNDOG_OCCLUDED_BY_SOLID(const RTCOccludedFunctionNArguments* args) {
    const auto& data = *static_cast<const GeometryData*>(args->geometryUserPtr);
    if (args->N != kLanes || data.quick == nullptr) {
        occluded_by_solid(args);
        return;
    }
    unsigned unsure = 0;
    for_each_group(asking_lanes(data, args->valid, args->ray), [&](const Group& group) {
        Told told = ask(*data.quick, rays_of(args->ray, group, 1));
        if (data.culling) told.unsure |= told.met, told.met = 0;
        group.for_each(told.met, [&](int, unsigned lane) { RTCRayN_tfar(args->ray, kLanes, lane) = -INFINITY; });
        unsure |= group.lanes_of_slots(told.unsure);
    });
    if (unsure != 0) occluded_by_solid_in(args, unsure);
}

}  // namespace sundog::cpu
