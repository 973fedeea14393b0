// SPDX-License-Identifier: Apache-2.0
#include "compile/bsdf_tables.h"

#include <algorithm>
#include <cmath>

#include "kernel/bsdf/ggx.h"
#include "kernel/bsdf/sheen.h"
#include "kernel/sequences.h"

namespace sundog {
namespace {

using namespace kernel;

constexpr uint kSide = BSDF_TABLE_SIDE;
constexpr uint kSamples = 512;

real2 sample(uint i) { return real2((static_cast<float>(i) + 0.5F) / kSamples, unit_from_word(reversed(i))); }
real3 direction_at(float cosine_there) {
    const float c = std::max(cosine_there, 1e-3F);
    return {std::sqrt(1 - c * c), 0, c};
}

/// Factors of f0 and f90 in the albedo of facets, which are drawn as they are seen.
real2 ggx_factors(float cosine_there, float roughness) {
    const float alpha = std::max(roughness * roughness, 1e-3F);
    const real3 to_eye = direction_at(cosine_there);
    double first = 0, second = 0;
    for (uint i = 0; i < kSamples; ++i) {
        const real3 h = ggx_normal(to_eye, alpha, alpha, sample(i));
        const float eye_half = dot(to_eye, h);
        const real3 to_light = h * (2 * eye_half) - to_eye;
        if (!(to_light.z > 0)) continue;
        const float share = ggx_both_visible(to_eye, to_light, alpha, alpha) / ggx_visible(to_eye, alpha, alpha);
        const float grazing = std::pow(1 - std::clamp(eye_half, 0.0F, 1.0F), 5.0F);
        first += share * (1 - grazing);
        second += share * grazing;
    }
    return real2(static_cast<float>(first / kSamples), static_cast<float>(second / kSamples));
}

float sheen_factor(float cosine_there, float roughness) {
    const real3 to_eye = direction_at(cosine_there);
    double sum = 0;
    for (uint i = 0; i < kSamples; ++i) {
        const real3 to_light = lambert_direction(sample(i));
        sum += sheen_value(to_eye, to_light, roughness) * 3.14159265;
    }
    return static_cast<float>(std::min(sum / kSamples, 1.0));
}

std::vector<float> make_tables() {
    std::vector<float> tables(BSDF_TABLE_FLOATS, 0.0F);
    for (uint row = 0; row < kSide; ++row) {
        const float roughness = static_cast<float>(row) / (kSide - 1);
        double mean_first = 0, mean_second = 0, weights = 0;
        for (uint column = 0; column < kSide; ++column) {
            const float cosine_there = static_cast<float>(column) / (kSide - 1);
            const real2 factors = ggx_factors(cosine_there, roughness);
            const uint at = row * kSide + column;
            tables[BSDF_TABLE_GGX - BSDF_TABLES_FIRST + 2 * at] = factors.x;
            tables[BSDF_TABLE_GGX - BSDF_TABLES_FIRST + 2 * at + 1] = factors.y;
            tables[BSDF_TABLE_SHEEN - BSDF_TABLES_FIRST + at] = sheen_factor(cosine_there, roughness);
        }
        // The mean over the hemisphere of what looking up between entries gives.
        for (uint i = 0; i < kSamples; ++i) {
            const float c = (static_cast<float>(i) + 0.5F) / kSamples;
            const float x = c * (kSide - 1);
            const uint column = std::min(static_cast<uint>(x), kSide - 2);
            const float f = x - static_cast<float>(column);
            const float* const entry = &tables[BSDF_TABLE_GGX - BSDF_TABLES_FIRST + 2 * (row * kSide + column)];
            mean_first += c * (entry[0] * (1 - f) + entry[2] * f);
            mean_second += c * (entry[1] * (1 - f) + entry[3] * f);
            weights += c;
        }
        tables[BSDF_TABLE_GGX_MEANS - BSDF_TABLES_FIRST + 2 * row] = static_cast<float>(mean_first / weights);
        tables[BSDF_TABLE_GGX_MEANS - BSDF_TABLES_FIRST + 2 * row + 1] = static_cast<float>(mean_second / weights);
    }
    return tables;
}

}  // namespace

const std::vector<float>& bsdf_tables() {
    static const std::vector<float> tables = make_tables();
    return tables;
}

}  // namespace sundog
