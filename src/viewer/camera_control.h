// SPDX-License-Identifier: Apache-2.0
// The window's camera: the scene's own until the user takes it over, then orbit, look, pan, zoom and fly.
#pragma once

#include "base/vec.h"
#include "kernel/shared.h"

namespace sundog::viewer {

/// Window coordinates, y down: a position, or how far the mouse was dragged.
struct MouseMove {
    float dx_px = 0, dy_px = 0;
};

/// Flying: how far along each axis, each -1 to 1; `up` is the world's.
struct FlyDirection {
    float right = 0, forward = 0, up = 0;
    friend bool operator==(const FlyDirection&, const FlyDirection&) = default;
};

/// Moves a kernel::Camera without ever jumping: whatever the camera was (rolled, off-centre, upside down), every
/// gesture is a small rigid motion of it. Orbiting turns about the pivot, a point on the view axis.
class CameraControl {
public:
    /// The scene's bounds at rest decide where the pivot lies and how fast one flies; may be empty.
    void set_bounds(const Bounds3& bounds);
    /// Upwards in the scene, about which yaw turns; z until it is told.
    void set_up(Vec3 up);
    /// The scene's own camera at this moment; shown until the user takes over. One of parallel rays becomes a pinhole
    /// that shows the same around the pivot.
    void follow(const kernel::Camera& scene_camera, bool parallel = false);
    /// Back to the scene's own camera.
    void go_home() { free_ = false; }
    /// True once the user has moved the camera.
    [[nodiscard]] bool is_free() const { return free_; }
    /// What to render with, for a window of width/height = `aspect`.
    [[nodiscard]] kernel::Camera camera(float aspect) const;

    /// Turns about the pivot; a drag over the window's height turns by 180 degrees.
    void orbit(MouseMove drag, float window_height_px);
    /// Turns about the eye towards where the mouse goes, by as much as the picture's centre spans there.
    void look(MouseMove drag, float window_height_px);
    /// Moves sideways, so that the plane through the pivot follows the mouse.
    void pan(MouseMove drag, float window_height_px);
    /// Each step brings the eye 1/8 nearer to the pivot (negative: away).
    void zoom(float steps);
    /// Moves eye and pivot; in one second by half the diagonal of the scene.
    void fly(FlyDirection direction, float seconds);

    /// The point about which orbit() turns.
    [[nodiscard]] Vec3 pivot() const;

private:
    void turn(Vec3 about, float yaw_deg, float pitch_deg);
    /// 1 where right, forward and up are a right-handed system, -1 in one seen in a mirror (POV-Ray's).
    [[nodiscard]] float handedness() const;

    bool free_ = false;
    Bounds3 bounds_;
    float radius_ = 1;
    Vec3 world_up_{0, 0, 1};
    Vec3 eye_, center_{0, 1, 0}, right_{1, 0, 0}, up_{0, 0, 1};
    float pivot_distance_ = 1;  // along the view axis
};

}  // namespace sundog::viewer
