// SPDX-License-Identifier: Apache-2.0
// Cameras that find a scene by themselves, and one that goes round it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "base/vec.h"
#include "kernel/shared.h"
#include "scene/environment.h"

namespace sundog::app {

/// From where a scene is looked at.
enum class View { front, back, left, right, top, bottom, iso };
inline constexpr std::array<std::string_view, 7> kViewNames{"front", "back", "left", "right", "top", "bottom", "iso"};

/// A view's name, or twelve numbers (see viewer::parse_camera_argument). Errors: UsageError.
std::variant<View, kernel::Camera> parse_camera(const std::string& text);

/// A pinhole, 30 degrees high, that shows all of `bounds` with a little around it. `front` looks to the compass's
/// middle; `top` and `bottom` have it at the picture's top; `iso` stands in front, to the right and above. Errors:
/// UsageError for bounds without an inside, or without an end.
kernel::Camera camera_of(View view, const scene::Compass& compass, const Bounds3& bounds, float aspect);

/// The camera after it has gone round a point by an angle, counter-clockwise as seen from above.
kernel::Camera turned(const kernel::Camera& camera, const scene::Compass& compass, Vec3 pivot, float angle_deg);

}  // namespace sundog::app
