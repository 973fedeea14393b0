// SPDX-License-Identifier: Apache-2.0
#include "solids/compiled_solid.h"

#include <algorithm>
#include <cmath>

namespace sundog::solids {

bool CompiledSolid::events(std::uint32_t index, const WorldRay& ray, Range range, EventList& out) const {
    const Node& node = nodes_[index];
    const Range reach = node.unbounded ? range : clip(node.active, ray, range);
    if (reach.empty()) return node.state_beyond;
    if (!passes_gate(node, ray, range)) return node.inverted;
    const std::size_t first = out.size();
    // A group's children may go far beyond what the group lets be seen of them: they are asked for that alone.
    const bool starts_inside = node.combination == Combination::leaf
                                   ? leaf_events(node, ray, range, out)
                                   : group_events(node, ray, widened(reach, ray, range), out);
    if (!node.inverted) return starts_inside;
    for (std::size_t i = first; i < out.size(); ++i) {
        Event& e = out[i];
        e.faces_ray = !e.faces_ray;
        e.flipped = !e.flipped;
        e.inside_after = !e.inside_after;
    }
    return !starts_inside;
}

CompiledSolid::Event CompiledSolid::event_of(const Node& node, const Ray& in_shape, const Crossing& c,
                                             bool inside_before) const {
    Event e;
    e.crossing = c;
    e.leaf = node.first;
    e.toggles = c.toggles;
    e.visible = c.visible;
    e.faces_ray = c.toggles ? !inside_before
                            : dot(leaves_[node.first].shape->normal(in_shape.at(c.t), c), in_shape.direction) < 0;
    e.inside_after = c.toggles ? !inside_before : inside_before;
    return e;
}

bool CompiledSolid::leaf_events(const Node& node, const WorldRay& ray, Range range, EventList& out) const {
    const Leaf& leaf = leaves_[node.first];
    const Ray in_shape = transform_ray(leaf.shape_from_world, ray);
    CrossingList crossings;
    const bool starts_inside = leaf.shape->crossings(in_shape, range, crossings);
    bool is_inside = starts_inside;
    for (const Crossing& c : crossings) {
        out.push_back(event_of(node, in_shape, c, is_inside));
        is_inside = out.back().inside_after;
    }
    return starts_inside;
}

/// Appends the first visible event alone: all that a shape that stands by itself is asked for.
void CompiledSolid::first_leaf_event(const Node& node, const WorldRay& ray, Range range, EventList& out) const {
    const Leaf& leaf = leaves_[node.first];
    const Ray in_shape = transform_ray(leaf.shape_from_world, ray);
    const auto append = [&](const Crossing& c, bool inside_before) {
        out.push_back(event_of(node, in_shape, c, inside_before));
        Event& e = out.back();
        if (!node.inverted) return;
        e.faces_ray = !e.faces_ray;
        e.flipped = true;
        e.inside_after = !e.inside_after;
    };
    if (node.convex) {
        Stretch stretch;
        if (!leaf.shape->stretch(in_shape, range, stretch)) return;
        if (stretch.begins) append(stretch.lower, false);
        else if (stretch.ends) append(stretch.upper, true);
        return;
    }
    CrossingList crossings;
    bool is_inside = leaf.shape->first_crossing(in_shape, range, crossings);
    for (const Crossing& c : crossings) {
        if (c.visible) return append(c, is_inside);
        if (c.toggles) is_inside = !is_inside;
    }
}

/// Puts the children's events together, place by place.
struct CompiledSolid::Sweep {
    const Node& node;
    ChildStates& states;
    EventList& out;
    std::size_t total;   ///< Children, those included that the ray doesn't meet.
    std::size_t inside;  ///< Of them, inside before the place at hand.

    [[nodiscard]] bool is_union() const {
        return node.combination == Combination::combined || node.combination == Combination::merged;
    }
    [[nodiscard]] bool inside_with(std::size_t count) const { return is_union() ? count > 0 : count == total; }

