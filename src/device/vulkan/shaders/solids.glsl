// SPDX-License-Identifier: Apache-2.0
// Exact solids. A ray's crossings with a solid's leaves are looked at one after the other, nearest first, until one shows:
// whether it does is told by what is inside just before and just after it. So there is no list of crossings that could
// overflow. What it means to be inside of a group, and which of coinciding faces counts, is as in solids/compiled_solid.cpp.

layout(scalar, set = 0, binding = BINDING_SOLIDS) readonly restrict buffer solids_buffer { double solid_slots[]; };
/// How deep groups lie in each other at most; 0: all solids are single shapes.
layout(constant_id = 5) const uint solid_depth = 0u;

uvec2 solid_words(uint place) { return unpackDouble2x32(solid_slots[place]); }

#include "device/vulkan/shaders/solid_shapes.glsl"

vec2 solid_floats(uint place) { return uintBitsToFloat(solid_words(place)); }

const uint BEFORE = 1u;
const uint AFTER = 2u;
const uint ALWAYS = 3u;

/// Crossings so near to each other, relative to the distances in question, are at one place.
const double SOLID_COINCIDENT = 1e-10lf;

struct SolidBox {
    dvec3 lower, upper;
};
SolidBox solid_box(uint place) {
    vec2 a = solid_floats(place);
    vec2 b = solid_floats(place + 1u);
    vec2 c = solid_floats(place + 2u);
    return SolidBox(dvec3(a.x, a.y, b.x), dvec3(b.y, c.x, c.y));
}
bool in_box(SolidBox box, dvec3 p) {
    return all(greaterThanEqual(p, box.lower)) && all(lessThanEqual(p, box.upper));
}

bool passes_gate(uint node, uint flags, SolidRay ray) {
    if ((flags & SOLID_GATED) == 0u) return true;
    SolidBox gate = solid_box(solid_words(node + 2u).x);
    SolidRay endless = ray;
    endless.to = SOLID_FAR;
    dvec2 part = clip_to_box(gate.lower, gate.upper, endless);
    return part.x <= part.y;
}

bool is_union(uint flags) {
    uint combination = flags & SOLID_COMBINATION;
    return combination == SOLID_COMBINED || combination == SOLID_MERGED;
}

dvec3 point_to_shape(uint leaf, dvec3 p) {
    return solid_vector(leaf + 1u) * p.x + solid_vector(leaf + 4u) * p.y + solid_vector(leaf + 7u) * p.z +
           solid_vector(leaf + 10u);
}
dvec3 vector_to_shape(uint leaf, dvec3 v) {
    return solid_vector(leaf + 1u) * v.x + solid_vector(leaf + 4u) * v.y + solid_vector(leaf + 7u) * v.z;
}

/// What of two points is inside of a node: BEFORE, AFTER, both or none.
uint solid_state(uint first, SolidRay ray, dvec3 before, dvec3 after) {
    uint node = first;
    uint states = 0u;  // of the groups that the node is in, two bits each, the innermost one's lowest
    while (true) {
        uvec2 head = solid_words(node);
        uint state = 0u;
        bool decided = false;
        if (!passes_gate(node, head.x, ray)) {
            decided = true;
        } else if ((head.x & SOLID_UNBOUNDED) == 0u) {
            SolidBox box = solid_box(node + SOLID_NODE_BOX);
            if (!in_box(box, before) && !in_box(box, after)) {
                // What is beyond is told of the node as it stands, inverted or not.
                state = ((head.x & SOLID_BEYOND) != 0u) != ((head.x & SOLID_INVERTED) != 0u) ? ALWAYS : 0u;
                decided = true;
            }
        }
        if (!decided) {
            if ((head.x & SOLID_COMBINATION) == SOLID_LEAF) {
                uint leaf = solid_words(node + 1u).y;
                uint kind = head.x >> SOLID_KIND_SHIFT;
                // In a loop, so that its code is there once.
                dvec3 p = point_to_shape(leaf, before);
                dvec3 way = vector_to_shape(leaf, after - before);
                for (uint bit = BEFORE; bit <= AFTER; bit <<= 1u) {
                    if (inside_shape(kind, leaf + SOLID_LEAF_NUMBERS, p)) state |= bit;
                    p += way;
                }
            } else {
                states = (states << 2u) | (is_union(head.x) ? 0u : ALWAYS);
                node += SOLID_NODE_SLOTS;
                continue;
            }
        }
        // The node is known: so may be the groups around it.
        uint next = head.y;
        while (true) {
            if ((head.x & SOLID_INVERTED) != 0u) state = ALWAYS - state;
            if (node == first) return state;
            node = solid_words(node + 1u).x;
            head = solid_words(node);
            bool joins = is_union(head.x);
            state = joins ? (states & ALWAYS) | state : states & state;
            if (state != (joins ? ALWAYS : 0u) && next != head.y) {
                states = (states & ~ALWAYS) | state;
                node = next;
                break;
            }
            next = head.y;
            states >>= 2u;
        }
    }
    return 0u;
}

