// SPDX-License-Identifier: Apache-2.0
#include "function_cases.h"

#include <cmath>
#include <random>

namespace sundog::parity {
namespace {

using namespace kernel;

class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}
    float between(float lower, float upper) { return std::uniform_real_distribution<float>(lower, upper)(engine_); }
    /// Spread evenly over orders of magnitude.
    float magnitude(float lower, float upper) { return std::exp(between(std::log(lower), std::log(upper))); }

private:
    std::mt19937 engine_;
};

/// Arguments 0 to 7 as ray_of() in kernel_calls.h reads them: a ray that starts around the unit cube and passes near
/// it.
void put_ray(Random& random, CallValues& a) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        a[axis] = random.between(-4, 4);
        a[3 + axis] = random.between(-1, 1) - a[axis];
    }
    a[6] = 0;
    a[7] = random.between(1, 20);
}

UniformValues uniforms_for(std::uint32_t function, Random& random) {
    UniformValues u{};
    for (float& v : u.v) v = random.between(-1, 1);
    switch (function) {
        case CALL_SPHERE:
            u.v[3] = random.between(0.2F, 1.5F);
            break;
        case CALL_BOX:
        case CALL_BOX_UV:
            for (int axis = 0; axis < 3; ++axis) u.v[3 + axis] = u.v[axis] + random.between(0.2F, 1.5F);
            break;
        case CALL_PLANE: {
            const float length = std::sqrt(u.v[0] * u.v[0] + u.v[1] * u.v[1] + u.v[2] * u.v[2]);
            for (int axis = 0; axis < 3; ++axis) u.v[axis] /= length;
            break;
        }
        case CALL_PINHOLE:
            for (int i = 3; i < 12; ++i) u.v[i] = 0.3F * u.v[i] + (i % 4 == 3 ? 1.0F : 0.0F);
            u.v[12] = random.between(5, 100);
            break;
        case CALL_FIELD:
            u.v[12] = std::floor(random.between(0, FIELD_WAVES + 0.99F));
            u.v[13] = std::floor(random.between(1, 5));
            break;
        case CALL_WAVE:
            u.v[12] = std::floor(random.between(0, WAVE_NONE + 0.99F));
            u.v[13] = random.between(-3, 3);
            u.v[14] = random.between(0.3F, 3);
            break;
        case CALL_CHOICE:
            u.v[12] = std::floor(random.between(0, CHOICE_CUBIC + 0.99F));
            u.v[13] = random.between(1, 3);
            break;
        case CALL_IMAGE_POSITION:
            u.v[12] = std::floor(random.between(0, 3.99F));
            if (u.v[12] == 3) u.v[12] = 5;
            break;
        case CALL_LIGHT_SHARE:
        case CALL_AREA_LIGHT:
            u.v[12] = std::floor(random.between(0, LIGHT_CYLINDER + 0.99F));
            u.v[13] = random.between(0, 3);
            u.v[14] = std::floor(random.between(0, 3));
            u.v[15] = std::floor(random.between(0, 3));
            u.v[16] = random.between(-0.5F, 0.5F);
            u.v[17] = random.between(-0.5F, 0.5F);
            break;
        case CALL_FOG:
        case CALL_LAYER:
            u.v[12] = std::floor(random.between(0, 1.99F));
            u.v[13] = random.between(0.5F, 4);
            break;
        case CALL_NORMAL:  // those that don't run a program
            u.v[12] = std::floor(random.between(NORMAL_BUMPS, NORMAL_WAVES + 0.99F));
            u.v[13] = random.between(0.3F, 3);
            u.v[14] = random.between(0, 1);
            break;
        case CALL_PHASE:
            u.v[12] = std::floor(random.between(1, 5.99F));
            u.v[13] = random.between(-0.8F, 0.8F);
            break;
        case CALL_PROJECTION:
            u.v[12] = std::floor(random.between(0, CAMERA_SPHERICAL + 0.99F));
            u.v[13] = random.between(0.5F, 5);
            break;
        case CALL_PIXEL_SAMPLE:
            u.v[12] = std::floor(random.between(SAMPLES_R2, SAMPLES_SOBOL + 0.99F));
            u.v[13] = std::floor(random.between(0, 4000));
            u.v[14] = std::floor(random.between(0, 8.99F));
            u.v[15] = std::floor(random.between(FILTER_PIXEL, FILTER_BLACKMAN_HARRIS + 0.99F));
            break;
        default:
            break;
    }
    return u;
}

void put_reflection(Random& random, CallValues& a) {
    a[9] = random.magnitude(1, 1000);  // shininess
    a[10] = random.between(0.5F, 2);   // eta
    a[11] = random.between(0, 1);      // cosine
    for (std::size_t i = 12; i < 15; ++i) a[i] = random.between(0, 1);
}

void put_surface(Random& random, CallValues& a) {
    put_ray(random, a);
    a[8] = std::floor(random.between(0, 200));  // a triangle of the textured scene
    a[9] = random.between(0, 1);
    a[10] = random.between(0, 1);
    for (std::size_t i = 11; i < 14; ++i) a[i] = random.between(-1, 1);
    a[14] = std::floor(random.between(0, 4));  // one of its materials
}

