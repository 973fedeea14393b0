// SPDX-License-Identifier: Apache-2.0
#include "fields/fractals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/four_lanes.h"

namespace sundog::fields {
namespace {

using Formula = scene::FractalForm::Formula;

/// Numbers go through the same iterations side by side: each waits for its own last one, not for the others'.
constexpr std::size_t kAtOnce = 4;
using Numbers = FourLanes;

struct Complex {
    Numbers x, y;
    friend Complex operator+(const Complex& a, const Complex& b) { return {a.x + b.x, a.y + b.y}; }
    friend Complex operator+(const Complex& a, double b) { return {a.x + b, a.y}; }
    friend Complex operator*(const Complex& a, const Complex& b) {
        return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
    }
    friend Complex operator*(double a, const Complex& b) { return {a * b.x, a * b.y}; }
    friend Complex operator/(const Complex& a, const Complex& b) {
        const Numbers square = b.x * b.x + b.y * b.y;
        const Numbers n = larger(square, 1e-300);
        return {(a.x * b.x + a.y * b.y) / n, (a.y * b.x - a.x * b.y) / n};
    }
};
Complex square(const Complex& a) { return {a.x * a.x - a.y * a.y, 2 * a.x * a.y}; }
Numbers norm(const Complex& a) { return a.x * a.x + a.y * a.y; }

Complex power(const Complex& a, int exponent) {
    if (exponent == 2) return square(a);
    Complex result = a;
    for (int i = 1; i < exponent; ++i) result = result * a;
    return result;
}

/// How magnets are renormalised (Peitgen and Richter, The Beauty of Fractals, 1986).
Complex magnet1(const Complex& z, const Complex& c) { return square((square(z) + c + -1) / (2 * z + c + -2)); }
Complex magnet2(const Complex& z, const Complex& c) {
    const Complex c1 = c + -1, c2 = c + -2;
    return square((z * square(z) + 3 * (c1 * z) + c1 * c2) / (3 * square(z) + 3 * (c2 * z) + c1 * c2 + 1));
}

/// Where an orbit has come to.
struct Orbit {
    double x = 0, y = 0, least_norm = 0;
};

double orbit_value(int type, double factor, const Orbit& z) {
    switch (type) {
        case 0:
            return factor;
        case 1:
            return std::sqrt(z.least_norm) * factor;
        case 2:
            return z.x * factor;
        case 3:
            return z.y * factor;
        case 4:
            return z.x * z.x * factor;
        case 5:
            return z.y * z.y * factor;
        default:
            return std::sqrt(z.x * z.x + z.y * z.y) * factor;
    }
}

/// Of an orbit that leaves after `iteration` more than one.
double exterior_value(const scene::FractalForm& form, int iteration, const Orbit& z) {
    if (form.exterior_type == 1) return static_cast<double>(iteration) / form.iterations;
    if (form.exterior_type >= 7) {
        const double period = form.exterior_factor + (form.exterior_type == 8 ? 1 : 0);
        return form.exterior_factor > 0 ? std::fmod(iteration, period) / form.exterior_factor : 0;
    }
    return orbit_value(form.exterior_type, form.exterior_factor, z);
}

double interior_value(const scene::FractalForm& form, const Orbit& z) {
    // The reference says the absolute value; its square is what povray's pictures show, within alone.
    if (form.interior_type == 6) return (z.x * z.x + z.y * z.y) * form.interior_factor;
    return orbit_value(form.interior_type, form.interior_factor, z);
}

/// Where orbits of z^2 + c from 0 are known to stay: c in the main cardioid or the disc left of it.
FourTruths in_largest_parts(const Complex& c) {
    const Numbers x = c.x - 0.25, y2 = c.y * c.y, q = x * x + y2;
    return (q * (q + x) <= y2 * 0.25) | ((c.x + 1) * (c.x + 1) + y2 <= 0.0625);
}

void fractal_values(const scene::FractalForm& form, const Complex& p, std::span<double> values) {
    const bool is_power = form.formula == Formula::power;
    const Complex c = form.julia ? Complex{form.c[0], form.c[1]} : p;
    Complex z = form.julia || is_power ? p : Complex{0, 0};
    Numbers least_norm = form.julia || is_power ? norm(p) : Numbers(std::numeric_limits<double>::infinity());
    const double far = is_power ? 4 : 10000;
    FourTruths stays = Numbers(0, 1, 2, 3) < Numbers(static_cast<double>(values.size()));
    if (is_power && form.exponent == 2 && !form.julia && form.interior_type == 0) {
        const FourTruths known = stays & in_largest_parts(c);
        for (std::size_t lane = 0; lane < values.size(); ++lane)
            if (known[lane]) values[lane] = interior_value(form, {});
        stays = stays & ~known;
        if (!any(stays)) return;
    }
    const auto orbit = [&](std::size_t lane) { return Orbit{z.x[lane], z.y[lane], least_norm[lane]}; };
    for (int i = 0; i < form.iterations; ++i) {
        if (is_power) z = power(z, form.exponent) + c;
        else z = form.formula == Formula::magnet1 ? magnet1(z, c) : magnet2(z, c);
        const Numbers n = norm(z);
        least_norm = lesser(least_norm, n);
        FourTruths leaves = ~(n <= far);
        // Magnets are attracted by 1, too.
        if (!is_power) leaves = leaves | (norm(z + -1) < 1e-4);
        leaves = leaves & stays;
        if (!any(leaves)) continue;
        for (std::size_t lane = 0; lane < values.size(); ++lane)
            if (leaves[lane]) values[lane] = exterior_value(form, i, orbit(lane));
        stays = stays & ~leaves;
        if (!any(stays)) return;
    }
    for (std::size_t lane = 0; lane < values.size(); ++lane)
        if (stays[lane]) values[lane] = interior_value(form, orbit(lane));
}

}  // namespace

void fractal_values(const scene::FractalForm& form, std::span<const double> x, std::span<const double> y,
                    std::span<double> values) {
    for (std::size_t first = 0; first < values.size(); first += kAtOnce) {
        const std::size_t count = std::min(kAtOnce, values.size() - first);
        const auto lanes = [&](std::span<const double> from) {
            const auto at = [&](std::size_t lane) { return from[first + std::min(lane, count - 1)]; };
            return Numbers(at(0), at(1), at(2), at(3));
        };
        fractal_values(form, Complex{lanes(x), lanes(y)}, values.subspan(first, count));
    }
}

double fractal_value(const scene::FractalForm& form, double x, double y) {
    double value = 0;
    fractal_values(form, std::span(&x, 1), std::span(&y, 1), std::span(&value, 1));
    return value;
}

}  // namespace sundog::fields
