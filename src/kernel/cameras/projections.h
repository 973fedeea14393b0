// SPDX-License-Identifier: Apache-2.0
// Camera projections other than the pinhole's (POV-Ray's reference, section 3.4.1.2 "Types of Projection").
#ifndef SUNDOG_KERNEL_CAMERAS_PROJECTIONS_H
#define SUNDOG_KERNEL_CAMERAS_PROJECTIONS_H

#include "kernel/cameras/pinhole.h"
#include "kernel/math.h"

KERNEL_BEGIN

/// The ray through image point (x, y) in [0,1]^2, y down. A ray that shows nothing (outside of a fisheye's circle) has
/// t_max under t_min.
FN Ray camera_ray(FrameParams frame_params, real x, real y) {
    uint kind = frame_params.camera_kind;
    Camera camera = frame_params.camera;
    if (kind == CAMERA_PERSPECTIVE) return pinhole_ray(camera, x, y, frame_params.far_z);
    float right_length = length(camera.right);
    float up_length = length(camera.up);
    vec3 right = camera.right * (1.0f / right_length);
    vec3 up = camera.up * (1.0f / up_length);
    vec3 forward = camera.center * (1.0f / length(camera.center));
    real h = 2.0f * x - 1.0f;  // -1..1 across the picture
    real v = 1.0f - 2.0f * y;
    Ray ray;
    ray.origin = real3(camera.eye);
    ray.t_min = real(0.0f);
    ray.t_max = real(frame_params.far_z);
    real along_right;
    real along_up;
    real along_forward;
    if (kind == CAMERA_ORTHOGRAPHIC) {
        ray.origin = ray.origin + real3(camera.right) * h + real3(camera.up) * v;
        ray.direction = real3(forward);
        return ray;
    }
    float half_angle = frame_params.camera_angle * 0.5f;
    if (kind == CAMERA_FISHEYE || kind == CAMERA_OMNIMAX) {
        // The unit circle of a picture in which right and up have their own lengths.
        real cx = h * (2.0f * right_length);
        real cy = v * (2.0f * up_length);
        if (kind == CAMERA_OMNIMAX) {
            // The dome's circle fills the picture's width; pictures that are wider than high lose the part of it that
            // lies below the dome first: 0.77915 is half the height from the zenith to 45 degrees under the horizon,
            // (1 + 0.5583)/2 by the lens below. As pictures of povray 3.7 show it.
            float aspect = right_length / up_length;
            float shrink = aspect > 1.0f ? max(1.0f / aspect, 0.77915f) : 1.0f;
            cx = h * (aspect > 1.0f ? aspect * shrink : 1.0f);
            cy = v * (aspect > 1.0f ? shrink : 1.0f / aspect) + real(1.0f - shrink);
        }
        real radius = sqrt(cx * cx + cy * cy);
        real inverse_radius = 1.0f / max(radius, real(1e-20f));
        real theta = radius * half_angle;
        if (kind == CAMERA_OMNIMAX) {
            // The dome's lens (Max, SIGGRAPH 1983: Computer Graphics Distortion for IMAX and OMNIMAX Projection).
            real r2 = radius * radius;
            theta = radius * (1.411269f + r2 * (0.25674f * r2 - 0.09439f));
        }
        ray.t_max = select(radius > real(1.0f), real(-1.0f), ray.t_max);
        real sine_theta = sine(theta);
        along_right = sine_theta * cx * inverse_radius;
        along_up = sine_theta * cy * inverse_radius;
        along_forward = cosine(theta);
        if (kind == CAMERA_OMNIMAX)  // the dome ends 45 degrees under its horizon
            ray.t_max = select(along_up < -along_forward, real(-1.0f), ray.t_max);
    } else if (kind == CAMERA_ULTRA_WIDE_ANGLE) {
        real a = h * half_angle;
        real b = v * (half_angle * up_length / right_length);
        along_right = sine(a);
        along_up = sine(b);
        along_forward = cosine(a) * cosine(b);
    } else if (kind == CAMERA_SPHERICAL || kind == CAMERA_PANORAMIC) {
        // A panorama always shows the half of space in front, widened or narrowed by its vectors' lengths.
        bool panoramic = kind == CAMERA_PANORAMIC;
        real longitude = h * (panoramic ? 1.57079633f : half_angle);
        real latitude = v * (panoramic ? 1.57079633f : frame_params.camera_vertical_angle * 0.5f);
        real ring = cosine(latitude);
        along_right = sine(longitude) * ring * (panoramic ? 2.0f * right_length : 1.0f);
        along_up = sine(latitude) * (panoramic ? 2.0f * up_length : 1.0f);
        along_forward = cosine(longitude) * ring * (panoramic ? length(camera.center) : 1.0f);
    } else {
        // Cylinders: 1 and 3 stand upright, 2 and 4 lie along `right`; 3 and 4 move the viewpoint along the cylinder.
        uint type = kind - CAMERA_CYLINDER + 1u;
        bool upright = type == 1u || type == 3u;
        real turn = (upright ? h : v) * half_angle;
        real slide = upright ? v : h;
        float slide_length = upright ? up_length : right_length;
        real along_axis = slide * slide_length;
        if (type >= 3u) {
            ray.origin = ray.origin + real3(upright ? up : right) * along_axis;
            along_axis = real(0.0f);
        }
        along_right = upright ? sine(turn) : along_axis;
        along_up = upright ? along_axis : sine(turn);
        along_forward = cosine(turn);
    }
    ray.direction = normalize(real3(right) * along_right + real3(up) * along_up + real3(forward) * along_forward);
    return ray;
}

KERNEL_END

#endif
