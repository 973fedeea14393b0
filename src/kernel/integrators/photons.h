// SPDX-License-Identifier: Apache-2.0
// The way of photons from a light through mirrors and lenses (Jensen, Global Illumination using Photon Maps, 1996).
// Where a surface both reflects and refracts, a photon becomes two. The device defines trace_closest first (see
// integrators/whitted.h). C++ only.
#ifndef SUNDOG_KERNEL_INTEGRATORS_PHOTONS_H
#define SUNDOG_KERNEL_INTEGRATORS_PHOTONS_H

#include <array>

#include "kernel/integrators/nested.h"
#include "kernel/integrators/path.h"
#include "kernel/integrators/photon_shot.h"
#include "kernel/lights/photon_flags.h"
#include "kernel/lights/photon_light.h"
#include "kernel/materials/bump.h"

namespace sundog::kernel {

/// Photons that arrived somewhere, lane by lane.
struct PhotonArrivals {
    using Lanes = PhotonQuery::Lanes;
    int lanes = 0;                                       ///< Of the arrays' places, how many there are.
    std::array<uint, PhotonQuery::kMostLanes> stored{};  ///< 1 where there is one.
    Lanes x, y, z, direction_x, direction_y, direction_z, red, green, blue;
    Lanes normal_x, normal_y, normal_z;  ///< Unit, of a surface, on the side that the photon came to; zero in media.
};

/// Takes photons. One for each call of follow_photons().
class PhotonSink {
public:
    PhotonSink() = default;
    PhotonSink(const PhotonSink&) = delete;
    PhotonSink& operator=(const PhotonSink&) = delete;
    virtual ~PhotonSink() = default;
    virtual void on_surface(const PhotonArrivals& arrivals) = 0;
    virtual void in_medium(const PhotonArrivals& arrivals) = 0;
};

}  // namespace sundog::kernel

KERNEL_BEGIN

/// Photons under way.
struct PhotonPaths {
    PathState path;  ///< `weight`: what is left of the power that they started with.
    real travelled;  ///< Length of the way from the light.
};

/// a where m, else b; of rays that start at one surface.
FN PhotonPaths chosen(mask m, PhotonPaths a, PhotonPaths b) {
    PhotonPaths p = b;
    p.path.ray.origin = select(m, a.path.ray.origin, b.path.ray.origin);
    p.path.ray.direction = select(m, a.path.ray.direction, b.path.ray.direction);
    p.path.weight = select(m, a.path.weight, b.path.weight);
    p.path.insides.inner = select(m, a.path.insides.inner, b.path.insides.inner);
    p.path.insides.outer = select(m, a.path.insides.outer, b.path.insides.outer);
    for (uint i = 0u; i < MAX_MEDIA_INSIDES; i = i + 1u)
        p.path.media.entry[i] = select(m, a.path.media.entry[i], b.path.media.entry[i]);
    return p;
}

/// Flux that a photon stands for after a way: lights don't grow dimmer with distance unless they fade, whatever stands
/// in between, as in povray. So what spreads from a point grows with the square of its way.
FN real photon_growth(Light light, real travelled) {
    real growth = real(1.0f);
    if (light.kind == LIGHT_LAMP || light.kind == LIGHT_SPOT) growth = travelled * travelled;
    Light fading = light;
    fading.kind = LIGHT_LAMP;
    if (light.kind == LIGHT_SUN) return growth;
    real3 unused = real3(real(0.0f));
    return growth * light_share(fading, unused, unused, travelled);
}

/// Hands photons at `place` to the sink.
inline void put_photons(real3 place, real3 direction, real3 normal, real3 power, mask stored,
                        PhotonArrivals& arrivals) {
    arrivals.lanes = static_cast<int>(sizeof(real) / sizeof(float));  // NOLINT(bugprone-sizeof-expression)
    store_lanes(select(stored, word(1u), word(0u)), arrivals.stored);
    store_lanes(place.x, arrivals.x);
    store_lanes(place.y, arrivals.y);
    store_lanes(place.z, arrivals.z);
    store_lanes(direction.x, arrivals.direction_x);
    store_lanes(direction.y, arrivals.direction_y);
    store_lanes(direction.z, arrivals.direction_z);
    store_lanes(normal.x, arrivals.normal_x);
    store_lanes(normal.y, arrivals.normal_y);
    store_lanes(normal.z, arrivals.normal_z);
    store_lanes(power.x, arrivals.red);
    store_lanes(power.y, arrivals.green);
    store_lanes(power.z, arrivals.blue);
}

