// SPDX-License-Identifier: Apache-2.0
// Storage types of the kernel on the C++ side: what arrays and parameters are made of. Layout is that of
// GLSL's scalar block layout (a vec3 is 12 bytes, aligned to 4), so both sides read the same bytes.
#pragma once

#include <concepts>
#include <cstdint>

namespace sundog::kernel {

using uint = std::uint32_t;

template <class T>
struct Vec2T {
    T x, y;
    Vec2T() = default;
    [[gnu::always_inline]] constexpr Vec2T(T x_, T y_) : x(x_), y(y_) {}
    [[gnu::always_inline]] constexpr explicit Vec2T(T s) : x(s), y(s) {}
    template <std::convertible_to<T> U>
    [[gnu::always_inline]] constexpr Vec2T(const Vec2T<U>& v) : x(v.x), y(v.y) {}
};

template <class T>
struct Vec3T {
    T x, y, z;
    Vec3T() = default;
    [[gnu::always_inline]] constexpr Vec3T(T x_, T y_, T z_) : x(x_), y(y_), z(z_) {}
    [[gnu::always_inline]] constexpr explicit Vec3T(T s) : x(s), y(s), z(s) {}
    template <std::convertible_to<T> U>
    [[gnu::always_inline]] constexpr Vec3T(const Vec3T<U>& v) : x(v.x), y(v.y), z(v.z) {}
};

using vec2 = Vec2T<float>;
using vec3 = Vec3T<float>;
static_assert(sizeof(vec3) == 12 && alignof(vec3) == 4);

}  // namespace sundog::kernel
