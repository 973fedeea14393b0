// SPDX-License-Identifier: Apache-2.0
// Path tracing (Kajiya, The Rendering Equation, SIGGRAPH 1986) with light that is aimed at and light that is met,
// weighed by multiple importance sampling (Veach 1997, chapter 9), and Russian roulette (Arvo and Kirk 1990).
//
// Surfaces are those of Whitted's integrator: what a light of colour 1 makes of them is pi times their BSDF times the
// cosine. Surfaces that shine are lights; lights without size are those of Whitted's integrator, with areas for soft
// shadows. Of ambient light there is none. Transparent surfaces stand in its way, except in that of lights without
// size, which no path could meet; those that don't bend light are passed straight by aimed rays, too.
//
// The device defines its traversal first (see whitted.h).
#ifndef SUNDOG_KERNEL_INTEGRATORS_PATH_TRACING_H
#define SUNDOG_KERNEL_INTEGRATORS_PATH_TRACING_H

#include "kernel/atmosphere/sky.h"
#include "kernel/integrators/aimed_light.h"
#include "kernel/integrators/air.h"
#include "kernel/integrators/scatter.h"
#include "kernel/integrators/surface_met.h"
#include "kernel/integrators/traced_path.h"
#include "kernel/materials/spectrum.h"
#ifdef KERNEL_MEDIA
#include "kernel/integrators/particles.h"
#endif
#ifdef __cplusplus
#include "kernel/integrators/paths_below.h"
#endif

KERNEL_BEGIN

/// From how many surfaces on paths that bring little are ended at random.
const uint ROULETTE_AFTER = 2u;

/// What paths see that leave the scene.
FN real3 background_met(SCENE TracedPath path, mask missed) {
    real3 seen = background_radiance(SCENE_ path.ray.direction);
    if (FEATURE(FEATURE_ENVIRONMENT)) {
        mask chosen = mask_and(missed, path.density > real(0.0f));
        if (any_lane(chosen)) {
            real other = environment_density(SCENE_ path.ray.direction) * FRAME.environment.probability;
            seen = seen * select(chosen, power_heuristic(path.density, other), real(1.0f));
        }
    }
    return seen;
}

