// SPDX-License-Identifier: Apache-2.0
// Vectors and affine maps in double precision, for scenes as written: transforms stack up there, and sizes vary widely.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "base/vec.h"

namespace sundog {

/// Three doubles: a point, a direction or a scale.
struct Vec3d {
    double x = 0, y = 0, z = 0;
    double& operator[](std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    double operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    friend bool operator==(const Vec3d&, const Vec3d&) = default;
};

constexpr Vec3d operator+(Vec3d a, Vec3d b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3d operator-(Vec3d a, Vec3d b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3d operator-(Vec3d a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3d operator*(Vec3d a, Vec3d b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
constexpr Vec3d operator*(Vec3d a, double s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr Vec3d operator*(double s, Vec3d a) { return a * s; }
constexpr Vec3d operator/(Vec3d a, double s) { return {a.x / s, a.y / s, a.z / s}; }
constexpr Vec3d& operator+=(Vec3d& a, Vec3d b) { return a = a + b; }
constexpr Vec3d& operator-=(Vec3d& a, Vec3d b) { return a = a - b; }

constexpr double dot(Vec3d a, Vec3d b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3d cross(Vec3d a, Vec3d b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3d a) { return std::sqrt(dot(a, a)); }
/// Unit vector along `a`; `a` itself where its length is zero.
inline Vec3d normalize(Vec3d a) {
    const double len = length(a);
    return len > 0 ? a / len : a;
}
inline bool is_finite(Vec3d a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }
constexpr Vec3 to_float(Vec3d a) { return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)}; }
constexpr Vec3d to_double(Vec3 a) { return {a.x, a.y, a.z}; }

/// An affine map p -> x*p.x + y*p.y + z*p.z + t: three columns and a translation.
struct Affine3d {
    Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, t{0, 0, 0};
    friend bool operator==(const Affine3d&, const Affine3d&) = default;
};

constexpr Vec3d transform_vector(const Affine3d& m, Vec3d v) { return m.x * v.x + m.y * v.y + m.z * v.z; }
constexpr Vec3d transform_point(const Affine3d& m, Vec3d p) { return transform_vector(m, p) + m.t; }
/// A normal carried by the map whose inverse is `inverse_map`: by its transposed linear part. Not normalised.
constexpr Vec3d transform_normal(const Affine3d& inverse_map, Vec3d n) {
    return {dot(inverse_map.x, n), dot(inverse_map.y, n), dot(inverse_map.z, n)};
}
/// a after b: transform_point(a * b, p) == transform_point(a, transform_point(b, p)).
constexpr Affine3d operator*(const Affine3d& a, const Affine3d& b) {
    return {transform_vector(a, b.x), transform_vector(a, b.y), transform_vector(a, b.z), transform_point(a, b.t)};
}
constexpr double determinant(const Affine3d& m) { return dot(m.x, cross(m.y, m.z)); }
/// Inverse of an affine map; undefined for a singular one (check `determinant` first).
constexpr Affine3d inverse(const Affine3d& m) {
    const double d = 1.0 / determinant(m);
    const Vec3d r0 = cross(m.y, m.z) * d;
    const Vec3d r1 = cross(m.z, m.x) * d;
    const Vec3d r2 = cross(m.x, m.y) * d;
    Affine3d inv{{r0.x, r1.x, r2.x}, {r0.y, r1.y, r2.y}, {r0.z, r1.z, r2.z}, {}};
    inv.t = -transform_vector(inv, m.t);
    return inv;
}

/// Axis-aligned bounding box; empty (lower > upper) when default-constructed.
struct Bounds3d {
    Vec3d lower{INFINITY, INFINITY, INFINITY}, upper{-INFINITY, -INFINITY, -INFINITY};
    [[nodiscard]] bool empty() const { return lower.x > upper.x; }
    void include(Vec3d p) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            lower[axis] = p[axis] < lower[axis] ? p[axis] : lower[axis];
            upper[axis] = p[axis] > upper[axis] ? p[axis] : upper[axis];
        }
    }
};

}  // namespace sundog
