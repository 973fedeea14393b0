// SPDX-License-Identifier: Apache-2.0
// What media send along a ray: their own light and what they scatter of lights, with shadows. Samples stand where
// povray's do (reference, section 3.4.8.2.4 "Sampling Parameters & Methods"; the places are those that pictures of
// povray 3.7 show), and count as there.
#ifndef SUNDOG_KERNEL_INTEGRATORS_MEDIA_H
#define SUNDOG_KERNEL_INTEGRATORS_MEDIA_H

#include "kernel/atmosphere/media.h"
#include "kernel/atmosphere/scattering.h"
#include "kernel/lights/shadow.h"
#include "kernel/patterns/noise.h"
#ifdef __cplusplus
#include "kernel/lights/photon_light.h"
#endif

KERNEL_BEGIN

/// A stretch of a ray in the media of a group.
struct MediaRay {
    Ray ray;
    MediaInsides insides;
    MediaGroup group;
};

/// Radiance that comes out of media at a ray's start, and the share of what comes from behind that gets through.
struct MediaLight {
    real3 glow;
    real3 passes;
};

/// Stretches of a ray that spots and cylinders light, ascending and disjoint; some of them empty.
const uint MAX_LIT_STRETCHES = 16u;
struct LitStretches {
    uint count;
    real enters[MAX_LIT_STRETCHES];
    real leaves[MAX_LIT_STRETCHES];
};

/// Where a ray comes into a spot's cone or a cylinder light's cylinder and where it leaves, as far as it is in 0..end;
/// both `end` where it doesn't come through.
FN void light_boundaries(Light light, Ray ray, real end, OUT(real) enters, OUT(real) leaves) {
    real3 from_light = ray.origin - real3(light.place);
    real along = dot(from_light, real3(light.axis));
    real rate = dot(ray.direction, real3(light.axis));
    real a;
    real b;
    real c;
    if (light.kind == LIGHT_SPOT) {
        float c2 = light.dark * light.dark;
        a = rate * rate - c2;
        b = along * rate - dot(ray.direction, from_light) * c2;
        c = along * along - dot(from_light, from_light) * c2;
    } else {
        a = rate * rate - 1.0f;
        b = along * rate - dot(ray.direction, from_light);
        c = along * along - dot(from_light, from_light) + light.dark * light.dark;
    }
    // Inside where a t^2 + 2 b t + c > 0 and the point is ahead of the light.
    real discriminant = b * b - a * c;
    mask crosses = discriminant > real(0.0f);
    real root = sqrt(max(discriminant, real(0.0f)));
    real per_a = 1.0f / select(abs(a) > real(1e-12f), a, real(-1e-12f));
    real t0 = (-b - root) * per_a;
    real t1 = (root - b) * per_a;
    real low = min(t0, t1);
    real high = max(t0, t1);
    mask low_ahead = along + rate * low > real(0.0f);
    mask high_ahead = along + rate * high > real(0.0f);
    // a < 0: inside between both; else beyond the one that is ahead.
    mask between = a < real(0.0f);
    enters = select(between, low, select(high_ahead, high, real(0.0f)));
    leaves = select(between, high, select(high_ahead, end, low));
    crosses = mask_and(crosses, mask_or(mask_not(between), mask_or(low_ahead, high_ahead)));
    enters = select(crosses, min(max(enters, real(0.0f)), end), end);
    leaves = select(crosses, min(max(leaves, real(0.0f)), end), end);
}

