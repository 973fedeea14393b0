// SPDX-License-Identifier: Apache-2.0
// Exact solids, and geometries that some rays don't see, through Embree.
#include "device/cpu/embree_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compile/compile.h"

namespace sundog::cpu {
namespace {

using SolidPointer = std::shared_ptr<const scene::Solid>;

template <class T>
std::shared_ptr<scene::Solid> solid_of(T shape, Vec3d at = {}) {
    auto solid = std::make_shared<scene::Solid>();
    solid->shape = std::move(shape);
    solid->parent_from_shape.t = at;
    return solid;
}

scene::Object object_of(SolidPointer solid, std::uint32_t material) {
    scene::Object object;
    object.shape = std::move(solid);
    object.material = material;
    return object;
}

/// A scene in Embree, asked ray by ray.
struct Traced {
    explicit Traced(const scene::Scene& scene)
        : compiled(compile(scene, {})), device(rtcNewDevice("threads=1")), embree(device.get(), *compiled) {}

    [[nodiscard]] RTCRayHit nearest(Vec3 origin, Vec3 direction, std::uint32_t kind = kernel::RAY_CAMERA) const {
        RTCRayHit r{};
        r.ray = ray_of(origin, direction, kind);
        r.hit.geomID = r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
        rtcIntersect1(embree.handle(), &r, nullptr);
#else
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(embree.handle(), &context, &r);
#endif
        return r;
    }
    [[nodiscard]] bool blocked(Vec3 origin, Vec3 direction) const {
        RTCRay ray = ray_of(origin, direction, kernel::RAY_SHADOW);
#if RTC_VERSION_MAJOR >= 4
        rtcOccluded1(embree.handle(), &ray, nullptr);
#else
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcOccluded1(embree.handle(), &context, &ray);
#endif
        return ray.tfar < 0;
    }
    static RTCRay ray_of(Vec3 o, Vec3 d, std::uint32_t kind) {
        RTCRay ray{};
        ray.org_x = o.x, ray.org_y = o.y, ray.org_z = o.z;
        ray.dir_x = d.x, ray.dir_y = d.y, ray.dir_z = d.z;
        ray.tfar = INFINITY;
        ray.mask = kind;
        return ray;
    }

    std::shared_ptr<const RenderScene> compiled;
    embree::Device device;
    EmbreeScene embree;
};

scene::Scene scene_with(std::vector<scene::Object> objects) {
    scene::Scene scene;
    scene.materials.resize(4);
    scene.objects = std::move(objects);
    return scene;
}

// Catches hits that lose their place, normal or material between the solid and Embree.
TEST(EmbreeScene, SolidsAreHitWhereTheyAre) {
    auto drilled = solid_of(scene::SolidGroup{
        scene::SolidGroup::Kind::common, {solid_of(scene::SolidBox{{-1, -1, -1}, {1, 1, 1}}), [] {
                                              auto drill = solid_of(scene::SolidCone{{-2, 0, 0}, {2, 0, 0}, 0.5, 0.5});
                                              drill->inverted = true;
                                              drill->material = 3;
                                              return drill;
                                          }()}});
    const Traced traced(scene_with({object_of(solid_of(scene::Torus{1, 0.25}, {0, 10, 0}), 1), object_of(drilled, 2)}));
    const RTCRayHit torus = traced.nearest({0, 10, -5}, {0, 0, 1});
    EXPECT_EQ(0U, torus.hit.geomID);
    EXPECT_EQ(1U, torus.hit.primID);
    EXPECT_NEAR(3.75, torus.ray.tfar, 1e-5);
    EXPECT_NEAR(-1, torus.hit.Ng_z, 1e-5);
    EXPECT_EQ(RTC_INVALID_GEOMETRY_ID, traced.nearest({-5, 0.1F, 0.1F}, {1, 0, 0}).hit.geomID);  // through the hole
    const RTCRayHit wall = traced.nearest({-0.9F, 0, 0}, {0.1F, 1, 0});
    EXPECT_EQ(1U, wall.hit.geomID);
    EXPECT_EQ(3U, wall.hit.primID);
    EXPECT_NEAR(0.5, wall.ray.tfar, 1e-5);
    EXPECT_NEAR(-1, wall.hit.Ng_y, 1e-5);
    EXPECT_TRUE(traced.blocked({-5, 0.9F, 0}, {1, 0, 0}));
    EXPECT_FALSE(traced.blocked({-5, 0.1F, 0}, {1, 0, 0}));
}

// Catches infinite solids that Embree drops, and bounds so large that its tree breaks.
TEST(EmbreeScene, SolidsWithoutEnd) {
    std::vector<scene::Object> objects;
    scene::Polynomial paraboloid{2, {{2, 0, 0, 1}, {0, 0, 2, 1}, {0, 1, 0, 1}}};  // opens downwards
    objects.push_back(object_of(solid_of(paraboloid), 1));
    for (int i = 0; i < 100; ++i) objects.push_back(object_of(solid_of(scene::Torus{1, 0.25}, {3.0 * i, 100, 0}), 2));
    const Traced traced(scene_with(std::move(objects)));
    const RTCRayHit far = traced.nearest({0, -1e6F, -1e6F}, {0, 0, 1});
    EXPECT_EQ(0U, far.hit.geomID);
    EXPECT_NEAR(1e6F - 1e3F, far.ray.tfar, 1);
    EXPECT_EQ(50U + 1, traced.nearest({150, 100, -5}, {0, 0, 1}).hit.geomID);
}

// Catches no_shadow, no_image and no_reflection not kept, for solids, spheres and triangles.
TEST(EmbreeScene, GeometriesHideFromSomeRays) {
    auto mesh = std::make_shared<scene::SolidMesh>();
    constexpr std::uint32_t none = scene::SolidMesh::kNoIndex;
    mesh->positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    mesh->triangles = {{{0, 1, 2}, {none, none, none}, {none, none, none}, none}};
    const std::vector<SolidPointer> shapes{solid_of(scene::Torus{0.01, 0.5}), solid_of(scene::SolidSphere{{}, 0.5}),
                                           solid_of(std::shared_ptr<const scene::SolidMesh>(mesh))};
    for (const SolidPointer& shape : shapes) {
        scene::Object object = object_of(shape, 1);
        object.casts_shadow = false;
        object.seen_in_reflections = false;
        const Traced eye_only(scene_with({object}));
        EXPECT_EQ(0U, eye_only.nearest({0, 0, -5}, {0, 0, 1}, kernel::RAY_CAMERA).hit.geomID);
        EXPECT_NE(0U, eye_only.nearest({0, 0, -5}, {0, 0, 1}, kernel::RAY_REFLECTED).hit.geomID);
        EXPECT_FALSE(eye_only.blocked({0, 0, -5}, {0, 0, 1}));
        object.casts_shadow = true;
        object.seen_by_camera = false;
        const Traced shadow_only(scene_with({object}));
        EXPECT_NE(0U, shadow_only.nearest({0, 0, -5}, {0, 0, 1}, kernel::RAY_CAMERA).hit.geomID);
        EXPECT_TRUE(shadow_only.blocked({0, 0, -5}, {0, 0, 1}));
    }
}

}  // namespace
}  // namespace sundog::cpu
