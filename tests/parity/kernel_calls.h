// SPDX-License-Identifier: Apache-2.0
// Every function of the kernel behind one number, written in the kernel's own subset: the tests call it from C++ at
// each width and from a compute shader, and compare what comes back.
#ifndef SUNDOG_TESTS_PARITY_KERNEL_CALLS_H
#define SUNDOG_TESTS_PARITY_KERNEL_CALLS_H

#include "kernel/atmosphere/fog.h"
#include "kernel/atmosphere/scattering.h"
#include "kernel/cameras/pixel_samples.h"
#include "kernel/cameras/projections.h"
#include "kernel/lights/light.h"
#include "kernel/materials/bump.h"
#include "kernel/materials/layers.h"
#include "kernel/materials/material.h"
#include "kernel/shapes/all_planes.h"
#include "parity/call_numbers.h"

KERNEL_BEGIN

/// Arguments or results that vary from ray to ray.
struct Varying {
    real v[CALL_VALUES];
};

FN real real_of(mask m) { return select(m, real(1.0f), real(0.0f)); }
FN real3 vector_of(Varying a, uint first) { return real3(a.v[first], a.v[first + 1u], a.v[first + 2u]); }
FN void put(INOUT(Varying) r, uint first, real3 x) {
    r.v[first] = x.x;
    r.v[first + 1u] = x.y;
    r.v[first + 2u] = x.z;
}
FN vec3 vector_of(UniformValues a, uint first) { return vec3(a.v[first], a.v[first + 1u], a.v[first + 2u]); }

/// Arguments 0 to 7: a ray, its direction made a unit vector.
FN Ray ray_of(Varying a) {
    Ray ray;
    ray.origin = vector_of(a, 0u);
    ray.direction = normalize(vector_of(a, 3u));
    ray.t_min = a.v[6];
    ray.t_max = a.v[7];
    return ray;
}

FN Varying call_math(uint function, Varying a) {
    Varying r = a;
    if (function == CALL_LOG2) r.v[0] = log2_positive(a.v[0]);
    if (function == CALL_EXP2) r.v[0] = exp2_clamped(a.v[0]);
    if (function == CALL_POWER) r.v[0] = power(a.v[0], a.v[1]);
    if (function == CALL_ANGLE) r.v[0] = angle_of(a.v[0], a.v[1]);
    if (function == CALL_HIT_ERROR) r.v[0] = hit_error(vector_of(a, 0u), vector_of(a, 3u), a.v[6]);
    return r;
}

FN Varying call_shape(SCENE uint function, UniformValues u, Varying a) {
    Varying r = a;
    Ray ray = ray_of(a);
    real t = real(0.0f);
    real3 normal = real3(real(0.0f));
    if (function == CALL_SPHERE) {
        r.v[0] = real_of(intersect_sphere(ray, vector_of(u, 0u), u.v[3], t, normal));
        r.v[1] = t;
        put(r, 2u, normal);
    }
    if (function == CALL_BOX) {
        r.v[0] = real_of(intersect_box(ray, vector_of(u, 0u), vector_of(u, 3u), t, normal));
        r.v[1] = t;
        put(r, 2u, normal);
    }
    if (function == CALL_PLANE) {
        r.v[0] = real_of(intersect_plane(ray, vector_of(u, 0u), u.v[3], t));
        r.v[1] = t;
    }
    if (function == CALL_TRIANGLE) {
        real hit_u;
        real hit_v;
        r.v[0] = real_of(
            intersect_triangle(ray, vector_of(a, 8u), vector_of(a, 11u), vector_of(a, 14u), t, hit_u, hit_v, normal));
        r.v[1] = t;
        r.v[2] = hit_u;
        r.v[3] = hit_v;
        put(r, 4u, normal);
    }
    if (function == CALL_PLANES) {
        Hit hit;
        hit.t = ray.t_max;
        hit.u = real(0.0f);
        hit.v = real(0.0f);
        hit.geometry = word(NONE);
        hit.primitive = word(NONE);
        hit.normal = real3(real(0.0f));
        mask everywhere = ray.t_max > real(0.0f);
        closest_plane(SCENE_ ray, RAY_CAMERA, everywhere, hit);
        r.v[0] = real_of(any_plane(SCENE_ ray, RAY_SHADOW, everywhere));
        r.v[1] = hit.t;
        r.v[2] = real_from_word(hit.geometry & word(255u));
        put(r, 3u, hit.normal);
    }
    if (function == CALL_SPHERE_UV) {
        real2 uv = sphere_uv(normalize(vector_of(a, 0u)));
        r.v[0] = uv.x;
        r.v[1] = uv.y;
    }
    if (function == CALL_BOX_UV) {
        real2 uv =
            box_uv(vector_of(a, 0u), normalize(vector_of(a, 3u)), real3(vector_of(u, 0u)), real3(vector_of(u, 3u)));
        r.v[0] = uv.x;
        r.v[1] = uv.y;
    }
    if (function == CALL_PLANE_UV) {
        real2 uv = plane_uv(vector_of(a, 0u), normalize(vector_of(a, 3u)));
        r.v[0] = uv.x;
        r.v[1] = uv.y;
    }
    if (function == CALL_INTERPOLATE) {
        put(r, 0u, interpolate(vector_of(a, 0u), vector_of(a, 3u), vector_of(a, 6u), a.v[9], a.v[10]));
    }
    return r;
}