/// As povray's pictures show, a ray is parted where nothing but spots and cylinders lights it; stretches that meet are
/// one.
FN LitStretches lit_stretches(SCENE MediaRay r, real end, mask here) {
    LitStretches lit;
    lit.count = 0u;
    if (!r.group.scatters) return lit;
    for (uint i = 0u; i < FRAME.light_count; i = i + 1u) {
        Light light = AT(lights, i);
        if ((light.flags & LIGHT_PASSES_MEDIA) != 0u) continue;
        bool narrow = light.kind == LIGHT_CYLINDER || (light.kind == LIGHT_SPOT && light.dark > 0.0f);
        if (!narrow || lit.count == MAX_LIT_STRETCHES) {
            lit.count = 0u;
            return lit;
        }
        real enters;
        real leaves;
        light_boundaries(light, r.ray, end, enters, leaves);
        if (!any_lane(mask_and(here, enters < leaves))) continue;
        // Samples at the rims are inside, however they round.
        real rim = min(leaves - enters, enters) * 1e-4f;
        enters = enters + rim;
        leaves = select(leaves < end, leaves - rim, leaves);
        for (uint k = 0u; k < lit.count; k = k + 1u) {
            mask before = enters < lit.enters[k];
            real later_enters = select(before, lit.enters[k], enters);
            real later_leaves = select(before, lit.leaves[k], leaves);
            lit.enters[k] = select(before, enters, lit.enters[k]);
            lit.leaves[k] = select(before, leaves, lit.leaves[k]);
            enters = later_enters;
            leaves = later_leaves;
        }
        lit.enters[lit.count] = enters;
        lit.leaves[lit.count] = leaves;
        lit.count = lit.count + 1u;
    }
    for (uint k = 1u; k < lit.count; k = k + 1u) {
        mask meet = lit.enters[k] <= lit.leaves[k - 1u];
        lit.enters[k] = select(meet, lit.enters[k - 1u], lit.enters[k]);
        lit.leaves[k] = select(meet, max(lit.leaves[k - 1u], lit.leaves[k]), lit.leaves[k]);
        lit.leaves[k - 1u] = select(meet, lit.enters[k - 1u], lit.leaves[k - 1u]);
    }
    return lit;
}

/// Where what is behind a lit stretch begins: outside of it, however that rounds.
FN real beyond(LitStretches lit, uint k, real reach) {
    return min(lit.leaves[k] + (lit.leaves[k] - lit.enters[k]) * 2e-4f, reach);
}

/// How many of a ray's intervals are in each stretch that is lit, and in each other one, by the medium's `ratio`: the
/// numbers that povray's pictures show where there is one lit stretch.
FN void share_intervals(LitStretches lit, real reach, float ratio, INOUT(real) of_dark, OUT(real) of_lit) {
    real one = real(1.0f);
    real none = real(0.0f);
    real lit_count = none;
    real dark_count = none;
    real passed = none;
    for (uint k = 0u; k < lit.count; k = k + 1u) {
        mask crosses = lit.enters[k] < lit.leaves[k];
        lit_count = lit_count + select(crosses, one, none);
        dark_count = dark_count + select(mask_and(crosses, passed < lit.enters[k]), one, none);
        passed = select(crosses, beyond(lit, k, reach), passed);
    }
    dark_count = dark_count + select(passed < reach, one, none);
    real to_share = of_dark - dark_count;
    of_lit = max(-floor(to_share * -ratio / max(lit_count, one)), one);
    of_dark = select(lit_count > none, max(-floor(to_share * (ratio - 1.0f)), one), of_dark);
}

