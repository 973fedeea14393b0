// SPDX-License-Identifier: Apache-2.0
// Distances to the nearest of points that are strewn one a cell (Worley, A Cellular Texture Basis Function, SIGGRAPH
// 1996).
#ifndef SUNDOG_KERNEL_PATTERNS_CRACKLE_H
#define SUNDOG_KERNEL_PATTERNS_CRACKLE_H

#include "kernel/patterns/noise.h"

KERNEL_BEGIN

/// The nearest points so far, by a measure that grows with the distance.
struct CracklePoints {
    real nearest, second, third;
    word hash;  ///< Of the nearest one's cell.
};

/// How far a vector reaches, before the root: the sum of its components' powers.
FN real crackle_measure(real3 v, float metric) {
    if (metric == 2.0f) return dot(v, v);
    real3 a = abs(v);
    if (metric == 1.0f) return a.x + a.y + a.z;
    real m = real(metric);
    return power(a.x, m) + power(a.y, m) + power(a.z, m);
}

/// What the distance to the cell at `step` along an axis adds to the measure at least: `within` is where p lies in its
/// own cell. Powers are rounded: a hair less of theirs.
FN real measured_gap(float step, real within, float metric) {
    if (step == 0.0f) return real(0.0f);
    real gap = step < 0.0f ? within : 1.0f - within;
    if (metric == 2.0f) return gap * gap;
    return metric == 1.0f ? gap * 0.9999f : power(gap, real(metric)) * 0.9999f;
}

/// Whether points with a measure of `gap` at least may be among the nearest three (`thirds`) or two.
FN bool may_be_near(CracklePoints found, real gap, bool thirds) {
    return any_lane(gap < (thirds ? found.third : found.second));
}

/// Looks at the point of the cell at `step` from the one that p lies in, `within` of it.
FN CracklePoints with_cell(CracklePoints found, real3 home, real3 within, vec3 step, float metric) {
    word hash = cell_hash(home + real3(step), 0x17u);
    real3 jitter = random_vector(hash) * real(0.5f);
    real3 offset = real3(step) + jitter + real3(real(0.5f)) - within;
    real measure = crackle_measure(offset, metric);
    found.third = min(found.third, max(found.second, measure));
    found.second = min(found.second, max(found.nearest, measure));
    found.hash = select(measure < found.nearest, hash, found.hash);
    found.nearest = min(found.nearest, measure);
    return found;
}

/// The nearest points within the 27 cells around p.
FN CracklePoints crackle_points(real3 p, float metric, bool thirds) {
    CracklePoints found;
    found.nearest = real(1.0e9f);
    found.second = real(1.0e9f);
    found.third = real(1.0e9f);
    found.hash = word(0u);
    real3 home = real3(floor(p.x), floor(p.y), floor(p.z));
    real3 within = p - home;
    // The cell itself and its neighbours behind faces first: most others, whole rows of them, are then too far.
    for (uint pass = 0u; pass < 2u; pass = pass + 1u) {
        for (float z = -1.0f; z < 1.5f; z = z + 1.0f) {
            real plane = measured_gap(z, within.z, metric);
            if (!may_be_near(found, plane, thirds)) continue;
            for (float y = -1.0f; y < 1.5f; y = y + 1.0f) {
                real row = plane + measured_gap(y, within.y, metric);
                if (!may_be_near(found, row, thirds)) continue;
                for (float x = -1.0f; x < 1.5f; x = x + 1.0f) {
                    bool close = abs(x) + abs(y) + abs(z) < 1.5f;
                    if (close != (pass == 0u)) continue;
                    if (may_be_near(found, row + measured_gap(x, within.x, metric), thirds))
                        found = with_cell(found, home, within, vec3(x, y, z), metric);
                }
            }
        }
    }
    return found;
}

/// Distance to the second nearest point less that to the nearest: 0 on the borders between them.
FN real crackle_value(real3 p) {
    CracklePoints found = crackle_points(p, 2.0f, false);
    return min(sqrt(found.second) - sqrt(found.nearest), real(1.0f));
}

/// A measure's root: the distance, where `offset` lies between along a fourth axis.
FN real crackle_distance(real measure, float metric, float offset) {
    if (metric == 2.0f) return sqrt(measure + offset * offset);
    if (metric == 1.0f) return measure + abs(offset);
    return power(measure + power(real(abs(offset)), real(metric)), real(1.0f / metric));
}

/// A sum of the three distances by the factors of `form`, or, if solid, a random number for each point.
FN real crackle_form_value(real3 p, vec3 form, float metric, float offset, bool solid) {
    CracklePoints found = crackle_points(p, metric, form.z != 0.0f && !solid);
    if (solid) return real_from_word(hash_word(found.hash) >> 8u) * 5.9604645e-8f;
    real sum = crackle_distance(found.nearest, metric, offset) * form.x;
    if (form.y != 0.0f) sum = sum + crackle_distance(found.second, metric, offset) * form.y;
    if (form.z != 0.0f) sum = sum + crackle_distance(found.third, metric, offset) * form.z;
    return clamp(sum, real(0.0f), real(1.0f));
}

KERNEL_END

#endif
