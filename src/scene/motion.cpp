// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "scene/scene.h"

namespace sundog::scene {

float value_at(const Motion& motion, float time_s) {
    switch (motion.kind) {
        case Motion::Kind::constant:
            return motion.base;
        case Motion::Kind::wave:
            return motion.base + motion.amplitude * std::sin(motion.speed * time_s);
        case Motion::Kind::linear:
            return motion.speed * time_s;
    }
    return motion.base;
}

Vec3 place_at(const Light& light, float time_s) {
    if (!light.moving) return light.place;
    return light.place + Vec3{std::cos(time_s * light.speed.x) * light.amplitude.x,
                              std::sin(time_s * light.speed.y) * light.amplitude.y,
                              std::cos(time_s * light.speed.z) * light.amplitude.z};
}

Affine3 transform_at(const ObjectMotion& motion, float time_s) {
    const Vec3 shift{motion.move_amplitude.x * std::sin(motion.move_speed.x * time_s),
                     motion.move_amplitude.y * std::sin(motion.move_speed.y * time_s),
                     motion.move_amplitude.z * std::sin(motion.move_speed.z * time_s)};
    return translation(motion.center + shift) * rotation({0, 0, 1}, value_at(motion.rot_z_deg, time_s)) *
           rotation({0, 1, 0}, value_at(motion.rot_y_deg, time_s)) *
           rotation({1, 0, 0}, value_at(motion.rot_x_deg, time_s)) * translation(-motion.center);
}

bool is_animated(const Scene& scene) {
    const auto moves = [](const Motion& m) { return m.kind != Motion::Kind::constant; };
    if (moves(scene.camera.rot_x_deg) || moves(scene.camera.rot_z_deg)) return true;
    for (const Light& light : scene.lights)
        if (light.moving) return true;
    for (const Object& object : scene.objects)
        if (object.motion) return true;
    return false;
}

}  // namespace sundog::scene