/// Sets the path's next ray, and its weight; paths without one end, and those of `ends` unless they go straight on.
/// `choice` draws the lobe, `u` the direction. The surface was met at `distance`.
FN void scatter_path(SCENE Surface s, Lobes lobes, LARGE(LayerColors) layered, LARGE(BsdfPoint) point,
                     Crossing crossing, Scatter scatter, ShadingFrame basis, real2 u, real choice, mask ends,
                     real distance, mask found, INOUT(TracedPath) path) {
    real3 black = real3(real(0.0f));
    real3 incoming = path.ray.direction;
    mask rough = mask_and(found, choice < scatter.rough);
    mask through = mask_and(found, choice >= scatter.rough + scatter.mirrored);
    mask mirrored = mask_and(mask_and(found, mask_not(rough)), mask_not(through));
    through = mask_and(through, scatter.through > real(0.0f));
    mirrored = mask_and(mirrored, scatter.mirrored > real(0.0f));

    Ray next = mirrored_ray(s, incoming);
    real3 carried = black;
    real drawn_before = path.density;
    real passed_before = path.passed + distance;
    path.density = real(0.0f);
    path.passed = real(0.0f);
    mask goes_on = mask_and(found, mask_not(ends));
    if (any_lane(rough)) {
        real3 to_eye = to_local(basis, -incoming);
        real3 local = cosine_direction(u);
        if (any_lane(mask_and(rough, scatter.gloss > real(0.0f)))) {
            // What is left of the number that drew the lobe says whether it is for the highlight.
            mask glossy = choice < scatter.rough * scatter.gloss;
            local = select(glossy, blinn_phong_direction(to_eye, scatter.exponent, u), local);
        }
        mask drawn = rough;
        if (FEATURE(FEATURE_BSDF)) {
            mask own = mask_and(rough, scatter.own);
            if (any_lane(own)) {
                real left = choice / max(scatter.rough, real(1e-10f));
                local = select(own, bsdf_directions(SCENE_ scatter.model, point, to_eye, u, left, own), local);
                drawn = mask_and(rough, dot(local, local) > real(0.5f));
            }
        }
        if (FEATURE(FEATURE_MEDIA)) {
            mask particle = mask_and(rough, scatter.particle);
            if (any_lane(particle)) {
                real c = phase_cosine(scatter.phase, scatter.eccentricity, u.x);
                real across = sqrt(max(1.0f - c * c, real(0.0f)));
                real around = u.y * 6.28318531f;
                // The normal looks back along the ray.
                local = select(particle, real3(across * cosine(around), across * sine(around), -c), local);
            }
        }
        real3 direction = to_world(basis, select(drawn, local, real3(real(0.0f), real(0.0f), real(1.0f))));
        direction = normalize(direction);
        mask behind;
        mask lit = scattering_lanes(SCENE_ s, lobes, scatter, direction, drawn, behind);
        real density;
        real3 value = scattered_light(SCENE_ s, lobes, layered, point, scatter, basis, lit,
                                      mask_and(behind, mask_not(behind)), direction, -incoming, density);
        lit = mask_and(lit, density > real(0.0f));
        carried = select(lit, value * (0.318309886f / max(density, real(1e-30f))), black);
        if (FEATURE(FEATURE_BSDF)) {
            mask beyond = mask_and(rough, mask_and(behind, scatter.own));
            next.origin = select(beyond, s.position - s.geometric_normal * s.error, next.origin);
            if (FEATURE(FEATURE_BODIES)) {
                path.insides.inner = select(beyond, crossing.behind.inner, path.insides.inner);
                path.insides.outer = select(beyond, crossing.behind.outer, path.insides.outer);
            }
        }
        next.direction = select(rough, direction, next.direction);
        path.density = select(rough, density, path.density);
    }
    if (FEATURE(FEATURE_MIRRORS | FEATURE_TRANSPARENT))
        carried = select(mirrored, lobes.reflectance * (1.0f / max(scatter.mirrored, real(1e-30f))), carried);
    if (FEATURE(FEATURE_TRANSPARENT)) {
        if (any_lane(through)) {
            real3 refracted;
            mask passes = refract_direction(incoming, s.normal, lobes.eta, refracted);
            mask bends = mask_and(passes, abs(lobes.eta - 1.0f) > real(0.0f));
            next.direction = select(through, select(bends, normalize(refracted), incoming), next.direction);
            next.origin = select(through, s.position - s.geometric_normal * s.error, next.origin);
            if (FEATURE(FEATURE_VEILS)) {
                mask straight = mask_and(through, mask_or(scatter.own, is_unbent(SCENE_ s, lobes, through)));
                // Aimed rays don't pass there.
                straight = mask_and(straight, mask_not(scatter.seamless));
                path.density = select(straight, drawn_before, path.density);
                path.passed = select(straight, passed_before, path.passed);
                mask may_pass = path.vertices < word(FRAME.max_depth + MAX_SHADOW_SURFACES);
                goes_on = mask_or(goes_on, mask_and(straight, may_pass));
            }
            carried = select(through, lobes.transmittance * (1.0f / max(scatter.through, real(1e-30f))), carried);
            if (FEATURE(FEATURE_DISPERSION)) {
                mask splits = disperses(SCENE_ s, lobes, mask_and(through, lobes.patterned));
                splits = mask_and(splits, mask_not(path.colored));
                carried = select(splits, carried * spectrum_light(path.spectrum), carried);
                path.colored = mask_or(path.colored, splits);
            }
            if (FEATURE(FEATURE_PATTERNED | FEATURE_BODIES)) {
                path.insides.inner = select(through, crossing.behind.inner, path.insides.inner);
                path.insides.outer = select(through, crossing.behind.outer, path.insides.outer);
            }
            if (FEATURE(FEATURE_HOLLOW)) {
                MediaInsides beyond = media_beyond(SCENE_ s, path.media, through);
                for (uint i = 0u; i < MAX_MEDIA_INSIDES; i = i + 1u)
                    path.media.entry[i] = select(through, beyond.entry[i], path.media.entry[i]);
            }
        }
    }
    path.kind = select(through, path.kind, word(RAY_REFLECTED));
    path.ray = next;
    path.weight = path.weight * carried;
    path.alive = mask_and(goes_on, largest(path.weight) > real(0.0f));
}

/// Puts particles in the places of surfaces, in lanes where they are met.
FN void take_particle(Particle particle, Ray ray, INOUT(Surface) s, INOUT(Lobes) lobes, INOUT(Scatter) scatter,
                      INOUT(ShadingFrame) basis) {
    mask met = particle.met;
    s.position = select(met, point_at(ray, particle.t), s.position);
    s.normal = select(met, -ray.direction, s.normal);
    s.geometric_normal = select(met, -ray.direction, s.geometric_normal);
    s.error = select(met, real(0.0f), s.error);
    s.material = select(met, word(0u), s.material);
    ShadingFrame around = frame_around(-ray.direction);
    basis.x = select(met, around.x, basis.x);
    basis.y = select(met, around.y, basis.y);
    basis.z = select(met, around.z, basis.z);
    become_matt(met, lobes, scatter);
    scatter.particle = met;
    scatter.phase = particle.type;
    scatter.eccentricity = particle.eccentricity;
}

