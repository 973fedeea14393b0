// SPDX-License-Identifier: Apache-2.0
// Exact solids, what some rays don't see, and back faces left out, through structures of ours; and Embree beside them.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <tuple>

#include "compile/compile.h"
#include "device/accel/world.h"
#include "device/cpu/embree_scene.h"

namespace sundog::cpu {
namespace {

constexpr Acceleration kOurs[] = {Acceleration::bvh,  Acceleration::kdtree, Acceleration::octree,
                                  Acceleration::grid, Acceleration::boxes,  Acceleration::none};

template <class T>
scene::Object solid_object(T shape, Vec3d at, std::uint32_t material) {
    auto solid = std::make_shared<scene::Solid>();
    solid->shape = std::move(shape);
    solid->parent_from_shape.t = at;
    scene::Object object;
    object.shape = std::shared_ptr<const scene::Solid>(std::move(solid));
    object.material = material;
    return object;
}

/// Tori, cones, spheres, boxes and a paraboloid without an end.
scene::Scene many_shapes() {
    scene::Scene scene;
    scene.materials.resize(3);
    std::mt19937 engine(7);
    const auto at = [&] {
        std::uniform_real_distribution<double> place(-5, 5);
        const double x = place(engine), y = place(engine);
        return Vec3d{x, y, place(engine)};
    };
    for (int i = 0; i < 40; ++i) {
        scene.objects.push_back(solid_object(scene::Torus{1, 0.25}, at(), 1));
        scene.objects.push_back(solid_object(scene::SolidCone{{0, 0, 0}, {0, 1, 0}, 0.7, 0.2, i % 2 == 0}, at(), 2));
        scene::Object ball;
        const Vec3d c = at();
        ball.shape = scene::Sphere{{static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z)}, 0.5F};
        scene.objects.push_back(ball);
    }
    scene::Polynomial paraboloid{2, {{2, 0, 0, 1}, {0, 0, 2, 1}, {0, 1, 0, 1}}};
    scene.objects.push_back(solid_object(paraboloid, {0, -6, 0}, 1));
    for (std::size_t i = 0; i < scene.objects.size(); ++i) scene.objects[i].name = std::to_string(i);
    return scene;
}

std::vector<kernel::Ray> rays_into(float size, int count) {
    std::mt19937 engine(5);
    std::uniform_real_distribution<float> place(-size, size);
    std::vector<kernel::Ray> rays;
    for (int i = 0; i < count; ++i) {
        const auto point = [&] {
            const float x = place(engine), y = place(engine);
            return Vec3{x, y, place(engine)};
        };
        const Vec3 origin = point() * (i % 3 == 0 ? 10.0F : 1.0F);
        const Vec3 direction = normalize(point() - origin);
        kernel::Ray ray;
        ray.origin = {origin.x, origin.y, origin.z};
        ray.direction = {direction.x, direction.y, direction.z};
        ray.t_min = 0;
        ray.t_max = i % 4 == 3 ? size : 3e38F;
        rays.push_back(ray);
    }
    return rays;
}

using Key = std::tuple<std::uint32_t, std::uint32_t, float, float, float>;

/// What a structure finds: geometry, primitive, t, u and v.
Key found_by(const accel::World& world, const kernel::Ray& ray, std::uint32_t kind) {
    accel::Scratch scratch;
    accel::Steps steps;
    const auto hit = world.nearest(ray, kind, scratch, steps);
    EXPECT_EQ(hit.has_value(), world.any(ray, kind, scratch, steps));
    return hit ? Key{hit->geometry, hit->primitive, hit->t, hit->u, hit->v} : Key{kernel::NONE, 0, 0, 0, 0};
}

RTCRayHit found_by_embree(const EmbreeScene& scene, const kernel::Ray& ray) {
    RTCRayHit r{};
    r.ray.org_x = ray.origin.x, r.ray.org_y = ray.origin.y, r.ray.org_z = ray.origin.z;
    r.ray.dir_x = ray.direction.x, r.ray.dir_y = ray.direction.y, r.ray.dir_z = ray.direction.z;
    r.ray.tfar = ray.t_max;
    r.ray.mask = kernel::RAY_CAMERA;
    r.hit.geomID = r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(scene.handle(), &r, nullptr);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene.handle(), &context, &r);
#endif
    return r;
}