/// All media at a point of a ray, with the light that they scatter along it.
FN_LARGE MediaPoint lit_media_at(SCENE MediaRay r, real t, mask asking, INOUT(RayCounts) counts) {
    real3 p = point_at(r.ray, t);
    Scatterers scatterers;
    MediaPoint point = media_at(SCENE_ r.group, p, scatterers);
    if (scatterers.count == 0u) return point;
    real most = real(0.0f);
    for (uint k = 0u; k < scatterers.count; k = k + 1u) most = max(most, largest(abs(scatterers.color[k])));
    mask scatters = mask_and(asking, most > real(0.0f));
    if (!any_lane(scatters)) return point;
    real3 black = real3(real(0.0f));
    for (uint i = 0u; i < FRAME.light_count; i = i + 1u) {
        Light light = AT(lights, i);
        if ((light.flags & LIGHT_PASSES_MEDIA) != 0u) continue;
        // What is blind to photons gets the light that they stand for along shadow rays.
        if (!r.group.collects) light.flags = light.flags | LIGHT_PHOTONS_NEVER_REFRACT;
        real distance;
        real3 to_light = direction_to_light(light, p, distance);
        real3 color = real3(light.color);
        if (FEATURE(FEATURE_LIGHT_SHAPES)) color = color * light_share(light, p, to_light, distance);
        mask lit = mask_and(scatters, largest(color) > real(0.0f));
        if (!any_lane(lit)) continue;
        if (FEATURE(FEATURE_SHADOWS)) {
            if ((light.flags & LIGHT_SHADOWS) != 0u)
                color = color * light_visibility(SCENE_ light, p, to_light, distance, r.insides, lit, counts);
        }
        color = select(lit, color, black);
        real cosine = dot(r.ray.direction, to_light);
        for (uint k = 0u; k < scatterers.count; k = k + 1u) {
            real phase = phase_function(scatterers.type[k], cosine, scatterers.eccentricity[k]);
            point.glow = point.glow + scatterers.color[k] * color * phase;
        }
    }
#ifdef __cplusplus
    if (FEATURE(FEATURE_PHOTONS) && r.group.collects && scene.photons->has_media()) {
        PhotonQuery query;
        set_photon_query(p, scatters, query);
        scene.photons->in_medium(query);
        real3 color = select(scatters, photon_answer(query), black);
        real cosine = dot(r.ray.direction, photon_source(query));
        for (uint k = 0u; k < scatterers.count; k = k + 1u) {
            real phase = phase_function(scatterers.type[k], cosine, scatterers.eccentricity[k]);
            point.glow = point.glow + select(scatters, scatterers.color[k] * color * phase, black);
        }
    }
#endif
    return point;
}

/// True where the light of two samples differs by more than a threshold.
FN mask differ(MediaPoint a, MediaPoint b, float threshold) {
    real3 d = abs(a.glow - b.glow);
    return d.x + d.y + d.z > real(threshold);
}

/// How far a sample is moved off its place, from -1/2 to 1/2 of the way to the next one, times the medium's jitter: by
/// the ray alone.
FN real media_jitter(Ray ray, word number, float amount) { return (random_at(ray.direction, number) - 0.5f) * amount; }

/// Adds a step of length dt: dimmed by what came before it alone, as povray's pictures show.
FN void add_step(MediaPoint mean, real dt, mask here, INOUT(MediaLight) sent) {
    sent.glow = select(here, sent.glow + sent.passes * mean.glow * dt, sent.glow);
    sent.passes = select(here, sent.passes * dimmed_by(mean.extinction * dt), sent.passes);
}

/// A sample that ends a part of a step: its light, its place, and the part's share of the step; 0 where it has been
/// counted already.
struct MediaPart {
    MediaPoint point;
    real t;
    real share;
};

FN MediaPoint chosen(mask m, MediaPoint a, MediaPoint b) {
    MediaPoint point;
    point.extinction = select(m, a.extinction, b.extinction);
    point.glow = select(m, a.glow, b.glow);
    return point;
}

FN void set_part(INOUT(MediaPart) part, mask m, MediaPart to) {
    part.point = chosen(m, to.point, part.point);
    part.t = select(m, to.t, part.t);
    part.share = select(m, to.share, part.share);
}

FN void add_share(INOUT(MediaPoint) sum, MediaPoint point, real share) {
    sum.extinction = sum.extinction + point.extinction * share;
    sum.glow = sum.glow + point.glow * share;
}

/// Where a ray is in an interval that it marches through by method 3. Each lane goes through its own tree of halves, so
/// that all sample something as long as they have anything to sample.
struct HalvedSteps {
    MediaPart ends[MAX_HALVINGS];  ///< Ends of the parts that a lane is in, the innermost last.
    word depth;                    ///< How many of them; 0: the step's end is to be sampled yet.
    word index;                    ///< The step.
    MediaPart left, right;
    MediaPoint sum;
};

FN MediaPoint nothing_there() {
    MediaPoint nothing;
    nothing.extinction = real3(real(0.0f));
    nothing.glow = real3(real(0.0f));
    return nothing;
}

