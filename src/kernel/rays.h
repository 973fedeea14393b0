// SPDX-License-Identifier: Apache-2.0
// Rays, hits, and how far to step off a surface.
#ifndef SUNDOG_KERNEL_RAYS_H
#define SUNDOG_KERNEL_RAYS_H

#include "kernel/math.h"

KERNEL_BEGIN

/// Points origin + t*direction for t in (t_min, t_max). The direction is a unit vector, so t is a distance.
struct Ray {
    real3 origin;
    real3 direction;
    real t_min;
    real t_max;
};

/// The nearest hit of a ray, as a traversal reports it.
struct Hit {
    real t;
    real u;          ///< Triangles: weight of the second corner; others: 0.
    real v;          ///< Triangles: weight of the third corner.
    word geometry;   ///< Into geometries; NONE for a miss.
    word primitive;  ///< Into triangles, spheres, boxes or planes, as the geometry's kind says.
    real3 normal;    ///< Geometric, outward, in object space, not normalised.
};

/// What was traced for a pixel.
struct RayCounts {
    word rays;         ///< All of them.
    word shadow_rays;  ///< Shadow rays among them.
};

/// How far rays that hit nothing go through fog and media, as in povray.
const float RAY_FAR = 2.0e10f;

/// How far a point origin + t*direction may lie off the surface it was found on. Rounding of t and of the sum are a few
/// units in the last place of the largest number involved; 64 of them (2^-18 relative) leave room for long thin
/// triangles.
FN real hit_error(real3 origin, real3 point, real t) {
    real3 a = max(abs(origin), abs(point));
    return max(largest(a), t) * 3.8146973e-6f;
}

/// Position on a ray.
FN real3 point_at(Ray ray, real t) { return ray.origin + ray.direction * t; }

KERNEL_END

#endif
