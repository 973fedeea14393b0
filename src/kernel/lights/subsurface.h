// SPDX-License-Identifier: Apache-2.0
// Light that enters a surface at one place and comes out at another: POV-Ray's reference, section 3.4.6.3.3.4
// "Subsurface Light Transport", by Jensen, Marschner, Levoy and Hanrahan (SIGGRAPH 2001). The CPU's alone; shaders
// never see this header. The device defines its traversal first (see integrators/whitted.h).
#ifndef SUNDOG_KERNEL_LIGHTS_SUBSURFACE_H
#define SUNDOG_KERNEL_LIGHTS_SUBSURFACE_H

#include "kernel/bsdf/dipole.h"
#include "kernel/bsdf/frame.h"
#include "kernel/lights/direct.h"
#include "kernel/lights/light_drawn.h"

KERNEL_BEGIN

/// A point at which light comes out, of lanes that are shaded together whatever they are made of.
struct SubsurfacePoint {
    Surface s;
    Dipole dipole;
    real eta;            ///< Index of refraction outside over that inside.
    word interior;       ///< Of the object,
    word kind;           ///< RAY_* of rays that see it,
    MediaInsides media;  ///< and what is around it.
    mask patterned;
};

/// Lanes of `found` whose layers let light in; their diffuse reflectance (layers side by side: their sum) and how far
/// light goes there before it is scattered (their mean).
FN mask translucent_layers(SCENE word material, LARGE(LayerColors) layered, mask found, OUT(real3) reflectance,
                           OUT(real3) reach) {
    real3 black = real3(real(0.0f));
    reflectance = black;
    reach = black;
    real weights = real(0.0f);
    mask todo = found;
    word look = FIELD(patterned, valid_index(todo, FIELD(materials, material, patterned)), look);
    while (any_lane(todo)) {
        uint i = first_lane(todo, look);
        mask here = mask_and(todo, look == word(i));
        todo = mask_and(todo, mask_not(here));
        uint first = AT(patterned, i).first_layer;
        for (uint l = 0u; l < AT(patterned, i).layer_count; l = l + 1u) {
            Layer layer = AT(layers, first + l);
            if (!(layer.translucency.x > 0.0f)) continue;
            real3 own = layered.own[l] * real(layer.diffuse);
            real weight = select(here, max(largest(own), real(0.0f)), real(0.0f));
            reflectance = reflectance + select(here, own, black);
            reach = reach + real3(layer.translucency) * weight;
            weights = weights + weight;
        }
    }
    reach = reach * (1.0f / max(weights, real(1e-30f)));
    return mask_and(found, weights > real(0.0f));
}

/// The point of lanes of `found`, seen along `ray_kind`'s rays from `media`, whose surfaces let light in: the answer
/// says which; `reflectance` is their diffuse one.
FN mask subsurface_point(SCENE LARGE(Surface) s, LARGE(Lobes) lobes, LARGE(LayerColors) layered, word ray_kind,
                         LARGE(MediaInsides) media, mask found, OUT(SubsurfacePoint) point, OUT(real3) reflectance) {
    real3 reach;
    mask spread = translucent_layers(SCENE_ s.material, layered, mask_and(found, lobes.patterned), reflectance, reach);
    if (!any_lane(spread)) return spread;
    point.s = s;
    point.eta = select(spread, lobes.eta, real(1.0f));
    point.dipole = dipole_of(reflectance, select(spread, reach, real3(real(1.0f))), 1.0f / point.eta);
    point.interior = interior_of(SCENE_ s, spread);
    point.kind = ray_kind;
    point.media = media;
    point.patterned = lobes.patterned;
    return spread;
}

/// The share of light that comes out of the point against `incoming`.
FN real share_leaving(LARGE(SubsurfacePoint) point, real3 incoming) {
    return 1.0f - fresnel_dielectric(-dot(point.s.normal, incoming), point.eta);
}

