// SPDX-License-Identifier: Apache-2.0
#include "scene/validate.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace sundog::scene {
namespace {

Scene good_scene() {
    Scene scene;
    scene.materials.emplace_back();
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{{0, 1, 2}, {kNone, kNone, kNone}, {kNone, kNone, kNone}, 0}};
    scene.objects.push_back({"triangle", {}, mesh, 0, std::nullopt});
    scene.objects.push_back({"ball", {}, Sphere{{0, 0, 0}, 1}, 0, std::nullopt});
    scene.lights.emplace_back();
    return scene;
}

// Catches a promise that is not checked: each case breaks one.
TEST(Validate, FindsEachBrokenPromise) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    const auto mesh = [](Scene& s) -> Mesh& { return *std::get<Boxed<Mesh>>(s.objects[0].shape); };
    EXPECT_NO_THROW(validate(good_scene()));
    const std::vector<std::function<void(Scene&)>> faults = {
        [](Scene& s) { s.materials.clear(); },
        [&](Scene& s) { mesh(s).triangles[0].position[2] = 3; },
        [&](Scene& s) { mesh(s).triangles[0].position[0] = kNone; },
        [&](Scene& s) { mesh(s).triangles[0].normal[1] = 0; },
        [&](Scene& s) { mesh(s).triangles[0].texcoord[1] = 0; },
        [&](Scene& s) { mesh(s).triangles[0].material = 1; },
        [&](Scene& s) { mesh(s).positions[1].y = kNan; },
        [](Scene& s) { std::get<Sphere>(s.objects[1].shape).radius = 0; },
        [](Scene& s) { s.objects[1].material = kNone; },
        [](Scene& s) {
            s.objects[1].shape = Plane{{0, 0, 2}, 0};
        },
        [](Scene& s) {
            s.objects[1].shape = Box{{0, 0, 0}, {1, -1, 1}};
        },
        [](Scene& s) { s.objects[1].motion.emplace().rot_y_deg.speed = kNan; },
        [](Scene& s) { s.materials[0].mtl->map_bump.texture = 0; },
        [](Scene& s) { s.materials[0].mtl->ior = 0; },
        [](Scene& s) { s.materials[0].mtl->diffuse.z = INFINITY; },
        [](Scene& s) {
            s.textures.push_back({"t", {}, 2, 2, {1, 2, 3}, true});
        },
        [](Scene& s) { s.lights[0].place.x = kNan; },
        [](Scene& s) { s.camera.focus = 0; },
        [](Scene& s) { s.sky.x = INFINITY; },
    };
    for (std::size_t i = 0; i < faults.size(); ++i) {
        Scene scene = good_scene();
        faults[i](scene);
        EXPECT_THROW(validate(scene), InputError) << "fault " << i;
    }
}

}  // namespace
}  // namespace sundog::scene