/// Stores photons along a stretch of the ray in media that scatter light, if any of them collects photons.
inline void store_in_media(SCENE Light light, PhotonShot shot, real3 power, PhotonPaths p, real distance,
                           PhotonSink& sink) {
    real end = min(distance, real(RAY_FAR));
    mask todo = mask_and(p.path.alive, end > real(0.0f));
    while (any_lane(todo)) {
        MediaGroup group;
        mask here = take_alike(SCENE_ p.path.media, FRAME.atmosphere != NONE, todo, group);
        if (group.count == 0u || !group.scatters || !group.collects) continue;
        // As many as there may be, further apart where they would be more. Endless ways have them near the begin.
        real step = real(shot.media_step);
        real spread = min(end, real(shot.media_step * 64.0f * float(shot.media_steps)));
        step = max(step, spread * (1.0f / float(shot.media_steps)));
        real3 passes = real3(real(1.0f));
        Scatterers scatterers;
        real at = step * random_at(p.path.ray.direction, word(7u));
        mask going = mask_and(here, at < end);
        for (uint i = 0u; i < shot.media_steps && any_lane(going); i = i + 1u) {
            real3 place = point_at(p.path.ray, at);
            real3 extinction = media_at(SCENE_ group, place, scatterers).extinction;
            real way = i == 0u ? at : step;
            passes = passes * dimmed_by(extinction * way);
            real grown = photon_growth(light, p.travelled + at) * step;
            PhotonArrivals arrivals;
            put_photons(place, p.path.ray.direction, real3(real(0.0f)), power * p.path.weight * passes * grown, going,
                        arrivals);
            sink.in_medium(arrivals);
            at = at + step;
            going = mask_and(going, at < end);
        }
    }
}

inline void follow_photons(SCENE Light light, PhotonShot shot, real3 power, PhotonPaths photons, bool first,
                           PhotonSink& sink, INOUT(RayCounts) counts, OUT(mask) met);

/// What passes through the surface in the lanes of `split`, one colour after the other.
FN_LARGE void follow_colors(SCENE Light light, PhotonShot shot, real3 power, PhotonPaths p, Surface s, Lobes lobes,
                            Crossing crossing, mask split, PhotonSink& sink, INOUT(RayCounts) counts) {
    word interior = interior_of(SCENE_ s, split);
    PhotonPaths ray = p;
    ray.path.depth = p.path.depth + word(1u);
    ray.path.nesting = p.path.nesting + 1u;
    Ray mirrored = mirrored_ray(s, p.path.ray.direction);
    MediaInsides beyond = p.path.media;
    if (FEATURE(FEATURE_HOLLOW)) beyond = media_beyond(SCENE_ s, beyond, split);
    mask todo = split;
    while (any_lane(todo)) {
        uint number = first_lane(todo, interior);
        mask here = mask_and(todo, interior == word(number));
        todo = mask_and(todo, mask_not(here));
        uint samples = AT(interiors, number).dispersion_samples;
        for (uint i = 0u; i < samples; i = i + 1u) {
            real place = real((float(i) + 0.5f) / float(samples));
            real eta = crossing_eta(SCENE_ crossing, interior, p.path.insides, place);
            real3 refracted;
            mask passes = refract_direction(p.path.ray.direction, s.normal, eta, refracted);
            ray.path.ray = mirrored;
            ray.path.ray.direction = select(passes, normalize(refracted), mirrored.direction);
            ray.path.ray.origin = select(passes, s.position - s.geometric_normal * s.error, mirrored.origin);
            ray.path.insides.inner = select(passes, crossing.behind.inner, p.path.insides.inner);
            ray.path.insides.outer = select(passes, crossing.behind.outer, p.path.insides.outer);
            for (uint k = 0u; k < MAX_MEDIA_INSIDES; k = k + 1u)
                ray.path.media.entry[k] = select(passes, beyond.entry[k], p.path.media.entry[k]);
            ray.path.weight = p.path.weight * lobes.transmittance * real3(spectrum_color(i, samples));
            ray.path.spectrum = place;
            ray.path.alive = here;
            mask unused;
            follow_photons(SCENE_ light, shot, power, ray, false, sink, counts, unused);
        }
    }
}

