// SPDX-License-Identifier: Apache-2.0
// What a light sends to a point: from where, how much.
#ifndef SUNDOG_KERNEL_LIGHTS_LIGHT_H
#define SUNDOG_KERNEL_LIGHTS_LIGHT_H

#include "kernel/math.h"
#include "kernel/rays.h"

KERNEL_BEGIN

/// Unit direction and distance from a point to a light; a sun is infinitely far, a cylinder's rays are parallel.
FN real3 direction_to_light(Light light, real3 point, OUT(real) distance) {
    if (light.kind == LIGHT_SUN) {
        distance = real(3.0e38f);
        return real3(light.place);
    }
    if (light.kind == LIGHT_CYLINDER) {
        distance = dot(point - real3(light.place), real3(light.axis));
        return real3(-light.axis);
    }
    real3 to_light = real3(light.place) - point;
    distance = length(to_light);
    return to_light * (1.0f / max(distance, real(1e-30f)));
}

/// 0 below `low`, 1 above `high`, a smooth cubic between.
FN real smooth_step(float low, float high, real x) {
    float range = high - low;
    if (range <= 0.0f) return select(x >= real(high), real(1.0f), real(0.0f));
    real t = clamp((x - low) * (1.0f / range), real(0.0f), real(1.0f));
    return t * t * (3.0f - 2.0f * t);
}

/// Share of a spot's or cylinder's light that goes to a point (1 for other kinds), with its fading over the distance
/// (POV-Ray's reference, sections 3.4.5.2 "Spotlights", 3.4.5.3 "Cylindrical Lights" and 3.4.5.10 "Light Fading").
FN real light_share(Light light, real3 point, real3 to_light, real distance) {
    real share = real(1.0f);
    if (light.kind == LIGHT_SPOT) {
        real cosine_off = -dot(to_light, real3(light.axis));
        share = smooth_step(light.dark, light.bright, cosine_off);
        if (light.tightness > 0.0f) share = share * power(max(cosine_off, real(0.0f)), real(light.tightness));
    } else if (light.kind == LIGHT_CYLINDER) {
        real3 from_light = point - real3(light.place);
        real along = dot(from_light, real3(light.axis));
        real3 off = from_light - real3(light.axis) * along;
        real radius = length(off);
        share = 1.0f - smooth_step(light.bright, light.dark, radius);
        share = select(along > real(0.0f), share, real(0.0f));
        if (light.tightness > 0.0f) {
            real inward = max(1.0f - radius * (1.0f / max(light.dark, 1e-20f)), real(0.0f));
            share = share * power(inward, real(light.tightness));
        }
    }
    if (light.fade_power > 0.0f && light.kind != LIGHT_SUN) {
        if (light.fade_distance > 0.0f) {
            real relative = distance * (1.0f / light.fade_distance);
            share = share * (2.0f / (1.0f + power(relative, real(light.fade_power))));
        } else {
            share = share / max(power(distance, real(light.fade_power)), real(1e-30f));
        }
    }
    return share;
}

/// Share of a row of `count` lights that its light number `index` has. Povray halves an area until four lights are
/// left at the corners of each part, whose mean counts: lights that two halves have in common count for both.
FN float area_share(uint index, uint count) {
    uint lower = 0u;
    uint upper = count - 1u;
    float share = 1.0f;
    while (upper - lower > 1u) {
        uint left_end = (lower + upper) / 2u;
        uint right_start = (lower + upper + 1u) / 2u;
        if (index != left_end || left_end != right_start) share = share * 0.5f;
        if (index <= left_end) upper = left_end;
        else lower = right_start;
    }
    return upper > lower ? share * 0.5f : share;
}

/// From one light of a row of `count` to the next; 0 for a single one.
FN float row_step(uint count) { return count > 1u ? 1.0f / float(count - 1u) : 0.0f; }

/// Where light number `index` of a row of `count` stands: -1/2 to 1/2; 0 for a single one.
FN float place_in_row(uint index, uint count) { return count > 1u ? float(index) / float(count - 1u) - 0.5f : 0.0f; }

/// Where an area light's point (s, t) in [-1/2, 1/2]^2 stands, seen from a point.
FN real3 area_light_place(Light light, real s, real t, real3 to_light) {
    if ((light.flags & LIGHT_CIRCULAR) != 0u) {
        // Squares around the middle become circles: as far out along their rays as the square's side was.
        real reach = sqrt(s * s + t * t);
        real square = max(abs(s), abs(t));
        real bend = select(reach > real(0.0f), square / max(reach, real(1e-30f)), real(1.0f));
        s = s * bend;
        t = t * bend;
    }
    real3 side_u = real3(light.area_u);
    real3 side_v = real3(light.area_v);
    if ((light.flags & LIGHT_ORIENT) != 0u) {
        // Level with z, as povray's pictures show: it tells where few lights stand.
        real3 y_axis = real3(real(0.0f), real(1.0f), real(0.0f));
        real3 z_axis = real3(real(0.0f), real(0.0f), real(1.0f));
        real3 aside = cross(to_light, select(abs(to_light.z) < real(0.99f), z_axis, y_axis));
        aside = normalize(aside);
        side_u = aside * length(light.area_u);
        side_v = cross(to_light, aside) * length(light.area_v);
    }
    return real3(light.place) + side_u * s + side_v * t;
}

KERNEL_END

#endif