/// Lanes of `found` where x is of the same object as the point: what has the same interior is one object, as in povray.
FN mask same_object(SCENE LARGE(SubsurfacePoint) point, LARGE(Surface) x, mask found) {
    mask layered = mask_and(found, (FIELD(materials, x.material, flags) & word(MATERIAL_PATTERNED)) != word(0u));
    word interior = interior_of(SCENE_ x, layered);
    mask shared = mask_and(layered, mask_and(interior == point.interior, interior != word(INTERIOR_PLAIN)));
    return mask_and(found, mask_or(shared, x.geometry == point.s.geometry));
}

/// Share of a light that comes to the place `origin` of its object.
FN_LARGE real3 light_outside(SCENE Light light, LARGE(LightDrawn) drawn, real3 origin, LARGE(MediaInsides) media,
                             mask lit, INOUT(RayCounts) counts) {
    if (!FEATURE(FEATURE_SHADOWS) || (light.flags & LIGHT_SHADOWS) == 0u) return real3(real(1.0f));
    return ray_transmittance(SCENE_ light, ray_to_light(light, drawn, origin), media, lit, counts);
}

/// Lanes of `asked` in which a light from `from` can enter at x, which was met from inside; `facing` is the cosine.
FN mask enters_at(SCENE Light light, LARGE(SubsurfacePoint) point, LARGE(Surface) x, real3 from, mask asked,
                  OUT(real) facing) {
    facing = -dot(x.normal, from);
    mask lit = mask_and(asked, mask_and(facing > real(0.0f), dot(x.geometric_normal, from) < real(0.0f)));
    if (FEATURE(FEATURE_LIGHT_GROUPS))
        lit = mask_and(lit, light_reaches(SCENE_ light.group, point.s.material, point.patterned));
    return lit;
}

/// What all lights send in at x, which was met from inside.
FN_LARGE real3 light_entering(SCENE LARGE(SubsurfacePoint) point, LARGE(Surface) x, real2 u, mask asked,
                              INOUT(RayCounts) counts) {
    real3 black = real3(real(0.0f));
    real3 sum = black;
    for (uint i = 0u; i < FRAME.light_count; i = i + 1u) {
        Light light = AT(lights, i);
        LightDrawn drawn = draw_light(SCENE_ light, x.position, u);
        real facing;
        mask lit = enters_at(SCENE_ light, point, x, drawn.from, asked, facing);
        real3 amount = abs(drawn.color);
        lit = mask_and(lit, largest(amount) > real(0.0f));
        if (!any_lane(lit)) continue;
        real3 origin = x.position - x.geometric_normal * x.error;
        real3 arriving = drawn.color * light_outside(SCENE_ light, drawn, origin, point.media, lit, counts);
        sum = sum + select(lit, arriving * (facing * (1.0f - fresnel_dielectric(facing, point.eta))), black);
    }
    return sum;
}

/// Of the sphere of directions, what share is drawn towards the surface.
const float SUBSURFACE_OUTWARD = 0.7f;
/// The most that a place counts, over its density.
const float SUBSURFACE_MOST = 8.0f;

/// Of red, green and blue, that whose turn it is at sample k; `turn` says at random who begins, so that few samples are
/// as fair as many.
FN real channel_in_turn(real3 v, real turn, uint k) {
    real third = fraction(turn + float(k % 3u) * 0.333333333f);
    return select(third < real(0.333333333f), v.x, select(third < real(0.666666667f), v.y, v.z));
}

