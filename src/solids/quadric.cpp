// SPDX-License-Identifier: Apache-2.0
#include "solids/quadric.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sundog::solids {
namespace {

/// The range of a coordinate.
struct Extent {
    double lower = -kInfinity, upper = kInfinity;
    [[nodiscard]] bool empty() const { return !(lower <= upper); }
};

/// a*v^2 + b*v + c's largest value for v in `range`.
double largest_of(double a, double b, double c, Extent range) {
    const auto at = [&](double v) {
        if (std::isfinite(v)) return (a * v + b) * v + c;
        if (a != 0) return a > 0 ? kInfinity : -kInfinity;
        if (b != 0) return (b > 0) == (v > 0) ? kInfinity : -kInfinity;
        return c;
    };
    double most = std::max(at(range.lower), at(range.upper));
    if (a < 0) {
        const double top = -b / (2 * a);
        if (top > range.lower && top < range.upper) most = std::max(most, at(top));
    }
    return most;
}

/// a*v + b's values for v in `range`.
Extent values_of(double a, double b, Extent range) {
    if (a == 0) return {b, b};
    const double first = a * range.lower + b;
    const double last = a * range.upper + b;
    return {std::min(first, last), std::max(first, last)};
}

class Quadric final : public Shape {
public:
    explicit Quadric(std::span<const scene::Polynomial::Term> terms) {
        for (const scene::Polynomial::Term& t : terms) {
            const std::array<unsigned, 3> exponents{t.x, t.y, t.z};
            std::array<std::size_t, 2> axes{};
            std::size_t degree = 0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                for (unsigned n = 0; n < exponents[axis]; ++n) axes[degree++] = axis;
            if (degree == 0) {
                constant_ += t.coefficient;
            } else if (degree == 1) {
                linear_[axes[0]] += t.coefficient;
            } else {
                rows_[axes[0]][axes[1]] += 0.5 * t.coefficient;
                rows_[axes[1]][axes[0]] += 0.5 * t.coefficient;
            }
        }
        convex_ = has_no_negative_direction();
    }

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        // From the point nearest to the origin, about which such shapes lie, rounding is least.
        const double t_near =
            std::clamp(-dot(ray.origin, ray.direction) / dot(ray.direction, ray.direction), range.lower, range.upper);
        const Vec3d p = ray.at(t_near);
        const Vec3d d = ray.direction;
        const Vec3d squared_d = squared(d);
        const double a = dot(d, squared_d);
        const double b = 2 * dot(p, squared_d) + dot(linear_, d);
        const double c = value(p);
        const auto append = [&](double s) {
            if (range.contains(t_near + s)) out.push_back({t_near + s});
        };
        if (a == 0) {
            if (b != 0) append(-c / b);
        } else if (const double discriminant = b * b - 4 * a * c; discriminant > 0) {
            const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
            const double s0 = q / a;
            const double s1 = q != 0 ? c / q : -s0;
            append(std::min(s0, s1));
            append(std::max(s0, s1));
        }
        const double start = range.lower - t_near;
        return (a * start + b) * start + c < 0;
    }
    [[nodiscard]] bool is_quick() const override { return true; }
    [[nodiscard]] bool is_convex() const override { return convex_; }
    [[nodiscard]] bool inside(Vec3d p) const override { return value(p) < 0; }
    [[nodiscard]] Vec3d normal(Vec3d p, const Crossing&) const override { return squared(p) * 2.0 + linear_; }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override {
        return transformed(m, part_within(everywhere()));
    }
    [[nodiscard]] Bounds3d bounds_within(const Affine3d& m, const Bounds3d& box) const override {
        const bool along_axes = m.x.y == 0 && m.x.z == 0 && m.y.x == 0 && m.y.z == 0 && m.z.x == 0 && m.z.y == 0;
        if (!along_axes) return common(bounds(m), box);
        Bounds3d in_shape;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double scale = (axis == 0 ? m.x : axis == 1 ? m.y : m.z)[axis];
            const double a = (box.lower[axis] - m.t[axis]) / scale;
            const double b = (box.upper[axis] - m.t[axis]) / scale;
            in_shape.lower[axis] = std::min(a, b);
            in_shape.upper[axis] = std::max(a, b);
        }
        return common(transformed(m, part_within(in_shape)), box);
    }
    [[nodiscard]] ShapeNumbers numbers() const override {
        ShapeNumbers out{ShapeNumbers::Kind::quadric, {}};
        out.add(Vec3d{rows_[0].x, rows_[1].y, rows_[2].z}).add(Vec3d{rows_[0].y, rows_[0].z, rows_[1].z});
        return out.add(linear_).add(constant_);
    }

