// SPDX-License-Identifier: Apache-2.0
#include "camera_views.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "arguments.h"
#include "usage_error.h"
#include "viewer/replay.h"

namespace sundog::app {
namespace {

constexpr float kHalfHeight_deg = 15;
constexpr float kRoomAround = 1.08F;

kernel::vec3 to_kernel(Vec3 v) { return {v.x, v.y, v.z}; }
Vec3 from_kernel(const kernel::vec3& v) { return {v.x, v.y, v.z}; }

/// Where the camera stands, seen from the middle of the scene.
Vec3 standpoint(View view, const scene::Compass& compass) {
    constexpr float kIsometric_deg = 35.26439F;  // All three axes look equally long.
    switch (view) {
        case View::front:
            return scene::direction_at(compass, 180, 0);
        case View::back:
            return scene::direction_at(compass, 0, 0);
        case View::left:
            return scene::direction_at(compass, -90, 0);
        case View::right:
            return scene::direction_at(compass, 90, 0);
        case View::top:
            return compass.up;
        case View::bottom:
            return -compass.up;
        case View::iso:
            return scene::direction_at(compass, 135, kIsometric_deg);
    }
    return compass.up;
}

}  // namespace

std::variant<View, kernel::Camera> parse_camera(const std::string& text) {
    for (std::size_t i = 0; i < kViewNames.size(); ++i)
        if (kViewNames[i] == text) return static_cast<View>(i);
    // A word is a misspelt view; numbers are a camera.
    if (text.find(',') == std::string::npos) parse_choice("--camera", text, {kViewNames.begin(), kViewNames.end()});
    if (const auto camera = viewer::parse_camera_argument(text)) return *camera;
    throw UsageError(
        "--camera: expected twelve numbers with commas between them: the eye, the way to the window's middle, half "
        "its width and half its height, each x,y,z; or front, back, left, right, top, bottom or iso",
        "the window of 'sundog view' shows the whole command for a picked pixel");
}

kernel::Camera camera_of(View view, const scene::Compass& compass, const Bounds3& bounds, float aspect) {
    const Vec3 extent = bounds.extent();
    if (bounds.empty() || !is_finite(extent) || !(length(extent) > 0))
        throw UsageError(fmt::format("--camera {}: the scene has nothing with an extent",
                                     kViewNames[static_cast<std::size_t>(view)]),
                         "planes and the like have no end; give the camera as twelve numbers");
    const Vec3 to_eye = normalize(standpoint(view, compass));
    const bool vertical = view == View::top || view == View::bottom;
    const Vec3 above = vertical ? compass.middle : compass.up;
    const Vec3 up = normalize(above - to_eye * dot(above, to_eye));
    const Vec3 right = cross(-to_eye, up) * (compass.mirrored ? -1.0F : 1.0F);
    const float half_height = std::tan(radians(kHalfHeight_deg)), half_width = half_height * aspect;
    // As near as all corners allow.
    float distance = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 half = extent * 0.5F;
        const Vec3 at{(corner & 1) != 0 ? half.x : -half.x, (corner & 2) != 0 ? half.y : -half.y,
                      (corner & 4) != 0 ? half.z : -half.z};
        const float aside = std::abs(dot(at, right)) / half_width, over = std::abs(dot(at, up)) / half_height;
        distance = std::max(distance, std::max(aside, over) * kRoomAround + dot(at, to_eye));
    }
    return {to_kernel(bounds.center() + to_eye * distance), to_kernel(-to_eye), to_kernel(right * half_width),
            to_kernel(up * half_height)};
}

kernel::Camera turned(const kernel::Camera& camera, const scene::Compass& compass, Vec3 pivot, float angle_deg) {
    const Affine3 turn = rotation(compass.up, compass.mirrored ? -angle_deg : angle_deg);
    const auto direction = [&](const kernel::vec3& v) { return to_kernel(transform_vector(turn, from_kernel(v))); };
    return {to_kernel(pivot + transform_vector(turn, from_kernel(camera.eye) - pivot)), direction(camera.center),
            direction(camera.right), direction(camera.up)};
}

}  // namespace sundog::app