/// Where materials have reflection models of their own, these take the place of the lobes.
FN void take_bsdf(SCENE mask found, real distance, INOUT(TracedPath) path, INOUT(Surface) s, INOUT(Lobes) lobes,
                  INOUT(Scatter) scatter, INOUT(ShadingFrame) basis, OUT(BsdfPoint) point) {
    real3 black = real3(real(0.0f));
    word model = FIELD(materials, s.material, bsdf);
    mask own = mask_and(found, model != word(NONE));
    scatter.own = own;
    scatter.model = valid_index(own, model);
    if (!any_lane(own)) return;
    // A bent or smoothed normal that faces away from the eye says nothing.
    mask away = mask_and(own, dot(s.normal, path.ray.direction) > real(-1e-3f));
    s.normal = select(away, s.geometric_normal, s.normal);
    ShadingFrame around = frame_around(s.normal);
    point = bsdf_at(SCENE_ s, own, path.spectrum, lobes.eta, around);
    if (FEATURE(FEATURE_DISPERSION)) {
        mask splits = mask_and(own, FIELD(bsdfs, scatter.model, dispersion) > real(0.0f));
        splits = mask_and(splits, mask_not(path.colored));
        path.weight = select(splits, path.weight * spectrum_light(path.spectrum), path.weight);
        path.colored = mask_or(path.colored, splits);
    }
    basis.x = select(own, around.x, basis.x);
    basis.y = select(own, around.y, basis.y);
    basis.z = select(own, around.z, basis.z);
    real opacity = bsdf_opacity(SCENE_ s, scatter.model, own);
    if (FEATURE(FEATURE_BODIES)) {
        // Between what bends light alike facets have no normals.
        scatter.seamless = mask_and(own, FIELD(materials, s.material, interior) != word(0u));
        scatter.seamless = mask_and(scatter.seamless, abs(lobes.eta - 1.0f) < real(1e-4f));
        opacity = select(scatter.seamless, real(0.0f), opacity);
    }
    scatter.rough = select(own, opacity, scatter.rough);
    scatter.mirrored = select(own, real(0.0f), scatter.mirrored);
    scatter.through = select(own, 1.0f - opacity, scatter.through);
    scatter.clear = bsdf_is_clear(SCENE_ scatter.model, point, own);
    lobes.transmittance = select(own, real3(1.0f - opacity), lobes.transmittance);
    lobes.reflectance = select(own, black, lobes.reflectance);
    lobes.eta = select(own, real(1.0f), lobes.eta);
    // Inside, light dims on its way.
    mask inside = mask_and(own, s.from_behind);
    if (!FEATURE(FEATURE_BODIES) && any_lane(inside)) {
        real3 rate = FIELD(bsdfs, scatter.model, attenuation) * (distance * -1.44269504f);
        real3 passes = real3(exp2_clamped(rate.x), exp2_clamped(rate.y), exp2_clamped(rate.z));
        path.weight = select(inside, path.weight * passes, path.weight);
    }
}

/// Ends paths that bring little at random, so that the others stand for them.
FN void play_roulette(INOUT(TracedPath) path) {
    mask plays = mask_and(path.alive, word(ROULETTE_AFTER) < path.vertices);
    if (!any_lane(plays)) return;
    real survival = clamp(largest(path.weight), real(0.05f), real(1.0f));
    real drawn = sample_hash(path.draws, path.vertices);
    mask ends = mask_and(plays, drawn >= survival);
    path.alive = mask_and(path.alive, mask_not(ends));
    path.weight = select(plays, path.weight * (1.0f / survival), path.weight);
}