FN HalvedSteps begun_steps(real begin, uint levels) {
    HalvedSteps steps;
    for (uint d = 0u; d < levels; d = d + 1u) {
        steps.ends[d].point = nothing_there();
        steps.ends[d].t = begin;
        steps.ends[d].share = real(0.0f);
    }
    steps.depth = word(0u);
    steps.index = word(0u);
    steps.left = steps.ends[0];
    steps.right = steps.ends[0];
    steps.sum = nothing_there();
    return steps;
}

/// Takes the sample `middle`, in the lanes of `todo`: where a half's ends differ by more than the threshold, it is
/// halved again, but none whose share of the step is `finest`. Steps that are done go to `sent`. Leaves the lanes that
/// have some left in `todo`.
FN void add_sample(MediaPart middle, uint samples, uint levels, float threshold, float finest, real dt,
                   INOUT(HalvedSteps) steps, INOUT(mask) todo, INOUT(MediaLight) sent) {
    // The whole part is done where neither half is to be halved.
    MediaPart left = steps.left;
    MediaPart right = steps.right;
    mask coarse = steps.depth == word(0u);
    mask splits = mask_and(todo, mask_not(coarse));
    mask may_split = mask_and(splits, right.share > real(finest));
    mask near = mask_and(may_split, differ(left.point, middle.point, threshold));
    mask far = mask_and(may_split, differ(middle.point, right.point, threshold));
    mask whole = mask_and(splits, mask_not(mask_or(near, far)));
    real third = select(whole, right.share * 0.333333333f, real(0.0f));
    add_share(steps.sum, left.point, third);
    add_share(steps.sum, middle.point, third);
    add_share(steps.sum, right.point, third);
    real near_half = select(mask_and(far, mask_not(near)), middle.share * 0.5f, real(0.0f));
    add_share(steps.sum, left.point, near_half);
    add_share(steps.sum, middle.point, near_half);
    real far_half = select(mask_and(near, mask_not(far)), middle.share * 0.5f, real(0.0f));
    add_share(steps.sum, middle.point, far_half);
    add_share(steps.sum, right.point, far_half);

    // On with the near half, the far one, or what comes after the part; a step's end opens a part.
    MediaPart rest = right;
    rest.share = select(far, middle.share, real(0.0f));
    mask opens = mask_or(near, mask_and(todo, mask_and(coarse, word(0u) < steps.index)));
    mask moves = mask_and(far, mask_not(near));
    for (uint d = 0u; d < levels; d = d + 1u) {
        set_part(steps.ends[d], mask_and(near, steps.depth == word(d + 1u)), rest);
        set_part(steps.ends[d], mask_and(moves, steps.depth == word(d + 1u)), rest);
        set_part(steps.ends[d], mask_and(opens, steps.depth == word(d)), middle);
    }
    steps.depth = steps.depth + select(opens, word(1u), word(0u));
    set_part(left, mask_or(moves, mask_and(coarse, steps.index == word(0u))), middle);
    set_part(right, moves, rest);
    mask starts = mask_and(todo, mask_and(coarse, steps.index == word(0u)));
    steps.index = steps.index + select(starts, word(1u), word(0u));
    mask ended = whole;
    while (any_lane(ended)) {
        set_part(left, ended, right);
        steps.depth = steps.depth - select(ended, word(1u), word(0u));
        mask step_ended = mask_and(ended, steps.depth == word(0u));
        if (any_lane(step_ended)) {
            add_step(steps.sum, dt, step_ended, sent);
            steps.sum = chosen(step_ended, nothing_there(), steps.sum);
            steps.index = steps.index + select(step_ended, word(1u), word(0u));
        }
        for (uint d = 0u; d < levels; d = d + 1u)
            set_part(right, mask_and(ended, steps.depth == word(d + 1u)), steps.ends[d]);
        ended = mask_and(mask_and(ended, mask_not(step_ended)), right.share <= real(0.0f));
    }
    for (uint d = 0u; d < levels; d = d + 1u)
        set_part(right, mask_and(opens, steps.depth == word(d + 1u)), steps.ends[d]);
    steps.left = left;
    steps.right = right;
    todo = mask_and(todo, steps.index < word(samples));
}

