// SPDX-License-Identifier: Apache-2.0
#include "import/orbit/object_motion.h"

#include <algorithm>
#include <array>
#include <vector>

#include "import/orbit/orbit_values.h"
#include "scene/bounds.h"

namespace sundog::import {
namespace {

constexpr std::array<std::string_view, 5> kWhat = {"rotX", "rotY", "rotZ", "move", "center"};
constexpr std::string_view kRotationForm =
    "motion = object rotX, rotY or rotZ, then const <deg>, wave <speed> <deg> <amplitude> or linear <speed>";

}  // namespace

MotionLine read_motion_line(LineCursor& value) {
    constexpr std::string_view kForm = "motion = object, then rotX, rotY, rotZ, move or center";
    using Kind = MotionLine::Kind;
    MotionLine motion{Kind::rot_z, {}, {}, {}, {}, {}, value};
    motion.object = value.name(kForm);
    const char* const at = value.here();
    const std::string_view what = value.token(kForm);
    const auto it = std::find(kWhat.begin(), kWhat.end(), what);
    if (it == kWhat.end()) value.fail(at, "unknown motion " + in_quotes(what), suggest(what, kWhat));
    motion.kind = static_cast<Kind>(it - kWhat.begin());
    if (motion.kind == Kind::move) {
        constexpr std::string_view kMoveForm = "motion = object move, then three speeds and three amplitudes";
        motion.speed = take_vec3(value, kMoveForm);
        motion.amplitude = take_vec3(value, kMoveForm);
        value.expect_end(kMoveForm);
    } else if (motion.kind == Kind::center) {
        motion.center = read_vec3(value, "motion = object center x y z");
    } else {
        motion.rotation = read_motion(value, kRotationForm, true);
    }
    return motion;
}

void apply_motion(const MotionLine& motion, std::span<scene::Object> objects) {
    using Kind = MotionLine::Kind;
    bool found = false;
    for (scene::Object& object : objects) {
        if (object.name != motion.object) continue;
        found = true;
        if (!object.motion) object.motion.emplace();
        switch (motion.kind) {
            case Kind::rot_x:
                object.motion->rot_x_deg = motion.rotation;
                break;
            case Kind::rot_y:
                object.motion->rot_y_deg = motion.rotation;
                break;
            case Kind::rot_z:
                object.motion->rot_z_deg = motion.rotation;
                break;
            case Kind::move:
                object.motion->move_speed = motion.speed;
                object.motion->move_amplitude = motion.amplitude;
                break;
            case Kind::center:
                object.motion->center = motion.center;
                break;
        }
    }
    if (found) return;
    std::vector<std::string_view> names;
    for (const scene::Object& object : objects)
        if (std::find(names.begin(), names.end(), object.name) == names.end() && names.size() < 100)
            names.push_back(object.name);
    motion.line.fail(motion.object.data(), "no object is named " + in_quotes(motion.object),
                     names.empty() ? "" : suggest(motion.object, names));
}

void set_motion_centers(std::span<scene::Object> objects, std::span<const MotionLine> motions) {
    for (scene::Object& object : objects) {
        if (!object.motion) continue;
        const bool has_center = std::any_of(motions.begin(), motions.end(), [&](const MotionLine& m) {
            return m.kind == MotionLine::Kind::center && m.object == object.name;
        });
        if (has_center) continue;
        const Bounds3 bounds = scene::bounds_of(object);
        if (!bounds.empty()) object.motion->center = bounds.center();
        else if (const auto* plane = std::get_if<scene::Plane>(&object.shape))
            object.motion->center = plane->normal * plane->offset;
    }
}

}  // namespace sundog::import
