// SPDX-License-Identifier: Apache-2.0
// What media send along a ray: their own light and what they scatter of lights, with shadows. CPU only.
#ifndef SUNDOG_KERNEL_INTEGRATORS_MEDIA_H
#define SUNDOG_KERNEL_INTEGRATORS_MEDIA_H

#include "kernel/atmosphere/media.h"
#include "kernel/atmosphere/scattering.h"
#include "kernel/lights/shadow.h"

KERNEL_BEGIN

/// Places on a ray where spots and cylinders begin and end to light it, ascending, with the ray's own end; beyond that,
/// all are the end.
const uint MAX_MEDIA_BOUNDARIES = 9u;
struct MediaBoundaries {
    uint count;
    real at[MAX_MEDIA_BOUNDARIES];
};

/// Where a ray enters and leaves the part of space that a light shines into; `end` for what isn't there.
FN void light_boundaries(Light light, Ray ray, real end, OUT(real) first, OUT(real) second) {
    real3 from_light = ray.origin - real3(light.place);
    real along_ray = dot(ray.direction, real3(light.axis));
    real along_origin = dot(from_light, real3(light.axis));
    real a;
    real b;
    real c;
    if (light.kind == LIGHT_SPOT) {
        float c2 = light.dark * light.dark;
        a = along_ray * along_ray - c2;
        b = along_ray * along_origin - dot(ray.direction, from_light) * c2;
        c = along_origin * along_origin - dot(from_light, from_light) * c2;
    } else {
        a = 1.0f - along_ray * along_ray;
        b = dot(ray.direction, from_light) - along_ray * along_origin;
        c = dot(from_light, from_light) - along_origin * along_origin - light.dark * light.dark;
    }
    real discriminant = b * b - a * c;
    mask crosses = mask_and(discriminant > real(0.0f), abs(a) > real(1e-12f));
    real root = sqrt(max(discriminant, real(0.0f)));
    real per_a = 1.0f / select(crosses, a, real(1.0f));
    first = (-b - root) * per_a;
    second = (root - b) * per_a;
    // Only the half of the cone that lies before the light.
    mask first_counts = mask_and(mask_and(crosses, along_origin + first * along_ray > real(0.0f)), first > real(0.0f));
    mask second_counts =
        mask_and(mask_and(crosses, along_origin + second * along_ray > real(0.0f)), second > real(0.0f));
    first = select(first_counts, min(first, end), end);
    second = select(second_counts, min(second, end), end);
}

FN MediaBoundaries media_boundaries(SCENE Ray ray, real end, bool scatters) {
    MediaBoundaries boundaries;
    boundaries.count = 0u;
    if (scatters) {
        for (uint i = 0u; i < FRAME.light_count; i = i + 1u) {
            Light light = AT(lights, i);
            bool narrow = light.kind == LIGHT_CYLINDER || (light.kind == LIGHT_SPOT && light.dark > 0.0f);
            if (!narrow || boundaries.count + 3u > MAX_MEDIA_BOUNDARIES) continue;
            real first;
            real second;
            light_boundaries(light, ray, end, first, second);
            boundaries.at[boundaries.count] = first;
            boundaries.at[boundaries.count + 1u] = second;
            boundaries.count = boundaries.count + 2u;
        }
    }
    boundaries.at[boundaries.count] = end;
    boundaries.count = boundaries.count + 1u;
    for (uint i = 1u; i < boundaries.count; i = i + 1u) {
        for (uint j = i; j > 0u; j = j - 1u) {
            real low = min(boundaries.at[j - 1u], boundaries.at[j]);
            boundaries.at[j] = max(boundaries.at[j - 1u], boundaries.at[j]);
            boundaries.at[j - 1u] = low;
        }
    }
    return boundaries;
}

/// All media at a point of a ray, with the light that they scatter along it.
FN_LARGE MediaPoint lit_media_at(SCENE Ray ray, real t, MediaInsides insides, bool atmosphere, mask active,
                                 INOUT(RayCounts) counts) {
    real3 p = point_at(ray, t);
    Scatterers scatterers;
    MediaPoint point = media_at(SCENE_ p, insides, atmosphere, active, scatterers);
    if (scatterers.count == 0u) return point;
    mask scatters = mask_and(active, mask_not(active));
    for (uint k = 0u; k < scatterers.count; k = k + 1u) {
        real3 c = abs(scatterers.color[k]);
        scatters = mask_or(scatters, max(c.x, max(c.y, c.z)) > real(0.0f));
    }
    if (!any_lane(scatters)) return point;
    real3 black = real3(real(0.0f));
    for (uint i = 0u; i < FRAME.light_count; i = i + 1u) {
        Light light = AT(lights, i);
        if ((light.flags & LIGHT_PASSES_MEDIA) != 0u) continue;
        real distance;
        real3 to_light = direction_to_light(light, p, distance);
        real3 color = real3(light.color);
        if (FEATURE(FEATURE_LIGHT_SHAPES)) color = color * light_share(light, p, to_light, distance);
        mask lit = mask_and(scatters, max(color.x, max(color.y, color.z)) > real(0.0f));
        if (!any_lane(lit)) continue;
        if (FEATURE(FEATURE_SHADOWS)) {
            if ((light.flags & LIGHT_SHADOWS) != 0u)
                color = color * light_visibility(SCENE_ light, p, to_light, distance, insides, lit, counts);
        }
        color = select(lit, color, black);
        real cosine = dot(ray.direction, to_light);
        for (uint k = 0u; k < scatterers.count; k = k + 1u) {
            real phase = phase_function(scatterers.type[k], cosine, scatterers.eccentricity[k]);
            point.glow = point.glow + scatterers.color[k] * color * phase;
        }
    }
    return point;
}

