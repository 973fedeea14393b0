// SPDX-License-Identifier: Apache-2.0
// Whitted's ray tracing (An Improved Illumination Model for Shaded Display, CACM 1980), iterative.
//
// Before including this header the device defines, in the kernel's namespace:
//   Hit trace_closest(SCENE Ray ray, mask alive, word ray_kind, bool together)
//     the nearest hit in (t_min, t_max); geometry NONE on a miss
//   mask trace_any(SCENE Ray ray, mask alive, word ray_kind)
//     true where anything, opaque or not, lies in between
// Where SUNDOG_KERNEL_SHORTCUTS is defined, trace_closest takes one argument more: what is known of the hits beforehand
// (SceneView::eye_hits), or null; and there is
//   mask unknown_shadows(SCENE uint light, real3 origin, word primitive, mask lit, OUT(mask) dark)
//     what is left of `lit` by what is known of a light's shadows (SceneView::light_cells); dark: known not to be lit
// ray_kind is one of RAY_*; the lanes' rays start or end close together where `together` says so. Lanes that aren't
// alive may return anything.
#ifndef SUNDOG_KERNEL_INTEGRATORS_WHITTED_H
#define SUNDOG_KERNEL_INTEGRATORS_WHITTED_H

#include "kernel/atmosphere/sky.h"
#include "kernel/integrators/air.h"
#include "kernel/integrators/path.h"
#include "kernel/integrators/record.h"
#include "kernel/integrators/seen_through.h"
#include "kernel/integrators/surface_met.h"
#include "kernel/lights/direct.h"
#ifdef KERNEL_MEDIA
#include "kernel/integrators/media.h"
#endif
#ifdef __cplusplus
#include "kernel/integrators/nested.h"
#include "kernel/lights/indirect.h"
#include "kernel/lights/photon_light.h"
#include "kernel/lights/subsurface.h"
#endif

KERNEL_BEGIN

