// SPDX-License-Identifier: Apache-2.0
// Hits with triangles that are known to be the nearest. Only units that hold a kernel include it.
#pragma once

#include "device/cpu/eye_hits.h"
#include "kernel/rays.h"

KERNEL_BEGIN

/// The hits of `ray` with triangles, in the lanes of `met`: as Embree's robust test computes them (Plücker coordinates
/// about the ray's origin), so that they agree with traced ones but for rounding.
FN void hit_given_triangles(SCENE Ray ray, word triangle, const EyeHits& given, mask met, INOUT(Hit) hit) {
    const word primitive = valid_index(met, triangle);
    const real3 v0 = GET(positions, FIELD(triangles, primitive, p0)) - ray.origin;
    const real3 v1 = GET(positions, FIELD(triangles, primitive, p1)) - ray.origin;
    const real3 v2 = GET(positions, FIELD(triangles, primitive, p2)) - ray.origin;
    const real3 e0 = v2 - v0;
    const real3 e1 = v0 - v1;
    const real3 e2 = v1 - v2;
    const real u = dot(cross(e0, v2 + v0), ray.direction);
    const real v = dot(cross(e1, v0 + v1), ray.direction);
    const real w = dot(cross(e2, v1 + v2), ray.direction);
    const real3 normal = cross(e0, e1);
    const real all = 1.0f / select(met, u + v + w, real(1.0f));
    const real along = select(met, dot(normal, ray.direction), real(1.0f));
    hit.t = select(met, dot(v0, normal) / along, hit.t);
    hit.u = select(met, u * all, hit.u);
    hit.v = select(met, v * all, hit.v);
    hit.normal = select(met, normal, hit.normal);
    hit.geometry = select(met, load(given.geometries, sizeof(uint), primitive), hit.geometry);
    hit.primitive = select(met, primitive, hit.primitive);
}

KERNEL_END