/// Follows each path to the next surface: adds to `radiance` what it finds there, and leaves the path with its next
/// ray, or ended. `first` gets what paths meet first. `together`: all are at their first.
FN void extend_path(SCENE bool together, INOUT(TracedPath) path, INOUT(real3) radiance, INOUT(RayCounts) counts,
                    INOUT(FirstHit) first) {
    real3 black = real3(real(0.0f));
    counts.rays = counts.rays + select(path.alive, word(1u), word(0u));
    Hit hit = trace_closest(SCENE_ path.ray, path.alive, path.kind, together);
    mask found = mask_and(path.alive, hit.geometry != word(NONE));
    mask missed = mask_and(path.alive, hit.geometry == word(NONE));
    real reach = select(found, hit.t, real(3.0e38f));
    Particle particle = no_particle();
#ifdef KERNEL_MEDIA
    if (FEATURE(FEATURE_MEDIA)) {
        particle = track_media(SCENE_ reach, path, radiance);
        reach = select(particle.met, particle.t, reach);
        mask left = largest(abs(path.weight)) > real(0.0f);
        found = mask_and(found, mask_and(left, mask_not(particle.met)));
        missed = mask_and(missed, mask_and(left, mask_not(particle.met)));
    }
#endif
    cross_fog(SCENE_ path.ray, reach, path.media, path.alive, path.weight, radiance);
    if (any_lane(missed))
        radiance = radiance + select(missed, path.weight * background_met(SCENE_ path, missed), black);
    path.alive = mask_or(found, particle.met);
    if (!any_lane(path.alive)) return;

    Surface s;
    Lobes lobes;
    LayerColors layered;
    Crossing crossing;
    real3 smooth_normal;
    real3 dimmed = surface_met(SCENE_ path.ray, hit, path.insides, path.spectrum, found, s, lobes, layered, crossing,
                               smooth_normal);
    path.weight = path.weight * dimmed;
    if (FEATURE(FEATURE_BODIES)) {
        dimmed = body_transmittance(SCENE_ crossing, body_of(SCENE_ s, found), path.insides, hit.t);
        path.weight = select(found, path.weight * dimmed, path.weight);
    }
    if (FRAME.aovs != 0u) {
        mask is_first = mask_and(found, path.vertices == word(0u));
        first.t = select(is_first, hit.t, first.t);
        first.normal = select(is_first, s.normal, first.normal);
        first.albedo = select(is_first, lobes.albedo, first.albedo);
        first.geometry = select(is_first, s.geometry, first.geometry);
        first.primitive = select(is_first, s.primitive, first.primitive);
        first.material = select(is_first, s.material, first.material);
    }
    // Textures of layers add what they reflect to their own light; others share it out.
    if (FEATURE(FEATURE_MIRRORS | FEATURE_TRANSPARENT)) {
        real3 white = real3(real(1.0f));
        real3 kept = max(white - lobes.reflectance - lobes.transmittance, black);
        lobes.diffuse = select(lobes.patterned, lobes.diffuse, lobes.diffuse * kept);
        lobes.specular = select(lobes.patterned, lobes.specular, lobes.specular * (white - lobes.reflectance));
    }
    Scatter scatter = scatter_of(SCENE_ s, lobes, layered, found);
    ShadingFrame basis = frame_around(s.normal);
    BsdfPoint point;
    if (FEATURE(FEATURE_BSDF)) take_bsdf(SCENE_ found, hit.t, path, s, lobes, scatter, basis, point);
#ifdef __cplusplus
    mask from_top = found;
#endif
    if (FEATURE(FEATURE_MEDIA)) {
        take_particle(particle, path.ray, s, lobes, scatter, basis);
        found = mask_or(found, particle.met);
    }
    real3 emission = lobes.emission + lobes.ambient * real3(FRAME.ambient);
    if (any_lane(mask_and(found, largest(emission) > real(0.0f)))) {
        real share = real(1.0f);
        mask chosen = mask_and(found, path.density > real(0.0f));
        if (any_lane(chosen)) {
            real other = emitter_density(SCENE_ path.ray, hit, path.passed, s, chosen);
            share = select(chosen, power_heuristic(path.density, other), share);
        }
        radiance = radiance + select(found, path.weight * emission * share, black);
    }
#ifdef __cplusplus
    if (FEATURE(FEATURE_SUBSURFACE)) {
        mask outside = mask_and(from_top, mask_not(crossing.leaves));
        go_below(SCENE_ layered, outside, counts, path, radiance, s, lobes, scatter, basis);
    }
#endif
    word dimension = path.vertices * word(CHOICES_A_VERTEX) + word(FIRST_CHOICE);
    real2 picks = sample_pair(path.draws, dimension + word(2u));
    mask ends = mask_not(path.vertices < word(FRAME.max_depth));
    if (FRAME.emitter_count > 0u) {
        mask asked = mask_and(found, scatter.rough > real(0.0f));
        if (any_lane(asked)) {
            real2 place = sample_pair(path.draws, dimension + word(1u));
            real3 aimed = aimed_light(SCENE_ s, lobes, layered, point, scatter, basis, path.media, place, picks.y,
                                      -path.ray.direction, ends, asked, counts);
            radiance = radiance + select(asked, path.weight * aimed, black);
        }
    }
    mask goes_on = mask_and(found, mask_not(ends));
    if (FEATURE(FEATURE_VEILS)) goes_on = mask_or(goes_on, mask_and(found, scatter.through > real(0.0f)));
    path.alive = goes_on;
    if (!any_lane(goes_on)) return;
    real2 direction = sample_pair(path.draws, dimension);
    scatter_path(SCENE_ s, lobes, layered, point, crossing, scatter, basis, direction, picks.x, ends, hit.t, goes_on,
                 path);
    path.vertices = path.vertices + word(1u);
    play_roulette(path);
}

KERNEL_END

#endif
