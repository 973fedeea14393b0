// SPDX-License-Identifier: Apache-2.0
// Reflection models behind one door: value, density, direction. Vectors are local to the shading frame, unit, and point
// away from the surface; `to_eye` is on the side of z.
#ifndef SUNDOG_KERNEL_BSDF_BSDF_H
#define SUNDOG_KERNEL_BSDF_BSDF_H

#include "kernel/bsdf/beckmann.h"
#include "kernel/bsdf/blinn_phong.h"
#include "kernel/bsdf/cook_torrance.h"
#include "kernel/bsdf/oren_nayar.h"
#include "kernel/bsdf/phong.h"
#include "kernel/bsdf/principled.h"
#include "kernel/bsdf/ward.h"

KERNEL_BEGIN

/// A reflection model at a point: its numbers, as the kinds use them.
struct BsdfPoint {
    real3 color;
    real alpha_x, alpha_y;  ///< Roughnesses; an exponent (Phong, Blinn-Phong), sigma (Oren-Nayar).
    real3 n, k;             ///< A metal's index of refraction.
    real eta;               ///< Of dielectrics: on the eye's side over that on the other.
    Principled principled;
};

/// BSDF times the absolute cosine, and the density over solid angle with which bsdf_direction() draws the direction,
/// for a kind (BSDF_*) that all lanes have.
FN void bsdf_value(SCENE uint kind, BsdfPoint p, real3 to_eye, real3 to_light, OUT(real3) value, OUT(real) density) {
    real3 black = real3(real(0.0f));
    value = black;
    density = real(0.0f);
    if (kind == BSDF_PRINCIPLED) {
        principled_value(SCENE_ p.principled, to_eye, to_light, value, density);
        return;
    }
    real3 h = to_eye + to_light;
    h = h * (1.0f / sqrt(max(dot(h, h), real(1e-20f))));
    real eye_half = dot(to_eye, h);
    mask seen = mask_and(to_light.z > real(0.0f), to_eye.z > real(0.0f));
    if (kind == BSDF_OREN_NAYAR) {
        value = p.color * oren_nayar_value(to_eye, to_light, p.alpha_x);
        density = lambert_density(to_light);
    } else if (kind == BSDF_PHONG) {
        value = p.color * phong_value(to_eye, to_light, p.alpha_x);
        density = phong_density(to_eye, to_light, p.alpha_x);
    } else if (kind == BSDF_BLINN_PHONG) {
        value = p.color * blinn_phong_value(to_eye, to_light, p.alpha_x);
        density = blinn_phong_density(to_eye, to_light, p.alpha_x);
    } else if (kind == BSDF_WARD) {
        value = p.color * ward_value(to_eye, to_light, p.alpha_x, p.alpha_y);
        density = ward_density(to_eye, to_light, p.alpha_x, p.alpha_y);
    } else if (kind == BSDF_COOK_TORRANCE) {
        value = fresnel_conductor(eye_half, p.n, p.k) * p.color * cook_torrance_value(to_eye, to_light, h, p.alpha_x);
        density = cook_torrance_density(to_eye, h, p.alpha_x);
    } else if (kind == BSDF_BECKMANN) {
        value =
            fresnel_conductor(eye_half, p.n, p.k) * p.color * beckmann_value(to_eye, to_light, h, p.alpha_x, p.alpha_y);
        density = beckmann_density(to_eye, h, p.alpha_x, p.alpha_y);
    } else if (kind == BSDF_CONDUCTOR) {
        value = fresnel_conductor(eye_half, p.n, p.k) * p.color * ggx_value(to_eye, to_light, h, p.alpha_x, p.alpha_y);
        density = ggx_density(to_eye, h, p.alpha_x, p.alpha_y);
    } else if (kind == BSDF_DIELECTRIC) {
        real f = fresnel_dielectric(eye_half, p.eta);
        value = p.color * (f * ggx_value(to_eye, to_light, h, p.alpha_x, p.alpha_y));
        density = f * ggx_density(to_eye, h, p.alpha_x, p.alpha_y);
        mask behind = to_light.z < real(0.0f);
        if (any_lane(behind)) {
            real3 facet = refracting_facet(to_eye, to_light, p.eta);
            real passes = 1.0f - fresnel_dielectric(dot(to_eye, facet), p.eta);
            real through = rough_refraction_value(to_eye, to_light, facet, p.eta, p.alpha_x, p.alpha_y);
            real drawn = rough_refraction_density(to_eye, to_light, facet, p.eta, p.alpha_x, p.alpha_y);
            value = select(behind, p.color * (passes * through), value);
            density = select(behind, passes * drawn, density);
        }
        seen = mask_and(to_eye.z > real(0.0f), abs(to_light.z) > real(0.0f));
    }
    value = select(seen, value * abs(to_light.z), black);
    density = select(seen, density, real(0.0f));
}

/// A direction of some kind's, drawn by `u` and, where there are several ways, `choice`; zero, or below the surface,
/// where the one drawn leads nowhere.
FN real3 bsdf_direction(SCENE uint kind, BsdfPoint p, real3 to_eye, real2 u, real choice) {
    if (kind == BSDF_PRINCIPLED) return principled_direction(SCENE_ p.principled, to_eye, u, choice);
    if (kind == BSDF_OREN_NAYAR) return lambert_direction(u);
    if (kind == BSDF_PHONG) return phong_direction(to_eye, p.alpha_x, u);
    if (kind == BSDF_BLINN_PHONG) return blinn_phong_direction(to_eye, p.alpha_x, u);
    if (kind == BSDF_WARD) return ward_direction(to_eye, p.alpha_x, p.alpha_y, u);
    if (kind == BSDF_COOK_TORRANCE) return cook_torrance_direction(to_eye, p.alpha_x, u);
    real3 h;
    if (kind == BSDF_BECKMANN) h = beckmann_normal(to_eye, p.alpha_x, p.alpha_y, u);
    else h = ggx_normal(to_eye, p.alpha_x, p.alpha_y, u);
    real eye_half = dot(to_eye, h);
    real3 mirrored = h * (2.0f * eye_half) - to_eye;
    if (kind != BSDF_DIELECTRIC) return mirrored;
    real3 refracted;
    refract_direction(-to_eye, h, p.eta, refracted);
    mask reflects = choice < fresnel_dielectric(eye_half, p.eta);
    mask right_side = select_mask(reflects, mirrored.z > real(0.0f), refracted.z < real(0.0f));
    return select(right_side, select(reflects, mirrored, refracted), real3(real(0.0f)));
}

KERNEL_END

#endif
