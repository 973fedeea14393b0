// SPDX-License-Identifier: Apache-2.0
// Whitted's ray tracing (1980) of as many places of the picture as there are lanes.
#pragma once

#include "kernel/cameras/pinhole.h"
#include "kernel/lights/light.h"
#include "kernel/materials/reflection.h"
#include "trace/sample.h"
#include "trace/shapes.h"
#include "trace/sky.h"
#include "trace/textures.h"
#include "trace/tile_work.h"

INTRO_LANES_BEGIN

/// What a frame is traced from.
struct View {
    const World* world;
    const Tables* tables;
    float width, height;  ///< Of the picture, in pixels.
};

struct Found {
    real t;
    word solid;  ///< Its number; NONE for the sky.
    word part;
};

FN Found closest_hit(const World& world, const Candidates& candidates, Ray ray, mask alive) {
    Found found;
    found.solid = word(NONE);
    found.part = word(kWhole);
    for (uint i = 0u; i < candidates.count; i = i + 1u) {
        uint number = candidates.numbers[i];
        real t;
        word part;
        mask here = solid_hit(world, world.solids[number], ray, alive, t, part);
        ray.t_max = select(here, t, ray.t_max);
        found.solid = select(here, word(number), found.solid);
        found.part = select(here, part, found.part);
    }
    found.t = ray.t_max;
    return found;
}

/// Lanes of `alive` whose way along the ray is barred.
FN mask is_shadowed(const World& world, const Ray& ray, mask alive) {
    mask dark = mask(false);
    for (uint i = 0u; i < world.solid_count; i = i + 1u) {
        const Solid& solid = world.solids[i];
        if (!solid.casts_shadow) continue;
        real t;
        word part;
        mask here = solid_hit(world, solid, ray, mask_and(alive, mask_not(dark)), t, part);
        dark = mask_or(dark, here);
        if (!any_lane(mask_and(alive, mask_not(dark)))) break;
    }
    return dark;
}

/// Light that thin air scatters from a lamp towards the eye along a ray from it to t: the integral of one over the
/// squared distance (a ray's stretch seen from the lamp, as an angle, over its distance).
FN real lamp_glow(vec3 place, Ray ray, real t) {
    real3 to_lamp = real3(place) - ray.origin;
    real along = dot(to_lamp, ray.direction);
    real off = sqrt(max(dot(to_lamp, to_lamp) - along * along, real(1e-4f)));
    return (angle_of(t - along, off) + angle_of(along, off)) / off;
}

/// Bends a flat surface's normal as water's (bumps of noise that wander).
FN real3 water_normal(const Tables& tables, real3 p, real3 normal, real steepness, float seconds, real distance) {
    // Far away waves are smaller than a pixel and only their mean is seen.
    real fade = steepness / (1.0f + distance * 0.045f);
    real slope_x = real(0.0f);
    real slope_y = real(0.0f);
    const float step = 0.004f;
    for (uint i = 0u; i < 2u; i = i + 1u) {
        float scale = i == 0u ? 0.021f : 0.043f;
        float drift = i == 0u ? 0.006f : -0.009f;
        real3 q = real3(p.x * scale + drift * seconds, p.y * (scale * 1.6f) + drift * 0.4f * seconds,
                        real(0.011f * seconds + 0.37f * float(i)));
        real h = noise_at(tables.noise, q);
        slope_x = slope_x + noise_at(tables.noise, real3(q.x + step, q.y, q.z)) - h;
        slope_y = slope_y + noise_at(tables.noise, real3(q.x, q.y + step, q.z)) - h;
    }
    return normalize(real3(normal.x - slope_x * fade, normal.y - slope_y * fade, normal.z));
}

/// Adds to a signature; order counts.
FN word signed_with(word signature, word what) { return (signature ^ what) * word(0x01000193u) + (signature >> 15u); }