/// Whether a crossing shows: no group around its leaf hides it. `faces_ray` tells if the outer side is the one that the
/// ray comes from, `flipped` if the leaf is inverted on the way up.
bool crossing_shows(SolidCrossing crossing, SolidRay ray, inout bool faces_ray, out bool flipped) {
    flipped = false;
    if ((crossing.flags & CROSSING_VISIBLE) == 0u) return false;
    if (solid_depth == 0u) {
        flipped = (solid_words(crossing.leaf).x & SOLID_INVERTED) != 0u;
        faces_ray = faces_ray != flipped;
        return true;
    }
    double near = SOLID_COINCIDENT *
                  (abs(crossing.t) + sqrt(dot(ray.origin, ray.origin) / dot(ray.direction, ray.direction)));
    dvec3 before = ray.origin + ray.direction * (crossing.t - near);
    dvec3 after = ray.origin + ray.direction * (crossing.t + near);
    bool toggles = (crossing.flags & CROSSING_TOGGLES) != 0u;
    uint state = 0u;
    if (toggles) state = (crossing.flags & CROSSING_ENTERS) != 0u ? AFTER : BEFORE;
    uint node = crossing.leaf;
    uint flags = solid_words(node).x;
    while (true) {
        if ((flags & SOLID_INVERTED) != 0u) {
            state = ALWAYS - state;
            faces_ray = !faces_ray;
            flipped = !flipped;
        }
        uint group = solid_words(node + 1u).x;
        if (group == NONE) return true;
        uvec2 head = solid_words(group);
        flags = head.x;
        uint combination = flags & SOLID_COMBINATION;
        bool joins = is_union(flags);
        if (combination == SOLID_CLIPPED && node != group + SOLID_NODE_SLOTS) return false;
        uint together = state;
        bool taken = false;  // by a child that comes first and has a face here, too
        for (uint child = group + SOLID_NODE_SLOTS; child != head.y; child = solid_words(child).y) {
            if (child == node) continue;
            uint other = solid_state(child, ray, before, after);
            if (combination == SOLID_MERGED && other == ALWAYS) return false;
            if (!joins && other == 0u) return false;
            if (other == BEFORE || other == AFTER) {
                if (child < node && other == state) taken = true;
                // What is left comes before what is entered.
                if (combination == SOLID_COMBINED && state == AFTER && other == BEFORE) taken = true;
            }
            together = joins ? together | other : together & other;
        }
        if (toggles) {
            if (taken) return false;
            // The face is the group's only if the group changes as it does.
            if (combination != SOLID_COMBINED && together != state) return false;
        }
        state = together;
        node = group;
    }
}