/// How deep under the point the dipole's sources stand, from which places are looked for: not out of the other side of
/// something thin, nor in the rounding of the surface itself.
FN real3 depths_below(SCENE LARGE(SubsurfacePoint) point, mask wanted, INOUT(RayCounts) counts) {
    Ray ray;
    ray.origin = point.s.position - point.s.geometric_normal * point.s.error;
    ray.direction = -point.s.geometric_normal;
    ray.t_min = real(0.0f);
    ray.t_max = real(3.0e38f);
    counts.rays = counts.rays + select(wanted, word(1u), word(0u));
    Hit back = trace_closest(SCENE_ ray, wanted, point.kind, true);
    real room = select(back.geometry != word(NONE), back.t * 0.5f, real(3.0e38f));
    return max(min(point.dipole.depth, real3(room)), real3(point.s.error * 4.0f));
}

/// The place x of the object that a ray from `under` the point meets, in a direction drawn by `u`; the answer is in
/// which lanes there is one. `basis` is around the point's outward normal.
FN mask place_below(SCENE LARGE(SubsurfacePoint) point, ShadingFrame basis, real2 u, real under, mask wanted,
                    INOUT(RayCounts) counts, OUT(Surface) x) {
    mask up = u.x < real(SUBSURFACE_OUTWARD);
    real z = select(up, u.x * (1.0f / SUBSURFACE_OUTWARD),
                    (u.x - SUBSURFACE_OUTWARD) * (-1.0f / (1.0f - SUBSURFACE_OUTWARD)));
    real across = sqrt(max(1.0f - z * z, real(0.0f)));
    real around = u.y * 6.28318531f;
    Ray ray;
    ray.origin = point.s.position - point.s.geometric_normal * under;
    ray.direction = to_world(basis, real3(across * cosine(around), across * sine(around), z));
    ray.t_min = real(0.0f);
    ray.t_max = real(3.0e38f);
    counts.rays = counts.rays + select(wanted, word(1u), word(0u));
    Hit hit = trace_closest(SCENE_ ray, wanted, point.kind, false);
    mask found = mask_and(wanted, hit.geometry != word(NONE));
    x = surface_at(SCENE_ ray, hit, found);
    return same_object(SCENE_ point, x, found);
}

/// What a place counts for the light that comes out at the point: the dipole's reflectance over the density with which
/// the place is drawn, the mean of those of three depths (Veach 1997, section 9.2.2: the balance heuristic).
FN real3 value_of_place(LARGE(SubsurfacePoint) point, real3 depth, LARGE(Surface) x) {
    real3 outward = point.s.geometric_normal;
    real3 off = x.position - point.s.position;
    real density = real(0.0f);
    for (uint c = 0u; c < 3u; c = c + 1u) {
        real3 way = off + outward * (c == 0u ? depth.x : c == 1u ? depth.y : depth.z);
        real way2 = max(dot(way, way), real(1e-30f));
        mask up = dot(way, outward) > real(0.0f);
        real share = select(up, real(SUBSURFACE_OUTWARD), real(1.0f - SUBSURFACE_OUTWARD));
        density = density + share * abs(dot(way, x.geometric_normal)) / (way2 * sqrt(way2));
    }
    density = density * (0.159154943f / 3.0f);
    real3 value = dipole_reflectance(point.dipole, dot(off, off)) * (1.0f / max(density, real(1e-30f)));
    // On a plane it is under 6 for any medium, and more by as much as the sources had to be nearer than the dipole's; a
    // place that is met at a grazing angle would be a bright dot.
    real3 source = point.dipole.depth;
    real3 nearer = max(real3(source.x / depth.x, source.y / depth.y, source.z / depth.z), real3(real(1.0f)));
    return min(value, nearer * SUBSURFACE_MOST);
}