/// What comes back along the ray of `path`, times its weight, as the scene's numbers have it: before working_gamma.
///
/// On a chain of mirrors with reflectances r_j and own colours c_j the sum is c_0 R_0 + r_0 c_1 R_1 + r_0 r_1 c_2 R_2 +
/// … with R_j = 1 - r_j, but R = 1 for the last: a surface whose secondary ray isn't followed (FrameParams::max_depth
/// or min_weight) counts whole, as if it were no mirror. Where a surface both reflects and refracts, the refracted ray
/// waits on a stack of MAX_BRANCHES entries; when that is full, only the stronger of the two is followed. Highlights
/// sit on the surface: transparency doesn't thin them. Textures of layers add what they reflect and let through to
/// their own light, which counts whole at any depth, as POV-Ray has it.
FN_RECURSIVE real3 path_radiance(SCENE PathState path, INOUT(RayCounts) counts, OUT(FirstHit) first,
                                 OUT(PathRecord) record) {
    real3 black = real3(real(0.0f));
    real3 radiance = black;
    PathState waiting[MAX_BRANCHES];
    uint waiting_count = 0u;
    first = nothing_met();
    if (RECORDING) record = blank_record();
    real3 from_first = black;
    bool is_first = true;
    while (true) {
        counts.rays = counts.rays + select(path.alive, word(1u), word(0u));
#ifdef SUNDOG_KERNEL_SHORTCUTS
        bool from_eye = is_first && path.nesting == 0u;
        Hit hit = trace_closest(SCENE_ path.ray, path.alive, path.kind, is_first, from_eye ? scene.eye_hits : nullptr);
#else
        Hit hit = trace_closest(SCENE_ path.ray, path.alive, path.kind, is_first);
#endif
        mask found = mask_and(path.alive, hit.geometry != word(NONE));
        mask missed = mask_and(path.alive, hit.geometry == word(NONE));
        real reach = select(found, hit.t, real(3.0e38f));
#ifdef KERNEL_MEDIA
        if (FEATURE(FEATURE_MEDIA)) {
            radiance = radiance + media_radiance(SCENE_ path.ray, reach, path.media, path.alive, path.weight, counts);
        }
#endif
        cross_fog(SCENE_ path.ray, reach, path.media, path.alive, path.weight, radiance);
        if (any_lane(missed))
            radiance = radiance + select(missed, path.weight * background_radiance(SCENE_ path.ray.direction), black);
        if (RECORDING) record_miss(SCENE_ missed, record);
        mask follow = mask_and(found, mask_not(found));
        if (any_lane(found)) {
            real spectrum = real(0.5f);
#ifdef __cplusplus
            if (FEATURE(FEATURE_DISPERSION)) spectrum = select(path.spectrum < real(0.0f), spectrum, path.spectrum);
#endif
            Surface s;
            Lobes lobes;
            LayerColors layered;
            Crossing crossing;
            real3 smooth_normal;
            real3 dimmed = surface_met(SCENE_ path.ray, hit, path.insides, spectrum, found, s, lobes, layered, crossing,
                                       smooth_normal);
            path.weight = path.weight * dimmed;
            real3 base;
            real3 highlight;
            LightStates states;
            direct_light(SCENE_ s, lobes, layered, -path.ray.direction, path.media, found, counts, base, highlight,
                         states);
#ifdef __cplusplus
            if (FEATURE(FEATURE_PHOTONS))
                photon_light(SCENE_ s, lobes, layered, -path.ray.direction, found, base, highlight);
            if (FEATURE(FEATURE_SUBSURFACE)) {
                mask spread;
                base = base + subsurface_light(SCENE_ s, lobes, layered, path.ray.direction, path.kind, path.media,
                                               path.weight, mask_and(found, mask_not(crossing.leaves)), counts, spread);
                if (RECORDING) record_unlike(spread, record);
            }
            if (FEATURE(FEATURE_RADIOSITY))
                base = base + indirect_light(SCENE_ s, smooth_normal, lobes, path.weight, found);
#endif
            if (is_first && (RECORDING || FRAME.aovs != 0u)) {
                first.t = select(found, hit.t, first.t);
                first.normal = select(found, s.normal, black);
                first.albedo = select(found, lobes.albedo, black);
                first.geometry = select(found, s.geometry, word(NONE));
                first.primitive = select(found, s.primitive, word(NONE));
                first.material = select(found, s.material, word(NONE));
                if (!RECORDING && FEATURE(FEATURE_VEILS) && WANTS_AOV(AOV_BEYOND))
                    see_through(SCENE_ path, s, lobes, crossing, hit.t, found, counts, first);
            }
            if (FEATURE(FEATURE_MIRRORS | FEATURE_TRANSPARENT)) {
                // Straight on where eta is 1, to the last bit.
                mask straight = mask_and(lobes.patterned, abs(lobes.eta - 1.0f) <= real(0.0f));
                word deepest = word(FRAME.max_depth * DEPTH_UNITS);
                mask deeper = mask_and(found, path.depth < deepest);
                mask deeper_on = mask_and(found, path.depth < select(straight, deepest + word(DEPTH_UNITS), deepest));
                real3 reflected = path.weight * lobes.reflectance;
                real3 transmitted = path.weight * lobes.transmittance;
                real reflected_most = largest(reflected);
                real transmitted_most = largest(transmitted);
                mask reflects =
                    mask_and(mask_and(deeper, reflected_most > real(0.0f)), reflected_most >= real(FRAME.min_weight));
                mask transmits = mask_and(mask_and(deeper_on, transmitted_most > real(0.0f)),
                                          transmitted_most >= real(FRAME.min_weight));
#ifdef __cplusplus
                if (FEATURE(FEATURE_EXPONENTS)) {
                    mask bent = mask_and(reflects, abs(lobes.exponent - 1.0f) > real(0.0f));
                    if (any_lane(bent) && path.nesting < MAX_NESTING) {
                        if (RECORDING) record_unlike(bent, record);
                        radiance = radiance + exponent_radiance(SCENE_ path, s, lobes, bent, counts);
                        reflects = mask_and(reflects, mask_not(bent));
                    }
                }
                if (FEATURE(FEATURE_DISPERSION)) {
                    mask split = mask_and(transmits, path.spectrum < real(0.0f));
                    split = disperses(SCENE_ s, lobes, split);
                    if (any_lane(split) && path.nesting < MAX_NESTING) {
                        if (RECORDING) record_unlike(split, record);
                        radiance = radiance + dispersed_radiance(SCENE_ path, s, lobes, crossing, split, counts);
                        transmits = mask_and(transmits, mask_not(split));
                    }
                }
#endif
                mask both = mask_and(reflects, transmits);
                if (waiting_count == MAX_BRANCHES) {
                    mask drop_reflected = mask_and(both, reflected_most < transmitted_most);
                    mask drop_transmitted = mask_and(both, mask_not(drop_reflected));
                    reflects = mask_and(reflects, mask_not(drop_reflected));
                    transmits = mask_and(transmits, mask_not(drop_transmitted));
                    both = mask_and(both, mask_not(both));
                }
                real3 r = select(reflects, lobes.reflectance, black);
                real3 t = select(transmits, lobes.transmittance, black);
                real3 one = real3(real(1.0f));
                real3 thinned = base * max(one - r - t, black) + highlight * (one - r);
                real3 own = select(lobes.patterned, base + highlight, thinned);
                if (RECORDING) {
                    real3 share = select(lobes.patterned, one, max(one - r - t, black));
                    record_surface(SCENE_ s, lobes, states, base, share, path.weight, found, is_first, record);
                }
                radiance = radiance + select(found, path.weight * own, black);

                follow = mask_or(reflects, transmits);
                if (any_lane(follow)) {
                    word reflected_depth = path.depth + word(DEPTH_UNITS);
                    word transmitted_depth = path.depth + select(straight, word(1u), word(DEPTH_UNITS));
                    Insides behind_insides = path.insides;
                    if (FEATURE(FEATURE_PATTERNED | FEATURE_BODIES)) behind_insides = crossing.behind;
                    real3 incoming = path.ray.direction;
                    Ray next = mirrored_ray(s, incoming);
                    if (FEATURE(FEATURE_TRANSPARENT)) {
                        if (any_lane(transmits)) {
                            real3 refracted_direction;
                            mask passes = refract_direction(incoming, s.normal, lobes.eta, refracted_direction);
                            // Straight on where eta is 1, to the last bit, and where rounding says "total" but Fresnel
                            // did not.
                            mask bends = mask_and(passes, abs(lobes.eta - 1.0f) > real(0.0f));
                            refracted_direction = select(bends, normalize(refracted_direction), incoming);
                            real3 behind = s.position - s.geometric_normal * s.error;
                            MediaInsides beyond = path.media;
                            if (FEATURE(FEATURE_HOLLOW)) beyond = media_beyond(SCENE_ s, beyond, transmits);
                            if (any_lane(both)) {
                                PathState branch = path;
                                branch.ray.origin = behind;
                                branch.ray.direction = refracted_direction;
                                branch.ray.t_min = real(0.0f);
                                branch.ray.t_max = real(3.0e38f);
                                branch.weight = transmitted;
                                branch.depth = transmitted_depth;
                                branch.insides = behind_insides;
                                branch.media = beyond;
                                branch.alive = both;
                                waiting[waiting_count] = branch;
                                waiting_count = waiting_count + 1u;
                            }
                            next.origin = select(reflects, next.origin, behind);
                            next.direction = select(reflects, next.direction, refracted_direction);
                            for (uint i = 0u; i < MAX_MEDIA_INSIDES; i = i + 1u)
                                path.media.entry[i] = select(reflects, path.media.entry[i], beyond.entry[i]);
                        }
                    }
                    path.weight = select(reflects, reflected, transmitted);
                    path.depth = select(reflects, reflected_depth, transmitted_depth);
                    path.insides.inner = select(reflects, path.insides.inner, behind_insides.inner);
                    path.insides.outer = select(reflects, path.insides.outer, behind_insides.outer);
                    path.kind = select(reflects, word(RAY_REFLECTED), path.kind);
                    path.ray = next;
                }
            } else {
                radiance = radiance + select(found, path.weight * (base + highlight), black);
                if (RECORDING)
                    record_surface(SCENE_ s, lobes, states, base, real3(real(1.0f)), path.weight, found, is_first,
                                   record);
            }
        }
        if (RECORDING && is_first) from_first = radiance;
        path.alive = follow;
        is_first = false;
        if (!any_lane(follow)) {
            if (waiting_count == 0u) break;
            waiting_count = waiting_count - 1u;
            path = waiting[waiting_count];
        }
    }
    if (RECORDING) {
        record.beyond = luminance(radiance - from_first);
        record.rest = radiance - record.shade * first.albedo;
    }
    return radiance;
}

