// SPDX-License-Identifier: Apache-2.0
// A thin lens (Cook, Porter and Carpenter, Distributed Ray Tracing, SIGGRAPH 1984): what lies in the plane of focus is
// sharp, all else is blurred to the shape of the aperture.
#ifndef SUNDOG_KERNEL_CAMERAS_LENS_H
#define SUNDOG_KERNEL_CAMERAS_LENS_H

#include "kernel/math.h"
#include "kernel/rays.h"

KERNEL_BEGIN

/// A place in the unit disc, or in the regular polygon of so many sides in it; neighbouring numbers give neighbouring
/// places.
FN real2 aperture_place(uint blades, real2 u) {
    if (blades < 3u) {
        // Squares around the middle become circles (Shirley and Chiu, A Low Distortion Map Between Disk and Square,
        // 1997).
        real x = 2.0f * u.x - 1.0f;
        real y = 2.0f * u.y - 1.0f;
        mask wide = abs(x) > abs(y);
        real radius = select(wide, x, y);
        real safe = select(abs(radius) > real(0.0f), radius, real(1.0f));
        real turn = select(wide, y, x) / safe * 0.785398163f;
        real angle = select(wide, turn, 1.57079633f - turn);
        return real2(radius * cosine(angle), radius * sine(angle));
    }
    real scaled = u.x * float(blades);
    real sector = min(floor(scaled), real(float(blades) - 1.0f));
    real along = scaled - sector;
    real outward = sqrt(u.y);
    float step = 6.28318531f / float(blades);
    real first = sector * step + 1.57079633f;
    real second = first + step;
    return real2((cosine(first) * (1.0f - along) + cosine(second) * along) * outward,
                 (sine(first) * (1.0f - along) + sine(second) * along) * outward);
}

/// A pinhole's ray as one through a place on the lens, drawn by `u`.
FN Ray lens_ray(FrameParams frame_params, Ray ray, real2 u) {
    if (frame_params.lens_radius <= 0.0f) return ray;
    Camera camera = frame_params.camera;
    vec3 right = camera.right * (frame_params.lens_radius / length(camera.right));
    vec3 up = camera.up * (frame_params.lens_radius / length(camera.up));
    vec3 forward = camera.center * (1.0f / length(camera.center));
    real2 place = aperture_place(frame_params.lens_blades, u);
    real cosine_off = max(dot(ray.direction, real3(forward)), real(1e-6f));
    real3 sharp = ray.origin + ray.direction * (frame_params.focus_distance / cosine_off);
    ray.origin = ray.origin + real3(right) * place.x + real3(up) * place.y;
    real3 toward = sharp - ray.origin;
    ray.direction = normalize(toward);
    return ray;
}

KERNEL_END

#endif