/// What photons see of a surface.
struct PhotonSurface {
    Surface s;
    Lobes lobes;
    Crossing crossing;
};

FN_LARGE PhotonSurface photon_surface(SCENE PathState path, Hit hit, mask found) {
    PhotonSurface at;
    at.s = surface_at(SCENE_ path.ray, hit, found);
    if (FEATURE(FEATURE_BUMP)) at.s.normal = bumped_normal(SCENE_ at.s);
    at.lobes = evaluate_material(SCENE_ at.s, path.ray.direction);
    at.crossing.leaves = mask_and(found, mask_not(found));
    at.crossing.behind = path.insides;
    if (FEATURE(FEATURE_PATTERNED)) {
        word interior = interior_of(SCENE_ at.s, at.lobes.patterned);
        at.crossing = crossing_at(interior, path.insides);
        real spectrum = real(0.5f);
        if (FEATURE(FEATURE_DISPERSION)) spectrum = select(path.spectrum < real(0.0f), spectrum, path.spectrum);
        real eta = crossing_eta(SCENE_ at.crossing, interior, path.insides, spectrum);
        at.lobes.eta = select(at.lobes.patterned, eta, at.lobes.eta);
        LayerColors layered;
        evaluate_layers(SCENE_ at.s, path.ray.direction, found, is_enclosed(at.crossing), false, at.lobes, layered);
        if (FEATURE(FEATURE_NORMALS)) at.s.normal = layered.mirror;
    }
    return at;
}

/// Lanes of `alive` whose light, if it is projected through an object, comes through that.
FN mask projected_lanes(SCENE Light light, Ray ray, mask alive) {
    if (light.projection == 0u) return alive;
    Hit window = trace_closest(SCENE_ ray, alive, word(light.projection), false);
    return mask_and(alive, window.geometry != word(NONE));
}