/// Traces kLanes places given in pixels from the picture's left upper corner. `eye` are the solids that a ray from the
/// eye may meet here.
[[gnu::noinline]] inline void trace_lanes(const View& view, const Candidates& eye, const Candidates& all, real2 at,
                                          Sample* out, Counts& counts) {
    const World& world = *view.world;
    const Tables& tables = *view.tables;
    real u = at.x * (1.0f / view.width);
    real v = at.y * (1.0f / view.height);
    Ray ray = pinhole_ray(world.camera, u, v, kFar);
    ray.t_max = real(1e6f);
    real3 off_center = real3(u - 0.5f, v - 0.5f, real(0.0f));
    real bright = world.exposure * (1.0f - world.vignette * 2.0f * dot(off_center, off_center));
    real3 weight = real3(bright);
    real3 added = real3(real(0.0f));
    real3 light_out = real3(real(0.0f));
    real3 place_out = real3(real(0.0f));
    real depth_share = real(1.0f);
    word texture_out = word(0u);
    word signature = word(0x811c9dc5u);
    mask alive = mask(true);
    vec3 forward = world.camera.center * (1.0f / length(world.camera.center));

    for (uint bounce = 0u;; bounce = bounce + 1u) {
        counts.rays += static_cast<unsigned>(__builtin_popcount(lane_bits(alive)));
        Found hit = closest_hit(world, bounce == 0u ? eye : all, ray, alive);
        mask on_solid = mask_and(alive, hit.solid != word(NONE));
        mask on_sky = mask_and(alive, mask_not(on_solid));
        signature = select(alive, signed_with(signature, (hit.solid << 8u) + hit.part), signature);

        real3 air = real3(real(0.0f));
        if (bounce == 0u) {
            for (uint i = 0u; i < world.lamp_count; i = i + 1u) {
                const Lamp& lamp = world.lamps[i];
                if (lamp.glow <= 0.0f) continue;
                air = air + real3(lamp.light.color) * (lamp_glow(lamp.light.place, ray, hit.t) * lamp.glow);
            }
        }
        added = added + weight * air;

        if (any_lane(on_sky)) {
            real3 clear = sky_color(world.sky, ray.direction);
            real3 cloud = real3(real(0.0f));
            real3 place = real3(real(0.0f));
            real share = real(1.0f);
            if (world.sky.texture != 0u) {
                cloud = cloud_light(world.sky, ray.direction, clear);
                share = cloud_place(ray.direction, place);
            }
            if (bounce == 0u) {
                light_out = select(on_sky, cloud * weight, light_out);
                place_out = select(on_sky, place, place_out);
                depth_share = select(on_sky, share, depth_share);
                texture_out = select(on_sky, word(world.sky.texture), texture_out);
            } else if (world.sky.texture != 0u) {
                clear = clear + cloud * texture_color(tables, world.textures[world.sky.texture], place * (1.0f / share));
            }
            added = select(on_sky, added + weight * clear, added);
        }
        alive = on_solid;
        if (!any_lane(alive)) break;

        // The surface.
        real t = select(alive, hit.t, real(1.0f));
        real3 position = point_at(ray, t);
        real3 normal = real3(real(0.0f), real(0.0f), real(1.0f));
        real3 own_place = position;
        word material = word(0u);
        mask left = alive;
        while (any_lane(left)) {
            uint number = first_lane(left, hit.solid);
            mask here = mask_and(left, hit.solid == word(number));
            const Solid& solid = world.solids[number];
            normal = select(here, solid_normal(world, solid, hit.part, position), normal);
            material = select(here, word(solid.material), material);
            if (world.materials[solid.material].texture != 0u) {
                own_place = select(here, to_own_space(solid, position - real3(solid.origin)), own_place);
            }
            left = mask_and(left, mask_not(here));
        }
        material = valid_index(alive, material);
        normal = select(dot(normal, ray.direction) > real(0.0f), -normal, normal);
        const Material* materials = world.materials;
        real waves = load(&materials[0].waves, sizeof(Material), material);
        mask wavy = mask_and(alive, waves > real(0.0f));
        if (any_lane(wavy)) {
            normal = select(wavy, water_normal(tables, position, normal, waves, world.seconds, t), normal);
        }
        word texture = load(&materials[0].texture, sizeof(Material), material);
        real3 diffuse = load(&materials[0].diffuse, sizeof(Material), material);
        real3 emission = load(&materials[0].emission, sizeof(Material), material);
        real highlight = load(&materials[0].highlight, sizeof(Material), material);
        real shininess = load(&materials[0].shininess, sizeof(Material), material);
        real3 mirror = load(&materials[0].mirror, sizeof(Material), material);
        real mirror_edge = load(&materials[0].mirror_edge, sizeof(Material), material);

        real3 to_eye = -ray.direction;
        real facing = clamp(dot(normal, to_eye), real(0.0f), real(1.0f));
        real m = 1.0f - facing;
        real m2 = m * m;
        real edge = m2 * m2 * m;
        real3 reflected = mirror + max(real3(mirror_edge) - mirror, real3(real(0.0f))) * edge;
        real error = hit_error(ray.origin, position, t) * 8.0f;
        real3 start = position + normal * error;

        // Lamps.
        real upward = 0.5f + 0.5f * normal.z;
        real3 light = mix(real3(world.ambient_down), real3(world.ambient_up), upward);
        real3 shine = real3(real(0.0f));
        for (uint i = 0u; i < world.lamp_count; i = i + 1u) {
            const Lamp& lamp = world.lamps[i];
            real distance;
            real3 to_lamp = direction_to_light(lamp.light, start, distance);
            real cosine = lambert(normal, to_lamp);
            mask lit = mask_and(alive, cosine > real(0.0f));
            real share = real(1.0f);
            if (lamp.light.kind == LIGHT_SPOT) {
                share = smooth_step(lamp.light.dark, lamp.light.bright, -dot(to_lamp, real3(lamp.light.axis)));
            }
            if (lamp.reach > 0.0f) {
                real relative = distance * (1.0f / lamp.reach);
                share = share / (1.0f + relative * relative);
            }
            lit = mask_and(lit, share > real(0.004f));
            if (any_lane(lit)) {
                counts.rays += static_cast<unsigned>(__builtin_popcount(lane_bits(lit)));
                Ray shadow;
                shadow.origin = start;
                shadow.direction = to_lamp;
                shadow.t_min = error;
                shadow.t_max = distance;
                lit = mask_and(lit, mask_not(is_shadowed(world, shadow, lit)));
            }
            real bright_spot = highlight * blinn_phong_highlight(normal, to_lamp, to_eye, shininess);
            real3 color = real3(lamp.light.color) * select(lit, share, real(0.0f));
            light = light + color * cosine;
            shine = shine + color * bright_spot;
            word state = select(lit, select(bright_spot > real(0.02f), word(2u), word(1u)), word(0u));
            signature = select(alive, signed_with(signature, state + word(i * 4u)), signature);
        }

        real clear_share = real(1.0f);
        if (world.fog > 0.0f) clear_share = exp2_clamped(-t * world.fog);
        real3 fogged = real3(world.fog_color) * (1.0f - clear_share);
        light = light * diffuse * (real3(real(1.0f)) - reflected) * clear_share;
        shine = (shine + emission) * clear_share + fogged;
        if (bounce == 0u) {
            depth_share = select(alive, 1.0f / (t * dot(ray.direction, real3(forward))), depth_share);
            light_out = select(alive, light * weight, light_out);
            place_out = select(alive, own_place, place_out);
            texture_out = select(alive, texture, texture_out);
        } else {
            shine = shine + light * texture_colors(world, tables, texture, own_place, alive);
        }
        added = select(alive, added + weight * shine, added);

        weight = weight * reflected * clear_share;
        alive = mask_and(alive, largest(weight) > real(0.02f * world.exposure));
        if (bounce == world.bounces || !any_lane(alive)) break;
        ray.origin = start;
        ray.direction = mirror_direction(ray.direction, normal);
        // Bumps may send it under the surface.
        ray.direction = normalize(ray.direction);
        ray.t_min = error;
        ray.t_max = real(1e6f);
    }
    place_out = place_out * depth_share;

    const real channels[kChannels] = {added.x,     added.y,     added.z,     light_out.x, light_out.y,
                                      light_out.z, place_out.x, place_out.y, place_out.z, depth_share};
    for (int lane = 0; lane < kLanes; ++lane) {
        for (int c = 0; c < kChannels; ++c) out[lane].channels[c] = channels[c].v[lane];
        out[lane].texture = texture_out.v[lane];
        out[lane].signature = signature.v[lane];
    }
}

INTRO_LANES_END
