// SPDX-License-Identifier: Apache-2.0
// An exact solid, ready for rays: shapes placed in the world and the tree of what is made of them.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/vec.h"
#include "scene/solid.h"
#include "solids/bounds_tree.h"
#include "solids/shape.h"

namespace sundog::solids {

/// Where a ray meets a solid.
struct Hit {
    double t = 0;
    Vec3d normal;                ///< Unit, world space, out of the solid.
    std::uint32_t material = 0;  ///< Into Scene::materials.
    double u = 0, v = 0;         ///< Texture coordinates; 0 where the leaf's materials need none.
};

/// How the children of a node are put together.
enum class Combination : std::uint8_t {
    leaf,      ///< One shape.
    combined,  ///< Inside any; all their surfaces are there.
    merged,    ///< Inside any; surfaces inside of another child are not there.
    common,    ///< Inside all.
    clipped,   ///< The first child's surface and inside, as far as they lie inside all other children.
};

/// Immutable: any number of threads may ask at once.
class CompiledSolid {
public:
    /// A shape, placed.
    struct Leaf {
        ShapePointer shape;
        Affine3d shape_from_world;
        std::uint32_t material = 0;
        std::uint32_t interior_material = scene::Solid::kInherited;
        bool needs_uv = true;   ///< Its materials may look at texture coordinates.
        const char* kind = "";  ///< What messages call the shape: "a cone".
    };
    struct Node {
        Combination combination = Combination::leaf;
        bool inverted = false;
        bool state_beyond = false;  ///< Whether points off `active` are inside.
        bool quick = false;         ///< A shape that is_quick().
        bool convex = false;        ///< A shape that is_convex().
        bool convex_parts = false;  ///< What convex shapes, or all but them, have in common.
        bool convex_clips = false;  ///< Clipped by convex shapes alone: to one stretch of a ray.
        std::uint32_t first = 0;    ///< Into leaves, or into nodes: the first child; siblings are neighbours.
        std::uint32_t count = 0;
        std::uint32_t tree = kNoTree;     ///< Into trees: over the children's `active` boxes, where there are many.
        std::uint32_t always_inside = 0;  ///< How many children have state_beyond.
        Bounds3d active;                  ///< Off this box there is no surface, and the inside doesn't change.
        std::uint32_t gate = kNoGate;     ///< Into gates.
        bool unbounded = true;            ///< `active` is everywhere.
    };
    static constexpr std::uint32_t kNoTree = 0xffffffffU, kNoGate = 0xffffffffU;

    /// The nearest surface within `range`.
    [[nodiscard]] std::optional<Hit> nearest(const Ray& ray, Range range) const;
    /// Whether there is any surface within `range`.
    [[nodiscard]] bool any(const Ray& ray, Range range) const;
    /// The hit where a ray crosses a leaf's boundary, visibly: `faces_ray` where it comes from outside of what the
    /// boundary is of, `flipped` where that is outside of the leaf.
    [[nodiscard]] Hit hit_on(const Ray& ray, std::uint32_t leaf, const Crossing& crossing, bool faces_ray,
                             bool flipped) const;
    [[nodiscard]] bool inside(Vec3d point) const { return inside_node(0, point); }
    /// Around all surfaces; infinite sides where the solid has no end.
    [[nodiscard]] const Bounds3d& bounds() const { return surface_bounds_; }
    /// Which materials hits may have, ascending.
    [[nodiscard]] const std::vector<std::uint32_t>& materials() const { return materials_; }