private:
    [[nodiscard]] Vec3d squared(Vec3d v) const { return {dot(rows_[0], v), dot(rows_[1], v), dot(rows_[2], v)}; }
    [[nodiscard]] double value(Vec3d p) const { return dot(p, squared(p) + linear_) + constant_; }

    /// Whether the terms of second order are negative nowhere: by the signs of all principal minors (Sylvester's
    /// criterion).
    [[nodiscard]] bool has_no_negative_direction() const {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            if (rows_[i][i] < 0 || rows_[i][i] * rows_[j][j] < rows_[i][j] * rows_[i][j]) return false;
        }
        return dot(rows_[0], cross(rows_[1], rows_[2])) >= 0;
    }

    /// A box around the part of the surface and the inside that lies in a box.
    [[nodiscard]] Bounds3d part_within(Bounds3d box) const {
        // Again, as one coordinate's extent may narrow another's.
        for (std::size_t i = 0; i < 6; ++i) {
            const std::size_t axis = i % 3;
            for (std::size_t k = 1; k <= 2; ++k) {
                const std::size_t along = (axis + k) % 3;
                const Extent found = extent(axis, along, 3 - axis - along, {box.lower[along], box.upper[along]});
                // Room for rounding.
                const double lower = found.lower - 1e-9 * std::abs(found.lower);
                const double upper = found.upper + 1e-9 * std::abs(found.upper);
                if (std::isfinite(lower)) box.lower[axis] = std::max(box.lower[axis], lower);
                if (std::isfinite(upper)) box.upper[axis] = std::min(box.upper[axis], upper);
                if (found.empty() || !(box.lower[axis] <= box.upper[axis])) return {};
            }
        }
        return box;
    }

    /// How far coordinate u reaches where the polynomial isn't positive, v is in `range` and w is anything: at the w at
    /// which the polynomial is least.
    [[nodiscard]] Extent extent(std::size_t u, std::size_t v, std::size_t w, Extent range) const {
        const double ww = rows_[w][w];
        if (ww < 0) return {};
        const bool has_w = ww > 0;
        if (!has_w && (rows_[w][u] != 0 || rows_[w][v] != 0 || linear_[w] != 0)) return {};
        const auto without = [&](double term, double one, double other) {
            return has_w ? term - one * other / ww : term;
        };
        const double half_w = 0.5 * linear_[w];
        const double uu = without(rows_[u][u], rows_[w][u], rows_[w][u]);
        const double uv = without(rows_[u][v], rows_[w][u], rows_[w][v]);
        const double vv = without(rows_[v][v], rows_[w][v], rows_[w][v]);
        const double half_u = without(0.5 * linear_[u], rows_[w][u], half_w);
        const double half_v = without(0.5 * linear_[v], rows_[w][v], half_w);
        const double rest = without(constant_, half_w, half_w);
        // uu*u^2 + 2*(uv*v + half_u)*u + (vv*v^2 + 2*half_v*v + rest) <= 0
        if (uu > 1e-12 * (std::abs(rows_[u][u]) + std::abs(uv) + std::abs(vv))) {
            const double a = -uv / uu;
            const double b = -half_u / uu;
            const double most = largest_of(a * a - vv / uu, 2 * (a * b - half_v / uu), b * b - rest / uu, range);
            if (most < 0) return {kInfinity, -kInfinity};
            const Extent middle = values_of(a, b, range);
            return {middle.lower - std::sqrt(most), middle.upper + std::sqrt(most)};
        }
        if (uu != 0 || uv != 0 || half_u == 0) return {};
        const double most = largest_of(-vv, -2 * half_v, -rest, range) / (2 * std::abs(half_u));
        return half_u > 0 ? Extent{-kInfinity, most} : Extent{-most, kInfinity};
    }

    std::array<Vec3d, 3> rows_{};  ///< Of the symmetric matrix of the terms of second order.
    Vec3d linear_;
    double constant_ = 0;
    bool convex_ = false;
};

}  // namespace

ShapePointer make_quadric(std::span<const scene::Polynomial::Term> terms) { return std::make_shared<Quadric>(terms); }

}  // namespace sundog::solids
