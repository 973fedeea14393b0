// SPDX-License-Identifier: Apache-2.0
// From a solid as written to a CompiledSolid.
#include <algorithm>
#include <cmath>
#include <string>

#include "solids/compiled_solid.h"

namespace sundog::solids {

namespace {

/// Groups of one kind in each other are one group; those that are left nest no deeper than a ray's stack can go.
constexpr std::size_t kMaxNesting = 200;
constexpr std::size_t kMaxWrittenNesting = 5000;
/// From so many children on, a group has a tree over them.
constexpr std::size_t kTreeFrom = 8;

struct NodeBounds {
    Bounds3d inside, outside, surface;
};

/// A solid with what the groups above it say.
struct Placed {
    const scene::Solid* solid;
    Affine3d world_from_parent;
    std::uint32_t material, interior_material;
};

Combination combination_of(scene::SolidGroup::Kind kind) {
    switch (kind) {
        case scene::SolidGroup::Kind::combined:
            return Combination::combined;
        case scene::SolidGroup::Kind::merged:
            return Combination::merged;
        default:
            return Combination::common;
    }
}

Affine3d world_from_shape(const Placed& placed) {
    const Affine3d m = placed.world_from_parent * placed.solid->parent_from_shape;
    const double scale = length(m.x) * length(m.y) * length(m.z);
    if (!(std::abs(determinant(m)) > 1e-14 * scale) || !is_finite(m.x + m.y + m.z + m.t))
        refuse_shape(placed.solid->where, "this object's transforms flatten it", "no scale may be 0");
    return m;
}

/// There and back again, axes don't come to lie quite where they were: what is rounding beside a column's largest
/// number becomes 0, so that planes across axes are known as such.
Affine3d cleaned(Affine3d m) {
    for (Vec3d* column : {&m.x, &m.y, &m.z}) {
        const double most = std::max({std::abs(column->x), std::abs(column->y), std::abs(column->z)});
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (std::abs((*column)[axis]) < 1e-13 * most) (*column)[axis] = 0;
    }
    return m;
}

/// Grown by a millionth: more than cleaned() can move what is in it.
Bounds3d roomy(Bounds3d box) {
    if (box.empty()) return box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double ends = std::abs(box.lower[axis]) + std::abs(box.upper[axis]);
        if (!std::isfinite(ends)) continue;
        box.lower[axis] -= 1e-6 * ends;
        box.upper[axis] += 1e-6 * ends;
    }
    return box;
}

const char* kind_of(const scene::SolidSphere&) { return "a sphere"; }
const char* kind_of(const scene::SolidBox&) { return "a box"; }
const char* kind_of(const scene::SolidCone&) { return "a cone"; }
const char* kind_of(const scene::HalfSpace&) { return "a plane"; }
const char* kind_of(const scene::Torus&) { return "a torus"; }
const char* kind_of(const scene::Polynomial&) { return "a polynomial"; }
const char* kind_of(const scene::Superellipsoid&) { return "a superellipsoid"; }
const char* kind_of(const scene::Blob&) { return "a blob"; }
const char* kind_of(const scene::Lathe&) { return "a lathe"; }
const char* kind_of(const scene::SurfaceOfRevolution&) { return "a surface of revolution"; }
const char* kind_of(const scene::Prism&) { return "a prism"; }
const char* kind_of(const scene::SphereSweep&) { return "a sphere sweep"; }
const char* kind_of(const scene::HeightField&) { return "a height field"; }
const char* kind_of(const scene::Disc&) { return "a disc"; }
const char* kind_of(const scene::FlatPolygon&) { return "a polygon"; }
const char* kind_of(const scene::Isosurface&) { return "an isosurface"; }
const char* kind_of(const scene::JuliaFractal&) { return "a Julia fractal"; }
const char* kind_of(const scene::Ovus&) { return "an ovus"; }
const char* kind_of(const scene::Lemon&) { return "a lemon"; }
const char* kind_of(const scene::Parametric&) { return "a parametric surface"; }
const char* kind_of(const std::shared_ptr<const scene::SolidMesh>&) { return "a mesh"; }
const char* kind_of(const scene::SolidGroup&) { return "a group"; }

std::uint32_t own_or(std::uint32_t own, std::uint32_t above) { return own != scene::Solid::kInherited ? own : above; }

}  // namespace

class SolidCompiler {
public:
    explicit SolidCompiler(std::span<const scene::Texture> textures,
                           const std::function<bool(std::uint32_t)>& needs_uv = {})
        : textures_(textures), needs_uv_(needs_uv) {}