CallValues varying_for(std::uint32_t function, Random& random) {
    CallValues a;
    for (float& v : a) v = random.between(-1, 1);
    if (function >= CALL_FIRST_PROCEDURAL) {
        if (function == CALL_FOG) put_ray(random, a);
        if (function == CALL_SINE) a[0] = random.between(-1000, 1000);
        if (function == CALL_FIELD || function == CALL_CHOICE || function == CALL_LIGHT_SHARE ||
            function == CALL_NORMAL)
            for (std::size_t i = 0; i < 3; ++i) a[i] *= 4;
    } else if (function >= CALL_FIRST_SURFACE) {
        put_surface(random, a);
    } else if (function >= CALL_FIRST_PATTERN) {
        for (std::size_t i = 0; i < 4; ++i) a[i] = random.between(i < 2 ? -3 : 1, 7);
    } else if (function >= CALL_FIRST_REFLECTION) {
        put_reflection(random, a);
    } else if (function <= CALL_POWER) {
        a[0] = function == CALL_EXP2 ? random.between(-130, 130) : random.magnitude(1e-30F, 1e30F);
        if (function == CALL_POWER) a[0] = random.between(0, 1);
        a[1] = random.magnitude(0.1F, 1000);
    } else if (function == CALL_TRIANGLE || (function >= CALL_FIRST_SHAPE && function <= CALL_PLANES)) {
        put_ray(random, a);
    }
    return a;
}

}  // namespace

std::vector<FunctionCase> function_cases() {
    return {{"log2", CALL_LOG2, 1e-6F, 1e-6F},
            {"exp2", CALL_EXP2, 1e-6F, 1e-37F},
            // The exponent magnifies the logarithm's error: a thousand times its absolute error of 1e-7.
            {"power", CALL_POWER, 2e-4F, 1e-30F},
            {"angle", CALL_ANGLE, 1e-5F, 1e-6F},
            {"hit_error", CALL_HIT_ERROR, 1e-6F, 0},
            // Differences of numbers near 10 keep 1e-6 of them; grazing rays magnify that.
            {"sphere", CALL_SPHERE, 1e-3F, 1e-3F, true},
            {"box", CALL_BOX, 1e-5F, 1e-5F, true},
            {"plane", CALL_PLANE, 1e-3F, 1e-4F, true},
            {"triangle", CALL_TRIANGLE, 1e-3F, 1e-4F, true},
            {"all_planes", CALL_PLANES, 1e-3F, 1e-4F, true},
            {"sphere_uv", CALL_SPHERE_UV, 1e-5F, 2e-6F},
            {"box_uv", CALL_BOX_UV, 1e-5F, 1e-6F},
            {"plane_uv", CALL_PLANE_UV, 1e-3F, 1e-4F},
            {"interpolate", CALL_INTERPOLATE, 1e-6F, 1e-6F},
            {"lambert", CALL_LAMBERT, 1e-6F, 1e-6F},
            {"mirror", CALL_MIRROR, 1e-6F, 1e-6F},
            {"phong", CALL_PHONG, 2e-3F, 1e-6F},
            {"blinn_phong", CALL_BLINN, 2e-3F, 1e-6F},
            {"refract", CALL_REFRACT, 1e-3F, 1e-3F, true},
            {"fresnel", CALL_FRESNEL, 1e-3F, 1e-4F},
            {"schlick", CALL_SCHLICK, 1e-5F, 1e-6F},
            {"direction_to_light", CALL_LIGHT, 1e-5F, 1e-6F},
            {"pinhole", CALL_PINHOLE, 1e-5F, 1e-6F},
            {"pixel_sample", CALL_PIXEL_SAMPLE, 1e-5F, 1e-5F, true},
            {"checker", CALL_CHECKER, 0, 0, true},
            {"wrap_texel", CALL_WRAP, 0, 0, true},
            {"texture", CALL_TEXTURE, 1e-4F, 1e-4F},
            {"surface", CALL_SURFACE, 1e-4F, 1e-4F},
            {"material", CALL_MATERIAL, 1e-3F, 1e-3F},
            {"bump", CALL_BUMP, 1e-3F, 1e-3F},
            {"sine", CALL_SINE, 1e-5F, 1e-6F},
            // Where a value jumps (from one repeat to the next), the two sides' roundings may fall either way.
            {"field", CALL_FIELD, 1e-4F, 1e-5F, true},
            {"wave", CALL_WAVE, 1e-3F, 1e-4F, true},
            {"choice", CALL_CHOICE, 0, 0, true},
            {"image_position", CALL_IMAGE_POSITION, 1e-4F, 1e-5F, true},
            {"light_share", CALL_LIGHT_SHARE, 1e-3F, 1e-4F, true},
            {"area_light", CALL_AREA_LIGHT, 1e-4F, 1e-5F, true},
            {"fog", CALL_FOG, 1e-3F, 1e-4F},
            {"layer", CALL_LAYER, 1e-3F, 1e-4F, true},
            {"projection", CALL_PROJECTION, 1e-4F, 1e-5F, true},
            {"normal", CALL_NORMAL, 1e-4F, 1e-4F},
            {"phase", CALL_PHASE, 1e-4F, 1e-4F}};
}

Arguments random_arguments(const FunctionCase& function, std::size_t batches) {
    Random random(function.function + 1);
    Arguments arguments;
    for (std::size_t batch = 0; batch < batches; ++batch) {
        arguments.uniforms.push_back(uniforms_for(function.function, random));
        for (std::size_t i = 0; i < CALL_BATCH; ++i)
            arguments.varying.push_back(varying_for(function.function, random));
    }
    return arguments;
}

}  // namespace sundog::parity
