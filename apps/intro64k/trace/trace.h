// SPDX-License-Identifier: Apache-2.0
// Whitted's ray tracing (1980) of as many places of the picture as there are lanes.
#pragma once

#include "kernel/cameras/pinhole.h"
#include "kernel/lights/light.h"
#include "kernel/materials/reflection.h"
#include "trace/shapes.h"
#include "trace/sky.h"
#include "trace/textures.h"
#include "trace/tile_work.h"

namespace sundog::intro {

/// Red, green and blue from 0 to 255 of radiance: a film's curve (Narkowicz, ACES Filmic Tone Mapping Curve, 2016), and
/// the square root in place of the screen's own gamma.
FN real3 tone_of(real3 c) {
    real3 x = max(c, real3(real(0.0f)));
    real3 num = x * (x * real(2.51f) + real3(real(0.03f)));
    real3 den = x * (x * real(2.43f) + real3(real(0.59f))) + real3(real(0.14f));
    return real3(sqrt(min(num.x / den.x, real(1.0f))), sqrt(min(num.y / den.y, real(1.0f))),
                 sqrt(min(num.z / den.z, real(1.0f)))) *
           real(255.0f);
}

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

[[gnu::noinline]] inline Found closest_hit(const World& world, const Candidates& candidates, Ray ray, mask alive) {
    Found found;
    found.solid = word(NONE);
    found.part = word(kWhole);
    for (uint i = 0u; i < candidates.count; i = i + 1u) {
        uint number = candidates.numbers[i];
        mask here = mask_and(alive, may_hit(world.solids[number], ray));
        if (!any_lane(here)) continue;
        real t;
        word part;
        here = solid_hit(world, world.solids[number], ray, here, t, part);
        ray.t_max = select(here, t, ray.t_max);
        found.solid = select(here, word(number), found.solid);
        found.part = select(here, part, found.part);
    }
    found.t = ray.t_max;
    return found;
}

/// Lanes of `alive` whose way along the ray is barred.
[[gnu::noinline]] inline mask is_shadowed(const World& world, const Ray& ray, mask alive) {
    mask dark = mask(false);
    for (uint i = 0u; i < world.solid_count; i = i + 1u) {
        const Solid& solid = world.solids[i];
        if (!solid.casts_shadow) continue;
        mask here = mask_and(alive, may_hit(solid, ray));
        if (!any_lane(here)) continue;
        real t;
        word part;
        here = solid_hit(world, solid, ray, here, t, part);
        dark = mask_or(dark, here);
        alive = mask_and(alive, mask_not(here));
        if (!any_lane(alive)) break;
    }
    return dark;
}

/// Light that thin air scatters from a lamp towards the eye along a ray from it to t: the integral of one over the
/// squared distance (a ray's stretch seen from the lamp, as an angle, over its distance).
[[gnu::noinline]] inline real lamp_glow(vec3 place, const Ray& ray, real t) {
    real3 to_lamp = real3(place) - ray.origin;
    real along = dot(to_lamp, ray.direction);
    real off = sqrt(max(dot(to_lamp, to_lamp) - along * along, real(1e-4f)));
    // Both angles by one arc tangent of the sum: within half a turn, as off is positive.
    real beyond = t - along;
    return angle_of((beyond + along) * off, off * off - beyond * along) / off;
}

/// Bends a level surface's normal as water's: bumps of noise that wander.
[[gnu::noinline]] inline real3 water_normal(const Tables& tables, const real3& p, float steepness, float seconds,
                                            real distance) {
    // Far away waves are smaller than a pixel, and only their mean is seen.
    real fade = steepness / (1.0f + distance * 0.045f);
    real slope_x = real(0.0f);
    real slope_y = real(0.0f);
    for (uint i = 0u; i < 2u; i = i + 1u) {
        float scale = i == 0u ? 0.021f : 0.043f;
        float drift = i == 0u ? 0.006f : -0.009f;
        real2 slopes = noise_slopes(tables.noise,
                                    real3(p.x * scale + drift * seconds, p.y * (scale * 1.6f) + drift * 0.4f * seconds,
                                          real(0.011f * seconds + 0.37f * float(i))));
        slope_x = slope_x + slopes.x;
        slope_y = slope_y + slopes.y;
    }
    return normalize(real3(-slope_x * fade, -slope_y * fade, real(1.0f)));
}

/// Adds to a signature; order counts.
FN word signed_with(word signature, word what) { return (signature ^ what) * word(0x01000193u) + (signature >> 15u); }

/// What trace_lanes() finds, in the order in which it is stored.
struct Traced {
    real3 light;  ///< Radiance that no texture dims ...
    real share;   ///< ... (in the fourth place there is nothing to compare).
    real3 shade;  ///< What the texture's colour is multiplied by; where there is none, added as it is.
    real unused;
    real3 tone;  ///< Of the whole.
    real one;
    real3 place;  ///< In the texture's space, over the depth.
    real over_depth;
    word signature, highlights, texture, outline;
};

/// Traces kLanes places given in pixels from the picture's left upper corner. `eye` are the solids that a ray from the
/// eye may meet here.
[[gnu::noinline]] inline Traced trace_lanes(const View& view, const Candidates& eye, const Candidates& all, real2 at,
                                            Counts& counts) {
    const World& world = *view.world;
    const Tables& tables = *view.tables;
    real u = at.x * (1.0f / view.width);
    real v = at.y * (1.0f / view.height);
    Ray ray = pinhole_ray(world.camera, u, v, kFar);
    ray.t_max = real(1e6f);
    real3 off_center = real3(u - 0.5f, v - 0.5f, real(0.0f));
    real bright = world.exposure * (1.0f - world.air.vignette * 2.0f * dot(off_center, off_center));
    real3 weight = real3(bright);
    real3 added = real3(real(0.0f));
    real3 light_out = real3(real(0.0f));
    real3 place_out = real3(real(0.0f));
    real depth_share = real(1.0f);
    word texture_out = word(0u);
    word outline = word(0x811c9dc5u);
    word signature = outline;
    word highlights = outline;
    mask alive = mask(true);
    vec3 forward = world.camera.center * (1.0f / length(world.camera.center));

    for (uint bounce = 0u;; bounce = bounce + 1u) {
        counts.rays += static_cast<unsigned>(__builtin_popcount(lane_bits(alive)));
        Found hit = closest_hit(world, bounce == 0u ? eye : all, ray, alive);
        mask on_solid = mask_and(alive, hit.solid != word(NONE));
        mask on_sky = mask_and(alive, mask_not(on_solid));
        // What is seen so faintly that nobody would miss it needs no edges.
        mask clear_view = mask_and(alive, largest(weight) > real(0.035f * world.exposure));
        word what = (hit.solid << 8u) + hit.part;
        signature = select(clear_view, signed_with(signature, what), signature);
        mask clear_mirror = mask_and(alive, largest(weight) > real(0.15f * world.exposure));
        outline = select(clear_mirror, signed_with(outline, what), outline);

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
            real3 clear = sky_color(world.air, world.sky, ray.direction);
            if (world.sky.texture != 0u) {
                // Clouds lie in a plane; none are looked up far out in it.
                real3 place = real3(ray.direction.x, ray.direction.y, real(0.0f)) *
                              (1.0f / (max(ray.direction.z, real(0.0f)) + 0.07f));
                clear = clear + cloud_light(world.sky, ray.direction, clear) *
                                    texture_color(tables, world.textures[world.sky.texture], place);
            }
            added = select(on_sky, added + weight * clear, added);
        }
        alive = on_solid;
        if (!any_lane(alive)) break;

        // The surface: lanes that hit the same solid are taken together.
        real t = select(alive, hit.t, real(1.0f));
        real3 position = point_at(ray, t);
        real zero = real(0.0f);
        real3 normal = real3(zero, zero, real(1.0f));
        real3 own_place = position;
        word texture = word(0u);
        real3 diffuse = real3(zero);
        real3 emission = diffuse;
        real3 mirror = diffuse;
        real mirror_edge = zero;
        real highlight = zero;
        real shininess = real(1.0f);
        mask left = alive;
        while (any_lane(left)) {
            uint number = first_lane(left, hit.solid);
            mask here = mask_and(left, hit.solid == word(number));
            left = mask_and(left, mask_not(here));
            const Solid& solid = world.solids[number];
            const Material& material = world.materials[solid.material];
            real3 n = solid_normal(world, solid, hit.part, position);
            if (material.waves > 0.0f) n = water_normal(tables, position, material.waves, world.seconds, t);
            normal = select(here, n, normal);
            if (material.texture != 0u) {
                own_place = select(here, to_own_space(solid, position - real3(solid.origin)), own_place);
                texture = select(here, word(material.texture), texture);
            }
            diffuse = select(here, real3(material.diffuse), diffuse);
            emission = select(here, real3(material.emission), emission);
            mirror = select(here, real3(material.mirror), mirror);
            mirror_edge = select(here, real(material.mirror_edge), mirror_edge);
            highlight = select(here, real(material.highlight), highlight);
            shininess = select(here, real(material.shininess), shininess);
        }
        normal = select(dot(normal, ray.direction) > zero, -normal, normal);

        real3 to_eye = -ray.direction;
        real facing = clamp(dot(normal, to_eye), real(0.0f), real(1.0f));
        real m = 1.0f - facing;
        real m2 = m * m;
        real edge = m2 * m2 * m;
        real3 reflected = mirror + max(real3(mirror_edge) - mirror, real3(real(0.0f))) * edge;
        real error = hit_error(ray.origin, position, t) * 8.0f;
        real3 start = position + normal * error;

        // Lamps.
        real matter = max(largest(diffuse), highlight);
        mask lightable = mask_and(alive, matter > real(0.0f));
        real upward = 0.5f + 0.5f * normal.z;
        real3 light = mix(real3(world.air.ambient_down), real3(world.air.ambient_up), upward);
        real3 shine = real3(real(0.0f));
        for (uint i = 0u; i < world.lamp_count; i = i + 1u) {
            const Lamp& lamp = world.lamps[i];
            real distance;
            real3 to_lamp = direction_to_light(lamp.light, start, distance);
            real cosine = lambert(normal, to_lamp);
            mask lit = mask_and(lightable, cosine > real(0.0f));
            real share = real(1.0f);
            if (lamp.light.kind == LIGHT_SPOT) {
                share = smooth_step(lamp.light.dark, lamp.light.bright, -dot(to_lamp, real3(lamp.light.axis)));
            }
            if (lamp.reach > 0.0f) {
                real relative = distance * (1.0f / lamp.reach);
                share = share / (1.0f + relative * relative);
            }
            lit = mask_and(lit, share > real(0.01f));
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
            mask clear_light = mask_and(
                clear_view, largest(weight) * share * max(matter * cosine, bright_spot) > real(0.03f * world.exposure));
            word lamp_number = word(i * 2u);
            signature =
                select(clear_light, signed_with(signature, lamp_number + select(lit, word(1u), word(0u))), signature);
            mask seen_highlight = mask_and(clear_light, mask_and(lit, bright_spot > real(0.05f)));
            highlights = select(seen_highlight, signed_with(highlights, lamp_number + word(bounce * 64u)), highlights);
        }

        real clear_share = real(1.0f);
        if (world.air.fog > 0.0f) clear_share = exp2_clamped(-t * world.air.fog);
        real3 fogged = real3(world.air.fog_color) * (1.0f - clear_share);
        light = light * diffuse * (real3(real(1.0f)) - reflected) * clear_share;
        shine = (shine + emission) * clear_share + fogged;
        if (bounce == 0u) {
            depth_share = select(alive, 1.0f / (t * dot(ray.direction, real3(forward))), depth_share);
            light_out = select(alive, light * weight, light_out);
            place_out = select(alive, own_place, place_out);
            texture_out = select(alive, texture, texture_out);
        } else {
            real3 color = texture_colors(world, tables, texture, own_place, alive);
            shine = shine + light * color;
            // Edges of tiles in a mirror are outlines, too.
            word bright_tile = select(color.y > real(0.3f), word(1u), word(2u));
            outline = select(clear_mirror, signed_with(outline, bright_tile), outline);
        }
        added = select(alive, added + weight * shine, added);

        weight = weight * reflected * clear_share;
        alive = mask_and(alive, largest(weight) > real(0.03f * world.exposure));
        if (bounce == world.air.bounces || !any_lane(alive)) break;
        ray.origin = start;
        ray.direction = mirror_direction(ray.direction, normal);
        // Bumps may send it under the surface.
        ray.direction = normalize(ray.direction);
        ray.t_min = error;
        ray.t_max = real(1e6f);
    }
    Traced out;
    out.light = added;
    out.shade = light_out;
    out.share = out.unused = real(0.0f);
    out.one = real(1.0f);
    out.tone = tone_of(added + light_out * texture_colors(world, tables, texture_out, place_out, mask(true)));
    out.place = place_out * depth_share;
    out.over_depth = depth_share;
    out.signature = signature | word(1u);
    out.highlights = highlights;
    out.texture = texture_out;
    out.outline = outline;
    return out;
}

}  // namespace sundog::intro
