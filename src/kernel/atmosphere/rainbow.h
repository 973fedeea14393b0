// SPDX-License-Identifier: Apache-2.0
#ifndef SUNDOG_KERNEL_ATMOSPHERE_RAINBOW_H
#define SUNDOG_KERNEL_ATMOSPHERE_RAINBOW_H

#include "kernel/patterns/program.h"

KERNEL_BEGIN

/// Rainbows, in `code` from `at` on: a share of a ray of this length gives way to their colours (POV-Ray's reference,
/// section 3.4.3.5 "Rainbow"). Dims `weight` and returns what they add to the radiance that it carries. Where several
/// stand at one place, theirs is the mean, as in povray; and they dim what is behind by the share 1/e over `distance`,
/// but by no more than the colour's transmit, which rises to 1 where an arc fades out.
FN real3 rainbow_radiance(SCENE uint at, Ray ray, real distance, INOUT(real3) weight) {
    real3 black = real3(real(0.0f));
    real3 glow = black;
    real3 passing = black;
    real hits = real(0.0f);
    real reach = min(distance, real(RAY_FAR));
    for (uint i = 0u; i < AT(code, at); i = i + 1u) {
        uint bow = at + 1u + i * RAINBOW_WORDS;
        real3 axis = real3(code_vec3(SCENE_ bow));
        real cosine = dot(ray.direction, axis);
        real3 aside = ray.direction - axis * cosine;
        real off_axis = length(aside);
        real place = (angle_of(off_axis, cosine) - code_float(SCENE_ bow + 6u)) * code_float(SCENE_ bow + 7u) + 0.5f;
        float jitter = code_float(SCENE_ bow + 9u);
        if (jitter > 0.0f) place = place + (2.0f * random_at(ray.direction, word(i)) - 1.0f) * jitter;
        mask hit = mask_and(real(0.0f) <= place, place <= real(1.0f));
        // The angle around the axis, from `up`, and how much of the arc is there.
        real upward = dot(aside, real3(code_vec3(SCENE_ bow + 3u)));
        real turned = angle_of(sqrt(max(off_axis * off_axis - upward * upward, real(0.0f))), upward);
        float arc = code_float(SCENE_ bow + 10u);
        float full = code_float(SCENE_ bow + 11u);
        real share = clamp((arc - turned) * (1.0f / max(arc - full, 1e-6f)), real(0.0f), real(1.0f));
        share = share * share * (3.0f - 2.0f * share);
        hit = mask_and(hit, share > real(0.0f));
        if (!any_lane(hit)) continue;
        // Short of 1, where a gradient begins again.
        PigmentColor c =
            run_program(SCENE_ AT(code, bow + 12u), real3(min(place, real(0.999999f)), real(0.0f), real(0.0f)));
        real clear = exp2_clamped(reach * (-1.44269504f / max(code_float(SCENE_ bow + 8u), 1e-20f)));
        clear = max(clear, 1.0f - share * (1.0f - c.transmitted));
        real tinted = c.filtered * (1.0f - clear);
        real3 passes = (real3(1.0f - tinted) + c.rgb * tinted) * clear;
        glow = glow + select(hit, c.rgb * (1.0f - clear), black);
        passing = passing + select(hit, passes, black);
        hits = hits + select(hit, real(1.0f), real(0.0f));
    }
    mask any_hit = hits > real(0.0f);
    real mean = 1.0f / max(hits, real(1.0f));
    real3 added = select(any_hit, weight * glow * mean, black);
    weight = select(any_hit, weight * passing * mean, weight);
    return added;
}

KERNEL_END

#endif
