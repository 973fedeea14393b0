// SPDX-License-Identifier: Apache-2.0
#include "device/vulkan/hierarchy.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/diagnostics.h"
#include "solids/compiled_solid.h"

namespace sundog::vulkan {
namespace {

Vec3 to_vec3(kernel::vec3 v) { return {v.x, v.y, v.z}; }

std::size_t number_of_solid(const RenderScene& scene, std::uint32_t geometry) {
    const auto placed = std::lower_bound(scene.solids.begin(), scene.solids.end(), geometry,
                                         [](const PlacedSolid& s, std::uint32_t g) { return s.geometry < g; });
    if (placed == scene.solids.end() || placed->geometry != geometry)
        throw DeviceError("geometry " + std::to_string(geometry) + " is a solid, but the scene holds none for it");
    return static_cast<std::size_t>(placed - scene.solids.begin());
}

/// A primitive with its shape; `solids` as in build_hierarchy().
kernel::Leaf leaf_of(const RenderScene& scene, const SolidSlots& solids, std::uint32_t primitive,
                     std::uint32_t geometry) {
    switch (scene.geometries[geometry].kind) {
        case kernel::GEOMETRY_SPHERE: {
            const kernel::Sphere& sphere = scene.spheres[primitive];
            return {sphere.center, {sphere.radius, 0, 0}, {0, 0, 0}, primitive, geometry};
        }
        case kernel::GEOMETRY_BOX:
            return {scene.boxes[primitive].lower, scene.boxes[primitive].upper, {0, 0, 0}, primitive, geometry};
        case kernel::GEOMETRY_SOLID:
            return {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, solids.roots[number_of_solid(scene, geometry)], geometry};
        default: {
            const kernel::Triangle& triangle = scene.triangles[primitive];
            return {scene.positions[triangle.p0], scene.positions[triangle.p1], scene.positions[triangle.p2], primitive,
                    geometry};
        }
    }
}

/// Widens a box by the rounding that went into its planes.
Bounds3 padded(Bounds3 box, float relative) {
    const auto pad = [&](float a, float b) { return relative * std::max(std::fabs(a), std::fabs(b)); };
    const Vec3 by{pad(box.lower.x, box.upper.x), pad(box.lower.y, box.upper.y), pad(box.lower.z, box.upper.z)};
    return {box.lower - by, box.upper + by};
}

/// Solids without an end get a box that reaches far beyond all else.
Bounds3 bounds_of_solid(const solids::CompiledSolid& solid) {
    constexpr double farthest = 1e12;
    const auto within = [&](double v) { return static_cast<float>(std::clamp(v, -farthest, farthest)); };
    const Bounds3d& b = solid.bounds();
    Bounds3 box;
    box.include(Vec3{within(b.lower.x), within(b.lower.y), within(b.lower.z)});
    box.include(Vec3{within(b.upper.x), within(b.upper.y), within(b.upper.z)});
    return padded(box, 2.4e-7F);
}

Bounds3 bounds_of(const RenderScene& scene, const kernel::Leaf& leaf) {
    Bounds3 box;
    switch (scene.geometries[leaf.geometry].kind) {
        case kernel::GEOMETRY_SPHERE: {
            const float radius = std::fabs(leaf.b.x);
            const Vec3 extent{radius, radius, radius};
            return padded({to_vec3(leaf.a) - extent, to_vec3(leaf.a) + extent}, 2.4e-7F);
        }
        case kernel::GEOMETRY_BOX:
            box.include(to_vec3(leaf.a));
            box.include(to_vec3(leaf.b));
            return box;
        case kernel::GEOMETRY_SOLID:
            return bounds_of_solid(*scene.solids[number_of_solid(scene, leaf.geometry)].solid);
        default:
            box.include(to_vec3(leaf.a));
            box.include(to_vec3(leaf.b));
            box.include(to_vec3(leaf.c));
            return box;
    }
}

/// The primitives of the given geometries, in the scene's order.
std::vector<kernel::Leaf> leaves_of(const RenderScene& scene, const SolidSlots& solids,
                                    std::span<const std::uint32_t> geometries) {
    std::vector<kernel::Leaf> leaves;
    for (const std::uint32_t g : geometries) {
        const kernel::Geometry& geometry = scene.geometries[g];
        for (std::uint32_t i = 0; i < geometry.primitive_count; ++i) {
            const kernel::Leaf leaf = leaf_of(scene, solids, geometry.first_primitive + i, g);
            // A solid that clips leave nothing of has no place in a hierarchy.
            const bool nothing = geometry.kind == kernel::GEOMETRY_SOLID &&
                                 scene.solids[number_of_solid(scene, g)].solid->bounds().empty();
            if (!nothing) leaves.push_back(leaf);
        }
    }
    return leaves;
}

void append_part(const RenderScene& scene, const SolidSlots& solids, std::span<const std::uint32_t> geometries,
                 std::uint32_t instance, Hierarchy& out) {
    const auto leaves = leaves_of(scene, solids, geometries);
    if (leaves.empty()) return;
    std::vector<Bounds3> bounds(leaves.size());
    tbb::parallel_for(std::size_t{0}, leaves.size(), [&](std::size_t i) { bounds[i] = bounds_of(scene, leaves[i]); });
    const bvh::WideBvh part = bvh::build(bounds);

    const auto first_node = static_cast<std::uint32_t>(out.nodes.size());
    const auto first_leaf = static_cast<std::uint32_t>(out.leaves.size());
    for (kernel::WideNode node : part.nodes) {
        node.child_base += first_node;
        node.primitive_base += first_leaf;
        out.nodes.push_back(node);
    }
    out.leaves.resize(first_leaf + leaves.size());
    tbb::parallel_for(std::size_t{0}, leaves.size(),
                      [&](std::size_t i) { out.leaves[first_leaf + i] = leaves[part.order[i]]; });
    out.parts.push_back({first_node, instance, part.bounds});
    out.depth = std::max(out.depth, part.depth);
}

Bounds3 to_world(const kernel::Instance& instance, const Bounds3& box) {
    const Affine3 world_from_object{to_vec3(instance.world_from_object_x), to_vec3(instance.world_from_object_y),
                                    to_vec3(instance.world_from_object_z), to_vec3(instance.world_from_object_t)};
    Bounds3 out;
    Vec3 largest = max(-world_from_object.t, world_from_object.t);
    for (unsigned corner = 0; corner < 8; ++corner) {
        const Vec3 p{corner & 1U ? box.upper.x : box.lower.x, corner & 2U ? box.upper.y : box.lower.y,
                     corner & 4U ? box.upper.z : box.lower.z};
        const Vec3 turned = transform_vector(world_from_object, p);
        largest = max(largest, max(-turned, turned));
        out.include(turned + world_from_object.t);
    }
    // Rotation and translation may cancel: what rounding took is measured by the largest number on the way.
    const Vec3 slack = largest * 2e-6F;
    return {out.lower - slack, out.upper + slack};
}

}  // namespace

Hierarchy build_hierarchy(const RenderScene& scene, const SolidSlots& solids) {
    std::vector<std::uint32_t> at_rest;
    std::vector<std::uint32_t> moving;
    for (std::uint32_t g = 0; g < scene.geometries.size(); ++g) {
        const kernel::Geometry& geometry = scene.geometries[g];
        if (geometry.kind == kernel::GEOMETRY_PLANE || geometry.primitive_count == 0) continue;
        (geometry.instance == kernel::NONE ? at_rest : moving).push_back(g);
    }
    Hierarchy hierarchy;
    if (scene.features & kernel::FEATURE_INSTANCES) {
        // A node of a hierarchy over n things has two children or more, unless it is the only one.
        hierarchy.top_capacity = static_cast<std::uint32_t>(moving.size()) + 1;
        hierarchy.nodes.resize(hierarchy.top_capacity);
    }
    append_part(scene, solids, at_rest, kernel::NONE, hierarchy);
    for (const std::uint32_t g : moving) {
        append_part(scene, solids, std::span(&g, 1), scene.geometries[g].instance, hierarchy);
    }
    if (hierarchy.nodes.empty()) hierarchy.nodes = bvh::build({}).nodes;
    return hierarchy;
}

TopLevel build_top_level(const Hierarchy& hierarchy, const Frame& frame) {
    std::vector<Bounds3> bounds;
    std::vector<kernel::TopRef> refs;
    for (const Part& part : hierarchy.parts) {
        Bounds3 box = part.bounds;
        if (part.instance != kernel::NONE) {
            if (part.instance >= frame.instances.size()) continue;
            box = to_world(frame.instances[part.instance], part.bounds);
        }
        // A placement that overflows shows nothing, as its rays can't be carried there either.
        if (!is_finite(box.lower) || !is_finite(box.upper)) continue;
        bounds.push_back(box);
        refs.push_back({part.root, part.instance});
    }
    bvh::WideBvh top = bvh::build(bounds);
    TopLevel level{std::move(top.nodes), {}, top.depth};
    for (const std::uint32_t i : top.order) level.refs.push_back(refs[i]);
    return level;
}

}  // namespace sundog::vulkan