/// Whether `count` random samples are enough, whose light adds up to `sum`, and its squares to `squares`.
///
/// As povray's numbers of samples show: the true variance, which is with the medium's confidence not larger than the
/// samples' times f/q (f = count - 1; q, the chi-squared distribution's quantile, by Wilson and Hilferty 1931), is at
/// most the medium's times count^2 over the greatest number of samples.
FN mask few_samples_do(SCENE uint medium, uint count, real3 sum, real3 squares) {
    if (count < max(AT(code, medium + 22u), 2u)) return mask(false);
    float n = float(count);
    real3 variance = (squares - sum * sum * (1.0f / n)) * (1.0f / (n - 1.0f));
    real spread = real(2.0f / (9.0f * (n - 1.0f)));
    real quantile = max(1.0f - spread + code_float(SCENE_ medium + 24u) * sqrt(spread), real(0.0f));
    float good = code_float(SCENE_ medium + 23u) * n * n / float(AT(code, medium + 14u));
    return largest(variance) <= good * quantile * quantile * quantile;
}

/// Goes through one interval, of length `len`.
///
/// Method 1: random places, until their variance is small enough (see few_samples_do()). Method 2: the middles of even
/// steps, or places about them. As povray's pictures show, a sample's light is dimmed from the interval's begin on by
/// what is at the sample itself. Method 3: samples at the ends of steps and in
/// their middles, halved further where they differ; where all is the same and scatters nothing, one sample stands for
/// all. The methods share one loop, for shaders have a copy of all that a sample needs for each place that asks for it.
FN void march_interval(SCENE MediaRay r, real begin, real len, uint number, mask here, INOUT(MediaLight) sent,
                       INOUT(RayCounts) counts) {
    uint method = AT(code, r.group.first + 15u);
    bool randomly = method == 1u;
    bool evenly = method == 2u;
    bool is_even = method == 3u && !r.group.varies && !r.group.scatters;
    uint samples = AT(code, r.group.first + 14u);
    uint levels = AT(code, r.group.first + 16u);
    float threshold = code_float(SCENE_ r.group.first + 17u);
    float jitter = code_float(SCENE_ r.group.first + 19u);
    float finest = 1.0f / float(1u << (levels - 1u));  // The share of a step that isn't halved further.
    real dt = len * (1.0f / float(method == 3u ? samples - 1u : samples));
    real3 depth = real3(real(0.0f));
    real3 glow = depth;
    real3 squares = depth;
    HalvedSteps steps;
    if (method == 3u) steps = begun_steps(begin, levels);
    uint i = 0u;
    mask todo = here;
    while (any_lane(todo)) {
        MediaPart part;
        part.share = real(1.0f);
        real at = real(float(i) + 0.5f);
        if (randomly) {
            // Steps of the golden ratio from a random place: any number of them is spread evenly.
            at = media_jitter(r.ray, word(number * 256u), 1.0f) + (0.5f + 0.618033989f * float(i));
            at = at - floor(at);
            part.t = begin + len * at;
        } else if (evenly) {
            if (jitter > 0.0f) at = at + media_jitter(r.ray, word(number * 256u + i), jitter);
            part.t = begin + dt * at;
        } else {
            mask coarse = steps.depth == word(0u);
            at = real_from_word(steps.index);
            if (jitter > 0.0f) at = at + media_jitter(r.ray, steps.index + word(number * 256u), jitter) + 0.5f * jitter;
            part.t =
                select(coarse, begin + len * ((1.0f / float(samples)) * at), (steps.left.t + steps.right.t) * 0.5f);
            part.share = select(coarse, part.share, steps.right.share * 0.5f);
        }
        part.point = lit_media_at(SCENE_ r, part.t, todo, counts);
        i = i + 1u;
        if (randomly) {
            real3 light = dimmed_by(part.point.extinction * (len * at)) * part.point.glow * len;
            glow = glow + light;
            squares = squares + light * light;
            depth = depth + part.point.extinction * len;
            mask ended = todo;
            if (i < samples) ended = mask_and(todo, few_samples_do(SCENE_ r.group.first, i, glow, squares));
            float share = 1.0f / float(i);
            sent.glow = select(ended, sent.glow + sent.passes * glow * share, sent.glow);
            sent.passes = select(ended, sent.passes * dimmed_by(depth * share), sent.passes);
            todo = mask_and(todo, mask_not(ended));
        } else if (evenly) {
            glow = glow + dimmed_by(part.point.extinction * (dt * at)) * part.point.glow * dt;
            depth = depth + part.point.extinction * dt;
            if (i >= samples) break;
        } else if (is_even) {
            for (uint k = 1u; k < samples; k = k + 1u) add_step(part.point, dt, here, sent);
            break;
        } else {
            add_sample(part, samples, levels, threshold, finest, dt, steps, todo, sent);
        }
    }
    if (evenly) {
        sent.glow = select(here, sent.glow + sent.passes * glow, sent.glow);
        sent.passes = select(here, sent.passes * dimmed_by(depth), sent.passes);
    }
}