    std::shared_ptr<CompiledSolid> compile(const scene::Solid& solid, std::uint32_t material) {
        out_->nodes_.emplace_back();
        const NodeBounds bounds = place(0, {&solid, {}, material, scene::Solid::kInherited}, 0, true);
        out_->surface_bounds_ = bounds.surface;
        collect_materials();
        return out_;
    }

private:
    NodeBounds place(std::uint32_t index, const Placed& placed, std::size_t depth, bool with_clips) {
        if (depth > kMaxNesting)
            refuse_shape(placed.solid->where, "objects are nested more than " + std::to_string(kMaxNesting) + " deep");
        const scene::Solid& solid = *placed.solid;
        NodeBounds bounds;
        if (with_clips && !solid.clipped_by.empty()) {
            bounds = place_clipped(index, placed, depth);
        } else {
            if (const auto* group = std::get_if<scene::SolidGroup>(&solid.shape))
                bounds = place_group(index, placed, *group, depth);
            else bounds = place_leaf(index, placed);
            if (!solid.bounded_by.empty() && !is_finite(joined(bounds.inside, bounds.surface))) set_gate(index, placed);
            if (solid.inverted) {
                out_->nodes_[index].inverted = true;
                std::swap(bounds.inside, bounds.outside);
            }
        }
        set_active(out_->nodes_[index], bounds);
        return bounds;
    }

    NodeBounds place_leaf(std::uint32_t index, const Placed& placed) {
        const Affine3d m = world_from_shape(placed);
        CompiledSolid::Leaf leaf;
        leaf.shape = std::visit(
            [&](const auto& shape) -> ShapePointer {
                if constexpr (requires { make_shape(shape, placed.solid->where, textures_); })
                    return make_shape(shape, placed.solid->where, textures_);
                else if constexpr (requires { make_shape(shape, placed.solid->where); })
                    return make_shape(shape, placed.solid->where);
                else refuse_shape(placed.solid->where, "this kind of object can't be drawn yet");
            },
            placed.solid->shape);
        leaf.kind = std::visit([](const auto& shape) { return kind_of(shape); }, placed.solid->shape);
        leaf.shape_from_world = inverse(m);
        leaf.material = own_or(placed.solid->material, placed.material);
        leaf.interior_material = own_or(placed.solid->interior_material, placed.interior_material);
        const NodeBounds bounds = bounds_of_leaf(*leaf.shape, m);
        out_->nodes_[index].first = static_cast<std::uint32_t>(out_->leaves_.size());
        out_->nodes_[index].quick = leaf.shape->is_quick();
        out_->nodes_[index].convex = leaf.shape->is_convex();
        leaf.needs_uv = needs_uv(leaf);
        out_->leaves_.push_back(std::move(leaf));
        return bounds;
    }

    [[nodiscard]] bool needs_uv(const CompiledSolid::Leaf& leaf) const {
        if (!needs_uv_ || needs_uv_(leaf.material)) return true;
        if (leaf.interior_material != scene::Solid::kInherited && needs_uv_(leaf.interior_material)) return true;
        const std::vector<std::uint32_t> own = leaf.shape->materials();
        return std::any_of(own.begin(), own.end(), needs_uv_);
    }

    NodeBounds place_group(std::uint32_t index, const Placed& placed, const scene::SolidGroup& group,
                           std::size_t depth) {
        std::vector<Placed> children;
        gather(placed, group, children, 0);
        Combination combination = combination_of(group.kind);
        // What is cut away by a union loses the union's inner surfaces: outside of all is what all have in common
        // outside.
        if (combination == Combination::combined && placed.solid->inverted) combination = Combination::merged;
        return place_children(index, combination, children, frame_of(placed), depth);
    }

    NodeBounds place_clipped(std::uint32_t index, const Placed& placed, std::size_t depth) {
        std::vector<Placed> children{placed};
        for (const std::shared_ptr<const scene::Solid>& clip : placed.solid->clipped_by)
            children.push_back({clip.get(), placed.world_from_parent, placed.material, placed.interior_material});
        return place_children(index, Combination::clipped, children, frame_of(placed), depth);
    }

    /// A box around what a solid's `bounded_by` have in common, as the node's gate.
    void set_gate(std::uint32_t index, const Placed& placed) {
        Bounds3d box = everywhere();
        for (const std::shared_ptr<const scene::Solid>& bound : placed.solid->bounded_by) {
            SolidCompiler aside(textures_);
            aside.out_->nodes_.emplace_back();
            const NodeBounds b = aside.place(0, {bound.get(), placed.world_from_parent, 0, 0}, 0, true);
            box = common(box, joined(b.inside, b.surface));
        }
        if (box.empty() || !is_finite(box)) return;
        out_->nodes_[index].gate = static_cast<std::uint32_t>(out_->gates_.size());
        out_->gates_.push_back(padded(box));
    }

