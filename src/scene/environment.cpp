// SPDX-License-Identifier: Apache-2.0
#include "scene/environment.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sundog::scene {
namespace {

/// The axis, with its sign, that lies nearest to a direction.
Vec3 nearest_axis(Vec3d v) {
    std::size_t longest = 2;
    for (std::size_t i = 0; i < 2; ++i)
        if (std::abs(v[i]) > std::abs(v[longest])) longest = i;
    Vec3 axis{};
    axis[longest] = v[longest] < 0 ? -1.0F : 1.0F;
    return axis;
}

float radiance_of(float value) {
    // Squares of it, and sums over a picture, are to be finite, too.
    constexpr float kMost = 1e9F;
    return value > 0 ? std::min(value, kMost) : 0;  // NaN becomes 0
}

}  // namespace

Compass compass_of(const Scene& scene) {
    Compass compass;
    if (!scene.projection_camera) return compass;
    const ProjectionCamera& camera = *scene.projection_camera;
    compass.up = nearest_axis(camera.sky);
    if (compass.up.y != 0) compass.middle = {0, 0, 1};
    compass.mirrored = dot(cross(camera.direction, camera.up), camera.right) < 0;
    return compass;
}

Vec3 direction_at(const Compass& compass, float azimuth_deg, float elevation_deg) {
    const Vec3 right = cross(compass.middle, compass.up) * (compass.mirrored ? -1.0F : 1.0F);
    const float azimuth = radians(azimuth_deg), elevation = radians(elevation_deg);
    return (compass.middle * std::cos(azimuth) + right * std::sin(azimuth)) * std::cos(elevation) +
           compass.up * std::sin(elevation);
}

Vec3 direction_in(const Environment& environment, float u, float v) {
    const float around = (u - 0.5F) * 2 * kPi, down = v * kPi;
    const Vec3 right = cross(environment.middle, environment.up);
    return (environment.middle * std::cos(around) + right * std::sin(around)) * std::sin(down) +
           environment.up * std::cos(down);
}

void hang(Environment environment, float turn_deg, Scene& scene) {
    const Compass compass = compass_of(scene);
    environment.up = compass.up;
    environment.middle = normalize(direction_at(compass, -turn_deg, 0));
    for (Vec3& pixel : environment.radiance) pixel = {radiance_of(pixel.x), radiance_of(pixel.y), radiance_of(pixel.z)};
    if (compass.mirrored) {
        const auto width = static_cast<std::ptrdiff_t>(environment.width);
        for (auto row = environment.radiance.begin(); row != environment.radiance.end(); row += width)
            std::reverse(row, row + width);
    }
    scene.environment = std::move(environment);
}

}  // namespace sundog::scene