/// From `begin` to `end` of a ray in a number of intervals; `seed` tells stretches of a ray apart.
FN_LARGE void march_media(SCENE MediaRay r, real begin, real end, real intervals, uint seed, mask here,
                          INOUT(MediaLight) sent, INOUT(RayCounts) counts) {
    mask todo = mask_and(here, begin < end);
    real len = (end - begin) / intervals;
    uint i = 0u;
    while (any_lane(todo)) {
        march_interval(SCENE_ r, begin + len * float(i), len, seed + i * 64u, todo, sent, counts);
        i = i + 1u;
        todo = mask_and(todo, real(float(i)) < intervals);
    }
}

/// Radiance that media add along a ray up to `distance`, for a ray that carries `weight`; dims the weight by what they
/// take away.
FN_LARGE real3 media_radiance(SCENE Ray ray, real distance, MediaInsides insides, mask alive, INOUT(real3) weight,
                              INOUT(RayCounts) counts) {
    real3 sum = real3(real(0.0f));
    mask todo = alive;
    while (any_lane(todo)) {
        MediaRay r;
        r.ray = ray;
        r.insides = insides;
        mask here = take_alike(SCENE_ insides, FRAME.atmosphere != NONE, todo, r.group);
        if (r.group.count == 0u) continue;
        real reach = select(here, min(distance, real(RAY_FAR)), real(0.0f));
        if (!r.group.emits && !r.group.scatters) {
            weight = select(here, weight * dimmed_by(media_depth(SCENE_ r.group, ray, reach)), weight);
            continue;
        }
        LitStretches lit = lit_stretches(SCENE_ r, reach, here);
        // What is the same everywhere is one interval, as in povray.
        bool is_even = !r.group.varies && !r.group.scatters;
        real intervals = real(is_even ? 1.0f : float(AT(code, r.group.first + 18u)));
        real lit_intervals = intervals;
        if (lit.count > 0u && AT(code, r.group.first + 18u) > 1u)
            share_intervals(lit, reach, code_float(SCENE_ r.group.first + 20u), intervals, lit_intervals);
        MediaLight light;
        light.glow = real3(real(0.0f));
        light.passes = real3(real(1.0f));
        real passed = real(0.0f);
        // What lies before each lit stretch, that stretch, and what lies behind them all, one after the other.
        for (uint i = 0u; i < 2u * lit.count + 1u; i = i + 1u) {
            mask crosses = here;
            real from = passed;
            real to = reach;
            real number = intervals;
            uint k = i / 2u;
            bool is_lit = i % 2u == 1u;
            if (k < lit.count) {
                crosses = mask_and(here, lit.enters[k] < lit.leaves[k]);
                if (!any_lane(crosses)) continue;
                to = lit.enters[k];
            }
            if (is_lit) {
                from = lit.enters[k];
                to = lit.leaves[k];
                number = lit_intervals;
                passed = select(crosses, beyond(lit, k, reach), passed);
            }
            march_media(SCENE_ r, from, to, number, 2u * i, crosses, light, counts);
        }
        sum = select(here, sum + weight * light.glow, sum);
        weight = select(here, weight * light.passes, weight);
    }
    return sum;
}

KERNEL_END

#endif
