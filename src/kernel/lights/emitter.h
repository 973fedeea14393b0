// SPDX-License-Identifier: Apache-2.0
// All that lights a scene, as one list from which paths draw: shining triangles and spheres, lights without size, the
// environment. Entries are drawn by their power with Walker's alias method (1977).
#ifndef SUNDOG_KERNEL_LIGHTS_EMITTER_H
#define SUNDOG_KERNEL_LIGHTS_EMITTER_H

#include "kernel/bsdf/frame.h"
#include "kernel/lights/environment_light.h"
#include "kernel/materials/material.h"

KERNEL_BEGIN

/// Which of the emitters, in each lane.
struct EmitterChoice {
    word kind;         ///< EMITTER_*
    word index;        ///< Of the triangle, sphere or light.
    word geometry;     ///< The triangle's or sphere's.
    real probability;  ///< With which it was drawn.
};

/// Draws an emitter by a number in [0, 1); there must be some.
FN EmitterChoice choose_emitter(SCENE real pick) {
    real scaled = pick * float(FRAME.emitter_count);
    real whole = min(floor(scaled), real(float(FRAME.emitter_count) - 1.0f));
    word slot = word_from_real(whole);
    mask keeps = scaled - whole < FIELD(emitters, slot, keep);
    word chosen = select(keeps, slot, FIELD(emitters, slot, alias));
    EmitterChoice choice;
    choice.kind = FIELD(emitters, chosen, kind);
    choice.index = FIELD(emitters, chosen, index);
    choice.geometry = FIELD(emitters, chosen, geometry);
    choice.probability = FIELD(emitters, chosen, probability);
    return choice;
}

/// A place that shines, as seen from a point.
struct EmitterSample {
    real3 to_light;  ///< Unit.
    real distance;
    real3 radiance;  ///< That comes from there; 0 where it shines elsewhere.
    real density;    ///< Of drawing it, over solid angle, the choice of the emitter included.
};

/// Puts `other` in the lanes of m.
FN void take_sample(mask m, EmitterSample other, INOUT(EmitterSample) drawn) {
    drawn.to_light = select(m, other.to_light, drawn.to_light);
    drawn.distance = select(m, other.distance, drawn.distance);
    drawn.radiance = select(m, other.radiance, drawn.radiance);
    drawn.density = select(m, other.density, drawn.density);
}

/// Point `p` of an object of a geometry, in world space.
FN real3 placed_point(SCENE word geometry, real3 p) {
    if (!FEATURE(FEATURE_INSTANCES)) return p;
    word instance = FIELD(geometries, geometry, instance);
    mask moved = instance != word(NONE);
    word i = valid_index(moved, instance);
    real3 placed = FIELD(instances, i, world_from_object_x) * p.x + FIELD(instances, i, world_from_object_y) * p.y +
                   FIELD(instances, i, world_from_object_z) * p.z + FIELD(instances, i, world_from_object_t);
    return select(moved, placed, p);
}

/// Draws a point of a shining triangle, all of whose points are as likely (Turk, Generating Random Points in Triangles,
/// 1990; folded so that neighbouring numbers give neighbouring points: Heitz, A Low-Distortion Map Between Triangle and
/// Square, 2019).
FN EmitterSample sample_triangle(SCENE EmitterChoice choice, real3 point, real2 u, mask asked) {
    word triangle = valid_index(asked, choice.index);
    word geometry = valid_index(asked, choice.geometry);
    real3 a = placed_point(SCENE_ geometry, GET(positions, FIELD(triangles, triangle, p0)));
    real3 e1 = placed_point(SCENE_ geometry, GET(positions, FIELD(triangles, triangle, p1))) - a;
    real3 e2 = placed_point(SCENE_ geometry, GET(positions, FIELD(triangles, triangle, p2))) - a;
    mask upper = u.x < u.y;
    real b1 = select(upper, u.x * 0.5f, u.x - u.y * 0.5f);
    real b2 = select(upper, u.y - u.x * 0.5f, u.y * 0.5f);
    real3 to_place = a + e1 * b1 + e2 * b2 - point;
    real3 normal = cross(e1, e2);
    real double_area = length(normal);
    real distance2 = max(dot(to_place, to_place), real(1e-30f));
    EmitterSample drawn;
    drawn.distance = sqrt(distance2);
    drawn.to_light = to_place * (1.0f / drawn.distance);
    real cosine_there = abs(dot(normal, drawn.to_light)) / max(double_area, real(1e-30f));
    drawn.density = choice.probability * 2.0f * distance2 / max(double_area * cosine_there, real(1e-30f));
    Surface there;
    there.geometry = geometry;
    there.primitive = triangle;
    there.material = FIELD(triangles, triangle, material);
    there.weights = real2(b1, b2);
    there.uv = real2(real(0.0f), real(0.0f));
    if (FEATURE(FEATURE_TEXTURES)) there.uv = triangle_uv(SCENE_ triangle, b1, b2);
    drawn.radiance = emission_at(SCENE_ there);
    drawn.radiance = select(cosine_there > real(1e-6f), drawn.radiance, real3(real(0.0f)));
    return drawn;
}