/// The mean over a step of a ray, halved where what its ends say differs.
FN MediaPoint mean_over_step(SCENE Ray ray, real start, real width, MediaPoint left, MediaPoint right, real3 weight,
                             MediaSampling sampling, MediaInsides insides, bool atmosphere, mask active,
                             INOUT(RayCounts) counts) {
    MediaPoint ends[MAX_HALVINGS + 1u];
    float places[MAX_HALVINGS + 1u];
    uint top = 0u;
    ends[0] = right;
    places[0] = 1.0f;
    float place = 0.0f;
    MediaPoint sum;
    sum.extinction = real3(real(0.0f));
    sum.glow = real3(real(0.0f));
    while (true) {
        float part = places[top] - place;
        real3 glow_error = abs((ends[top].glow - left.glow) * weight) * (width * part);
        real3 extinction_error = abs((ends[top].extinction - left.extinction) * weight) * (width * part);
        real error = max(max(glow_error.x, max(glow_error.y, glow_error.z)),
                         max(extinction_error.x, max(extinction_error.y, extinction_error.z)));
        if (top < sampling.halvings && any_lane(mask_and(active, error > real(sampling.threshold)))) {
            float middle = 0.5f * (place + places[top]);
            top = top + 1u;
            places[top] = middle;
            ends[top] = lit_media_at(SCENE_ ray, start + width * middle, insides, atmosphere, active, counts);
        } else {
            sum.extinction = sum.extinction + (left.extinction + ends[top].extinction) * real(0.5f * part);
            sum.glow = sum.glow + (left.glow + ends[top].glow) * real(0.5f * part);
            left = ends[top];
            place = places[top];
            if (top == 0u) return sum;
            top = top - 1u;
        }
    }
    return sum;
}

/// Radiance that media add along a ray up to `distance`, for a ray that carries `weight`; dims the weight by what they
/// take away. A step counts its light as seen from its start, whole, as pictures of povray show it: media of some depth
/// are brighter than they ought to be, the more so the fewer steps there are.
FN_LARGE real3 media_radiance(SCENE Ray ray, real distance, MediaInsides insides, mask alive, INOUT(real3) weight,
                              INOUT(RayCounts) counts) {
    real3 black = real3(real(0.0f));
    bool atmosphere = FRAME.atmosphere != NONE;
    mask active = in_media(insides, atmosphere, alive);
    if (!any_lane(active)) return black;
    MediaSampling sampling = media_sampling(SCENE_ insides, atmosphere, active);
    real end = min(select(active, distance, real(0.0f)), real(MEDIA_FAR));
    MediaBoundaries boundaries = media_boundaries(SCENE_ ray, end, sampling.scatters);
    bool uniform = !sampling.varies && !sampling.scatters;
    real3 sum = black;
    real start = real(0.0f);
    MediaPoint left = lit_media_at(SCENE_ ray, start, insides, atmosphere, active, counts);
    for (uint piece = 0u; piece < boundaries.count; piece = piece + 1u) {
        real width = (boundaries.at[piece] - start) * (1.0f / float(sampling.steps));
        if (!any_lane(mask_and(active, width > real(0.0f)))) continue;
        for (uint i = 0u; i < sampling.steps; i = i + 1u) {
            MediaPoint mean = left;
            if (!uniform) {
                MediaPoint right =
                    lit_media_at(SCENE_ ray, start + width * float(i + 1u), insides, atmosphere, active, counts);
                mean = mean_over_step(SCENE_ ray, start + width * float(i), width, left, right, weight, sampling,
                                      insides, atmosphere, active, counts);
                left = right;
            }
            real3 depth = mean.extinction * width;
            real3 passes = dimmed_by(depth);
            real3 light = mean.glow * width;
            if (sampling.exact_steps) {
                // The mean of e^-x over the step.
                real3 thin = real3(real(1.0f)) - depth * real(0.5f);
                real3 one = real3(real(1.0f));
                light.x = light.x * select(abs(depth.x) < real(1e-3f), thin.x, (one.x - passes.x) / depth.x);
                light.y = light.y * select(abs(depth.y) < real(1e-3f), thin.y, (one.y - passes.y) / depth.y);
                light.z = light.z * select(abs(depth.z) < real(1e-3f), thin.z, (one.z - passes.z) / depth.z);
            }
            sum = sum + select(active, weight * light, black);
            weight = select(active, weight * passes, weight);
        }
        start = boundaries.at[piece];
    }
    return sum;
}

KERNEL_END

#endif
