// SPDX-License-Identifier: Apache-2.0
#include "spd/builder.h"

#include <cmath>
#include <memory>

namespace sundog::bench {
namespace {

constexpr double kHalfHeight = 0.41421356237309503;  // tan 22.5 degrees

}  // namespace

SceneBuilder& SceneBuilder::eye(Vec3 from, Vec3 at, Vec3 up) {
    const Vec3 ahead = normalize(at - from);
    const Vec3 right = normalize(cross(ahead, up));
    scene::ProjectionCamera camera;
    camera.location = to_double(from);
    camera.direction = to_double(ahead);
    camera.right = to_double(right) * (2 * kHalfHeight * 4 / 3);
    camera.up = to_double(cross(right, ahead)) * (2 * kHalfHeight);
    scene_.projection_camera = camera;
    return *this;
}

SceneBuilder& SceneBuilder::light(Vec3 place, float strength) {
    scene::Light& light = scene_.lights.emplace_back();
    light.place = place;
    light.color = {strength, strength, strength};
    return *this;
}

std::uint32_t SceneBuilder::material(Vec3 color, float mirror, bool glass) {
    scene::Material& material = scene_.materials.emplace_back();
    scene::MtlSurface surface;
    surface.diffuse = color;
    if (mirror > 0) {
        surface.specular = {mirror, mirror, mirror};
        surface.shininess = 100;
        surface.illum = 3;
    }
    if (glass) {
        surface.opacity = 0.1F;
        surface.ior = 1.5F;
        surface.illum = 6;
    }
    material.mtl = std::move(surface);
    return static_cast<std::uint32_t>(scene_.materials.size() - 1);
}

scene::Object& SceneBuilder::object() {
    scene::Object& object = scene_.objects.emplace_back();
    object.name = std::to_string(scene_.objects.size());
    return object;
}

void SceneBuilder::sphere(Vec3 center, float radius, std::uint32_t material) {
    scene::Object& ball = object();
    ball.shape = scene::Sphere{center, radius};
    ball.material = material;
}

void SceneBuilder::cone(Vec3 base, float base_radius, Vec3 cap, float cap_radius, std::uint32_t material) {
    auto solid = std::make_shared<scene::Solid>();
    solid->shape = scene::SolidCone{to_double(base), to_double(cap), base_radius, cap_radius, true};
    scene::Object& side = object();
    side.shape = std::shared_ptr<const scene::Solid>(std::move(solid));
    side.material = material;
}

void SceneBuilder::mesh(scene::Mesh mesh) { object().shape = std::move(mesh); }

void SceneBuilder::ground(float half_side, float z, std::uint32_t material) {
    scene::Mesh square;
    const float s = half_side;
    add_triangle(square, {-s, -s, z}, {s, -s, z}, {s, s, z}, material);
    add_triangle(square, {-s, -s, z}, {s, s, z}, {-s, s, z}, material);
    mesh(std::move(square));
}

void add_triangle(scene::Mesh& mesh, Vec3 a, Vec3 b, Vec3 c, std::uint32_t material) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {a, b, c});
    constexpr std::uint32_t none = scene::kNone;
    mesh.triangles.push_back({{first, first + 1, first + 2}, {none, none, none}, {none, none, none}, material});
}

Vec3 perpendicular_to(Vec3 axis) {
    const Vec3 other = std::abs(axis.x) < 0.6F ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    return normalize(cross(axis, other));
}

}  // namespace sundog::bench