/// The cosine of half the angle that a sphere takes of the view from a point at distance2 from its middle, as one
/// minus it; from inside, all directions.
FN real sphere_view(real radius, real distance2) {
    real sin2 = min(radius * radius / max(distance2, real(1e-30f)), real(1.0f));
    // 1 - sqrt(1 - x) without cancellation.
    real outside = sin2 / (1.0f + sqrt(1.0f - sin2));
    return select(sin2 < real(1.0f), outside, real(2.0f));
}

/// Draws a direction to a shining sphere, within the cone that it takes of the view (Shirley and Wang 1991).
FN EmitterSample sample_sphere(SCENE EmitterChoice choice, real3 point, real2 u, mask asked) {
    word sphere = valid_index(asked, choice.index);
    word geometry = valid_index(asked, choice.geometry);
    real radius = FIELD(spheres, sphere, radius);
    real3 center = placed_point(SCENE_ geometry, FIELD(spheres, sphere, center));
    real3 to_center = center - point;
    real distance2 = max(dot(to_center, to_center), real(1e-30f));
    real view = sphere_view(radius, distance2);
    real cos_off = 1.0f - u.x * view;
    real sin_off = sqrt(max(1.0f - cos_off * cos_off, real(0.0f)));
    real angle = u.y * 6.28318531f;
    ShadingFrame basis = frame_around(to_center * (1.0f / sqrt(distance2)));
    EmitterSample drawn;
    drawn.to_light = to_world(basis, real3(sin_off * cosine(angle), sin_off * sine(angle), cos_off));
    // To the near side; from inside to the far one.
    real along = dot(to_center, drawn.to_light);
    real3 beside = to_center - drawn.to_light * along;
    real half_chord = sqrt(max(radius * radius - dot(beside, beside), real(0.0f)));
    drawn.distance = select(distance2 > radius * radius, along - half_chord, along + half_chord);
    // Short of it by what rounding does to a grazing ray.
    drawn.distance = max(drawn.distance - radius * 1e-3f, real(0.0f));
    drawn.density = choice.probability / (6.28318531f * view);
    Surface there;
    there.geometry = geometry;
    there.primitive = sphere;
    there.material = FIELD(spheres, sphere, material);
    there.weights = real2(real(0.0f), real(0.0f));
    there.uv = there.weights;
    if (FEATURE(FEATURE_TEXTURES)) {
        real3 from_center = point + drawn.to_light * drawn.distance - center;
        there.uv = sphere_uv(from_center * (1.0f / max(length(from_center), real(1e-30f))));
    }
    drawn.radiance = emission_at(SCENE_ there);
    return drawn;
}

/// With which density over solid angle a shining surface that a ray met would have been drawn from `passed` before the
/// ray's origin; 0 where it is on no list.
FN real emitter_density(SCENE Ray ray, Hit hit, real passed, Surface s, mask found) {
    real power = FIELD(materials, s.material, emission_power);
    mask listed = mask_and(found, power > real(0.0f));
    if (!any_lane(listed)) return real(0.0f);
    real cosine_there = abs(dot(s.geometric_normal, ray.direction));
    real distance = hit.t + passed;
    real density =
        power * (1.0f / max(FRAME.emitted_power, 1e-30f)) * distance * distance / max(cosine_there, real(1e-6f));
    if (FEATURE(FEATURE_ANALYTIC)) {
        word kind = FIELD(geometries, s.geometry, kind);
        mask is_sphere = mask_and(listed, kind == word(GEOMETRY_SPHERE));
        if (any_lane(is_sphere)) {
            word sphere = valid_index(is_sphere, s.primitive);
            real radius = FIELD(spheres, sphere, radius);
            real3 to_center = placed_point(SCENE_ s.geometry, FIELD(spheres, sphere, center)) - ray.origin;
            if (FEATURE(FEATURE_VEILS)) to_center = to_center + ray.direction * passed;
            real view = sphere_view(radius, max(dot(to_center, to_center), real(1e-30f)));
            real probability = power * (1.0f / max(FRAME.emitted_power, 1e-30f)) * 12.5663706f * radius * radius;
            density = select(is_sphere, probability / (6.28318531f * view), density);
        }
        listed = mask_and(listed, mask_or(is_sphere, kind == word(GEOMETRY_TRIANGLES)));
    }
    return select(listed, density, real(0.0f));
}

KERNEL_END

#endif