/// Light that comes out at a point after having been scattered many times. Rays in all directions from under it, where
/// the dipole's source stands, find places where it entered: more of them near by, much as the dipole has it, and on
/// any shape. Each channel has a depth of its own; they take turns. Rays that find nothing aren't counted, as in
/// povray, whose open surfaces are up to twice as bright.
FN_LARGE real3 diffused_light(SCENE LARGE(SubsurfacePoint) point, word samples, mask wanted, INOUT(RayCounts) counts) {
    real3 black = real3(real(0.0f));
    real3 p = point.s.position;
    real3 depth = depths_below(SCENE_ point, wanted, counts);
    ShadingFrame basis = frame_around(point.s.geometric_normal);
    real turn_x = random_at(p, word(101u));
    real turn_y = random_at(p, word(102u));
    real turn_channel = random_at(p, word(100u));
    real3 sum = black;
    real counted = real(0.0f);
    for (uint k = 0u; k < FRAME.subsurface_samples; k = k + 1u) {
        mask here = mask_and(wanted, word(k) < samples);
        if (!any_lane(here)) break;
        real2 turned = real2(fraction(turn_x + 0.754877666f * float(k)), fraction(turn_y + 0.569840291f * float(k)));
        real under = channel_in_turn(depth, turn_channel, k);
        Surface x;
        mask found = place_below(SCENE_ point, basis, turned, under, here, counts, x);
        if (!any_lane(found)) continue;
        mask up = turned.x < real(SUBSURFACE_OUTWARD);
        real weight = select(up, real(0.5f / SUBSURFACE_OUTWARD), real(0.5f / (1.0f - SUBSURFACE_OUTWARD)));
        counted = counted + select(found, weight, real(0.0f));
        real3 value = value_of_place(point, depth, x);
        found = mask_and(found, largest(value) > real(1e-4f));
        if (!any_lane(found)) continue;
        real2 u = real2(random_at(p, word(2u * k + 103u)), random_at(p, word(2u * k + 104u)));
        sum = sum + select(found, value * light_entering(SCENE_ point, x, u, found, counts), black);
    }
    return select(wanted, sum * (1.0f / max(counted, real(1e-3f))), black);
}

