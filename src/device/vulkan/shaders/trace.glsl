// SPDX-License-Identifier: Apache-2.0
// Traversal of the wide hierarchy: trace_closest and trace_any as integrators/whitted.h wants them.
#include "device/bvh/node_hits.h"
#include "kernel/shapes/all_planes.h"
#include "kernel/shapes/box.h"
#include "kernel/shapes/sphere.h"
#include "kernel/shapes/triangle.h"

layout(scalar, set = 0, binding = BINDING_NODES) readonly restrict buffer nodes_buffer { WideNode nodes[]; };
layout(scalar, set = 0, binding = BINDING_LEAVES) readonly restrict buffer leaves_buffer { Leaf leaves[]; };
layout(scalar, set = 0, binding = BINDING_TOP_REFS) readonly restrict buffer top_refs_buffer { TopRef top_refs[]; };

/// The inner children of one node that are still to be visited.
struct NodeGroup {
    uint child_base;
    uint masks;  ///< Bits 0 to 7: children, by slot ^ octant; bits 8 to 15: which slots hold inner nodes.
};

const uint GROUP_CHILDREN = 0xffu;

/// The group that holds nothing but a root: with no inner slots before it, every slot is node child_base itself.
NodeGroup root_group(uint root) { return NodeGroup(root, 1u); }

vec3 point_to_instance(uint instance, vec3 p) {
    return instances[instance].object_from_world_x * p.x + instances[instance].object_from_world_y * p.y +
           instances[instance].object_from_world_z * p.z + instances[instance].object_from_world_t;
}

vec3 vector_to_instance(uint instance, vec3 v) {
    return instances[instance].object_from_world_x * v.x + instances[instance].object_from_world_y * v.y +
           instances[instance].object_from_world_z * v.z;
}

/// The ray in an instance's own space. Its direction keeps the length that makes t the same in both.
Ray ray_to_instance(uint instance, Ray ray) {
    if (instance != NONE) {
        ray.origin = point_to_instance(instance, ray.origin);
        ray.direction = vector_to_instance(instance, ray.direction);
    }
    return ray;
}

bool is_culled(uint material, vec3 normal, vec3 direction) {
    return FEATURE(FEATURE_CULL) && dot(normal, direction) >= 0.0f &&
           (materials[material].flags & MATERIAL_TRANSPARENT) == 0u;
}

#ifdef SUNDOG_SOLIDS
#include "device/vulkan/shaders/solids.glsl"
#endif

/// Hits so near to each other, relative to their distance, are at one place (accel/primitive_facts.h).
const float COINCIDENT = 1e-6f;

/// How far to look for hits that may be at the place of the one so far, or nearer.
float reach_of(Hit hit) {
    return (FEATURE(FEATURE_ANALYTIC) && hit.geometry != NONE) ? hit.t * (1.0f + COINCIDENT) : hit.t;
}

/// Whether a shape's surface counts before the hit so far: if it is nearer, or at its place and before it in order, as on
/// the CPU (cpu/coincidence.h). What is left comes before what is entered, then what was written first. Planes, which
/// are asked before all else, know but the order.
bool comes_before(Hit hit, Ray ray, float t, vec3 normal, uint geometry, uint primitive) {
    if (hit.geometry == NONE || abs(t - hit.t) > COINCIDENT * hit.t) return t < hit.t;
    bool leaves = dot(normal, ray.direction) > 0.0f;
    bool comparable = geometries[hit.geometry].kind != GEOMETRY_PLANE &&
                      geometries[hit.geometry].instance == geometries[geometry].instance;
    bool other_leaves = comparable ? dot(hit.normal, ray.direction) > 0.0f : leaves;
    if (leaves != other_leaves) return leaves;
    return geometry < hit.geometry || (geometry == hit.geometry && primitive < hit.primitive);
}

