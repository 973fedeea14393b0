// SPDX-License-Identifier: Apache-2.0
// Crossings of convex solids whose distance function is known: ovus and lemon.
#pragma once

#include <algorithm>
#include <cmath>

#include "solids/ray.h"

namespace sundog::solids {

/// Where a convex function f(t), negative inside, changes its sign within [lower, upper]: the ends of the one interval
/// inside. False where the ray stays outside. To the last bits; a ray that only touches may be found to miss.
template <class F>
bool convex_interval(const F& f, double lower, double upper, double& enters, double& leaves) {
    double a = lower;
    double b = upper;
    double fa = f(a);
    double fb = f(b);
    double within = fa < fb ? a : b;
    // Golden sections towards the least value, until some value is negative.
    constexpr double kGolden = 0.6180339887498949;
    double c = b - kGolden * (b - a);
    double d = a + kGolden * (b - a);
    double fc = f(c);
    double fd = f(d);
    for (int i = 0; i < 80 && !(std::min(std::min(fa, fb), std::min(fc, fd)) < 0); ++i) {
        if (fc < fd) {
            b = d, fb = fd;
            d = c, fd = fc;
            c = b - kGolden * (b - a), fc = f(c);
        } else {
            a = c, fa = fc;
            c = d, fc = fd;
            d = a + kGolden * (b - a), fd = f(d);
        }
        if (!(a < c && c < d && d < b)) break;
    }
    const double least = std::min(std::min(fa, fb), std::min(fc, fd));
    if (!(least < 0)) return false;
    within = least == fc ? c : least == fd ? d : least == fa ? a : b;
    const auto root = [&](double outside, double inside) {
        double f_out = f(outside);
        double f_in = f(inside);
        if (!(f_out > 0)) return outside;
        for (int i = 0; i < 100; ++i) {
            // Illinois's rule (Dowell and Jarratt 1971); every third step halves.
            double t = outside - f_out * (inside - outside) / (f_in - f_out);
            const double low = std::min(outside, inside);
            const double high = std::max(outside, inside);
            if (i % 3 == 2 || !(t > low && t < high)) t = 0.5 * (low + high);
            if (!(t > low && t < high)) break;
            const double value = f(t);
            if (value == 0) return t;
            if (value < 0) inside = t, f_in = value, f_out *= 0.5;
            else outside = t, f_out = value, f_in *= 0.5;
        }
        return 0.5 * (outside + inside);
    };
    enters = root(lower, within);
    leaves = root(upper, within);
    return true;
}

}  // namespace sundog::solids