FN Varying call_reflection(uint function, UniformValues u, Varying a) {
    Varying r = a;
    real3 normal = normalize(vector_of(a, 0u));
    real3 to_light = normalize(vector_of(a, 3u));
    real3 to_eye = normalize(vector_of(a, 6u));
    if (function == CALL_LAMBERT) r.v[0] = lambert(normal, to_light);
    if (function == CALL_MIRROR) put(r, 0u, mirror_direction(-to_eye, normal));
    if (function == CALL_PHONG) r.v[0] = phong_highlight(normal, to_light, to_eye, a.v[9]);
    if (function == CALL_BLINN) r.v[0] = blinn_phong_highlight(normal, to_light, to_eye, a.v[9]);
    if (function == CALL_REFRACT) {
        real3 front = select(dot(normal, to_eye) < real(0.0f), -normal, normal);
        real3 refracted;
        mask passes = refract_direction(-to_eye, front, a.v[10], refracted);
        r.v[0] = real_of(passes);
        put(r, 1u, select(passes, refracted, real3(real(0.0f))));
    }
    if (function == CALL_FRESNEL) r.v[0] = fresnel_dielectric(a.v[11], a.v[10]);
    if (function == CALL_SCHLICK) put(r, 0u, fresnel_schlick(vector_of(a, 12u), a.v[11]));
    if (function == CALL_LIGHT) {
        Light light;
        light.place = vector_of(u, 0u);
        light.color = vec3(1.0f);
        light.kind = u.v[3] > 0.0f ? LIGHT_SUN : LIGHT_LAMP;
        light.flags = LIGHT_SHADOWS | LIGHT_HIGHLIGHTS;
        real distance;
        put(r, 0u, direction_to_light(light, vector_of(a, 0u), distance));
        r.v[3] = distance;
    }
    return r;
}

FN Varying call_camera(uint function, UniformValues u, Varying a) {
    Varying r = a;
    if (function == CALL_PINHOLE) {
        Camera camera;
        camera.eye = vector_of(u, 0u);
        camera.center = vector_of(u, 3u);
        camera.right = vector_of(u, 6u);
        camera.up = vector_of(u, 9u);
        Ray ray = pinhole_ray(camera, a.v[0], a.v[1], u.v[12]);
        put(r, 0u, ray.origin);
        put(r, 3u, ray.direction);
        r.v[6] = ray.t_max;
    }
    if (function == CALL_PIXEL_SAMPLE) {
        PixelSampling sampling;
        sampling.pattern = uint(u.v[12]);
        sampling.cells = uint(u.v[14]);
        sampling.pixel_filter = uint(u.v[15]);
        sampling.radius = 1.5f;
        PixelSample at = pixel_sample(sampling, word_from_real(abs(a.v[0]) * 100.0f),
                                      word_from_real(abs(a.v[1]) * 100.0f), uint(u.v[13]));
        put(r, 0u, real3(at.x, at.y, at.weight));
    }
    return r;
}

