// SPDX-License-Identifier: Apache-2.0
// How much light microfacets and sheen send back in all, looked up in the array `tables`, where
// compile/bsdf_tables.h makes from the models themselves.
#ifndef SUNDOG_KERNEL_BSDF_ALBEDO_TABLES_H
#define SUNDOG_KERNEL_BSDF_ALBEDO_TABLES_H

#include "kernel/math.h"

KERNEL_BEGIN

/// Entry (column, row) and those beside it of a table whose rows are roughnesses and whose columns are cosines, both 0
/// to 1; entries are `stride` floats long.
FN real table_value(SCENE uint first, uint stride, real cosine_there, real roughness) {
    const float last = float(BSDF_TABLE_SIDE - 1u);
    real x = clamp(cosine_there, real(0.0f), real(1.0f)) * last;
    real y = clamp(roughness, real(0.0f), real(1.0f)) * last;
    real x0 = min(floor(x), real(last - 1.0f));
    real y0 = min(floor(y), real(last - 1.0f));
    real fx = x - x0;
    real fy = y - y0;
    word at = word(first) + (word_from_real(y0) * word(BSDF_TABLE_SIDE) + word_from_real(x0)) * word(stride);
    word below = at + word(BSDF_TABLE_SIDE * stride);
    return mix(mix(GET(tables, at), GET(tables, at + word(stride)), fx),
               mix(GET(tables, below), GET(tables, below + word(stride)), fx), fy);
}

/// Albedo of GGX facets with Schlick's reflectance f0 to f90: f0 times the first number plus f90 times the second
/// (Karis, Real Shading in Unreal Engine 4, 2013).
FN real2 ggx_albedo(SCENE real cosine_there, real roughness) {
    return real2(table_value(SCENE_ BSDF_TABLE_GGX, 2u, cosine_there, roughness),
                 table_value(SCENE_ BSDF_TABLE_GGX + 1u, 2u, cosine_there, roughness));
}

/// Its mean over the cosine-weighted hemisphere.
FN real2 ggx_mean_albedo(SCENE real roughness) {
    const float last = float(BSDF_TABLE_SIDE - 1u);
    real y = clamp(roughness, real(0.0f), real(1.0f)) * last;
    real y0 = min(floor(y), real(last - 1.0f));
    real fy = y - y0;
    word at = word(BSDF_TABLE_GGX_MEANS) + word_from_real(y0) * word(2u);
    return real2(mix(GET(tables, at), GET(tables, at + word(2u)), fy),
                 mix(GET(tables, at + word(1u)), GET(tables, at + word(3u)), fy));
}

/// Albedo of white sheen.
FN real sheen_albedo(SCENE real cosine_there, real roughness) {
    return table_value(SCENE_ BSDF_TABLE_SHEEN, 1u, cosine_there, roughness);
}

KERNEL_END

#endif
