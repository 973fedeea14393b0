// SPDX-License-Identifier: Apache-2.0
// Geometry of reflection: Lambert, Phong, Blinn-Phong, mirror, Snell, Fresnel. All vectors are unit and point away from
// the surface, unless said otherwise.
#ifndef SUNDOG_KERNEL_MATERIALS_REFLECTION_H
#define SUNDOG_KERNEL_MATERIALS_REFLECTION_H

#include "kernel/math.h"
#include "kernel/rays.h"

KERNEL_BEGIN

/// Lambert's cosine law (1760): share of a light's colour that a matt surface gets.
FN real lambert(real3 normal, real3 to_light) { return max(dot(normal, to_light), real(0.0f)); }

/// Direction of a ray `incoming` (towards the surface) after a mirror.
FN real3 mirror_direction(real3 incoming, real3 normal) { return incoming - normal * (2.0f * dot(normal, incoming)); }

/// Phong's highlight (1975): cosine between the mirrored view ray and the light, to the power of shininess.
FN real phong_highlight(real3 normal, real3 to_light, real3 to_eye, real shininess) {
    real3 mirrored = normal * (2.0f * dot(normal, to_eye)) - to_eye;
    return power(max(dot(mirrored, to_light), real(0.0f)), shininess);
}

/// Blinn's highlight (1977): cosine between the normal and the halfway vector, to the power of shininess.
FN real blinn_phong_highlight(real3 normal, real3 to_light, real3 to_eye, real shininess) {
    real3 halfway = to_light + to_eye;
    real length_squared = max(dot(halfway, halfway), real(1e-30f));
    return power(max(dot(normal, halfway), real(0.0f)) / sqrt(length_squared), shininess);
}

/// Snell's law: direction of a ray `incoming` (towards the surface) behind it; eta is the index of refraction in front
/// over the one behind. False in lanes of total internal reflection, where the direction is meaningless.
FN mask refract_direction(real3 incoming, real3 normal, real eta, OUT(real3) refracted) {
    real cos_in = -dot(normal, incoming);
    real sin2_out = eta * eta * max(1.0f - cos_in * cos_in, real(0.0f));
    real cos_out = sqrt(max(1.0f - sin2_out, real(0.0f)));
    refracted = incoming * eta + normal * (eta * cos_in - cos_out);
    return sin2_out < real(1.0f);
}

/// True where nothing is refracted: only from the denser side. A grazing ray that no surface bends goes on.
FN mask is_total_reflection(real cos_in, real eta) {
    return mask_and(eta > real(1.0f), eta * eta * (1.0f - cos_in * cos_in) >= real(1.0f));
}

/// Unpolarised Fresnel reflectance of a dielectric (Born and Wolf, section 1.5); eta as above; 1 at total internal
/// reflection, 0 at every angle where eta is 1.
FN real fresnel_dielectric(real cos_in, real eta) {
    real c = min(abs(cos_in), real(1.0f));
    real sin2_out = eta * eta * (1.0f - c * c);
    mask total = is_total_reflection(c, eta);
    real cos_out = sqrt(max(1.0f - sin2_out, real(0.0f)));
    real parallel = (c - eta * cos_out) / (c + eta * cos_out);
    real perpendicular = (eta * c - cos_out) / (eta * c + cos_out);
    real partial =
        select(abs(eta - 1.0f) > real(0.0f), (parallel * parallel + perpendicular * perpendicular) * 0.5f, real(0.0f));
    return select(total, real(1.0f), partial);
}

/// Schlick's approximation (1994) for an opaque surface of reflectance r0 at normal incidence.
FN real3 fresnel_schlick(real3 r0, real cos_in) {
    real m = clamp(1.0f - cos_in, real(0.0f), real(1.0f));
    real m2 = m * m;
    real m5 = m2 * m2 * m;
    return r0 + (real3(real(1.0f)) - r0) * m5;
}

KERNEL_END

#endif