    [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
    [[nodiscard]] const std::vector<Leaf>& leaves() const { return leaves_; }
    [[nodiscard]] const std::vector<Bounds3d>& gates() const { return gates_; }

private:
    friend class SolidCompiler;

    /// A change along a ray, of one node: a surface, or the inside, or both.
    struct Event {
        Crossing crossing;
        std::uint32_t leaf = 0;
        std::uint32_t child = 0;  ///< Which of the node's children it came from, while they are put together.
        bool toggles = false;     ///< The node's inside changes here.
        bool visible = false;     ///< A surface is there.
        bool faces_ray = false;   ///< The surface's outer side is the one that the ray comes from.
        bool flipped = false;     ///< Inverted on the way up: the shape's own normal points inwards.
        bool inside_after = false;
    };
    using EventList = SmallVector<Event, 12>;
    /// Whether a child is inside, before and after the events that are at one place.
    struct ChildState {
        bool before = false, after = false;
    };
    using ChildStates = SmallVector<ChildState, 16>;
    using ChildList = SmallVector<std::uint32_t, 32>;
    struct Sweep;

    /// Crossings so near to each other, relative to the distances in question, are at one place: faces that were meant
    /// to coincide differ by rounding only.
    static constexpr double kCoincident = 1e-10;
    static double coincidence_tolerance(const WorldRay& ray, double t) {
        return kCoincident * (std::abs(t) + ray.distance);
    }
    /// `part` of a range with room for rounding at both ends.
    static Range widened(Range part, const WorldRay& ray, Range whole) {
        return {std::max(whole.lower, part.lower - 10 * coincidence_tolerance(ray, part.lower)),
                std::min(whole.upper, part.upper + 10 * coincidence_tolerance(ray, part.upper))};
    }
    /// Whether a place in `whole` does not coincide with an end of its part.
    static bool is_off_ends(Range part, Range whole, const WorldRay& ray, double t) {
        const double near = 10 * coincidence_tolerance(ray, t);
        return (part.lower == whole.lower || t > part.lower + near) &&
               (part.upper == whole.upper || t < part.upper - near);
    }

    /// Whether the ray may meet the node: comes through its active box and its gate.
    [[nodiscard]] bool may_meet(const Node& node, const WorldRay& ray, Range range) const {
        return (node.unbounded || !clip(node.active, ray, range).empty()) && passes_gate(node, ray, range);
    }
    [[nodiscard]] bool passes_gate(const Node& node, const WorldRay& ray, Range range) const {
        return node.gate == kNoGate || !clip(gates_[node.gate], ray, {range.lower, kInfinity}).empty();
    }
    bool events(std::uint32_t node, const WorldRay& ray, Range range, EventList& out) const;
    [[nodiscard]] Event event_of(const Node& node, const Ray& in_shape, const Crossing& crossing,
                                 bool inside_before) const;
    void first_leaf_event(const Node& node, const WorldRay& ray, Range range, EventList& out) const;
    bool leaf_events(const Node& node, const WorldRay& ray, Range range, EventList& out) const;
    bool child_events(const Node& node, const ChildList& children, std::size_t place, const WorldRay& ray, Range range,
                      EventList& all, ChildStates& states) const;
    bool common_events(const Node& node, const ChildList& children, const WorldRay& ray, Range range, EventList& all,
                       ChildStates& states) const;
    bool convex_events(const Node& node, const WorldRay& ray, Range range, EventList& out) const;
    [[nodiscard]] Range range_of_clips(const Node& node, const WorldRay& ray, Range range) const;
    bool group_events(const Node& node, const WorldRay& ray, Range range, EventList& out) const;
    void nearest_event(std::uint32_t node, const WorldRay& ray, Range& range, std::optional<Event>& best) const;
    bool any_off_ends(std::uint32_t index, const WorldRay& ray, Range range, Range kept, bool& found) const;
    [[nodiscard]] bool any_event(std::uint32_t node, const WorldRay& ray, Range range) const;
    [[nodiscard]] bool inside_node(std::uint32_t node, Vec3d point) const;
    [[nodiscard]] Hit hit_of(const Event& event, const Ray& ray) const;

    std::vector<Node> nodes_;  ///< The root is first.
    std::vector<Leaf> leaves_;
    std::vector<BoundsTree> trees_;
    std::vector<Bounds3d> gates_;  ///< A ray that passes by a node's gate doesn't meet the node: POV-Ray's bounded_by.
    std::vector<std::uint32_t> materials_;
    Bounds3d surface_bounds_;
};

/// Flattens a solid: every shape gets its place in the world, every leaf its material (its own, else the nearest
/// group's above it, else `material`). Errors: InputError for shapes that can't be, singular transforms, and groups
/// nested more than 1,000 deep.
/// `textures` are the scene's, for functions of pigments; `needs_uv` says which materials look at texture coordinates
/// (left out: all).
std::shared_ptr<const CompiledSolid> compile_solid(const scene::Solid& solid, std::uint32_t material,
                                                   std::span<const scene::Texture> textures = {},
                                                   const std::function<bool(std::uint32_t)>& needs_uv = {});

/// Whether a solid is a flat union whose children may as well be objects of their own (POV-Ray's split_union): a
/// combined group that is neither inverted nor clipped.
bool can_be_split(const scene::Solid& solid);

}  // namespace sundog::solids
