// SPDX-License-Identifier: Apache-2.0
// Quantiles of the normal distribution.
#pragma once

#include <cmath>
#include <numbers>

namespace sundog {

/// What a number of the standard normal distribution is below with probability `p`, 0 to 1; within -40..40.
inline double normal_quantile(double p) {
    double low = -40;
    double high = 40;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (std::erfc(-middle / std::numbers::sqrt2) / 2 < p ? low : high) = middle;
    }
    return low;
}

}  // namespace sundog
