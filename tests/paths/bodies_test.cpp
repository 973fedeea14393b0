// SPDX-License-Identifier: Apache-2.0
// Bodies of glass and liquids in each other (kernel/materials/body.h), against Snell's and Beer's laws.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "scenes/scene_builder.h"

namespace sundog {
namespace {

using namespace test;

enum class Kind { whitted, paths, principled };

scene::Material clear_body(Kind kind, float ior) {
    if (kind != Kind::principled) return clear_glass(ior);
    scene::Material m;
    m.principled->metallic = 0;
    m.principled->roughness = 0;
    m.principled->transmission = 1;
    m.principled->thickness = 1;
    m.principled->ior = ior;
    return m;
}

/// A slab across the y axis, so wide that its sides aren't met.
void add_slab(scene::Scene& s, float near, float far, scene::Index material) {
    const float side = 40 + 0.1F * static_cast<float>(s.objects.size());
    add_shape(s, scene::Box{{-side, near, -side}, {side, far, side}}, material);
}

/// A wall at y = 6 that shines from x = edge on.
void add_half_lit_wall(scene::Scene& s, float edge) {
    add_quad(s, {edge, 6, -90}, {90, 6, -90}, {90, 6, 90}, {edge, 6, 90}, add_material(s, shining({1, 1, 1})));
}

/// How bright the one place is that is seen 45 degrees to the right.
float seen_aslant(const scene::Scene& s, Kind kind) {
    const std::unique_ptr<Device> device = make_cpu_device({.threads = 2});
    FrameOptions options = size(1, 1);
    options.max_depth = 12;
    if (kind != Kind::whitted) options.integrator = kernel::INTEGRATOR_PATH;
    kernel::Camera camera{};
    const float half = std::sqrt(0.5F);
    camera.center = {half, half, 0};
    camera.right = {1e-4F * half, -1e-4F * half, 0};
    camera.up = {0, 0, 1e-4F};
    options.camera = camera;
    return render_on(*device, s, options, kind == Kind::whitted ? 1 : 256).film.mean(0, 0).x;
}

/// How far a ray that goes 45 degrees aslant in air gets to the side on a way of 1 through slabs.
float tangent_in(float ior) {
    const float sine = std::sqrt(0.5F) / ior;
    return sine / std::sqrt(1 - sine * sine);
}

constexpr float kGlass = 1.5F, kWater = 1.33F;

void expect_edge_at(float x, Kind kind,
                    const std::function<void(scene::Scene&, scene::Index, scene::Index)>& add_slabs) {
    for (const float beside : {-0.03F, 0.03F}) {
        scene::Scene s = empty_scene();
        const scene::Index glass = add_material(s, clear_body(kind, kGlass));
        add_slabs(s, glass, add_material(s, clear_body(kind, kWater)));
        add_half_lit_wall(s, x + beside);
        const float seen = seen_aslant(s, kind);
        if (beside < 0) EXPECT_GT(seen, 0.6F) << static_cast<int>(kind);
        else EXPECT_LT(seen, 0.3F) << static_cast<int>(kind);
    }
}

// Water in glass, and water that reaches into the glass around it: light is bent where the one that was entered last
// begins and ends. Catches surfaces that know nothing of what is around them, which bend light as in air.
TEST(Bodies, LightIsBentByWhatIsOnBothSides) {
    for (const Kind kind : {Kind::whitted, Kind::paths, Kind::principled}) {
        const float glass = tangent_in(kGlass), water = tangent_in(kWater);
        expect_edge_at(1 + glass + water + glass + 2, kind, [](scene::Scene& s, scene::Index g, scene::Index w) {
            add_slab(s, 1, 4, g);
            add_slab(s, 2, 3, w);
        });
        expect_edge_at(1 + glass + 0.7F * water + 1.3F * glass + 2, kind,
                       [](scene::Scene& s, scene::Index g, scene::Index w) {
                           add_slab(s, 1, 2.3F, g);
                           add_slab(s, 2.7F, 4, g);
                           add_slab(s, 2, 3, w);
                       });
    }
}

// Two blocks of one glass that reach into each other look like one block. Catches a seam, and a body that ends where
// the second begins.
TEST(Bodies, WhatIsOfOneGlassHasNoSeams) {
    const auto picture = [](Kind kind, bool in_two) {
        scene::Scene s = empty_scene();
        const scene::Index glass = add_material(s, clear_body(kind, kGlass));
        if (in_two) {
            add_shape(s, scene::Box{{-1, 2, -1}, {0.4F, 3, 1}}, glass);
            add_shape(s, scene::Box{{-0.4F, 2.0005F, -0.9995F}, {1, 2.9995F, 0.9995F}}, glass);
        } else {
            add_shape(s, scene::Box{{-1, 2, -1}, {1, 3, 1}}, glass);
        }
        for (int i = -9; i < 9; ++i) {
            const auto x = static_cast<float>(i);
            add_quad(s, {x, 6, -9}, {x + 0.5F, 6, -9}, {x + 0.5F, 6, 9}, {x, 6, 9},
                     add_material(s, shining({1, 1, 1})));
        }
        const std::unique_ptr<Device> device = make_cpu_device({.threads = 2});
        FrameOptions options = size(48, 48);
        options.max_depth = 12;
        if (kind != Kind::whitted) options.integrator = kernel::INTEGRATOR_PATH;
        return render_on(*device, s, options, kind == Kind::whitted ? 1 : 1024).film;
    };
    for (const Kind kind : {Kind::whitted, Kind::paths, Kind::principled}) {
        const Film one = picture(kind, false), two = picture(kind, true);
        double apart = 0;
        int far_apart = 0;
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 48; ++x) {
                const double here = std::abs(one.mean(x, y).x - two.mean(x, y).x);
                apart += here / (48 * 48);
                far_apart += here > 0.2 ? 1 : 0;
            }
        EXPECT_LT(apart, 0.012) << static_cast<int>(kind);
        EXPECT_LE(far_apart, 8) << static_cast<int>(kind);
    }
}

// Light that half of is left after a way of 1 is a quarter after 2, whether the way ends at the body's own surface, at
// something in it, or at another body. Catches light that isn't dimmed on its way to what isn't the body's.
TEST(Bodies, WhatIsInThemIsSeenThroughThem) {
    for (const bool inner : {false, true}) {
        scene::Scene s = empty_scene();
        scene::Material dim = clear_body(Kind::principled, 1);
        dim.principled->specular = 0;
        dim.principled->attenuation_color = {0.5F, 0.25F, 1};
        dim.principled->attenuation_distance = 1;
        add_slab(s, 1, 8, add_material(s, dim));
        if (inner) add_slab(s, 2, 2.5F, add_material(s, clear_body(Kind::principled, 1.0001F)));
        add_quad(s, {-9, 3, -9}, {9, 3, -9}, {9, 3, 9}, {-9, 3, 9}, add_material(s, shining({1, 1, 1})));
        const std::unique_ptr<Device> device = make_cpu_device({.threads = 2});
        FrameOptions options = size(1, 1);
        options.integrator = kernel::INTEGRATOR_PATH;
        options.camera = narrow_camera(1e-4F);
        const Vec3 seen = render_on(*device, s, options, 64).film.mean(0, 0);
        const float way = inner ? 1.5F : 2.0F;
        EXPECT_NEAR(seen.x, std::pow(0.5F, way), 0.01F) << inner;
        EXPECT_NEAR(seen.y, std::pow(0.25F, way), 0.01F) << inner;
        EXPECT_NEAR(seen.z, 1, 0.01F) << inner;
    }
}

// Bodies in each other lose no light.
TEST(Bodies, AreInvisibleInEvenLight) {
    for (const Kind kind : {Kind::paths, Kind::principled}) {
        scene::Scene s = empty_scene();
        s.sky = {1, 1, 1};
        const scene::Index glass = add_material(s, clear_body(kind, kGlass));
        add_shape(s, scene::Sphere{{0, 4, 0}, 2}, glass);
        add_shape(s, scene::Sphere{{0.5F, 4, 0}, 1}, add_material(s, clear_body(kind, kWater)));
        add_shape(s, scene::Sphere{{-1.5F, 4, 0}, 1}, glass);
        const std::unique_ptr<Device> device = make_cpu_device({.threads = 2});
        FrameOptions options = size(24, 24);
        options.integrator = kernel::INTEGRATOR_PATH;
        options.max_depth = 64;
        const Film film = render_on(*device, s, options, 256).film;
        double sum = 0;
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 24; ++x) sum += film.mean(x, y).x;
        EXPECT_NEAR(sum / (24 * 24), 1, 0.01) << static_cast<int>(kind);
    }
}

}  // namespace
}  // namespace sundog