    /// Whether all other children let a surface of this one be seen here: on one of the place's two sides at least.
    [[nodiscard]] bool others_permit(std::uint32_t child) const {
        if (node.combination == Combination::combined) return true;
        if (node.combination == Combination::clipped && child != 0) return false;
        // Children that the ray doesn't meet, or not here, are on both sides what they were before.
        const bool wanted = !is_union();
        std::size_t permitting = wanted ? inside : total - inside;
        for (const ChildState& s : states)
            if (s.before != s.after && s.after == wanted) ++permitting;
        const ChildState& own = states[child];
        if (own.before == wanted || own.after == wanted) --permitting;
        return permitting == total - 1;
    }

    void emit(const Event& event, bool is_inside) {
        out.push_back(event);
        out.back().toggles = false;
        out.back().inside_after = is_inside;
    }

    /// Events of one place, from `first` to before `last`.
    void place(const Event* first, const Event* last) {
        std::size_t inside_after = inside;
        for (const Event* e = first; e != last; ++e) {
            if (!e->toggles || states[e->child].after == e->inside_after) continue;
            states[e->child].after = e->inside_after;
            inside_after = e->inside_after ? inside_after + 1 : inside_after - 1;
        }
        const bool before = inside_with(inside);
        const bool after = inside_with(inside_after);
        const std::size_t begin = out.size();
        // Surfaces at which the inside doesn't change.
        for (const Event* e = first; e != last; ++e)
            if (!e->toggles && e->visible && others_permit(e->child)) emit(*e, before);
        if (node.combination == Combination::combined) {
            // Of faces that coincide, the first child's counts. What is left comes before what is entered.
            if (const Event* leaving = surface_of_change(first, last, false)) emit(*leaving, before);
            if (const Event* entering = surface_of_change(first, last, true)) emit(*entering, before);
        } else if (before != after) {
            if (const Event* surface = surface_of_change(first, last, after)) emit(*surface, before);
        }
        if (before != after) {
            if (out.size() == begin) {
                emit(*first, after);
                out.back().visible = false;
            }
            out.back().toggles = true;
            out.back().inside_after = after;
        }
        for (const Event* e = first; e != last; ++e) states[e->child].before = states[e->child].after;
        inside = inside_after;
    }

