// SPDX-License-Identifier: Apache-2.0
// Host-side vectors and affine maps. Kernels have their own (kernel/compat/types.h).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace sundog {

inline constexpr float kPi = 3.14159265358979323846F;

/// Degrees to radians.
constexpr float radians(float angle_deg) { return angle_deg * (kPi / 180.0F); }

/// Two floats: texture coordinates, window positions.
struct Vec2 {
    float x = 0, y = 0;
    friend bool operator==(const Vec2&, const Vec2&) = default;
};

/// Three floats: a point, a direction or a linear RGB colour; the name of the variable says which.
struct Vec3 {
    float x = 0, y = 0, z = 0;
    float& operator[](std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    float operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    friend bool operator==(const Vec3&, const Vec3&) = default;
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
constexpr Vec3 operator*(Vec3 a, float s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr Vec3 operator*(float s, Vec3 a) { return a * s; }
constexpr Vec3 operator/(Vec3 a, float s) { return {a.x / s, a.y / s, a.z / s}; }
constexpr Vec3& operator+=(Vec3& a, Vec3 b) { return a = a + b; }
constexpr Vec3& operator-=(Vec3& a, Vec3 b) { return a = a - b; }
constexpr Vec3& operator*=(Vec3& a, float s) { return a = a * s; }

constexpr float dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) {  // Right-handed: x cross y is z.
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline float length(Vec3 a) { return std::sqrt(dot(a, a)); }
/// Unit vector along `a`; `a` itself where its length is zero.
inline Vec3 normalize(Vec3 a) {
    const float len = length(a);
    return len > 0 ? a / len : a;
}
constexpr Vec3 min(Vec3 a, Vec3 b) {  // Component by component.
    return {a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.z < b.z ? a.z : b.z};
}
constexpr Vec3 max(Vec3 a, Vec3 b) {  // Component by component.
    return {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z};
}
inline bool is_finite(Vec3 a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

/// An affine map p -> x*p.x + y*p.y + z*p.z + t: three columns and a translation.
struct Affine3 {
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, t{0, 0, 0};
    friend bool operator==(const Affine3&, const Affine3&) = default;
};

constexpr Vec3 transform_vector(const Affine3& m, Vec3 v) { return m.x * v.x + m.y * v.y + m.z * v.z; }
constexpr Vec3 transform_point(const Affine3& m, Vec3 p) { return transform_vector(m, p) + m.t; }
/// a after b: transform_point(a * b, p) == transform_point(a, transform_point(b, p)).
constexpr Affine3 operator*(const Affine3& a, const Affine3& b) {
    return {transform_vector(a, b.x), transform_vector(a, b.y), transform_vector(a, b.z), transform_point(a, b.t)};
}
constexpr Affine3 translation(Vec3 t) { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, t}; }
constexpr Affine3 scaling(Vec3 s) { return {{s.x, 0, 0}, {0, s.y, 0}, {0, 0, s.z}, {0, 0, 0}}; }
/// Rotation by angle_deg about the line through the origin along unit `axis`, counter-clockwise seen from its tip.
inline Affine3 rotation(Vec3 axis, float angle_deg) {
    const float c = std::cos(radians(angle_deg));
    const float s = std::sin(radians(angle_deg));
    const auto column = [&](Vec3 e) { return e * c + cross(axis, e) * s + axis * (dot(axis, e) * (1 - c)); };
    return {column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1}), {0, 0, 0}};
}
/// Inverse of an affine map; undefined for a singular one (check `determinant` first).
constexpr float determinant(const Affine3& m) { return dot(m.x, cross(m.y, m.z)); }
constexpr Affine3 inverse(const Affine3& m) {
    const float d = 1.0F / determinant(m);
    const Vec3 r0 = cross(m.y, m.z) * d;
    const Vec3 r1 = cross(m.z, m.x) * d;
    const Vec3 r2 = cross(m.x, m.y) * d;
    Affine3 inv{{r0.x, r1.x, r2.x}, {r0.y, r1.y, r2.y}, {r0.z, r1.z, r2.z}, {}};
    inv.t = -transform_vector(inv, m.t);
    return inv;
}

/// Axis-aligned bounding box; empty (lower > upper) when default-constructed.
struct Bounds3 {
    Vec3 lower{INFINITY, INFINITY, INFINITY}, upper{-INFINITY, -INFINITY, -INFINITY};
    [[nodiscard]] bool empty() const { return lower.x > upper.x; }
    [[nodiscard]] Vec3 center() const { return (lower + upper) * 0.5F; }
    [[nodiscard]] Vec3 extent() const { return upper - lower; }
    void include(Vec3 p) { lower = min(lower, p), upper = max(upper, p); }
    void include(const Bounds3& b) { lower = min(lower, b.lower), upper = max(upper, b.upper); }
    friend bool operator==(const Bounds3&, const Bounds3&) = default;
};
/// The box around a box that is moved; empty if that is.
inline Bounds3 transformed(const Affine3& m, const Bounds3& box) {
    Bounds3 out;
    if (box.empty()) return out;
    for (unsigned corner = 0; corner < 8; ++corner)
        out.include(transform_point(
            m, {(corner & 1U) != 0 ? box.upper.x : box.lower.x, (corner & 2U) != 0 ? box.upper.y : box.lower.y,
                (corner & 4U) != 0 ? box.upper.z : box.lower.z}));
    return out;
}

}  // namespace sundog
