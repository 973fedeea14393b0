// SPDX-License-Identifier: Apache-2.0
// One place of a light: of areas, one that is drawn.
#ifndef SUNDOG_KERNEL_LIGHTS_LIGHT_DRAWN_H
#define SUNDOG_KERNEL_LIGHTS_LIGHT_DRAWN_H

#include "kernel/lights/light.h"

KERNEL_BEGIN

/// What a light sends to a point.
struct LightDrawn {
    real3 place;   ///< From where; a sun's is meaningless.
    real3 toward;  ///< Unit: the direction to that,
    real reach;    ///< and how far it is.
    real3 from;    ///< Unit: the direction from which it lights, an area's middle unless the area illuminates.
    real3 color;   ///< Without shadows.
};

/// What `light` sends to the point p; `u` draws an area's place.
FN LightDrawn draw_light(SCENE Light light, real3 p, real2 u) {
    LightDrawn drawn;
    real distance;
    real3 to_light = direction_to_light(light, p, distance);
    drawn.place = real3(light.place);
    drawn.toward = to_light;
    drawn.reach = distance;
    if (light.area_count_u * light.area_count_v > 1u) {
        real3 place = area_light_place(light, u.x - 0.5f, u.y - 0.5f, to_light);
        real3 to_place = light.kind == LIGHT_SUN ? place : place - p;
        real away = max(length(to_place), real(1e-30f));
        drawn.place = place;
        drawn.toward = to_place * (1.0f / away);
        if (light.kind != LIGHT_SUN) drawn.reach = away;
    }
    bool in_parts = (light.flags & LIGHT_ILLUMINATES) != 0u;
    drawn.from = in_parts ? drawn.toward : to_light;
    drawn.color = real3(light.color);
    if (FEATURE(FEATURE_LIGHT_SHAPES))
        drawn.color = drawn.color * light_share(light, p, drawn.from, in_parts ? drawn.reach : distance);
    return drawn;
}

/// The shadow ray to it from `origin`, which may lie off the point it was drawn for.
FN Ray ray_to_light(Light light, LightDrawn drawn, real3 origin) {
    Ray ray;
    ray.origin = origin;
    ray.direction = drawn.toward;
    ray.t_min = real(0.0f);
    ray.t_max = drawn.reach;
    if (light.kind == LIGHT_LAMP || light.kind == LIGHT_SPOT) {
        real3 to_place = drawn.place - origin;
        real away = length(to_place);
        ray.direction = to_place * (1.0f / max(away, real(1e-30f)));
        ray.t_max = away - hit_error(origin, drawn.place, away);
    } else if (light.kind != LIGHT_SUN) {
        ray.t_max = drawn.reach - hit_error(origin, drawn.place, drawn.reach);
    }
    return ray;
}

KERNEL_END

#endif