/// Light that comes out along the ray after having been scattered once, at points drawn along the refracted ray
/// (section 3.4 of the paper). Its formula is taken with the samples' own density, as povray's pictures of flat
/// surfaces under light from many directions have it: head-on, a third of what a medium would scatter once.
FN_LARGE real3 single_scattered_light(SCENE LARGE(SubsurfacePoint) point, real3 incoming, word samples, mask wanted,
                                      INOUT(RayCounts) counts) {
    real3 black = real3(real(0.0f));
    real3 inward;
    mask passes = refract_direction(incoming, point.s.normal, point.eta, inward);
    mask bends = abs(point.eta - 1.0f) > real(0.0f);
    wanted = mask_and(wanted, mask_or(passes, mask_not(bends)));
    if (!any_lane(wanted)) return black;
    inward = select(bends, normalize(inward), incoming);
    real cos_out = max(-dot(point.s.normal, inward), real(1e-3f));
    Ray way;
    way.origin = point.s.position - point.s.geometric_normal * point.s.error;
    way.direction = inward;
    way.t_min = real(0.0f);
    way.t_max = real(3.0e38f);
    counts.rays = counts.rays + select(wanted, word(1u), word(0u));
    Hit end = trace_closest(SCENE_ way, wanted, point.kind, true);
    real room = select(end.geometry != word(NONE), end.t, real(3.0e38f));
    real3 depth = point.dipole.depth;
    real3 rate = real3(2.0f / depth.x, 2.0f / depth.y, 2.0f / depth.z);
    real turn = random_at(point.s.position, word(99u));
    real turn_channel = random_at(point.s.position, word(98u));
    real3 sum = black;
    real taken = real(0.0f);
    for (uint k = 0u; k < FRAME.subsurface_single_samples; k = k + 1u) {
        mask here = mask_and(wanted, word(k) < samples);
        if (!any_lane(here)) break;
        taken = taken + select(here, real(1.0f), real(0.0f));
        real u = max(1.0f - fraction(turn + 0.618033989f * float(k)), real(1e-7f));
        real distance = log2_positive(u) * -0.34657359f * channel_in_turn(depth, turn_channel, k);
        here = mask_and(here, distance < room);
        if (!any_lane(here)) continue;
        real3 drawn_share = real3(exp_negative(rate.x * distance) * rate.x, exp_negative(rate.y * distance) * rate.y,
                                  exp_negative(rate.z * distance) * rate.z);
        real density = (drawn_share.x + drawn_share.y + drawn_share.z) * 0.333333333f;
        real3 value = drawn_share * (0.5f / max(density, real(1e-30f)));
        real3 p = way.origin + inward * distance;
        real2 place = real2(random_at(point.s.position, word(2u * k + 1000003u)),
                            random_at(point.s.position, word(2u * k + 1000004u)));
        for (uint i = 0u; i < FRAME.light_count; i = i + 1u) {
            Light light = AT(lights, i);
            LightDrawn drawn = draw_light(SCENE_ light, p, place);
            Ray inner = ray_to_light(light, drawn, p);
            counts.rays = counts.rays + select(here, word(1u), word(0u));
            Hit hit = trace_closest(SCENE_ inner, here, point.kind, false);
            mask found = mask_and(here, hit.geometry != word(NONE));
            if (!any_lane(found)) continue;
            Surface x = surface_at(SCENE_ inner, hit, found);
            real facing;
            mask lit = enters_at(SCENE_ light, point, x, drawn.from, same_object(SCENE_ point, x, found), facing);
            real3 amount = abs(drawn.color);
            lit = mask_and(lit, largest(amount) > real(0.0f));
            if (!any_lane(lit)) continue;
            real3 origin = x.position - x.geometric_normal * x.error;
            real3 color = drawn.color * light_outside(SCENE_ light, drawn, origin, point.media, lit, counts);
            real cos_in = sqrt(max(1.0f - point.eta * point.eta * (1.0f - facing * facing), real(1e-6f)));
            // What goes straight to the light stands for a refracted way, which is shorter (equation 10).
            real length_in = hit.t * facing / cos_in;
            real3 faded = real3(exp_negative(length_in / depth.x), exp_negative(length_in / depth.y),
                                exp_negative(length_in / depth.z));
            real gain = facing * (1.0f - fresnel_dielectric(facing, point.eta)) * cos_in / (cos_in + cos_out);
            sum = sum + select(lit, color * value * faded * gain, black);
        }
    }
    return select(wanted, sum * point.dipole.albedo * (0.25f / max(taken, real(1.0f))), black);
}

/// How many of so many samples a ray of less weight takes: its noise counts as little.
FN word fewer_samples(uint samples, real weight) {
    real share = min(weight * weight, real(1.0f));
    return word_from_real(max(share * float(samples), real(float(min(samples, 6u)))) + 0.5f);
}

/// What light that entered elsewhere adds to the matt light of the surfaces of `found`, met along `incoming`; black in
/// lanes that let none in (the others are those of `spread`). `weight` is what counts of the answer.
FN_LARGE real3 subsurface_light(SCENE LARGE(Surface) s, LARGE(Lobes) lobes, LARGE(LayerColors) layered, real3 incoming,
                                word kind, LARGE(MediaInsides) media, real3 weight, mask found, INOUT(RayCounts) counts,
                                OUT(mask) spread) {
    real3 black = real3(real(0.0f));
    real3 reflectance;
    SubsurfacePoint point;
    spread = subsurface_point(SCENE_ s, lobes, layered, kind, media, found, point, reflectance);
    if (!any_lane(spread)) return black;
    real most = largest(weight);
    word many = fewer_samples(FRAME.subsurface_samples, most);
    word single = fewer_samples(FRAME.subsurface_single_samples, most);
    real3 diffused = diffused_light(SCENE_ point, many, spread, counts);
    real3 once = single_scattered_light(SCENE_ point, incoming, single, spread, counts);
    return select(spread, (diffused + once) * share_leaving(point, incoming), black);
}

KERNEL_END

#endif
