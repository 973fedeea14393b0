// SPDX-License-Identifier: Apache-2.0
#include "stage/builder.h"

#include <cmath>

namespace sundog::intro {

using namespace kernel;

Pose turned(vec3 origin, float first_z, float then_x, float then_z) {
    const float c1 = std::cos(first_z);
    const float s1 = std::sin(first_z);
    const float c2 = std::cos(then_x);
    const float s2 = std::sin(then_x);
    const float c3 = std::cos(then_z);
    const float s3 = std::sin(then_z);
    const auto turn = [=](vec3 v) {
        const vec3 a(c1 * v.x - s1 * v.y, s1 * v.x + c1 * v.y, v.z);
        const vec3 b(a.x, c2 * a.y - s2 * a.z, s2 * a.y + c2 * a.z);
        return vec3(c3 * b.x - s3 * b.y, s3 * b.x + c3 * b.y, b.z);
    };
    return {origin, turn(vec3(1, 0, 0)), turn(vec3(0, 1, 0)), turn(vec3(0, 0, 1))};
}

uint Builder::material(const Material& m) {
    world_.materials[world_.material_count] = m;
    return world_.material_count++;
}

uint Builder::texture(const Texture& t) {
    // Number 0 is no texture.
    if (world_.texture_count == 0) world_.texture_count = 1;
    world_.textures[world_.texture_count] = t;
    return world_.texture_count++;
}

uint Builder::metal(vec3 color) {
    Material m{.highlight = 0.9F, .shininess = 70, .mirror_edge = 1};
    m.diffuse = color * 0.35F;
    m.mirror = color * 0.72F;
    return material(m);
}

uint Builder::polished(const Texture& t) {
    constexpr Material kPolish{.diffuse = {0.95F, 0.95F, 0.95F},
                               .highlight = 0.6F,
                               .shininess = 60,
                               .mirror = {0.04F, 0.04F, 0.04F},
                               .mirror_edge = 0.6F};
    const uint number = material(kPolish);
    world_.materials[number].texture = texture(t);
    return number;
}

uint Builder::glowing(vec3 light) {
    Material m{};
    m.emission = light;
    return material(m);
}

Solid& Builder::solid(SolidKind kind, const Pose& pose, uint material) {
    Solid& s = world_.solids[world_.solid_count++];
    s = Solid{};
    s.kind = kind;
    s.material = material;
    s.casts_shadow = true;
    s.first_part = world_.part_count;
    s.origin = pose.origin;
    s.x = pose.x;
    s.y = pose.y;
    s.z = pose.z;
    cutting_ = false;
    return s;
}

void Builder::plane(vec3 unit_normal, float offset, uint material, const Pose& pose) {
    Solid& s = solid(SolidKind::kPlane, pose, material);
    s.middle = unit_normal;
    s.radius = offset;
    s.casts_shadow = false;
}

void Builder::sphere(vec3 middle, float radius, uint material) {
    Solid& s = solid(SolidKind::kSphere, {middle}, material);
    s.middle = middle;
    s.radius = radius;
}

void Builder::torus(const Pose& pose, float ring, float tube, uint material) {
    carve(pose, vec3(0, 0, 0), ring + tube, material);
    Solid& s = world_.solids[world_.solid_count - 1];
    s.kind = SolidKind::kTorus;
    s.ring = ring;
    s.tube = tube;
}

void Builder::box(vec3 middle, vec3 half, uint material) {
    carve({middle}, vec3(0, 0, 0), length(half), material).block(vec3(0, 0, 0), half);
}

void Builder::cylinder(vec3 foot, float height, float radius, uint material) {
    const vec3 middle(0, 0, height * 0.5F);
    carve({foot}, middle, std::sqrt(radius * radius + middle.z * middle.z), material)
        .tube(2, middle, radius)
        .block(middle, vec3(radius * 1.01F, radius * 1.01F, middle.z));
}

Builder& Builder::carve(const Pose& pose, vec3 middle, float radius, uint material) {
    Solid& s = solid(SolidKind::kCarved, pose, material);
    s.middle = pose.origin + pose.x * middle.x + pose.y * middle.y + pose.z * middle.z;
    s.radius = radius;
    return *this;
}

Builder& Builder::part(const Part& p) {
    world_.parts[world_.part_count++] = p;
    Solid& s = world_.solids[world_.solid_count - 1];
    (cutting_ ? s.cut_count : s.base_count)++;
    return *this;
}

Builder& Builder::ball(vec3 middle, float radius) { return part({PartKind::kBall, 0, middle, {}, radius}); }
Builder& Builder::block(vec3 middle, vec3 half) { return part({PartKind::kBox, 0, middle, half, 0}); }
Builder& Builder::tube(uint axis, vec3 middle, float radius) {
    return part({PartKind::kTube, axis, middle, {}, radius});
}
Builder& Builder::half_space(vec3 unit_normal, float offset) {
    return part({PartKind::kHalfSpace, 0, unit_normal, {}, offset});
}

Builder& Builder::without() {
    cutting_ = true;
    return *this;
}

Lamp& Builder::lamp(vec3 place, vec3 color, float reach, float glow) {
    Lamp& l = world_.lamps[world_.lamp_count++];
    l = Lamp{};
    l.light.kind = LIGHT_LAMP;
    l.light.place = place;
    l.light.color = color;
    l.reach = reach;
    l.glow = glow;
    return l;
}

void Builder::lantern(vec3 place, float radius, vec3 color, float bright, float reach, float glow) {
    sphere(place, radius, glowing(color * (bright * 1.3F)));
    shadowless();
    lamp(place, color * bright, reach, glow);
}

Lamp& Builder::sun(vec3 direction, vec3 color) {
    Lamp& l = lamp(normalize(direction), color, 0, 0);
    l.light.kind = LIGHT_SUN;
    return l;
}

Lamp& Builder::spot(vec3 place, vec3 at, vec3 color, float half_angle, float softness) {
    Lamp& l = lamp(place, color, 0, 0);
    l.light.kind = LIGHT_SPOT;
    l.light.axis = normalize(at - place);
    l.light.dark = std::cos(half_angle);
    l.light.bright = std::cos(half_angle * (1 - softness));
    return l;
}

void Builder::camera(vec3 eye, vec3 at, float lens, float aspect, float roll) {
    const vec3 forward = normalize(at - eye);
    const vec3 level = normalize(cross(forward, vec3(0, 0, 1)));
    const vec3 above = cross(level, forward);
    const float c = std::cos(roll);
    const float s = std::sin(roll);
    // The window is as high as a 16:9 one; wider ones show more at the sides.
    const float half_height = 9.0F / 16.0F;
    world_.camera.eye = eye;
    world_.camera.center = forward * lens;
    world_.camera.right = (level * c + above * s) * (half_height * aspect);
    world_.camera.up = (above * c - level * s) * half_height;
}

}  // namespace sundog::intro