    /// The first child's visible surface at which that child becomes `entered`.
    [[nodiscard]] const Event* surface_of_change(const Event* first, const Event* last, bool entered) const {
        const Event* best = nullptr;
        for (const Event* e = first; e != last; ++e) {
            const ChildState& s = states[e->child];
            if (!e->toggles || !e->visible || s.before == s.after || s.after != entered || e->inside_after != entered)
                continue;
            if (node.combination == Combination::clipped && e->child != 0) continue;
            if (!best || e->child < best->child) best = e;
        }
        return best;
    }
};

/// Adds the events of children[place]; false if they make an intersection's outcome certain: nowhere inside, and
/// nothing to be seen.
bool CompiledSolid::child_events(const Node& node, const ChildList& children, std::size_t place, const WorldRay& ray,
                                 Range range, EventList& all, ChildStates& states) const {
    const std::size_t first = all.size();
    const bool is_inside = events(node.first + children[place], ray, range, all);
    states[place] = {is_inside, is_inside};
    for (std::size_t i = first; i < all.size(); ++i) all[i].child = static_cast<std::uint32_t>(place);
    return is_inside || all.size() > first;
}

/// All children's events where only what is inside of all matters; false if nothing is. Quick shapes come first, and
/// each child is asked for what lies inside of those before it: what it is elsewhere can't be seen, nor make the whole
/// inside, for one of those is outside there.
bool CompiledSolid::common_events(const Node& node, const ChildList& children, const WorldRay& ray, Range range,
                                  EventList& all, ChildStates& states) const {
    Range inside_quick = range;
    Range part = range;
    for (std::size_t i = 0; i < children.size(); ++i) {
        if (!nodes_[node.first + children[i]].quick) continue;
        const std::size_t first = all.size();
        if (!child_events(node, children, i, ray, part, all, states)) return false;
        Range hull{states[i].before ? range.lower : kInfinity, range.upper};
        for (std::size_t e = first; e < all.size(); ++e) {
            if (!all[e].toggles) hull.lower = range.lower;  // A surface that bounds nothing.
            else if (all[e].inside_after) hull.lower = std::min(hull.lower, all[e].crossing.t);
            hull.upper = all[e].toggles && !all[e].inside_after ? all[e].crossing.t : range.upper;
        }
        if (hull.lower <= inside_quick.lower && hull.upper >= inside_quick.upper) continue;
        inside_quick.lower = std::max(inside_quick.lower, hull.lower);
        inside_quick.upper = std::min(inside_quick.upper, hull.upper);
        if (inside_quick.lower == kInfinity) return false;
        part = widened(inside_quick, ray, range);
        if (part.empty()) return false;
    }
    for (std::size_t i = 0; i < children.size(); ++i)
        if (!nodes_[node.first + children[i]].quick && !child_events(node, children, i, ray, part, all, states))
            return false;
    return true;
}

bool CompiledSolid::group_events(const Node& node, const WorldRay& ray, Range range, EventList& out) const {
    if (node.convex_parts) return convex_events(node, ray, range, out);
    const bool is_common = node.combination == Combination::common || node.combination == Combination::clipped;
    ChildList children;
    std::size_t unmet_inside = 0;
    if (node.tree == kNoTree) {
        for (std::uint32_t child = 0; child < node.count; ++child) children.push_back(child);
    } else {
        // In the children's order, which decides among faces that coincide.
        Range whole = range;
        trees_[node.tree].along(ray, ray.inverse, whole, [&](std::uint32_t child) { children.push_back(child); });
        std::sort(children.begin(), children.end());
        unmet_inside = node.always_inside;
        for (const std::uint32_t child : children)
            if (nodes_[node.first + child].state_beyond) --unmet_inside;
        if (is_common && node.count - children.size() != unmet_inside) return false;
    }
    EventList all;
    ChildStates states;
    for (std::size_t i = 0; i < children.size(); ++i) states.push_back({});
    if (is_common) {
        if (!common_events(node, children, ray, range, all, states)) return false;
    } else {
        for (std::size_t i = 0; i < children.size(); ++i) child_events(node, children, i, ray, range, all, states);
    }
    std::size_t inside = unmet_inside;
    for (const ChildState& s : states) inside += s.before ? 1 : 0;
    Sweep sweep{node, states, out, node.count, inside};
    const bool starts_inside = sweep.inside_with(inside);
    std::sort(all.begin(), all.end(), [](const Event& a, const Event& b) {
        return a.crossing.t != b.crossing.t ? a.crossing.t < b.crossing.t : a.child < b.child;
    });
    for (std::size_t i = 0; i < all.size();) {
        const double t = all[i].crossing.t;
        const double limit = t + coincidence_tolerance(ray, t);
        std::size_t end = i + 1;
        while (end < all.size() && all[end].crossing.t <= limit) ++end;
        sweep.place(all.begin() + i, all.begin() + end);
        i = end;
    }
    return starts_inside;
}

void CompiledSolid::nearest_event(std::uint32_t index, const WorldRay& ray, Range& range,
                                  std::optional<Event>& best) const {
    const Node& node = nodes_[index];
    if (!may_meet(node, ray, range)) return;
    if (node.combination == Combination::combined && !node.inverted) {
        if (node.tree == kNoTree)
            for (std::uint32_t child = 0; child < node.count; ++child)
                nearest_event(node.first + child, ray, range, best);
        else
            trees_[node.tree].along(ray, ray.inverse, range,
                                    [&](std::uint32_t child) { nearest_event(node.first + child, ray, range, best); });
        return;
    }
    if (node.convex_clips && !node.inverted) {
        const Range kept = range_of_clips(node, ray, range);
        if (kept.empty()) return;
        std::optional<Event> found = best;
        Range search = widened(kept, ray, range);
        nearest_event(node.first, ray, search, found);
        if (!found || (best && found->crossing.t == best->crossing.t && found->leaf == best->leaf)) return;
        if (is_off_ends(kept, range, ray, found->crossing.t)) {
            best = found;
            range.upper = std::min(range.upper, found->crossing.t + 2 * coincidence_tolerance(ray, found->crossing.t));
            return;
        }
        // Where a face coincides with what it is clipped by, all events must be compared.
    }
    EventList list;
    if (node.combination == Combination::leaf) first_leaf_event(node, ray, range, list);
    else events(index, ray, range, list);
    for (const Event& e : list) {
        if (!e.visible) continue;
        if (best) {
            // As in Sweep::place: of surfaces that coincide the one that is left, then the one written first.
            const double distance = e.crossing.t - best->crossing.t;
            const bool coincide = std::abs(distance) <= coincidence_tolerance(ray, e.crossing.t);
            if (coincide && e.faces_ray != best->faces_ray ? e.faces_ray
                                                           : (coincide ? e.leaf > best->leaf : distance > 0))
                return;
        }
        best = e;
        range.upper = std::min(range.upper, e.crossing.t + 2 * coincidence_tolerance(ray, e.crossing.t));
        return;
    }
}

/// Whether a node that is clipped to the stretch `kept` of `range` shows there, and not at the ends alone; `found`:
/// whether it may show at all.
bool CompiledSolid::any_off_ends(std::uint32_t index, const WorldRay& ray, Range range, Range kept, bool& found) const {
    const Node& node = nodes_[index];
    const Range search = widened(kept, ray, range);
    if (node.combination != Combination::leaf) {
        found = any_event(index, ray, search);
        return false;
    }
    if (!may_meet(node, ray, search)) return false;
    const Leaf& leaf = leaves_[node.first];
    const Ray in_shape = transform_ray(leaf.shape_from_world, ray);
    const auto is_clear = [&](double t) {
        found = true;
        return is_off_ends(kept, range, ray, t);
    };
    if (node.convex) {
        Stretch stretch;
        return leaf.shape->stretch(in_shape, search, stretch) &&
               ((stretch.begins && is_clear(stretch.lower.t)) || (stretch.ends && is_clear(stretch.upper.t)));
    }
    CrossingList crossings;
    leaf.shape->first_crossing(in_shape, search, crossings);
    return std::any_of(crossings.begin(), crossings.end(),
                       [&](const Crossing& c) { return c.visible && is_clear(c.t); });
}

bool CompiledSolid::any_event(std::uint32_t index, const WorldRay& ray, Range range) const {
    const Node& node = nodes_[index];
    if (!may_meet(node, ray, range)) return false;
    if (node.combination == Combination::combined && !node.inverted) {
        bool found = false;
        if (node.tree == kNoTree) {
            for (std::uint32_t child = 0; child < node.count && !found; ++child)
                found = any_event(node.first + child, ray, range);
        } else {
            Range rest = range;
            trees_[node.tree].along(ray, ray.inverse, rest, [&](std::uint32_t child) {
                found = found || any_event(node.first + child, ray, range);
                if (found) rest.upper = -kInfinity;
            });
        }
        return found;
    }
    if (node.convex_clips && !node.inverted) {
        const Range kept = range_of_clips(node, ray, range);
        if (kept.empty()) return false;
        bool found = false;
        if (any_off_ends(node.first, ray, range, kept, found)) return true;
        if (!found) return false;
        const auto shrunk = [&](double t, double by) { return t + by * 10 * coincidence_tolerance(ray, t); };
        const Range sure{kept.lower == range.lower ? range.lower : shrunk(kept.lower, 1),
                         kept.upper == range.upper ? range.upper : shrunk(kept.upper, -1)};
        if (!sure.empty() && any_event(node.first, ray, sure)) return true;
    }
    if (node.combination == Combination::leaf) {
        const Leaf& leaf = leaves_[node.first];
        const Ray in_shape = transform_ray(leaf.shape_from_world, ray);
        if (node.convex) {
            Stretch stretch;
            return leaf.shape->stretch(in_shape, range, stretch) && (stretch.begins || stretch.ends);
        }
        CrossingList crossings;
        leaf.shape->first_crossing(in_shape, range, crossings);
        return std::any_of(crossings.begin(), crossings.end(), [](const Crossing& c) { return c.visible; });
    }
    EventList list;
    events(index, ray, range, list);
    return std::any_of(list.begin(), list.end(), [](const Event& e) { return e.visible; });
}

std::optional<Hit> CompiledSolid::nearest(const Ray& asked_ray, Range range) const {
    const WorldRay ray(asked_ray);
    std::optional<Event> best;
    const Range asked = range;
    nearest_event(0, ray, range, best);
    if (!best || !asked.contains(best->crossing.t)) return std::nullopt;
    return hit_of(*best, ray);
}

bool CompiledSolid::any(const Ray& ray, Range range) const { return any_event(0, WorldRay(ray), range); }

Hit CompiledSolid::hit_on(const Ray& ray, std::uint32_t leaf, const Crossing& crossing, bool faces_ray,
                          bool flipped) const {
    Event event;
    event.crossing = crossing;
    event.leaf = leaf;
    event.toggles = event.visible = true;
    event.faces_ray = faces_ray;
    event.flipped = flipped;
    return hit_of(event, ray);
}

Hit CompiledSolid::hit_of(const Event& event, const Ray& ray) const {
    const Leaf& leaf = leaves_[event.leaf];
    Hit hit;
    hit.t = event.crossing.t;
    const Vec3d in_shape = transform_ray(leaf.shape_from_world, ray).at(hit.t);
    const auto to_world = [&](Vec3d n) {
        // Slopes of polynomials and fractals may be so long that their squares overflow.
        const double squared = dot(n, n);
        if (!(squared > 1e-60 && squared < 1e60)) n = normalize(n);
        return normalize(transform_normal(leaf.shape_from_world, n));
    };
    const Vec3d carried = to_world(leaf.shape->normal(in_shape, event.crossing));
    hit.normal = event.flipped ? -carried : carried;
    if (event.crossing.toggles) {
        // The passage from outside to inside tells better than rounding which way the normal must point.
        const auto agrees = [&](Vec3d n) { return (dot(n, ray.direction) < 0) == event.faces_ray; };
        if (const std::optional<Vec3d> face = leaf.shape->face_normal(in_shape, event.crossing)) {
            // A smoothed normal may look past the ray where the face does not. Turned around, it would point into the
            // face, and rays that go on from there would meet the same place again.
            const Vec3d flat = agrees(to_world(*face)) ? to_world(*face) : -to_world(*face);
            if (dot(hit.normal, flat) < 0) hit.normal = -hit.normal;
            if (!agrees(hit.normal)) hit.normal = flat;
        } else if (!agrees(hit.normal)) {
            hit.normal = -hit.normal;
        }
    }
    const std::uint32_t own = leaf.shape->material(in_shape, event.crossing);
    hit.material = own != scene::Solid::kInherited ? own : leaf.material;
    if (!event.faces_ray && leaf.interior_material != scene::Solid::kInherited) hit.material = leaf.interior_material;
    if (!leaf.needs_uv) return hit;
    const std::array<double, 2> uv = leaf.shape->uv(in_shape, event.crossing);
    hit.u = uv[0];
    hit.v = uv[1];
    return hit;
}

bool CompiledSolid::inside_node(std::uint32_t index, Vec3d point) const {
    const Node& node = nodes_[index];
    if (!contains(node.active, point)) return node.state_beyond;
    bool is_inside = false;
    if (node.combination == Combination::leaf) {
        const Leaf& leaf = leaves_[node.first];
        is_inside = leaf.shape->inside(transform_point(leaf.shape_from_world, point));
    } else if (node.combination == Combination::combined || node.combination == Combination::merged) {
        const auto in_child = [&](std::uint32_t child) { return inside_node(node.first + child, point); };
        if (node.tree != kNoTree && node.always_inside == 0) {
            is_inside = trees_[node.tree].any_at(point, in_child);
        } else {
            for (std::uint32_t child = 0; child < node.count && !is_inside; ++child) is_inside = in_child(child);
        }
    } else {
        is_inside = true;
        for (std::uint32_t child = 0; child < node.count && is_inside; ++child)
            is_inside = inside_node(node.first + child, point);
    }
    return is_inside != node.inverted;
}

}  // namespace sundog::solids