/// Finds the crossing that comes next.
void search_solid(uint root, SolidRay ray, inout SolidSearch search) {
    uint last = search.leaf;
    uint end = solid_words(root).y;
    uint node = root;
    while (node != end) {
        uvec2 head = solid_words(node);
        // However far the search has come, a shape is asked about the same part of the ray: so its crossings stay where
        // they are, to the bit.
        dvec2 within = dvec2(ray.from, ray.to);
        if ((head.x & SOLID_UNBOUNDED) == 0u) {
            SolidBox box = solid_box(node + SOLID_NODE_BOX);
            within = clip_to_box(box.lower, box.upper, ray);
        }
        bool met = within.x <= within.y && within.x <= search.next.t && within.y >= search.after;
        if (met && passes_gate(node, head.x, ray)) {
            if ((head.x & SOLID_COMBINATION) != SOLID_LEAF) {
                node += SOLID_NODE_SLOTS;
                continue;
            }
            uint leaf = solid_words(node + 1u).y;
            search.leaf = node;
            search.with_ties = node > last && last != NONE;
            SolidRay in_shape =
                SolidRay(point_to_shape(leaf, ray.origin), vector_to_shape(leaf, ray.direction), within.x, within.y);
            shape_crossings(head.x >> SOLID_KIND_SHIFT, leaf + SOLID_LEAF_NUMBERS, in_shape, search);
        }
        node = head.y;
    }
}

struct SolidHit {
    float t, u, v;
    vec3 normal;  ///< Outward, in the space of the ray.
    uint material;
};

/// The nearest surface of a solid in (ray.t_min, ray.t_max).
bool intersect_solid(uint root, Ray world_ray, out SolidHit hit) {
    SolidRay ray = SolidRay(dvec3(world_ray.origin), dvec3(world_ray.direction), double(world_ray.t_min),
                            double(world_ray.t_max));
    SolidSearch search;
    search.after = ray.from;
    search.leaf = NONE;
    while (true) {
        search.next.t = ray.to;
        search.next.leaf = NONE;
        search_solid(root, ray, search);
        SolidCrossing crossing = search.next;
        if (crossing.leaf == NONE) return false;
        search.after = crossing.t;
        search.leaf = crossing.leaf;
        uint leaf = solid_words(crossing.leaf + 1u).y;
        uint numbers = leaf + SOLID_LEAF_NUMBERS;
        uint kind = solid_words(crossing.leaf).x >> SOLID_KIND_SHIFT;
        dvec3 p = point_to_shape(leaf, ray.origin + ray.direction * crossing.t);
        dvec3 n = shape_normal(kind, numbers, p, crossing);
        bool toggles = (crossing.flags & CROSSING_TOGGLES) != 0u;
        bool faces_ray = toggles ? (crossing.flags & CROSSING_ENTERS) != 0u
                                 : dot(n, vector_to_shape(leaf, ray.direction)) < 0.0lf;
        bool flipped;
        if (!crossing_shows(crossing, ray, faces_ray, flipped)) continue;
        n = normalize(n);
        n = normalize(
            dvec3(dot(solid_vector(leaf + 1u), n), dot(solid_vector(leaf + 4u), n), dot(solid_vector(leaf + 7u), n)));
        if (flipped) n = -n;
        // The passage from outside to inside tells better than rounding which way the normal must point.
        if (toggles && (dot(n, ray.direction) < 0.0lf) != faces_ray) n = -n;
        uvec2 materials = solid_words(leaf);
        hit.t = float(crossing.t);
        hit.normal = vec3(n);
        hit.material = !faces_ray && materials.y != NONE ? materials.y : materials.x;
        if (FEATURE(FEATURE_CULL) && is_culled(hit.material, hit.normal, world_ray.direction)) continue;
        vec2 uv = vec2(0.0f);
        if (FEATURE(FEATURE_TEXTURES)) uv = shape_uv(kind, numbers, p, crossing);
        hit.u = uv.x;
        hit.v = uv.y;
        return true;
    }
    return false;
}
