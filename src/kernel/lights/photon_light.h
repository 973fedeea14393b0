// SPDX-License-Identifier: Apache-2.0
// Light that mirrors and lenses threw somewhere. The CPU's alone; shaders never see this header.
#ifndef SUNDOG_KERNEL_LIGHTS_PHOTON_LIGHT_H
#define SUNDOG_KERNEL_LIGHTS_PHOTON_LIGHT_H

#include "kernel/lights/direct.h"
#include "kernel/lights/indirect.h"
#include "kernel/lights/photon_query.h"

KERNEL_BEGIN

/// A query at `position` for the lanes of `wanted`.
inline void set_photon_query(real3 position, mask wanted, PhotonQuery& query) {
    query.lanes = static_cast<int>(sizeof(real) / sizeof(float));  // NOLINT(bugprone-sizeof-expression): or is a float
    store_lanes(select(wanted, word(1u), word(0u)), query.wanted);
    store_lanes(position.x, query.x);
    store_lanes(position.y, query.y);
    store_lanes(position.z, query.z);
}
FN real3 photon_answer(const PhotonQuery& query) {
    return real3(load_lanes(query.red), load_lanes(query.green), load_lanes(query.blue));
}
FN real3 photon_source(const PhotonQuery& query) {
    return real3(load_lanes(query.from_x), load_lanes(query.from_y), load_lanes(query.from_z));
}

/// Adds what photons do that arrive on one side of the surfaces of `wanted`: as povray's pictures show, they light by
/// all of the finish, highlights too, like a light that stands where they came from.
inline void add_photons(SCENE LARGE(Surface) s, LARGE(Lobes) lobes, LARGE(LayerColors) layered, real3 to_eye,
                        real3 side, mask behind, mask wanted, INOUT(real3) base, INOUT(real3) highlight) {
    if (!any_lane(wanted)) return;
    PhotonQuery query;
    set_photon_query(s.position, wanted, query);
    store_lanes(side.x, query.normal_x);
    store_lanes(side.y, query.normal_y);
    store_lanes(side.z, query.normal_z);
    scene.photons->on_surface(query);
    real3 flux = photon_answer(query);
    real3 to_light = photon_source(query);
    real facing = dot(side, to_light);
    real3 amount = abs(flux);
    mask lit = mask_and(wanted, mask_and(largest(amount) > real(0.0f), facing > real(0.0f)));
    lit = mask_and(lit, mask_or(lobes.patterned, dot(s.normal, to_light) > real(0.0f)));
    if (!any_lane(lit)) return;
    // What surfaces answer is times the cosine; flux per area has that in it already. Near grazing, where a few
    // directions' mean says little, it stays bounded.
    real3 color = flux * (1.0f / max(facing, real(0.02f)));
    add_light(SCENE_ s, lobes, layered, color, LIGHT_HIGHLIGHTS, FRAME.light_count, lit, mask_and(behind, lit),
              to_light, to_eye, base, highlight);
}

/// Adds the light of photons to what direct_light() says of the surfaces of `alive`.
inline void photon_light(SCENE LARGE(Surface) s, LARGE(Lobes) lobes, LARGE(LayerColors) layered, real3 to_eye,
                         mask alive, INOUT(real3) base, INOUT(real3) highlight) {
    mask collects = (FIELD(geometries, s.geometry, photons) & word(PHOTONS_COLLECT)) != word(0u);
    mask wanted = mask_and(alive, collects);
    mask nowhere = mask_and(alive, mask_not(alive));
    add_photons(SCENE_ s, lobes, layered, to_eye, s.geometric_normal, nowhere, wanted, base, highlight);
    if (FEATURE(FEATURE_BACKLIT)) {
        mask backlit = (FIELD(materials, s.material, flags) & word(MATERIAL_BACKLIT)) != word(0u);
        mask behind = mask_and(wanted, backlit);
        add_photons(SCENE_ s, lobes, layered, to_eye, -s.geometric_normal, behind, behind, base, highlight);
    }
}

KERNEL_END

#endif
