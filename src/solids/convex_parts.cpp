// SPDX-License-Identifier: Apache-2.0
// Intersections and differences of convex shapes: along a ray each is one interval, so ends of intervals are all there
// is to compare.
#include <algorithm>
#include <cmath>

#include "solids/compiled_solid.h"

namespace sundog::solids {
namespace {

/// An end of an interval; without a crossing it is the range's own.
struct End {
    Crossing crossing;
    std::uint32_t leaf = 0;
    bool flipped = false;
    bool exists = false;
    [[nodiscard]] double t(double otherwise) const { return exists ? crossing.t : otherwise; }
};

struct Interval {
    End lower, upper;
};

/// The part of a ray that is inside a convex shape, from its crossings.
Interval interval_of(const CrossingList& crossings, bool starts_inside, std::uint32_t leaf, bool flipped) {
    Interval out;
    if (!starts_inside) out.lower = {crossings[0], leaf, flipped, true};
    // The last one ends it: rounding may tear it in two, as at a cone's apex.
    const bool ends_inside = (crossings.size() % 2 == 0) == starts_inside;
    if (!ends_inside) out.upper = {crossings.back(), leaf, flipped, true};
    return out;
}

}  // namespace

/// The part of `range` that lies inside all of a clipped node's clips; empty where there is none.
Range CompiledSolid::range_of_clips(const Node& node, const Ray& ray, Range range) const {
    for (std::uint32_t child = node.first + 1; child < node.first + node.count; ++child) {
        const Node& part = nodes_[child];
        const Range none{1, 0};
        if (!may_meet(part, ray, range)) return none;
        const Leaf& leaf = leaves_[part.first];
        CrossingList crossings;
        const bool starts_inside = leaf.shape->crossings(transform_ray(leaf.shape_from_world, ray), range, crossings);
        if (!starts_inside && crossings.empty()) return none;
        // A surface in the plane that it is cut at stays.
        const Interval inside = interval_of(crossings, starts_inside, part.first, false);
        const double lower = inside.lower.t(range.lower);
        const double upper = inside.upper.t(range.upper);
        range.lower = std::max(range.lower, lower - coincidence_tolerance(ray, lower));
        range.upper = std::min(range.upper, upper + coincidence_tolerance(ray, upper));
    }
    return range;
}

bool CompiledSolid::convex_events(const Node& node, const Ray& ray, Range range, EventList& out) const {
    const double off = std::sqrt(dot(ray.origin, ray.origin) / dot(ray.direction, ray.direction));
    const auto tolerance = [&](double t) { return kCoincident * (std::abs(t) + off); };
    Interval kept;
    SmallVector<Interval, 8> cuts;
    for (std::uint32_t child = node.first; child < node.first + node.count; ++child) {
        const Node& part = nodes_[child];
        CrossingList crossings;
        const bool met = may_meet(part, ray, range);
        bool starts_inside = false;
        if (met) {
            const Leaf& leaf = leaves_[part.first];
            starts_inside = leaf.shape->crossings(transform_ray(leaf.shape_from_world, ray), range, crossings);
        }
        const bool never_inside = !starts_inside && crossings.empty();
        if (part.inverted) {
            if (!never_inside) cuts.push_back(interval_of(crossings, starts_inside, part.first, true));
            continue;
        }
        if (never_inside) return false;
        const Interval own = interval_of(crossings, starts_inside, part.first, false);
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