    /// The children of a group, and in their place those of groups of its kind among them.
    void gather(const Placed& placed, const scene::SolidGroup& group, std::vector<Placed>& children,
                std::size_t depth) {
        if (depth > kMaxWrittenNesting)
            refuse_shape(placed.solid->where,
                         "objects are nested more than " + std::to_string(kMaxWrittenNesting) + " deep");
        const scene::Solid& solid = *placed.solid;
        const Affine3d world_from_group = placed.world_from_parent * solid.parent_from_shape;
        const std::uint32_t material = own_or(solid.material, placed.material);
        const std::uint32_t interior = own_or(solid.interior_material, placed.interior_material);
        for (const std::shared_ptr<const scene::Solid>& child : group.children) {
            const Placed below{child.get(), world_from_group, material, interior};
            const auto* inner = std::get_if<scene::SolidGroup>(&child->shape);
            if (inner && inner->kind == group.kind && !child->inverted && child->clipped_by.empty())
                gather(below, *inner, children, depth + 1);
            else children.push_back(below);
        }
    }

    /// Where a group's children were written.
    static Affine3d frame_of(const Placed& placed) {
        return placed.world_from_parent * placed.solid->parent_from_shape;
    }

    NodeBounds place_children(std::uint32_t index, Combination combination, const std::vector<Placed>& children,
                              const Affine3d& world_from_frame, std::size_t depth) {
        const auto first = static_cast<std::uint32_t>(out_->nodes_.size());
        out_->nodes_.resize(first + children.size());
        std::vector<NodeBounds> bounds;
        std::vector<Bounds3d> active;
        std::uint32_t always_inside = 0;
        for (std::size_t i = 0; i < children.size(); ++i) {
            const bool with_clips = combination != Combination::clipped || i > 0;
            const auto slot = first + static_cast<std::uint32_t>(i);
            bounds.push_back(place(slot, children[i], depth + 1, with_clips));
            active.push_back(out_->nodes_[slot].active);
            if (out_->nodes_[slot].state_beyond) ++always_inside;
        }
        CompiledSolid::Node& node = out_->nodes_[index];
        node.combination = combination;
        node.first = first;
        node.count = static_cast<std::uint32_t>(children.size());
        node.always_inside = always_inside;
        const auto all_convex = [&](std::uint32_t from) {
            return std::all_of(out_->nodes_.begin() + from, out_->nodes_.begin() + first + node.count,
                               [&](const CompiledSolid::Node& child) {
                                   return child.combination == Combination::leaf &&
                                          !(child.inverted && combination == Combination::clipped) &&
                                          out_->leaves_[child.first].shape->is_convex();
                               });
        };
        node.convex_parts = combination == Combination::common && children.size() < kTreeFrom && all_convex(first);
        node.convex_clips = combination == Combination::clipped && all_convex(first + 1);
        if (children.size() >= kTreeFrom && combination != Combination::clipped) {
            node.tree = static_cast<std::uint32_t>(out_->trees_.size());
            out_->trees_.emplace_back(active);
        }
        if (combination == Combination::combined || combination == Combination::merged) return bounds_of_union(bounds);
        NodeBounds together = bounds_of_common(bounds, combination == Combination::clipped);
        if (!is_finite(reach_of(together)) && !reach_of(together).empty()) narrow(index, world_from_frame, together);
        return together;
    }

    static Bounds3d reach_of(const NodeBounds& bounds) { return joined(bounds.inside, bounds.surface); }

    /// Shapes without an end are bounded by what cuts them; boxes tell that best along the axes that they were written
    /// along.
    void narrow(std::uint32_t index, const Affine3d& world_from_frame, NodeBounds& bounds) const {
        const double scale = length(world_from_frame.x) * length(world_from_frame.y) * length(world_from_frame.z);
        if (!(std::abs(determinant(world_from_frame)) > 1e-14 * scale)) return;
        const Bounds3d in_frame = reach_of(bounds_in(index, inverse(world_from_frame)));
        const Bounds3d reach = transformed(world_from_frame, roomy(in_frame));
        bounds.inside = common(bounds.inside, reach);
        bounds.surface = common(bounds.surface, reach);
    }

