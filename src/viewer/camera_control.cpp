// SPDX-License-Identifier: Apache-2.0
#include "viewer/camera_control.h"

#include <algorithm>
#include <cmath>

namespace sundog::viewer {
namespace {

constexpr float kSteepest_deg = 89.5F;

Vec3 from_kernel(kernel::vec3 v) { return {v.x, v.y, v.z}; }
kernel::vec3 to_kernel(Vec3 v) { return {v.x, v.y, v.z}; }

float degrees(float angle_rad) { return angle_rad * (180 / kPi); }

}  // namespace

void CameraControl::set_bounds(const Bounds3& bounds) {
    bounds_ = bounds;
    const float half_diagonal = bounds.empty() ? 0 : length(bounds.extent()) / 2;
    radius_ = half_diagonal > 0 && std::isfinite(half_diagonal) ? half_diagonal : 1;
}

void CameraControl::set_up(Vec3 up) {
    if (length(up) > 0 && std::isfinite(length(up))) world_up_ = normalize(up);
}

float CameraControl::handedness() const { return dot(cross(right_, center_), up_) < 0 ? -1.0F : 1.0F; }

void CameraControl::follow(const kernel::Camera& scene_camera, bool parallel) {
    if (free_) return;
    eye_ = from_kernel(scene_camera.eye);
    center_ = from_kernel(scene_camera.center);
    right_ = from_kernel(scene_camera.right);
    up_ = from_kernel(scene_camera.up);
    // The pivot is the point of the view axis nearest to the middle of the scene, where that lies ahead.
    const Vec3 target = bounds_.empty() ? Vec3{} : bounds_.center();
    const float along = dot(target - eye_, normalize(center_));
    pivot_distance_ = along > radius_ * 0.05F ? along : radius_;
    if (parallel) center_ = normalize(center_) * pivot_distance_;
}

kernel::Camera CameraControl::camera(float aspect) const {
    Vec3 right = right_;
    // The height of the view stays; the width follows the window.
    if (free_) right = normalize(right_) * (length(up_) * aspect);
    return {to_kernel(eye_), to_kernel(center_), to_kernel(right), to_kernel(up_)};
}

Vec3 CameraControl::pivot() const { return eye_ + normalize(center_) * pivot_distance_; }

void CameraControl::turn(Vec3 about, float yaw_deg, float pitch_deg) {
    free_ = true;
    // Where the camera is upright, it may not tip over the pole; one that already stands on its head may go on.
    const float elevation_deg = degrees(std::atan2(dot(normalize(center_), world_up_), dot(normalize(up_), world_up_)));
    if (std::abs(elevation_deg) <= kSteepest_deg) {
        pitch_deg = std::clamp(elevation_deg + pitch_deg, -kSteepest_deg, kSteepest_deg) - elevation_deg;
    }
    const float hand = handedness();
    const Affine3 map = rotation(world_up_, hand * yaw_deg) * rotation(normalize(right_), hand * pitch_deg);
    eye_ = about + transform_vector(map, eye_ - about);
    center_ = transform_vector(map, center_);
    right_ = transform_vector(map, right_);
    up_ = transform_vector(map, up_);
}

void CameraControl::orbit(MouseMove drag, float window_height_px) {
    const float deg_per_px = 180 / std::max(window_height_px, 1.0F);
    turn(pivot(), -drag.dx_px * deg_per_px, -drag.dy_px * deg_per_px);
}

void CameraControl::look(MouseMove drag, float window_height_px) {
    const float field_of_view_deg = 2 * degrees(std::atan2(length(up_), length(center_)));
    const float deg_per_px = field_of_view_deg / std::max(window_height_px, 1.0F);
    turn(eye_, -drag.dx_px * deg_per_px, -drag.dy_px * deg_per_px);
}

void CameraControl::pan(MouseMove drag, float window_height_px) {
    free_ = true;
    const float world_per_px =
        2 * length(up_) / std::max(window_height_px, 1.0F) * pivot_distance_ / std::max(length(center_), 1e-20F);
    eye_ += (normalize(up_) * drag.dy_px - normalize(right_) * drag.dx_px) * world_per_px;
}

void CameraControl::zoom(float steps) {
    free_ = true;
    const Vec3 target = pivot();
    // Never quite arriving keeps the way back open; never far beyond the scene keeps floats exact.
    pivot_distance_ = std::clamp(pivot_distance_ * std::pow(0.875F, steps), radius_ * 1e-4F, radius_ * 1e4F);
    eye_ = target - normalize(center_) * pivot_distance_;
}

void CameraControl::fly(FlyDirection direction, float seconds) {
    if (direction == FlyDirection{}) return;
    free_ = true;
    const Vec3 way =
        normalize(right_) * direction.right + normalize(center_) * direction.forward + world_up_ * direction.up;
    eye_ += way * (radius_ * seconds);
}

}  // namespace sundog::viewer
