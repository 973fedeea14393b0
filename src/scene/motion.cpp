// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "scene/deformation.h"
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

Light placed_at(const Light& light, float time_s) {
    Light placed = light;
    placed.motion.reset();
    placed.moving = false;
    if (light.motion) {
        const Affine3 world_from_light = transform_at(*light.motion, time_s);
        const bool sun = light.kind == Light::Kind::sun;
        placed.place =
            sun ? transform_vector(world_from_light, light.place) : transform_point(world_from_light, light.place);
        placed.point_at = transform_point(world_from_light, light.point_at);
    } else if (light.moving) {
        placed.place += Vec3{std::cos(time_s * light.speed.x) * light.amplitude.x,
                             std::sin(time_s * light.speed.y) * light.amplitude.y,
                             std::cos(time_s * light.speed.z) * light.amplitude.z};
    }
    return placed;
}

ProjectionCamera placed_at(const ProjectionCamera& camera, float time_s) {
    ProjectionCamera placed = camera;
    if (!camera.motion) return placed;
    placed.motion.reset();
    // A camera keeps its size, however its node is scaled.
    const Affine3 world_from_camera = transform_at(*camera.motion, time_s);
    const auto turned = [&](Vec3d v) {
        const double size = length(v);
        return normalize(to_double(transform_vector(world_from_camera, to_float(v)))) * size;
    };
    placed.location = to_double(transform_point(world_from_camera, to_float(camera.location)));
    placed.direction = turned(camera.direction);
    placed.right = turned(camera.right);
    placed.up = turned(camera.up);
    return placed;
}

bool moves(const Object& object) { return object.motion.has_value() || object.node_motion.has_value(); }

Affine3 transform_at(const ObjectMotion& motion, float time_s) {
    const Vec3 shift{motion.move_amplitude.x * std::sin(motion.move_speed.x * time_s),
                     motion.move_amplitude.y * std::sin(motion.move_speed.y * time_s),
                     motion.move_amplitude.z * std::sin(motion.move_speed.z * time_s)};
    return translation(motion.center + shift) * rotation({0, 0, 1}, value_at(motion.rot_z_deg, time_s)) *
           rotation({0, 1, 0}, value_at(motion.rot_y_deg, time_s)) *
           rotation({1, 0, 0}, value_at(motion.rot_x_deg, time_s)) * translation(-motion.center);
}

Affine3 transform_at(const Object& object, float time_s) {
    return object.node_motion ? transform_at(*object.node_motion, time_s) : transform_at(*object.motion, time_s);
}

bool is_animated(const Scene& scene) {
    const auto turns = [](const Motion& m) { return m.kind != Motion::Kind::constant; };
    if (scene.projection_camera ? scene.projection_camera->motion.has_value()
                                : turns(scene.camera.rot_x_deg) || turns(scene.camera.rot_z_deg))
        return true;
    for (const Light& light : scene.lights)
        if (light.moving || light.motion) return true;
    for (const Object& object : scene.objects)
        if (moves(object)) return true;
    return is_deforming(scene);
}

}  // namespace sundog::scene