FN Varying call_pattern(SCENE uint function, Varying a) {
    Varying r = a;
    real2 uv = real2(a.v[0], a.v[1]);
    if (function == CALL_CHECKER) r.v[0] = real_of(checker_is_other(uv, real2(a.v[2], a.v[3])));
    if (function == CALL_WRAP) {
        r.v[0] = real_from_word(wrap_texel(floor(a.v[0] * 20.0f), floor(a.v[2] * 30.0f) + 1.0f, a.v[3] > real(4.0f)));
    }
    if (function == CALL_TEXTURE) {
        word texture = select(a.v[2] > real(4.0f), word(1u), word(0u));
        // Once more in the bits of wrapping. Not TEXTURE_NEAREST: a last bit would choose another texel.
        word flags = word_from_real(a.v[3] * 2.0f) & word(15u);
        flags = flags * word(17u);
        real alpha;
        real3 color = texture_lookup(SCENE_ texture, flags, uv, alpha);
        put(r, 0u, color);
        r.v[3] = alpha;
        r.v[4] = texture_channel(color, alpha, flags);
    }
    return r;
}

/// A hit on triangle number a.v[8] of the scene at (u, v) = a.v[9], a.v[10]: surface, material, bump.
FN Varying call_surface(SCENE uint function, Varying a) {
    Varying r = a;
    Ray ray = ray_of(a);
    Hit hit;
    hit.primitive = word_from_real(a.v[8]);
    hit.geometry = word(1u);
    hit.t = ray.t_max;
    hit.u = a.v[9];
    hit.v = a.v[10] * (1.0f - a.v[9]);
    hit.normal = vector_of(a, 11u);
    Surface s = surface_at(SCENE_ ray, hit, hit.t > real(0.0f));
    if (function == CALL_SURFACE) {
        put(r, 0u, s.position);
        put(r, 3u, s.geometric_normal);
        put(r, 6u, s.normal);
        r.v[9] = s.uv.x;
        r.v[10] = s.uv.y;
        r.v[11] = s.error;
        r.v[12] = real_of(s.from_behind);
    }
    if (function == CALL_MATERIAL) {
        // Other materials than the triangle's own, too.
        s.material = word_from_real(a.v[14]);
        Lobes lobes = evaluate_material(SCENE_ s, ray.direction);
        put(r, 0u, lobes.diffuse);
        put(r, 3u, lobes.specular);
        put(r, 6u, lobes.reflectance);
        put(r, 9u, lobes.transmittance);
        r.v[12] = lobes.eta;
        r.v[13] = lobes.shininess;
        r.v[14] = real_of(lobes.phong);
    }
    if (function == CALL_BUMP) {
        s.material = word_from_real(a.v[14]);
        put(r, 0u, bumped_normal(SCENE_ s));
    }
    return r;
}

