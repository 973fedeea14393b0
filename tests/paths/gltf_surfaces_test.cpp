// SPDX-License-Identifier: Apache-2.0
// What vertices and materials of glTF files have, followed by paths; each brightness is known in closed form.
#include <gtest/gtest.h>

#include "scenes/scene_builder.h"

namespace sundog {
namespace {

using namespace test;

/// Matt, without any reflection off its surface.
scene::Material lambert(Vec3 color) {
    scene::Material m;
    m.principled.emplace();
    m.principled->base_color = color;
    m.principled->metallic = 0;
    m.principled->specular = 0;
    m.principled->double_sided = true;
    return m;
}

/// A wall all over the view at y = 2, which faces the camera; its vertices all have the same attributes.
void add_wall(scene::Scene& s, scene::Index material, const scene::Mesh::Attributes& attributes, bool turned = false) {
    scene::Mesh mesh;
    mesh.positions = {{-9, 2, -9}, {9, 2, -9}, {9, 2, 9}, {-9, 2, 9}};
    mesh.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.attributes.assign(4, attributes);
    constexpr scene::Index n = scene::kNone;
    mesh.triangles.push_back({{0, 1, 2}, {n, n, n}, {0, 1, 2}, material});
    mesh.triangles.push_back({{0, 2, 3}, {n, n, n}, {0, 2, 3}, material});
    if (turned)
        for (scene::Mesh::Triangle& t : mesh.triangles) {
            std::swap(t.position[1], t.position[2]);
            std::swap(t.texcoord[1], t.texcoord[2]);
        }
    add_shape(s, mesh, material);
}

Vec3 mean_radiance(const scene::Scene& s, std::uint32_t samples) {
    const std::unique_ptr<Device> device = make_cpu_device({.threads = 2});
    FrameOptions options = size(8, 8);
    options.integrator = kernel::INTEGRATOR_PATH;
    const Picture picture = render_on(*device, s, options, samples);
    Vec3 sum;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) sum += picture.film.mean(x, y);
    return sum / 64;
}

// A matt wall under a sky of 1 all over is as bright as its colour. Catches vertices' colours that paths don't find, or
// find twice.
TEST(GltfSurfaces, ColorsOfVertices) {
    scene::Scene s = empty_scene();
    s.sky = {1, 1, 1};
    add_wall(s, add_material(s, lambert({0.5F, 1, 1})), {{}, {0.8F, 0.5F, 0.25F}, 1, {}, 1});
    const Vec3 found = mean_radiance(s, 64);
    EXPECT_NEAR(found.x, 0.4F, 0.01F);
    EXPECT_NEAR(found.y, 0.5F, 0.01F);
    EXPECT_NEAR(found.z, 0.25F, 0.01F);
}

// Half of what is seen of a wall of alpha 0.5 is the sky behind it. Catches alpha that paths don't find, and masks that
// compare another number than the product of both alphas.
TEST(GltfSurfaces, AlphaOfVertices) {
    using Alpha = scene::PrincipledSurface::Alpha;
    const auto red = [](Alpha mode, float cutoff) {
        scene::Scene s = empty_scene();
        s.sky = {1, 1, 1};
        scene::Material m = lambert({0, 0, 0});
        m.principled->alpha_mode = mode;
        m.principled->alpha = 0.8F;
        m.principled->alpha_cutoff = cutoff;
        add_wall(s, add_material(s, m), {{}, {1, 1, 1}, 0.5F, {}, 1});
        return mean_radiance(s, 64).x;
    };
    EXPECT_NEAR(red(Alpha::opaque, 0), 0, 1e-6F);
    EXPECT_NEAR(red(Alpha::blend, 0), 0.6F, 0.02F);
    EXPECT_NEAR(red(Alpha::mask, 0.45F), 1, 1e-6F);
    EXPECT_NEAR(red(Alpha::mask, 0.35F), 0, 1e-6F);
}

// Catches backs that the eye sees; and ones that don't stand in the light's way: a sun behind the wall reaches nothing.
TEST(GltfSurfaces, TheEyeAloneLooksThroughBacks) {
    scene::Scene s = empty_scene();
    s.sky = {0.25F, 0.25F, 0.25F};
    scene::Material m = lambert({1, 1, 1});
    m.principled->double_sided = false;
    const scene::Index one_sided = add_material(s, m);
    add_wall(s, one_sided, {}, true);
    EXPECT_NEAR(mean_radiance(s, 16).x, 0.25F, 1e-5F);
    // A matt wall further away, lit from the camera's side through the first one's back: by nothing.
    s.sky = {0, 0, 0};
    add_quad(s, {-9, 4, -9}, {9, 4, -9}, {9, 4, 9}, {-9, 4, 9}, add_material(s, matt({1, 1, 1})));
    add_light(s, scene::Light::Kind::sun, {0, -1, 0});
    EXPECT_NEAR(mean_radiance(s, 16).x, 0, 1e-6F);
    s.objects.erase(s.objects.begin());
    EXPECT_NEAR(mean_radiance(s, 16).x, 1, 0.01F);
}

// A smooth coat on black, whose own normal map leans by 30 degrees to the right, mirrors what stands there: 4% of its
// radiance, by Schlick's formula. Catches a coat that goes by its base's normal, and a map that is read from its
// base's.
TEST(GltfSurfaces, TheCoatHasItsOwnNormal) {
    const auto red = [](bool mapped) {
        scene::Scene s = empty_scene();
        scene::Texture leaning;
        leaning.width = leaning.height = 1;
        leaning.srgb = false;
        leaning.rgba8 = {0xffee80bfU};  // x of 0.5, z of 0.87.
        s.textures.push_back(leaning);
        scene::Material m = lambert({0, 0, 0});
        m.principled->clearcoat = 1;
        m.principled->clearcoat_roughness = 0.1F;
        if (mapped) m.principled->clearcoat_normal_map.texture = 0;
        add_wall(s, add_material(s, m), {{}, {1, 1, 1}, 1, {1, 0, 0}, 1});
        scene::Material shining = matt({0, 0, 0});
        shining.mtl->emission = {10, 10, 10};
        add_quad(s, {5, -40, -40}, {5, -40, 40}, {5, 1.9F, 40}, {5, 1.9F, -40}, add_material(s, shining));
        FrameOptions options = size(8, 8);
        options.integrator = kernel::INTEGRATOR_PATH;
        options.camera = kernel::Camera{{0, 0, 0}, {0, 1, 0}, {0.02F, 0, 0}, {0, 0, 0.02F}};
        const std::unique_ptr<Device> device = make_cpu_device({.threads = 2});
        return render_on(*device, s, options, 64).film.mean(4, 4).x;
    };
    EXPECT_NEAR(red(true), 0.4F, 0.02F);
    EXPECT_LT(red(false), 0.01F);
}

}  // namespace
}  // namespace sundog
