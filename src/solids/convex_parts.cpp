// SPDX-License-Identifier: Apache-2.0
// Intersections and differences of convex shapes: along a ray each is one interval, so ends of intervals are all there
// is to compare.
#include <algorithm>
#include <cmath>

#include "solids/compiled_solid.h"

namespace sundog::solids {
namespace {

/// An end of what is kept; without a crossing it is the range's own.
struct End {
    Crossing crossing;
    std::uint32_t leaf;
    bool flipped;
    bool exists;
    [[nodiscard]] double t(double otherwise) const { return exists ? crossing.t : otherwise; }
};

struct Interval {
    End lower, upper;
};

Interval interval_of(const Stretch& stretch, std::uint32_t leaf, bool flipped) {
    return {{stretch.lower, leaf, flipped, stretch.begins}, {stretch.upper, leaf, flipped, stretch.ends}};
}

}  // namespace

/// The part of `range` that lies inside all of a clipped node's clips; empty where there is none.
Range CompiledSolid::range_of_clips(const Node& node, const WorldRay& ray, Range range) const {
    for (std::uint32_t child = node.first + 1; child < node.first + node.count; ++child) {
        const Node& part = nodes_[child];
        const Range none{1, 0};
        if (!may_meet(part, ray, range)) return none;
        const Leaf& leaf = leaves_[part.first];
        Stretch inside;
        if (!leaf.shape->stretch(transform_ray(leaf.shape_from_world, ray), range, inside)) return none;
        if (inside.begins) range.lower = std::max(range.lower, inside.lower.t);
        if (inside.ends) range.upper = std::min(range.upper, inside.upper.t);
    }
    return range;
}

bool CompiledSolid::convex_events(const Node& node, const WorldRay& ray, Range range, EventList& out) const {
    const auto tolerance = [&](double t) { return coincidence_tolerance(ray, t); };
    Interval kept{};
    SmallVector<Interval, 8> cuts;
    for (std::uint32_t child = node.first; child < node.first + node.count; ++child) {
        const Node& part = nodes_[child];
        const Leaf& leaf = leaves_[part.first];
        Stretch stretch;
        const bool met = may_meet(part, ray, range) &&
                         leaf.shape->stretch(transform_ray(leaf.shape_from_world, ray), range, stretch);
        if (part.inverted) {
            if (met) cuts.push_back(interval_of(stretch, part.first, true));
            continue;
        }
        if (!met) return false;
        const Interval own = interval_of(stretch, part.first, false);
        // Of faces that coincide, the first child's counts.
        if (own.lower.exists &&
            (!kept.lower.exists || own.lower.crossing.t > kept.lower.crossing.t + tolerance(own.lower.crossing.t)))
            kept.lower = own.lower;
        if (own.upper.exists &&
            (!kept.upper.exists || own.upper.crossing.t < kept.upper.crossing.t - tolerance(own.upper.crossing.t)))
            kept.upper = own.upper;
        if (kept.lower.exists && kept.upper.exists &&
            kept.lower.crossing.t >= kept.upper.crossing.t - tolerance(kept.upper.crossing.t))
            return false;
    }
    SmallVector<Interval, 8> left;
    left.push_back(kept);
    for (const Interval& cut : cuts) {
        const double lower = cut.lower.t(-kInfinity);
        const double upper = cut.upper.t(kInfinity);
        SmallVector<Interval, 8> rest;
        for (const Interval& part : left) {
            const double from = part.lower.t(-kInfinity);
            const double to = part.upper.t(kInfinity);
            // Whichever of two coinciding ends is kept, they are the same place.
            const bool before = lower > from + (part.lower.exists ? tolerance(from) : 0);
            const bool behind = upper < to - (part.upper.exists ? tolerance(to) : 0);
            const bool apart = lower >= to - (part.upper.exists ? tolerance(to) : 0) ||
                               upper <= from + (part.lower.exists ? tolerance(from) : 0);
            if (apart) {
                rest.push_back(part);
                continue;
            }
            if (before) rest.push_back({part.lower, cut.lower});
            if (behind) rest.push_back({cut.upper, part.upper});
        }
        left.clear();
        for (const Interval& part : rest) left.push_back(part);
    }
    const auto append = [&](const End& end, bool enters) {
        if (!end.exists) return;
        Event e;
        e.crossing = end.crossing;
        e.leaf = end.leaf;
        e.toggles = e.visible = true;
        e.faces_ray = e.inside_after = enters;
        e.flipped = end.flipped;
        out.push_back(e);
    };
    for (const Interval& part : left) {
        append(part.lower, true);
        append(part.upper, false);
    }
    return !left.empty() && !left[0].lower.exists;
}

}  // namespace sundog::solids