/// The functions that procedural scenes add. u.v[12] to [17] choose kinds, counts and exponents.
FN Varying call_procedural(SCENE uint function, UniformValues u, Varying a) {
    Varying r = a;
    uint kind = uint(u.v[12]);
    real3 p = vector_of(a, 0u);
    if (function == CALL_SINE) r.v[0] = sine(a.v[0]);
    if (function == CALL_FIELD)
        r.v[0] = field_value(kind, p, vec3(u.v[13], 0.5f, 0.25f), (1u + kind % 3u) | (3u << 8u));
    if (function == CALL_WAVE) r.v[0] = wave_value(kind, a.v[0], u.v[13], u.v[0], u.v[14]);
    if (function == CALL_CHOICE) r.v[0] = choice_value(kind, p, vec3(u.v[13], 1.5f, 2.0f), 0.25f);
    if (function == CALL_IMAGE_POSITION) {
        real2 uv = image_position(kind, p);
        r.v[0] = uv.x;
        r.v[1] = uv.y;
    }
    if (function == CALL_LIGHT_SHARE || function == CALL_AREA_LIGHT) {
        Light light;
        light.place = vector_of(u, 0u);
        light.color = vec3(1.0f);
        light.kind = kind;
        light.flags = LIGHT_HIGHLIGHTS | (u.v[3] > 0.0f ? LIGHT_CIRCULAR : 0u) | (u.v[4] > 0.0f ? LIGHT_ORIENT : 0u);
        light.axis = normalize(vector_of(u, 6u));
        light.bright = kind == LIGHT_SPOT ? 0.6f : 0.3f;
        light.dark = kind == LIGHT_SPOT ? 0.1f : 1.5f;
        light.tightness = u.v[14];
        light.fade_distance = u.v[13];
        light.fade_power = u.v[15];
        light.area_u = vector_of(u, 3u);
        light.area_v = vector_of(u, 9u);
        light.area_count_u = 3u;
        light.area_count_v = 4u;
        real distance;
        real3 to_light = direction_to_light(light, p, distance);
        if (function == CALL_LIGHT_SHARE) {
            r.v[0] = light_share(light, p, to_light, distance);
            r.v[1] = distance;
        } else {
            put(r, 0u, area_light_place(light, u.v[16], u.v[17], to_light));
        }
    }
    if (function == CALL_FOG) {
        Fog fog;
        fog.ground = kind & 1u;
        fog.distance = u.v[13];
        fog.color = abs(vector_of(u, 0u));
        fog.filter_share = abs(u.v[3]);
        fog.transmit_share = 0.1f;
        fog.altitude = 0.5f;
        fog.offset = u.v[4];
        fog.up = normalize(vector_of(u, 6u));
        real3 glow;
        put(r, 0u, fog_transmittance(fog, ray_of(a), a.v[7], glow));
        put(r, 3u, glow);
    }
    if (function == CALL_LAYER) {
        Layer layer;
        layer.flags = kind & 1u;
        layer.reflection_min = abs(vector_of(u, 0u));
        layer.reflection_max = abs(vector_of(u, 3u));
        layer.reflection_falloff = u.v[13];
        layer.reflection_metallic = abs(u.v[9]);
        put(r, 0u,
            layer_reflectance(layer, select(a.v[4] > real(0.0f), real(1.5f), real(1.0f / 1.5f)), a.v[4] > real(0.5f),
                              abs(p), abs(a.v[3])));
        put(r, 3u, metallic_tint(abs(p), real(0.75f), abs(a.v[3])));
    }
    if (function == CALL_NORMAL) put(r, 0u, normal_offset(SCENE_ kind, free_point(p), 2u, u.v[13], u.v[14]));
    if (function == CALL_PHASE) {
        r.v[0] = phase_function(kind, a.v[0], u.v[13]);
        r.v[1] = phase_density(word(kind), a.v[0], real(u.v[13]));
        r.v[2] = phase_cosine(word(kind), real(u.v[13]), abs(a.v[1]));
    }
    if (function == CALL_PROJECTION) {
        FrameParams frame_params;
        frame_params.camera.eye = vector_of(u, 0u);
        frame_params.camera.center = vec3(0.0f, 0.0f, 1.0f);
        frame_params.camera.right = vec3(0.5f, 0.0f, 0.0f);
        frame_params.camera.up = vec3(0.0f, 0.375f, 0.0f);
        frame_params.camera_kind = kind;
        frame_params.camera_angle = u.v[13];
        frame_params.camera_vertical_angle = 1.25f;
        frame_params.far_z = 1000.0f;
        Ray ray = camera_ray(frame_params, abs(a.v[0]), abs(a.v[1]));
        put(r, 0u, ray.origin);
        put(r, 3u, ray.direction);
        r.v[6] = ray.t_max;
    }
    return r;
}

/// Calls function number `function` (CALL_*); results that it doesn't set are the arguments.
FN Varying call_kernel(SCENE uint function, UniformValues u, Varying a) {
    if (function < CALL_FIRST_SHAPE) return call_math(function, a);
    if (function < CALL_FIRST_REFLECTION) return call_shape(SCENE_ function, u, a);
    if (function < CALL_FIRST_CAMERA) return call_reflection(function, u, a);
    if (function < CALL_FIRST_PATTERN) return call_camera(function, u, a);
    if (function < CALL_FIRST_SURFACE) return call_pattern(SCENE_ function, a);
    if (function < CALL_FIRST_PROCEDURAL) return call_surface(SCENE_ function, a);
    return call_procedural(SCENE_ function, u, a);
}

KERNEL_END

#endif