/// Tests the primitive at `place` of the leaves; where it counts before the hit so far, makes it the hit.
bool hit_leaf(uint place, Ray ray, uint ray_kind, inout Hit hit) {
    Leaf leaf = leaves[place];
    if (FEATURE(FEATURE_HIDDEN) && (geometries[leaf.geometry].hidden_from & ray_kind) != 0u) return false;
    float t;
    float u = 0.0f;
    float v = 0.0f;
    vec3 normal;
    uint kind = GEOMETRY_TRIANGLES;
    if (FEATURE(FEATURE_ANALYTIC)) kind = geometries[leaf.geometry].kind;
    if (kind == GEOMETRY_TRIANGLES) {
        ray.t_max = hit.t;
        if (!intersect_triangle(ray, leaf.a, leaf.b, leaf.c, t, u, v, normal)) return false;
        uint material = triangles[leaf.primitive].material;
        if (FEATURE(FEATURE_CULL) && is_culled(material, normal, ray.direction)) return false;
        if (FEATURE(FEATURE_ONE_SIDED) && (ray_kind & RAY_CAMERA) != 0u && dot(normal, ray.direction) >= 0.0f &&
            (materials[material].flags & MATERIAL_ONE_SIDED) != 0u)
            return false;
    } else if (kind == GEOMETRY_SPHERE) {
        if (!intersect_sphere(ray, leaf.a, leaf.b.x, t, normal)) return false;
        if (FEATURE(FEATURE_CULL) && is_culled(spheres[leaf.primitive].material, normal, ray.direction)) return false;
#ifdef SUNDOG_SOLIDS
    } else if (kind == GEOMETRY_SOLID) {
        SolidHit found;
        if (!intersect_solid(leaf.primitive, ray, found)) return false;
        if (!comes_before(hit, ray, found.t, found.normal, leaf.geometry, 0u)) return false;
        hit = Hit(min(found.t, hit.t), found.u, found.v, leaf.geometry, found.material, found.normal);
        return true;
#endif
    } else {
        if (!intersect_box(ray, leaf.a, leaf.b, t, normal)) return false;
        if (FEATURE(FEATURE_CULL) && is_culled(boxes[leaf.primitive].material, normal, ray.direction)) return false;
    }
    if (kind != GEOMETRY_TRIANGLES) {
        if (!comes_before(hit, ray, t, normal, leaf.geometry, leaf.primitive)) return false;
        t = min(t, hit.t);
    }
    hit = Hit(t, u, v, leaf.geometry, leaf.primitive, normal);
    return true;
}

/// Nearest hit of the ray in (t_min, t_max), or the first one found where any will do.
///
/// One loop for both levels. Where things move, nodes[0] is the root of the top level, whose leaves are hierarchies:
/// their roots wait in `pending` until the ray, carried to their space, has gone through each.
Hit trace(Ray world_ray, uint ray_kind, bool any_will_do) {
    Hit hit = Hit(world_ray.t_max, 0.0f, 0.0f, NONE, NONE, vec3(0.0f));
    if (FEATURE(FEATURE_ANALYTIC)) {
        closest_plane(world_ray, ray_kind, true, hit);
        if (any_will_do && hit.geometry != NONE) return hit;
    }
    NodeGroup stack[stack_size];
    uint waiting = 0u;
    uint waiting_outside = 0u;  // entries that belong to the top level
    bool inside = !FEATURE(FEATURE_INSTANCES);
    uint pending = 0u;
    uint pending_base = 0u;
    Ray ray = world_ray;
    BoxRay box = box_ray(ray.origin, ray.direction);
    NodeGroup group = root_group(0u);
    while (true) {
        if ((group.masks & GROUP_CHILDREN) == 0u) {
            if (FEATURE(FEATURE_INSTANCES)) {
                if (inside && waiting == waiting_outside) {
                    inside = false;
                    ray = world_ray;
                    box = box_ray(ray.origin, ray.direction);
                }
                if (!inside && pending != 0u) {
                    TopRef top = top_refs[pending_base + uint(findLSB(pending))];
                    pending &= pending - 1u;
                    inside = true;
                    waiting_outside = waiting;
                    ray = ray_to_instance(top.instance, world_ray);
                    box = box_ray(ray.origin, ray.direction);
                    group = root_group(top.root);
                    continue;
                }
            }
            if (waiting == 0u) break;
            --waiting;
            group = stack[waiting];
        }
        uint bit = uint(findLSB(group.masks));
        group.masks &= ~(1u << bit);
        uint slot = bit ^ box.octant;
        WideNode node = nodes[group.child_base + bitCount((group.masks >> 8u) & ((1u << slot) - 1u))];
        uint inner_hits;
        uint primitive_hits;
        node_hits(node, box, ray.t_min, reach_of(hit), inner_hits, primitive_hits);
        if ((group.masks & GROUP_CHILDREN) != 0u) {
            stack[waiting] = group;
            ++waiting;
        }
        group = NodeGroup(node.child_base, ((node.exponents >> 16u) & 0xff00u) | inner_hits);
        if (FEATURE(FEATURE_INSTANCES) && !inside) {
            if (primitive_hits != 0u) {
                pending = primitive_hits;
                pending_base = node.primitive_base;
                if (inner_hits != 0u) {
                    stack[waiting] = group;
                    ++waiting;
                }
                group.masks = 0u;
            }
        } else {
            while (primitive_hits != 0u) {
                uint place = node.primitive_base + uint(findLSB(primitive_hits));
                primitive_hits &= primitive_hits - 1u;
                ray.t_max = reach_of(hit);
                if (hit_leaf(place, ray, ray_kind, hit) && any_will_do) return hit;
            }
        }
    }
    return hit;
}

Hit trace_closest(Ray ray, bool alive, uint ray_kind, bool together) {
    if (!alive) return Hit(ray.t_max, 0.0f, 0.0f, NONE, NONE, vec3(0.0f));
    return trace(ray, ray_kind, false);
}

bool trace_any(Ray ray, bool alive, uint ray_kind) {
    if (!alive) return false;
    return trace(ray, ray_kind, true).geometry != NONE;
}
