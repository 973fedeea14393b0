// SPDX-License-Identifier: Apache-2.0
#include "fields/fractals.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sundog::fields {
namespace {

using Formula = scene::FractalForm::Formula;

struct Complex {
    double x = 0, y = 0;
};
Complex operator+(Complex a, Complex b) { return {a.x + b.x, a.y + b.y}; }
Complex operator+(Complex a, double b) { return {a.x + b, a.y}; }
Complex operator*(Complex a, Complex b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }
Complex operator*(double a, Complex b) { return {a * b.x, a * b.y}; }
double norm(Complex a) { return a.x * a.x + a.y * a.y; }
Complex operator/(Complex a, Complex b) {
    const double n = std::max(norm(b), 1e-300);
    return {(a.x * b.x + a.y * b.y) / n, (a.y * b.x - a.x * b.y) / n};
}
Complex square(Complex a) { return {a.x * a.x - a.y * a.y, 2 * a.x * a.y}; }

Complex power(Complex a, int exponent) {
    Complex result = a;
    for (int i = 1; i < exponent; ++i) result = result * a;
    return result;
}

/// How magnets are renormalised (Peitgen and Richter, The Beauty of Fractals, 1986).
Complex magnet1(Complex z, Complex c) { return square((square(z) + c + -1) / (2 * z + c + -2)); }
Complex magnet2(Complex z, Complex c) {
    const Complex c1 = c + -1, c2 = c + -2;
    return square((z * square(z) + 3 * (c1 * z) + c1 * c2) / (3 * square(z) + 3 * (c2 * z) + c1 * c2 + 1));
}

double orbit_value(int type, double factor, Complex z, double least_norm) {
    switch (type) {
        case 0:
            return factor;
        case 1:
            return std::sqrt(least_norm) * factor;
        case 2:
            return z.x * factor;
        case 3:
            return z.y * factor;
        case 4:
            return z.x * z.x * factor;
        case 5:
            return z.y * z.y * factor;
        default:
            return std::sqrt(norm(z)) * factor;
    }
}

}  // namespace

double fractal_value(const scene::FractalForm& form, double x, double y) {
    const Complex p{x, y};
    const Complex c = form.julia ? Complex{form.c[0], form.c[1]} : p;
    const bool is_power = form.formula == Formula::power;
    Complex z = form.julia || is_power ? p : Complex{};
    double least_norm = form.julia || is_power ? norm(p) : std::numeric_limits<double>::infinity();
    const double far = is_power ? 4 : 10000;
    for (int i = 0; i < form.iterations; ++i) {
        if (is_power) z = (form.exponent == 2 ? square(z) : power(z, form.exponent)) + c;
        else z = form.formula == Formula::magnet1 ? magnet1(z, c) : magnet2(z, c);
        const double n = norm(z);
        least_norm = std::min(least_norm, n);
        // Magnets are attracted by 1, too.
        if (!(n <= far) || (!is_power && norm(z + -1) < 1e-4)) {
            if (form.exterior_type == 1) return static_cast<double>(i) / form.iterations;
            if (form.exterior_type >= 7) {
                const double period = form.exterior_factor + (form.exterior_type == 8 ? 1 : 0);
                return form.exterior_factor > 0 ? std::fmod(i, period) / form.exterior_factor : 0;
            }
            return orbit_value(form.exterior_type, form.exterior_factor, z, least_norm);
        }
    }
    // The reference says the absolute value; its square is what povray's pictures show, within alone.
    if (form.interior_type == 6) return norm(z) * form.interior_factor;
    return orbit_value(form.interior_type, form.interior_factor, z, least_norm);
}

}  // namespace sundog::fields