// Catches solids whose roots come out otherwise for each order of tests, solids without an end that are lost or spoil a
// structure, and other objects than Embree finds.
TEST(StructureScenes, SolidsAreHitAsEmbreeHitsThem) {
    const auto compiled = compile(many_shapes(), {});
    const auto rays = rays_into(6, 3000);
    const embree::Device device(rtcNewDevice("threads=1"));
    const EmbreeScene embree(device.get(), *compiled);
    const accel::World none(Acceleration::none, *compiled);
    std::size_t other_objects = 0, hits = 0;
    for (const kernel::Ray& ray : rays) {
        const Key ours = found_by(none, ray, kernel::RAY_CAMERA);
        const RTCRayHit theirs = found_by_embree(embree, ray);
        if (theirs.hit.geomID != kernel::NONE) ++hits;
        if (std::get<0>(ours) != theirs.hit.geomID) {
            ++other_objects;
        } else if (theirs.hit.geomID != kernel::NONE) {
            EXPECT_NEAR(std::get<2>(ours), theirs.ray.tfar, 1e-4F);
        }
    }
    EXPECT_GT(hits, 1000U);
    EXPECT_LE(other_objects, 2U);
    for (const Acceleration which : kOurs) {
        SCOPED_TRACE(name_of(which));
        const accel::World world(which, *compiled);
        for (const kernel::Ray& ray : rays)
            ASSERT_EQ(found_by(world, ray, kernel::RAY_CAMERA), found_by(none, ray, kernel::RAY_CAMERA));
    }
}

// Catches an endless solid in the structure itself, where it would make all other things look like a point.
TEST(StructureScenes, WhatHasNoEndSpoilsNothing) {
    const auto compiled = compile(many_shapes(), {});
    for (const Acceleration which :
         {Acceleration::bvh, Acceleration::kdtree, Acceleration::octree, Acceleration::grid}) {
        SCOPED_TRACE(name_of(which));
        const accel::World world(which, *compiled);
        accel::Scratch scratch;
        accel::Steps steps;
        const auto rays = rays_into(6, 500);
        for (const kernel::Ray& ray : rays) (void)world.nearest(ray, kernel::RAY_CAMERA, scratch, steps);
        EXPECT_LT(steps.tests, 30 * rays.size());  // of 121
    }
}

// Catches no_shadow and the like not kept.
TEST(StructureScenes, GeometriesHideFromSomeRays) {
    scene::Scene scene;
    scene.materials.resize(1);
    scene.objects.push_back(solid_object(scene::Torus{1, 0.4}, {0, 0, 0}, 0));
    scene::Object ball;
    ball.shape = scene::Sphere{{1, 0, 0}, 0.5F};
    scene.objects.push_back(ball);
    for (scene::Object& object : scene.objects) object.casts_shadow = false;
    const auto compiled = compile(scene, {});
    kernel::Ray ray;
    ray.origin = {1, 0, -5};
    ray.direction = {0, 0, 1};
    ray.t_min = 0;
    ray.t_max = 100;
    for (const Acceleration which : kOurs) {
        SCOPED_TRACE(name_of(which));
        const accel::World world(which, *compiled);
        EXPECT_NE(std::get<0>(found_by(world, ray, kernel::RAY_CAMERA)), kernel::NONE);
        EXPECT_EQ(std::get<0>(found_by(world, ray, kernel::RAY_SHADOW)), kernel::NONE);
    }
}

// Catches back faces that are hit where a frame leaves them out, and those that are left out where it doesn't.
TEST(StructureScenes, BackFacesAreLeftOut) {
    scene::Scene scene;
    scene.materials.resize(1);
    scene.objects.push_back(solid_object(scene::Torus{1, 0.4}, {0, 0, 0}, 0));
    scene::Object ball;
    ball.shape = scene::Sphere{{5, 0, 0}, 0.5F};
    scene.objects.push_back(ball);
    const auto compiled = compile(scene, {});
    Frame frame;
    for (const Acceleration which : kOurs) {
        SCOPED_TRACE(name_of(which));
        accel::World world(which, *compiled);
        for (const float x : {1.0F, 5.0F}) {
            kernel::Ray inside;
            inside.origin = {x, 0, 0};
            inside.direction = {0, 1, 0};
            inside.t_min = 0;
            inside.t_max = 0.9F;
            frame.params.features = kernel::FEATURE_CULL;
            world.update(frame);
            EXPECT_EQ(std::get<0>(found_by(world, inside, kernel::RAY_CAMERA)), kernel::NONE);
            frame.params.features = 0;
            world.update(frame);
            EXPECT_NE(std::get<0>(found_by(world, inside, kernel::RAY_CAMERA)), kernel::NONE);
        }
    }
}

}  // namespace
}  // namespace sundog::cpu