/// Follows photons to where they are stored: on surfaces that collect them, from the second one of their way on, and
/// in media likewise. `power` is theirs at the start, for a way of length 1 where it grows. If `first`, they come from
/// the light: those that meet anything but the target at first are dropped; `met` says which don't.
inline void follow_photons(SCENE Light light, PhotonShot shot, real3 power, PhotonPaths photons, bool first,
                           PhotonSink& sink, INOUT(RayCounts) counts, OUT(mask) met) {
    const real3 black = real3(real(0.0f));
    PhotonPaths p = photons;
    PhotonPaths waiting[MAX_BRANCHES];
    uint waiting_count = 0u;
    met = p.path.alive;
    while (true) {
        counts.rays = counts.rays + select(p.path.alive, word(1u), word(0u));
        Hit hit = trace_closest(SCENE_ p.path.ray, p.path.alive, word(first ? RAY_PHOTON : RAY_LATER_PHOTON), first);
        mask found = mask_and(p.path.alive, hit.geometry != word(NONE));
        word flags = FIELD(geometries, valid_index(found, hit.geometry), photons);
        if (first) {
            found = mask_and(found, (flags >> PHOTONS_TARGET_SHIFT) == word(shot.target));
            found = projected_lanes(SCENE_ light, p.path.ray, found);
        } else if (FEATURE(FEATURE_MEDIA) && shot.media_steps > 0u) {
            store_in_media(SCENE_ light, shot, power, p, select(found, hit.t, real(RAY_FAR)), sink);
        }
        if (FEATURE(FEATURE_MEDIA)) {
            bool attenuated = (light.flags & LIGHT_ATTENUATED) != 0u || !first;
            real3 passes = media_transmittance(SCENE_ p.path.ray, hit.t, p.path.media, attenuated, found);
            p.path.weight = select(found, p.path.weight * passes, p.path.weight);
        }
        mask follow = mask_and(found, mask_not(found));
        if (any_lane(found)) {
            if (FEATURE(FEATURE_PATTERNED) && FEATURE(FEATURE_TRANSPARENT)) {
                real3 dimmed = inside_transmittance(SCENE_ p.path.insides, hit.t);
                p.path.weight = select(found, p.path.weight * dimmed, p.path.weight);
            }
            PhotonSurface at = photon_surface(SCENE_ p.path, hit, found);
            if (FEATURE(FEATURE_LIGHT_GROUPS))
                found = mask_and(found, light_reaches(SCENE_ light.group, at.s.material, at.lobes.patterned));
            if (first) met = found;
            p.travelled = p.travelled + select(found, hit.t, real(0.0f));
            mask stored = mask_and(found, (flags & word(PHOTONS_COLLECT)) != word(0u));
            if (!first && any_lane(stored)) {
                PhotonArrivals arrivals;
                put_photons(at.s.position, p.path.ray.direction, at.s.geometric_normal,
                            power * p.path.weight * photon_growth(light, p.travelled), stored, arrivals);
                sink.on_surface(arrivals);
            }
            mask deeper = mask_and(found, p.path.depth < word(shot.max_depth));
            mask may_reflect = mask_and(deeper, photons_reflect(flags, light.flags));
            mask may_refract = mask_and(deeper, photons_refract(flags, light.flags));
            // What is thrown back because nothing gets through is a matter of refraction.
            real cos_in = -dot(at.s.normal, p.path.ray.direction);
            mask total = is_total_reflection(cos_in, at.lobes.eta);
            may_reflect = mask_or(may_reflect, mask_and(may_refract, total));
            real3 reflected = select(may_reflect, p.path.weight * at.lobes.reflectance, black);
            real3 transmitted = select(may_refract, p.path.weight * at.lobes.transmittance, black);
            real reflected_most = largest(reflected);
            real transmitted_most = largest(transmitted);
            real least = max(real(shot.min_weight), real(1e-20f));
            mask reflects = mask_and(may_reflect, reflected_most >= least);
            mask transmits = mask_and(may_refract, transmitted_most >= least);
            if (FEATURE(FEATURE_DISPERSION)) {
                mask split = disperses(SCENE_ at.s, at.lobes, mask_and(transmits, p.path.spectrum < real(0.0f)));
                if (any_lane(split) && p.path.nesting < MAX_NESTING) {
                    follow_colors(SCENE_ light, shot, power, p, at.s, at.lobes, at.crossing, split, sink, counts);
                    transmits = mask_and(transmits, mask_not(split));
                }
            }
            mask both = mask_and(reflects, transmits);
            if (waiting_count == MAX_BRANCHES) {
                mask drop_reflected = mask_and(both, reflected_most < transmitted_most);
                mask drop_transmitted = mask_and(both, mask_not(drop_reflected));
                reflects = mask_and(reflects, mask_not(drop_reflected));
                transmits = mask_and(transmits, mask_not(drop_transmitted));
                both = mask_and(both, mask_not(both));
            }
            follow = mask_or(reflects, transmits);
            if (any_lane(follow)) {
                PhotonPaths mirrored = p;
                mirrored.path.ray = mirrored_ray(at.s, p.path.ray.direction);
                mirrored.path.weight = reflected;
                mirrored.path.depth = p.path.depth + word(1u);
                PhotonPaths refracted = mirrored;
                real3 direction;
                mask passes = refract_direction(p.path.ray.direction, at.s.normal, at.lobes.eta, direction);
                mask bends = mask_and(passes, abs(at.lobes.eta - 1.0f) > real(0.0f));
                refracted.path.ray.direction = select(bends, normalize(direction), p.path.ray.direction);
                refracted.path.ray.origin = at.s.position - at.s.geometric_normal * at.s.error;
                refracted.path.weight = transmitted;
                refracted.path.insides = at.crossing.behind;
                if (FEATURE(FEATURE_HOLLOW)) refracted.path.media = media_beyond(SCENE_ at.s, p.path.media, transmits);
                if (any_lane(both)) {
                    waiting[waiting_count] = refracted;
                    waiting[waiting_count].path.alive = both;
                    waiting_count = waiting_count + 1u;
                }
                p = chosen(reflects, mirrored, refracted);
            }
        } else if (first) {
            met = found;
        }
        p.path.alive = follow;
        first = false;
        if (!any_lane(follow)) {
            if (waiting_count == 0u) return;
            waiting_count = waiting_count - 1u;
            p = waiting[waiting_count];
        }
    }
}

KERNEL_END

#endif
