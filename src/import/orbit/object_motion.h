// SPDX-License-Identifier: Apache-2.0
// Lines `motion = object …` of orbit scenes.
#pragma once

#include <span>
#include <string>

#include "base/text_file.h"
#include "scene/scene.h"

namespace sundog::import {

/// One line as written: which object, and what of its motion is set.
struct MotionLine {
    enum class Kind { rot_x, rot_y, rot_z, move, center } kind = Kind::rot_z;
    std::string_view object;
    scene::Motion rotation;
    Vec3 speed, amplitude, center;
    LineCursor line;
};

/// Reads the value of `motion = …`. Errors: InputError.
MotionLine read_motion_line(LineCursor& value);

/// Sets the motion of all objects of that name. Errors: InputError if there is none, or the same was set before.
void apply_motion(const MotionLine& motion, std::span<scene::Object> objects);

/// Gives objects without a `motion = object center …` line their bounding box's centre.
void set_motion_centers(std::span<scene::Object> objects, std::span<const MotionLine> motions);

}  // namespace sundog::import
