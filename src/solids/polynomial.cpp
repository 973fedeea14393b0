// SPDX-License-Identifier: Apache-2.0
// Polynomial surfaces of third and higher order (poly, cubic, quartic, polynomial).
#include <algorithm>
#include <cmath>
#include <vector>

#include "solids/polynomial_bounds.h"
#include "solids/quadric.h"
#include "solids/roots.h"
#include "solids/shape.h"

namespace sundog::solids {
namespace {

using Powers = std::array<std::array<double, kMaxDegree + 1>, kMaxDegree + 1>;

/// out[n] = the coefficients of (origin + direction*t)^n, for n up to `order`.
void powers_of(double origin, double direction, std::size_t order, Powers& out) {
    out[0][0] = 1;
    for (std::size_t n = 1; n <= order; ++n) {
        out[n][0] = out[n - 1][0] * origin;
        for (std::size_t i = 1; i < n; ++i) out[n][i] = out[n - 1][i] * origin + out[n - 1][i - 1] * direction;
        out[n][n] = out[n - 1][n - 1] * direction;
    }
}

/// p = p*(origin + direction*t) + what is added, where `degree` is p's before.
template <std::size_t Size>
void times_linear(std::array<double, Size>& p, std::size_t degree, double origin, double direction) {
    p[degree + 1] = p[degree] * direction;
    for (std::size_t i = degree; i > 0; --i) p[i] = p[i] * origin + p[i - 1] * direction;
    p[0] *= origin;
}

/// Coefficients along a ray of a polynomial of which all coefficients are given, those of the highest powers of x
/// first, among them those of y, among them those of z: Horner's scheme in three variables.
template <std::size_t N>
void expand_all(const double* coefficients, const Ray& ray, double* out) {
    std::array<double, N + 1> sum{};
    for (std::size_t x = 0; x <= N; ++x) {
        if (x > 0) times_linear(sum, x - 1, ray.origin.x, ray.direction.x);
        std::array<double, N + 1> in_y{};
        for (std::size_t y = 0; y <= x; ++y) {
            if (y > 0) times_linear(in_y, y - 1, ray.origin.y, ray.direction.y);
            std::array<double, N + 1> in_z{};
            in_z[0] = *coefficients++;
            for (std::size_t z = 1; z <= y; ++z) {
                times_linear(in_z, z - 1, ray.origin.z, ray.direction.z);
                in_z[0] += *coefficients++;
            }
            for (std::size_t i = 0; i <= y; ++i) in_y[i] += in_z[i];
        }
        for (std::size_t i = 0; i <= x; ++i) sum[i] += in_y[i];
    }
    std::copy(sum.begin(), sum.end(), out);
}

double power(double x, unsigned n) {
    double result = 1;
    for (; n > 0; n >>= 1U) {
        if ((n & 1U) != 0) result *= x;
        x *= x;
    }
    return result;
}

class Polynomial final : public Shape {
public:
    explicit Polynomial(const scene::Polynomial& p) : terms_(p.terms) {
        std::sort(terms_.begin(), terms_.end(),
                  [](const Term& a, const Term& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
        for (const Term& t : terms_) order_ = std::max<std::size_t>(order_, std::size_t{t.x} + t.y + t.z);
        if (order_ != 3 && order_ != 4) return;
        for (std::size_t x = 0; x <= order_; ++x) {
            for (std::size_t y = 0; y <= x; ++y) {
                for (std::size_t z = 0; z <= y; ++z) {
                    double sum = 0;
                    for (const Term& t : terms_)
                        if (t.x == order_ - x && t.y == x - y && t.z == y - z) sum += t.coefficient;
                    all_.push_back(sum);
                }
            }
        }
    }

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        // From the point nearest to the origin, about which such shapes lie, rounding is least.
        const double t_near =
            std::clamp(-dot(ray.origin, ray.direction) / dot(ray.direction, ray.direction), range.lower, range.upper);
        std::array<double, kMaxDegree + 1> along{};
        const std::span<double> c(along.data(), order_ + 1);
        expand({ray.at(t_near), ray.direction}, c);
        RootList roots;
        append_roots(c, range.lower - t_near, range.upper - t_near, roots);
        const double at_start = evaluate(c, range.lower - t_near);
        for (const double s : roots) {
            const double t = order_ > 4 ? polished(ray, t_near + s) : t_near + s;
            if (range.contains(t)) out.push_back({t});
        }
        return at_start < 0;
    }
    [[nodiscard]] bool inside(Vec3d p) const override { return value(p) < 0; }
    [[nodiscard]] Vec3d normal(Vec3d p, const Crossing&) const override {
        Vec3d gradient;
        for (const Term& t : terms_) {
            const double x = power(p.x, t.x);
            const double y = power(p.y, t.y);
            const double z = power(p.z, t.z);
            if (t.x > 0) gradient.x += t.coefficient * t.x * power(p.x, t.x - 1U) * y * z;
            if (t.y > 0) gradient.y += t.coefficient * t.y * x * power(p.y, t.y - 1U) * z;
            if (t.z > 0) gradient.z += t.coefficient * t.z * x * y * power(p.z, t.z - 1U);
        }
        return gradient;
    }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override {
        return transformed(m, polynomial_bounds(terms_, order_));
    }
    [[nodiscard]] ShapeNumbers numbers() const override {
        if (order_ > 6) return {};
        ShapeNumbers out{ShapeNumbers::Kind::polynomial, {}};
        out.add(static_cast<double>(order_)).add(static_cast<double>(terms_.size()));
        for (const Term& t : terms_) out.add(Vec3d{double(t.x), double(t.y), double(t.z)}).add(t.coefficient);
        return out;
    }

private:
    using Term = scene::Polynomial::Term;

    [[nodiscard]] double value(Vec3d p) const {
        double sum = 0;
        for (const Term& t : terms_) sum += t.coefficient * power(p.x, t.x) * power(p.y, t.y) * power(p.z, t.z);
        return sum;
    }
    /// Coefficients along the ray lose digits at high orders, the polynomial's own do not: two of Newton's steps on it,
    /// as long as they are small.
    [[nodiscard]] double polished(const Ray& ray, double t) const {
        for (int i = 0; i < 2; ++i) {
            const Vec3d p = ray.at(t);
            const double slope = dot(normal(p, {}), ray.direction);
            const double step = -value(p) / slope;
            if (!(std::abs(step) < 1e-5 * std::abs(t))) break;
            t += step;
        }
        return t;
    }
    /// Coefficients of the polynomial along a ray.
    void expand(const Ray& ray, std::span<double> out) const {
        if (order_ == 3) return expand_all<3>(all_.data(), ray, out.data());
        if (order_ == 4) return expand_all<4>(all_.data(), ray, out.data());
        Powers x;
        Powers y;
        Powers z;
        powers_of(ray.origin.x, ray.direction.x, order_, x);
        powers_of(ray.origin.y, ray.direction.y, order_, y);
        powers_of(ray.origin.z, ray.direction.z, order_, z);
        std::array<double, kMaxDegree + 1> of_z;
        std::array<double, kMaxDegree + 1> of_xy;
        for (std::size_t i = 0; i < terms_.size();) {
            // Terms that share their powers of x and y are summed over z first.
            const unsigned nx = terms_[i].x;
            const unsigned ny = terms_[i].y;
            std::size_t highest = 0;
            of_z.fill(0);
            for (; i < terms_.size() && terms_[i].x == nx && terms_[i].y == ny; ++i) {
                const std::size_t nz = terms_[i].z;
                highest = std::max(highest, nz);
                for (std::size_t k = 0; k <= nz; ++k) of_z[k] += terms_[i].coefficient * z[nz][k];
            }
            of_xy.fill(0);
            for (std::size_t a = 0; a <= nx; ++a)
                for (std::size_t b = 0; b <= ny; ++b) of_xy[a + b] += x[nx][a] * y[ny][b];
            for (std::size_t a = 0; a <= nx + ny; ++a)
                for (std::size_t b = 0; b <= highest; ++b) out[a + b] += of_xy[a] * of_z[b];
        }
    }

    std::vector<Term> terms_;
    std::size_t order_ = 1;
    std::vector<double> all_;  ///< Of order 3 or 4: as expand_all takes them.
};

}  // namespace

ShapePointer make_shape(const scene::Polynomial& polynomial, const SourceLocation& where) {
    std::size_t order = 0;
    for (const scene::Polynomial::Term& t : polynomial.terms) order = std::max(order, std::size_t{t.x} + t.y + t.z);
    if (order > kMaxDegree) refuse_shape(where, "a polynomial's order is at most 35");
    if (order <= 2) return make_quadric(polynomial.terms);
    if (const std::optional<QuarticTorus> torus = as_torus(polynomial.terms); torus && torus->axis == 1)
        return make_shape(scene::Torus{torus->major_radius, torus->minor_radius}, where);
    return std::make_shared<Polynomial>(polynomial);
}

}  // namespace sundog::solids
