// SPDX-License-Identifier: Apache-2.0
#include "compile/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "compile/compile.h"
#include "fields/function_builder.h"

namespace sundog {
namespace {

kernel::FrameParams frame_of(const scene::ProjectionCamera& camera, int width, int height) {
    scene::Scene scene;
    scene.projection_camera = camera;
    FrameOptions options;
    options.width = width, options.height = height;
    return make_frame(scene, *compile(scene, {}), options).params;
}

scene::ProjectionCamera lens(int samples) {
    scene::ProjectionCamera camera;
    camera.location = {0, 0, -10};
    camera.direction = {0, 0, 2};
    camera.right = {1, 0, 0};
    camera.blur.aperture = 4;
    camera.blur.most_samples = samples, camera.blur.least_samples = std::min(samples, 7);
    return camera;
}

// Catches a plane in focus at the wrong distance, and lenses of another size than povray's (a fourth of the aperture).
TEST(LensCamera, RaysFromTheLensMeetInFocus) {
    for (const int samples : {4, 7, 19, 37, 50}) {
        const scene::ProjectionCamera camera = lens(samples);
        const auto rays = make_lens_camera(camera, {});
        const kernel::FrameParams frame = frame_of(camera, 100, 100);
        float farthest = 0;
        double x = 0;
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(samples); ++i) {
            const auto ray = rays->ray(frame, {70, 20, 0.5F, 0.5F, 0, i});
            ASSERT_TRUE(ray);
            EXPECT_NEAR(-10, ray->origin.z, 1e-5);
            farthest = std::max(farthest, std::hypot(ray->origin.x, ray->origin.y));
            x += ray->origin.x / samples;
            const Vec3 focused = ray->origin + ray->direction * (10 / ray->direction.z);
            // A pixel is a twentieth wide there.
            EXPECT_NEAR(5 * (0.705 - 0.5), focused.x, 0.026) << samples;
            EXPECT_NEAR(5 * (0.5 - 0.205), focused.y, 0.026) << samples;
        }
        EXPECT_LT(farthest, samples == 4 ? 1.42F : 1.08F);
        EXPECT_GT(farthest, 0.6F);
        EXPECT_NEAR(0, x, 0.35);
    }
}

// Catches pixels that stop too late or too early: more samples allow more variance, confidence less.
TEST(LensCamera, EnoughSamplesDependOnVarianceAndConfidence) {
    scene::ProjectionCamera camera = lens(1000);
    camera.blur.variance = 0.001;
    const auto usual = make_lens_camera(camera, {});
    EXPECT_LT(usual->enough_variance(10), usual->enough_variance(100));
    // As povray counts: samples of variance 0.01 with 1000 at most take about 107 of them.
    EXPECT_LT(usual->enough_variance(95), 0.01F);
    EXPECT_GT(usual->enough_variance(120), 0.01F);
    camera.blur.confidence = 0.99;
    EXPECT_LT(make_lens_camera(camera, {})->enough_variance(50), usual->enough_variance(50));
}

std::shared_ptr<scene::SolidMesh> row_of_triangles(std::uint32_t count) {
    auto mesh = std::make_shared<scene::SolidMesh>();
    constexpr std::uint32_t kNone = scene::SolidMesh::kNoIndex;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto x = static_cast<float>(i);
        for (const Vec3 corner : {Vec3{x, 0, 0}, Vec3{x + 0.3F, 0, 0}, Vec3{x, 0.3F, 0}})
            mesh->positions.push_back(corner);
        mesh->triangles.push_back({{3 * i, 3 * i + 1, 3 * i + 2}, {kNone, kNone, kNone}, {kNone, kNone, kNone}, kNone});
    }
    return mesh;
}

// Catches triangles in another order than povray's, whose first two rows are the same.
TEST(MeshCamera, PixelsHaveTheirTriangles) {
    scene::MeshCamera mesh;
    mesh.meshes = {row_of_triangles(12)};
    scene::ProjectionCamera camera;
    camera.mesh = std::make_shared<const scene::MeshCamera>(mesh);
    const auto rays = make_mesh_camera(camera);
    const kernel::FrameParams frame = frame_of({}, 5, 4);
    const auto x_of = [&](std::uint32_t x, std::uint32_t y) { return rays->ray(frame, {x, y}).value().origin.x; };
    EXPECT_NEAR(3.1, x_of(3, 0), 1e-5);
    EXPECT_NEAR(3.1, x_of(3, 1), 1e-5);
    EXPECT_NEAR(8.1, x_of(3, 2), 1e-5);
    EXPECT_NEAR(11.1, x_of(1, 3), 1e-5);
    EXPECT_FALSE(rays->ray(frame, {2, 3}));
    EXPECT_NEAR(-1, rays->ray(frame, {0, 0})->direction.z, 1e-6);
}

// Catches functions asked at other places of the picture than -1/2 .. 1/2, upside down, or before the camera's own
// transformation, and directions of any length.
TEST(FunctionCamera, RaysAreThoseOfItsFunctions) {
    fields::FunctionBuilder places(3), directions(3);
    const std::array<fields::Number, 3> place{places.input(0) * places.constant(8),
                                              places.input(1) * places.constant(4), places.constant(-5)};
    const std::array<fields::Number, 3> direction{directions.input(0), directions.constant(0), directions.constant(2)};
    auto function = std::make_shared<scene::FunctionCamera>();
    function->location = std::make_shared<const scene::Function>(places.finish(place));
    function->direction = std::make_shared<const scene::Function>(directions.finish(direction));
    function->world_from_camera.t = {100, 0, 0};
    scene::ProjectionCamera camera;
    camera.function = function;
    const auto rays = make_function_camera(camera, {});
    const auto ray = rays->ray(frame_of({}, 8, 4), {6, 0});
    ASSERT_TRUE(ray);
    // The middle of that pixel: 6.5 of 8 along x, 0.5 of 4 down from the top.
    EXPECT_NEAR(ray->origin.x, 100 + 8 * 0.3125, 1e-5);
    EXPECT_NEAR(ray->origin.y, 4 * 0.375, 1e-6);
    EXPECT_NEAR(ray->origin.z, -5, 1e-6);
    EXPECT_NEAR(ray->direction.x / ray->direction.z, 0.3125 / 2, 1e-6);
    EXPECT_NEAR(ray->direction.x * ray->direction.x + ray->direction.z * ray->direction.z, 1, 1e-6);
    // Without functions: the camera's own vectors.
    auto plain = std::make_shared<scene::FunctionCamera>();
    camera.function = plain;
    camera.location = {1, 2, 3}, camera.direction = {0, 0, 4};
    const auto parallel = make_function_camera(camera, {})->ray(frame_of({}, 8, 4), {0, 3});
    ASSERT_TRUE(parallel);
    EXPECT_NEAR(parallel->origin.y, 2, 1e-6);
    EXPECT_NEAR(parallel->direction.z, 1, 1e-6);
}

}  // namespace
}  // namespace sundog
