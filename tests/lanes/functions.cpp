// SPDX-License-Identifier: Apache-2.0
// Compiled once per width (SUNDOG_KERNEL_LANES).
#include "lanes/functions.h"

#include <cstring>

#include "kernel/cameras/pinhole.h"
#include "kernel/lights/light.h"
#include "kernel/materials/reflection.h"
#include "kernel/patterns/texture.h"
#include "kernel/shapes/box.h"
#include "kernel/shapes/plane.h"
#include "kernel/shapes/sphere.h"
#include "kernel/shapes/triangle.h"

namespace sundog::test {
namespace {

using namespace kernel;

/// One group of lanes' numbers.
struct Numbers {
    real in[kInputs];
    real out[kOutputs];
};

real3 triple(const real* first) { return real3(first[0], first[1], first[2]); }
void put(real* first, real3 v) { first[0] = v.x, first[1] = v.y, first[2] = v.z; }
real number(mask m) { return select(m, real(1.0F), real(0.0F)); }

Ray ray_of(const real* first) {
    Ray ray;
    ray.origin = triple(first);
    ray.direction = normalize(triple(first + 3));
    ray.t_min = real(0.0F);
    ray.t_max = real(100.0F);
    return ray;
}

/// A hit's numbers where there is one, zeros elsewhere: what a miss leaves behind is nobody's business.
void put_hit(real* out, mask found, real t, real3 normal) {
    const real zero(0.0F);
    out[0] = number(found);
    out[1] = select(found, t, zero);
    put(out + 2, select(found, normal, real3(zero)));
}

void sphere(Numbers& n) {
    real t;
    real3 normal;
    const mask found = intersect_sphere(ray_of(n.in), vec3(0.1F, -0.2F, 0.3F), 0.9F, t, normal);
    put_hit(n.out, found, t, normal);
}
void box(Numbers& n) {
    real t;
    real3 normal;
    const mask found = intersect_box(ray_of(n.in), vec3(-0.7F, -0.5F, -0.3F), vec3(0.4F, 0.6F, 0.8F), t, normal);
    put_hit(n.out, found, t, normal);
}
void plane(Numbers& n) {
    real t;
    const mask found = intersect_plane(ray_of(n.in), vec3(0.6F, 0.0F, 0.8F), 0.1F, t);
    put_hit(n.out, found, t, real3(real(0.0F)));
}
void triangle(Numbers& n) {
    real t, u, v;
    real3 normal;
    const mask found =
        intersect_triangle(ray_of(n.in), real3(real(-1.0F), real(0.2F), real(-1.0F)),
                           real3(real(1.0F), real(0.1F), real(-0.8F)), triple(n.in + 6), t, u, v, normal);
    put_hit(n.out, found, t, normal);
    n.out[5] = select(found, u, real(0.0F));
    n.out[6] = select(found, v, real(0.0F));
}
void texture_coordinates(Numbers& n) {
    const real3 unit = normalize(triple(n.in));
    const real2 a = sphere_uv(unit);
    const real2 b = plane_uv(triple(n.in + 3), unit);
    const real2 c = box_uv(triple(n.in + 3), unit, real3(real(-1.0F)), real3(real(1.0F)));
    n.out[0] = a.x, n.out[1] = a.y, n.out[2] = b.x, n.out[3] = b.y, n.out[4] = c.x, n.out[5] = c.y;
}
void powers(Numbers& n) {
    n.out[0] = power(abs(n.in[0]), abs(n.in[1]) * 100.0F);
    n.out[1] = log2_positive(abs(n.in[0]) + 1e-6F);
    n.out[2] = exp2_clamped(n.in[1] * 40.0F);
    n.out[3] = angle_of(n.in[2], n.in[3]);
}
void highlights(Numbers& n) {
    const real3 normal = normalize(triple(n.in));
    const real3 to_light = normalize(triple(n.in + 3));
    const real3 to_eye = normalize(triple(n.in + 6));
    const real shininess = abs(n.in[9]) * 50.0F;
    n.out[0] = lambert(normal, to_light);
    n.out[1] = phong_highlight(normal, to_light, to_eye, shininess);
    n.out[2] = blinn_phong_highlight(normal, to_light, to_eye, shininess);
}
void reflections(Numbers& n) {
    const real3 normal = normalize(triple(n.in));
    const real3 incoming = normalize(triple(n.in + 3));
    put(n.out, mirror_direction(incoming, normal));
    n.out[3] = fresnel_dielectric(-dot(incoming, normal), abs(n.in[6]) + 0.2F);
    put(n.out + 4, fresnel_schlick(abs(triple(n.in + 7)) * real(0.5F), -dot(incoming, normal)));
}
void refraction(Numbers& n) {
    const real3 incoming = normalize(triple(n.in + 3));
    real3 normal = normalize(triple(n.in));
    normal = select(dot(normal, incoming) > real(0.0F), -normal, normal);
    real3 refracted;
    const mask passes = refract_direction(incoming, normal, abs(n.in[6]) + 0.2F, refracted);
    n.out[0] = number(passes);
    put(n.out + 1, select(passes, refracted, real3(real(0.0F))));
}
void camera(Numbers& n) {
    Camera c;
    c.eye = vec3(1.0F, 2.0F, 3.0F);
    c.center = vec3(0.0F, 1.5F, 0.0F);
    c.right = vec3(1.3F, 0.0F, 0.0F);
    c.up = vec3(0.0F, 0.0F, 1.0F);
    const Ray ray = pinhole_ray(c, n.in[0], n.in[1], 50.0F);
    put(n.out, ray.direction);
    n.out[3] = ray.t_max;
}
void light(Numbers& n) {
    Light lamp{};
    lamp.place = vec3(0.3F, 0.4F, 2.0F);
    lamp.kind = LIGHT_LAMP;
    real distance;
    put(n.out, direction_to_light(lamp, triple(n.in), distance));
    n.out[3] = distance;
}
void checker(Numbers& n) {
    n.out[0] = number(checker_is_other(real2(n.in[0], n.in[1]), real2(abs(n.in[2]) * 9.0F, abs(n.in[3]) * 7.0F)));
}

struct Function {
    std::string_view name;
    void (*call)(Numbers&);
};
constexpr Function kFunctions[] = {
    {"intersect_sphere", sphere},     {"intersect_box", box},           {"intersect_plane", plane},
    {"intersect_triangle", triangle}, {"uvs", texture_coordinates},     {"power, log2, exp2, angle", powers},
    {"highlights", highlights},       {"mirror, fresnel", reflections}, {"refract_direction", refraction},
    {"pinhole_ray", camera},          {"direction_to_light", light},    {"checker", checker}};

}  // namespace

std::string_view SUNDOG_KERNEL_PASTE(evaluate_, SUNDOG_KERNEL_LANES)(std::size_t function, const Batch& batch) {
    if (function >= std::size(kFunctions)) return {};
    for (std::size_t i = 0; i < batch.count; i += SUNDOG_KERNEL_LANES) {
        Numbers n;
        for (real& out : n.out) out = real(0.0F);
        for (std::size_t k = 0; k < kInputs; ++k) std::memcpy(&n.in[k], batch.inputs[k] + i, sizeof(real));
        kFunctions[function].call(n);
        for (std::size_t k = 0; k < kOutputs; ++k) std::memcpy(batch.outputs[k] + i, &n.out[k], sizeof(real));
    }
    return kFunctions[function].name;
}

}  // namespace sundog::test
