// SPDX-License-Identifier: Apache-2.0
// Small scenes written in code, rendered on a device: what analytic tests are made of.
#pragma once

#include <memory>
#include <string>

#include "compile/compile.h"
#include "device/cpu/cpu_device.h"
#include "device/device.h"
#include "scene/scene.h"

namespace sundog::test {

/// A scene with a camera at the origin that looks along +Y, Z up, 90 degrees high; black sky, no ambient.
inline scene::Scene empty_scene() {
    scene::Scene s;
    s.ambient = {0, 0, 0};
    s.sky = {0, 0, 0};
    return s;
}

inline scene::Index add_material(scene::Scene& s, scene::Material m) {
    s.materials.push_back(std::move(m));
    return static_cast<scene::Index>(s.materials.size() - 1);
}

/// Kd alone.
inline scene::Material matt(Vec3 diffuse) {
    scene::Material m;
    m.mtl->diffuse = diffuse;
    m.mtl->illum = 1;
    return m;
}

/// Kd and Ke.
inline scene::Material shining(Vec3 emission, Vec3 diffuse = {0, 0, 0}) {
    scene::Material m = matt(diffuse);
    m.mtl->emission = emission;
    return m;
}

/// Clear glass of MTL's model 7, which mirrors and refracts by Fresnel's equations.
inline scene::Material clear_glass(float ior) {
    scene::Material m = matt({0, 0, 0});
    m.mtl->specular = {1, 1, 1};
    m.mtl->ior = ior;
    m.mtl->opacity = 0;
    m.mtl->illum = 7;
    return m;
}

/// Emits and mirrors: own colour `emission`, reflectance `reflectance`.
inline scene::Material glowing_mirror(Vec3 emission, Vec3 reflectance) {
    scene::Material m;
    m.mtl->diffuse = {0, 0, 0};
    m.mtl->emission = emission;
    m.mtl->specular = reflectance;
    m.mtl->illum = 3;
    return m;
}

template <class Shape>
void add_shape(scene::Scene& s, Shape shape, scene::Index material) {
    scene::Object o;
    o.name = "object" + std::to_string(s.objects.size());
    o.shape = shape;
    o.material = material;
    s.objects.push_back(std::move(o));
}

/// A quadrilateral a, b, c, d of two triangles, counter-clockwise seen from its front.
inline void add_quad(scene::Scene& s, Vec3 a, Vec3 b, Vec3 c, Vec3 d, scene::Index material) {
    scene::Mesh mesh;
    mesh.positions = {a, b, c, d};
    constexpr scene::Index n = scene::kNone;
    mesh.triangles.push_back({{0, 1, 2}, {n, n, n}, {n, n, n}, material});
    mesh.triangles.push_back({{0, 2, 3}, {n, n, n}, {n, n, n}, material});
    add_shape(s, mesh, material);
}

inline void add_light(scene::Scene& s, scene::Light::Kind kind, Vec3 place, Vec3 color = {1, 1, 1}) {
    scene::Light light;
    light.kind = kind;
    light.place = place;
    light.color = color;
    s.lights.push_back(light);
}

/// A rendered picture and what it took.
struct Picture {
    Film film;
    RenderStats stats;
    Frame frame;
};

/// One sample a pixel through the middles, on `device`.
inline Picture render_on(Device& device, const scene::Scene& s, FrameOptions options, std::uint32_t samples = 1) {
    const std::shared_ptr<const RenderScene> compiled = compile(s, {});
    device.load(compiled);
    Frame frame = make_frame(s, *compiled, options);
    const PixelRect all{0, 0, static_cast<int>(frame.params.width), static_cast<int>(frame.params.height)};
    Film film(all, options.aovs);
    const StopFlag stop;
    const RenderStats stats = device.render(frame, {all, 0, samples}, film, stop);
    return {std::move(film), stats, std::move(frame)};
}

/// Looks from the origin along +Y; half the window, one unit before the eye, is `half` wide and high.
inline kernel::Camera narrow_camera(float half) {
    kernel::Camera camera{};
    camera.center = {0, 1, 0};
    camera.right = {half, 0, 0};
    camera.up = {0, 0, half};
    return camera;
}

inline FrameOptions size(int width, int height) {
    FrameOptions options;
    options.width = width;
    options.height = height;
    options.min_weight = 0;
    return options;
}

}  // namespace sundog::test
