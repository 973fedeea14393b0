// SPDX-License-Identifier: Apache-2.0
// Iridescence: a thin film's reflectance in red, green and blue (Belcour and Barla, A Practical Extension to Microfacet
// Theory for the Modeling of Varying Iridescence, SIGGRAPH 2017).
#ifndef SUNDOG_KERNEL_BSDF_THIN_FILM_H
#define SUNDOG_KERNEL_BSDF_THIN_FILM_H

#include "kernel/bsdf/fresnel.h"

KERNEL_BEGIN

/// How the eye's three matching functions answer to a spectrum that oscillates, by the difference of the ways in
/// nanometres and a phase in radians: their Fourier transforms as sums of Gaussians (the paper's equation 10 and its
/// constants), as linear sRGB.
FN real3 film_sensitivity(real way_nm, real shift) {
    real phase = way_nm * 6.28318531e-9f;
    real phase2 = phase * phase * -1.44269504f;
    real x = 5.4856e-13f * 164901.1f * cosine(1.6810e6f * phase + shift) * exp2_clamped(4.3278e9f * phase2);
    real y = 4.4201e-13f * 241790.3f * cosine(1.7953e6f * phase + shift) * exp2_clamped(9.3046e9f * phase2);
    real z = 5.2481e-13f * 203826.0f * cosine(2.2084e6f * phase + shift) * exp2_clamped(6.6121e9f * phase2);
    x = x + 9.7470e-14f * 168675.8f * cosine(2.2399e6f * phase + shift) * exp2_clamped(4.5282e9f * phase2);
    x = x * 9358914.4f;
    y = y * 9358914.4f;
    z = z * 9358914.4f;
    return real3(3.2404542f * x - 1.5371385f * y - 0.4985314f * z, 1.8760108f * y - 0.9692660f * x + 0.0415560f * z,
                 0.0556434f * x - 0.2040259f * y + 1.0572252f * z);
}

/// The index of refraction of a dielectric with reflectance f0 along the normal, under another one.
FN real index_behind(real f0, real outside) {
    real root = sqrt(min(max(f0, real(0.0f)), real(0.9999f)));
    return outside * (1.0f + root) / (1.0f - root);
}

FN real squared(real x) { return x * x; }

/// Reflectance of a film of index of refraction `film_ior` in air over a base of reflectance f0 along the normal.
FN real3 thin_film_reflectance(real cos_in, real film_ior, real thickness_nm, real3 base_f0) {
    // Where the film vanishes it becomes air.
    real fades = clamp(thickness_nm * (1.0f / 30.0f), real(0.0f), real(1.0f));
    real ior = mix(real(1.0f), film_ior, fades * fades * (3.0f - 2.0f * fades));
    real cos_first = clamp(cos_in, real(0.0f), real(1.0f));
    real sin2_film = (1.0f - cos_first * cos_first) / (ior * ior);
    real3 white = real3(real(1.0f));
    real cos2_film = 1.0f - sin2_film;
    real cos_film = sqrt(max(cos2_film, real(0.0f)));

    real f0 = squared((ior - 1.0f) / (ior + 1.0f));
    real r12 = f0 + (1.0f - f0) * power(1.0f - cos_first, real(5.0f));
    real t121 = 1.0f - r12;
    real phi21 = 3.14159265f - select(ior < real(1.0f), real(3.14159265f), real(0.0f));

    real3 behind = real3(index_behind(base_f0.x, real(1.0f)), index_behind(base_f0.y, real(1.0f)),
                         index_behind(base_f0.z, real(1.0f)));
    real3 r1 = real3(squared((behind.x - ior) / (behind.x + ior)), squared((behind.y - ior) / (behind.y + ior)),
                     squared((behind.z - ior) / (behind.z + ior)));
    real3 r23 = fresnel_between(r1, white, cos_film);
    real3 phi23 = real3(select(behind.x < ior, real(3.14159265f), real(0.0f)),
                        select(behind.y < ior, real(3.14159265f), real(0.0f)),
                        select(behind.z < ior, real(3.14159265f), real(0.0f)));

    real way = 2.0f * ior * thickness_nm * cos_film;
    real3 phi = real3(phi21) + phi23;
    real3 r123 = r23 * r12;
    r123 = min(max(r123, real3(real(1e-5f))), real3(real(0.9999f)));
    real3 root = real3(sqrt(r123.x), sqrt(r123.y), sqrt(r123.z));
    real3 between = white - r123;
    real3 rs = r23 * (t121 * t121);
    rs = real3(rs.x / between.x, rs.y / between.y, rs.z / between.z);

    real3 sum = real3(r12) + rs;
    real3 order = rs - real3(t121);
    for (uint m = 1u; m <= 2u; m = m + 1u) {
        order = order * root;
        float number = float(m);
        real3 seen_x = film_sensitivity(way * number, phi.x * number);
        real3 seen_y = film_sensitivity(way * number, phi.y * number);
        real3 seen_z = film_sensitivity(way * number, phi.z * number);
        sum = sum + order * real3(seen_x.x, seen_y.y, seen_z.z) * real(2.0f);
    }
    sum = min(max(sum, real3(real(0.0f))), white);
    return select(cos2_film < real(0.0f), white, sum);
}

KERNEL_END

#endif