    /// What a node's bounds would be in another space.
    NodeBounds bounds_in(std::uint32_t index, const Affine3d& frame_from_world) const {
        const CompiledSolid::Node& node = out_->nodes_[index];
        NodeBounds bounds;
        if (node.combination == Combination::leaf) {
            const CompiledSolid::Leaf& leaf = out_->leaves_[node.first];
            bounds = bounds_of_leaf(*leaf.shape, cleaned(frame_from_world * inverse(leaf.shape_from_world)));
        } else {
            std::vector<NodeBounds> children;
            for (std::uint32_t child = 0; child < node.count; ++child)
                children.push_back(bounds_in(node.first + child, frame_from_world));
            if (node.combination == Combination::combined || node.combination == Combination::merged) {
                bounds = bounds_of_union(children);
            } else {
                bounds = bounds_of_common(children, node.combination == Combination::clipped);
                // Twice, as one shape's end may be another's.
                for (std::uint32_t i = 0; i < 2 * node.count; ++i) {
                    const CompiledSolid::Node& child = out_->nodes_[node.first + i % node.count];
                    if (child.combination != Combination::leaf || child.inverted) continue;
                    const CompiledSolid::Leaf& leaf = out_->leaves_[child.first];
                    const Bounds3d reach = leaf.shape->bounds_within(
                        cleaned(frame_from_world * inverse(leaf.shape_from_world)), reach_of(bounds));
                    bounds.inside = common(bounds.inside, reach);
                    bounds.surface = common(bounds.surface, reach);
                }
            }
        }
        if (node.inverted) std::swap(bounds.inside, bounds.outside);
        return bounds;
    }

    static NodeBounds bounds_of_leaf(const Shape& shape, const Affine3d& m) {
        NodeBounds bounds{shape.inside_bounds(m), shape.outside_bounds(m), shape.bounds(m)};
        // A solid's surface is where inside and outside meet.
        if (!bounds.inside.empty()) bounds.surface = common(bounds.surface, common(bounds.inside, bounds.outside));
        return bounds;
    }

    static NodeBounds bounds_of_union(const std::vector<NodeBounds>& children) {
        NodeBounds out{{}, everywhere(), {}};
        for (const NodeBounds& child : children) {
            out.inside = joined(out.inside, child.inside);
            out.outside = common(out.outside, child.outside);
            out.surface = joined(out.surface, child.surface);
        }
        return out;
    }
    static NodeBounds bounds_of_common(const std::vector<NodeBounds>& children, bool first_surface_only) {
        NodeBounds out{everywhere(), {}, {}};
        Bounds3d reach = everywhere();
        for (const NodeBounds& child : children) {
            out.inside = common(out.inside, child.inside);
            out.outside = joined(out.outside, child.outside);
            if (!first_surface_only || &child == &children.front()) out.surface = joined(out.surface, child.surface);
            reach = common(reach, joined(child.inside, child.surface));
        }
        out.surface = common(out.surface, reach);
        return out;
    }
    static void set_active(CompiledSolid::Node& node, const NodeBounds& bounds) {
        const Bounds3d reach = joined(bounds.inside, bounds.surface);
        const Bounds3d void_reach = joined(bounds.outside, bounds.surface);
        node.state_beyond = !is_finite(reach) && !reach.empty() && (is_finite(void_reach) || void_reach.empty());
        node.active = padded(node.state_beyond ? void_reach : reach);
        node.unbounded = node.active.lower == everywhere().lower && node.active.upper == everywhere().upper;
    }

    void collect_materials() {
        std::vector<std::uint32_t>& materials = out_->materials_;
        for (const CompiledSolid::Leaf& leaf : out_->leaves_) {
            materials.push_back(leaf.material);
            if (leaf.interior_material != scene::Solid::kInherited) materials.push_back(leaf.interior_material);
            for (const std::uint32_t own : leaf.shape->materials()) materials.push_back(own);
        }
        std::sort(materials.begin(), materials.end());
        materials.erase(std::unique(materials.begin(), materials.end()), materials.end());
    }

    std::span<const scene::Texture> textures_;
    std::function<bool(std::uint32_t)> needs_uv_;
    std::shared_ptr<CompiledSolid> out_ = std::make_shared<CompiledSolid>();
};

std::shared_ptr<const CompiledSolid> compile_solid(const scene::Solid& solid, std::uint32_t material,
                                                   std::span<const scene::Texture> textures,
                                                   const std::function<bool(std::uint32_t)>& needs_uv) {
    return SolidCompiler(textures, needs_uv).compile(solid, material);
}

bool can_be_split(const scene::Solid& solid) {
    const auto* group = std::get_if<scene::SolidGroup>(&solid.shape);
    return group != nullptr && group->kind == scene::SolidGroup::Kind::combined && !solid.inverted &&
           solid.clipped_by.empty();
}

}  // namespace sundog::solids
