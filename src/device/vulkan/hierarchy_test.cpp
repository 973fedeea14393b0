// SPDX-License-Identifier: Apache-2.0
#include "device/vulkan/hierarchy.h"

#include <gtest/gtest.h>

#include <set>

namespace sundog::vulkan {
namespace {

/// Three spheres in geometries of their own, the last `moving` of which move; a plane besides.
RenderScene three_spheres(std::uint32_t moving) {
    RenderScene scene;
    for (std::uint32_t i = 0; i < 3; ++i) {
        scene.spheres.push_back({{static_cast<float>(i) * 10, 0, 0}, 1, 0});
        const std::uint32_t instance = i + moving >= 3 ? i + moving - 3 : kernel::NONE;
        scene.geometries.push_back({kernel::GEOMETRY_SPHERE, i, 1, instance, 0, 0, 0});
    }
    scene.planes.push_back({{0, 0, 1}, 0, 0, 3});
    scene.geometries.push_back({kernel::GEOMETRY_PLANE, 0, 1, kernel::NONE, 0, 0, 0});
    if (moving > 0) scene.features |= kernel::FEATURE_INSTANCES;
    return scene;
}

kernel::Instance moved_by(float x, float y, float z) {
    kernel::Instance instance{};
    instance.world_from_object_x = {1, 0, 0};
    instance.world_from_object_y = {0, 1, 0};
    instance.world_from_object_z = {0, 0, 1};
    instance.world_from_object_t = {x, y, z};
    return instance;
}

// Catches a second level where nothing moves, and planes that got into a hierarchy.
TEST(Hierarchy, IsOnePartWhereNothingMoves) {
    const Hierarchy hierarchy = build_hierarchy(three_spheres(0));
    ASSERT_EQ(hierarchy.parts.size(), 1U);
    EXPECT_EQ(hierarchy.parts[0].root, 0U);
    EXPECT_EQ(hierarchy.top_capacity, 0U);
    EXPECT_EQ(hierarchy.leaves.size(), 3U);
}

// Catches parts that share primitives or lose one, and roots that overlap the room for the top level.
TEST(Hierarchy, IsOnePartForEachGeometryThatMoves) {
    const Hierarchy hierarchy = build_hierarchy(three_spheres(2));
    ASSERT_EQ(hierarchy.parts.size(), 3U);
    std::set<std::uint32_t> geometries;
    for (const kernel::Leaf& leaf : hierarchy.leaves) geometries.insert(leaf.geometry);
    EXPECT_EQ(geometries, (std::set<std::uint32_t>{0, 1, 2}));
    for (const Part& part : hierarchy.parts) EXPECT_GE(part.root, hierarchy.top_capacity);
    EXPECT_EQ(hierarchy.parts[0].instance, kernel::NONE);
    EXPECT_EQ(hierarchy.parts[1].instance, 0U);
    EXPECT_EQ(hierarchy.parts[2].instance, 1U);
}

// Catches a scene without primitives that leaves the shader no root to start from.
TEST(Hierarchy, OfNothingHasARoot) {
    EXPECT_FALSE(build_hierarchy(RenderScene{}).nodes.empty());
    RenderScene scene;
    scene.features = kernel::FEATURE_INSTANCES;
    const Hierarchy hierarchy = build_hierarchy(scene);
    EXPECT_FALSE(build_top_level(hierarchy, Frame{}).nodes.empty());
}

// Catches bounds that stay where the object was at rest, and a top level that outgrows its room.
TEST(TopLevel, FollowsTheFrame) {
    const Hierarchy hierarchy = build_hierarchy(three_spheres(2));
    Frame frame;
    frame.instances = {moved_by(0, 100, 0), moved_by(0, 0, -100)};
    const TopLevel top = build_top_level(hierarchy, frame);
    EXPECT_EQ(top.refs.size(), 3U);
    EXPECT_LE(top.nodes.size(), hierarchy.top_capacity);
    // The node's frame starts at the lower corner of everything: x of the first sphere, y of those not moved, z of the
    // last.
    EXPECT_NEAR(top.nodes[0].origin.x, -1, 1e-3);
    EXPECT_NEAR(top.nodes[0].origin.y, -1, 1e-3);
    EXPECT_NEAR(top.nodes[0].origin.z, -101, 1e-3);
}

// Catches a placement that overflows and poisons the boxes of everything else.
TEST(TopLevel, LeavesOutWhatIsPlacedNowhere) {
    const Hierarchy hierarchy = build_hierarchy(three_spheres(2));
    Frame frame;
    frame.instances = {moved_by(INFINITY, 0, 0), moved_by(0, 0, 0)};
    EXPECT_EQ(build_top_level(hierarchy, frame).refs.size(), 2U);
}

}  // namespace
}  // namespace sundog::vulkan
