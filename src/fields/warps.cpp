// SPDX-License-Identifier: Apache-2.0
#include "fields/warps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fields/noise.h"
#include "kernel/patterns/noise.h"

namespace sundog::fields {
namespace {

using scene::Warp;

/// From the mapping's own axes, z outwards, to those that `orientation` asks for. Turns for the axes only.
Vec3d oriented(Vec3d orientation, Vec3d p) {
    const double size = length(orientation);
    const Vec3d o = size > 0 ? orientation / size : Vec3d{0, 0, 1};
    return {p.x * (o.y + o.z) + p.z * o.x, p.y * (o.x + o.z) - p.z * o.y, p.y * o.y - p.x * o.x + p.z * o.z};
}

/// An angle as a share of the circle: 0 to 1.
double turn_share(double y, double x) {
    const double share = std::atan2(y, x) / (2 * std::numbers::pi);
    return share < 0 ? share + 1 : share;
}

Vec3d repeated(const Warp& warp, Vec3d p) {
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (std::abs(warp.repeat[i]) > std::abs(warp.repeat[axis])) axis = i;
    const double width = warp.repeat[axis];
    if (width == 0) return p;
    const double copy = std::floor(p[axis] / width);
    Vec3d out = p;
    out[axis] -= copy * width;
    if (std::fmod(std::abs(copy), 2.0) == 1) {
        for (std::size_t i = 0; i < 3; ++i)
            if (warp.flip[i] != 0) out[i] = (i == axis ? width : 0) - out[i];
    }
    return out + warp.offset * copy;
}

Vec3d black_hole(const Warp& warp, Vec3d p) {
    // Where blocks repeat, `corner` is that of the block.
    Vec3d corner, center = warp.center;
    bool repeats = false;
    for (std::size_t i = 0; i < 3; ++i) {
        if (warp.repeat[i] == 0) continue;
        repeats = true;
        center[i] = std::max(center[i], warp.radius);
        const double size = std::max(warp.repeat[i], center[i] + warp.radius + warp.turbulence[i]);
        corner[i] = std::floor(p[i] / size) * size;
    }
    center += corner;
    if (repeats && !(warp.turbulence == Vec3d{})) {
        const auto single = [](double v) { return static_cast<float>(std::clamp(v, -1e6, 1e6) * 16); };
        const std::uint32_t hash = kernel::cell_hash(
            {std::floor(single(corner.x)), std::floor(single(corner.y)), std::floor(single(corner.z))}, 0x35U);
        const auto random = [&](std::uint32_t shift) { return static_cast<double>(hash >> shift & 1023U) / 1023; };
        center += warp.turbulence * Vec3d{random(0), random(10), random(20)};
    }
    const Vec3d from_center = p - center;
    const double distance = length(from_center);
    if (!(distance < warp.radius)) return p;
    const double closeness = 1 - distance / warp.radius;
    const double force = std::min(warp.strength * std::pow(closeness, warp.falloff), 1.0);
    return p + from_center * (warp.inverse ? -force : force);
}

Vec3d spherical(const Warp& warp, Vec3d p) {
    const double radius = length(p);
    if (radius == 0) return p;
    const double size = std::pow(radius, warp.distance_exponent);
    const double latitude = std::asin(std::clamp(p.y / radius, -1.0, 1.0)) / std::numbers::pi + 0.5;
    return oriented(warp.orientation, {turn_share(p.z, p.x) * size, latitude * size, radius});
}

Vec3d cylindrical(const Warp& warp, Vec3d p) {
    const double radius = std::hypot(p.x, p.z);
    if (radius == 0) return p;
    const double size = std::pow(radius, warp.distance_exponent);
    return oriented(warp.orientation, {turn_share(p.z, p.x) * size, p.y, radius});
}

Vec3d toroidal(const Warp& warp, Vec3d p) {
    const double from_axis = std::hypot(p.x, p.z);
    if (from_axis == 0) return p;
    const double outwards = from_axis - warp.major_radius;
    const double radius = std::hypot(outwards, p.y);
    if (radius == 0) return oriented(warp.orientation, {turn_share(p.z, p.x), 0, 0});
    const double size = std::pow(radius, warp.distance_exponent);
    const double around = turn_share(-p.y, -outwards);
    return oriented(warp.orientation, {turn_share(p.z, p.x) * size, around * size, radius});
}

/// A cube's net of four faces in a row, with the upper and the lower one at the second.
Vec3d cubic(Vec3d p) {
    const Vec3d a{std::abs(p.x), std::abs(p.y), std::abs(p.z)};
    const double size = std::max({a.x, a.y, a.z});
    if (size == 0) return p;
    const auto share = [&](double v) { return (v / size + 1) / 2; };
    double column = 1, row = 1, u = share(p.x), v = share(p.y);
    if (a.x >= a.y && a.x >= a.z) {
        column = p.x >= 0 ? 2 : 0;
        u = p.x >= 0 ? share(-p.z) : share(p.z);
    } else if (a.y >= a.z) {
        row = p.y >= 0 ? 2 : 0;
        v = p.y >= 0 ? share(-p.z) : share(p.z);
    } else if (p.z < 0) {
        column = 3;
        u = share(-p.x);
    }
    return {(column + u) / 4, (row + v) / 3, size};
}

}  // namespace

Vec3d warped(const Warp& warp, Vec3d p) {
    switch (warp.kind) {
        case Warp::Kind::turbulence:
            return p + warp.turbulence * turbulence(p, warp.lambda, warp.omega, std::clamp(warp.octaves, 1, 10));
        case Warp::Kind::repeat:
            return repeated(warp, p);
        case Warp::Kind::black_hole:
            return black_hole(warp, p);
        case Warp::Kind::planar:
            return oriented(warp.orientation, {p.x, p.y, warp.distance});
        case Warp::Kind::cylindrical:
            return cylindrical(warp, p);
        case Warp::Kind::spherical:
            return spherical(warp, p);
        case Warp::Kind::toroidal:
            return toroidal(warp, p);
        case Warp::Kind::cubic:
            return cubic(p);
    }
    return p;
}

}  // namespace sundog::fields