#ifdef __cplusplus
inline real3 nested_radiance(SCENE PathState path, INOUT(RayCounts) counts) {
    path.nesting = path.nesting + 1u;
    FirstHit unused;
    PathRecord forgotten;
    return path_radiance(SCENE_ path, counts, unused, forgotten);
}
#endif

#ifdef __cplusplus
/// The colour of the texture that `ray` meets first, and that surface's number (PathRecord::surface; 0: it has none).
FN real3 texture_along(SCENE Ray ray, mask alive, OUT(word) surface) {
    Hit hit = trace_closest(SCENE_ ray, alive, word(RAY_CAMERA), true);
    mask found = mask_and(alive, hit.geometry != word(NONE));
    surface = word(0u);
    if (!any_lane(found)) return real3(real(0.0f));
    Surface s = surface_at(SCENE_ ray, hit, found);
    Lobes lobes = evaluate_material(SCENE_ s, ray.direction);
    LayerColors layered;
    if (FEATURE(FEATURE_PATTERNED)) evaluate_layers(SCENE_ s, ray.direction, found, mask(false), false, lobes, layered);
    surface = select(found, object_number(s.geometry, s.material), word(0u));
    return lobes.albedo;
}
#endif

/// Linear radiance that comes back along `ray` in the lanes of `alive` (0 in others), and, if RECORDING, what it
/// remembers.
FN real3 recorded_radiance(SCENE Ray ray, mask alive, INOUT(RayCounts) counts, OUT(FirstHit) first,
                           OUT(PathRecord) record) {
    PathState path;
    path.ray = ray;
    path.weight = real3(real(1.0f));
    path.depth = word(0u);
    path.kind = word(RAY_CAMERA);
    path.media = eye_insides(SCENE_ alive);
    path.alive = alive;
    path.insides = insides_of_eye(SCENE_ alive);
#ifdef __cplusplus
    path.kind = word(scene.first_ray_kind);
    path.spectrum = real(-1.0f);
    path.nesting = 0u;
#endif
    return linear_light(SCENE_ path_radiance(SCENE_ path, counts, first, record));
}

/// The same without a memory.
FN real3 whitted_radiance(SCENE Ray ray, mask alive, INOUT(RayCounts) counts, OUT(FirstHit) first) {
    PathRecord forgotten;
    return recorded_radiance(SCENE_ ray, alive, counts, first, forgotten);
}

KERNEL_END

#endif
