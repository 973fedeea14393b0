// SPDX-License-Identifier: Apache-2.0
#include "device/bvh/build.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "device/bvh/encode.h"

namespace sundog::bvh {
namespace {

using kernel::BVH_MAX_DEPTH;
using kernel::BVH_MAX_LEAF;
using kernel::BVH_WIDTH;
using kernel::WideNode;

bool contains(const Bounds3& outer, const Bounds3& inner) {
    return min(outer.lower, inner.lower) == outer.lower && max(outer.upper, inner.upper) == outer.upper;
}

/// Boxes of many sizes: most small, a few that span the scene, some flat, some points.
std::vector<Bounds3> random_boxes(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(-10, 10);
    std::uniform_real_distribution<float> exponent(-12, 3);
    std::vector<Bounds3> boxes(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 p{place(random), place(random), place(random)};
        Vec3 size{std::exp2(exponent(random)), std::exp2(exponent(random)), std::exp2(exponent(random))};
        if (i % 7 == 0) size.y = 0;
        if (i % 11 == 0) size = {0, 0, 0};
        boxes[i] = {p, p + size};
    }
    return boxes;
}

/// Walks the whole hierarchy: every primitive is found exactly once, inside all boxes on the way to it; numbers are in
/// range; returns the depth found.
class Checker {
public:
    Checker(const WideBvh& bvh, const std::vector<Bounds3>& boxes)
        : bvh_(bvh), boxes_(boxes), found_(boxes.size(), 0), visited_(bvh.nodes.size(), 0) {}

    void check() {
        ASSERT_FALSE(bvh_.nodes.empty());
        ASSERT_EQ(bvh_.order.size(), boxes_.size());
        std::vector<Bounds3> path;
        const std::uint32_t depth = walk(0, path);
        EXPECT_EQ(depth, bvh_.depth);
        EXPECT_LE(depth, BVH_MAX_DEPTH);
        EXPECT_TRUE(std::all_of(found_.begin(), found_.end(), [](int n) { return n == 1; }));
        EXPECT_TRUE(std::all_of(visited_.begin(), visited_.end(), [](int n) { return n == 1; }));
    }

private:
    std::uint32_t walk(std::uint32_t index, std::vector<Bounds3>& path) {
        EXPECT_LT(index, bvh_.nodes.size());
        if (index >= bvh_.nodes.size() || path.size() > BVH_MAX_DEPTH) return 0;
        ++visited_[index];
        const WideNode& node = bvh_.nodes[index];
        std::uint32_t child = node.child_base;
        std::uint32_t depth = 1;
        for (std::uint32_t slot = 0; slot < BVH_WIDTH; ++slot) {
            path.push_back(unpack(node, slot));
            const std::uint32_t leaf = (node.leaves[slot / 4] >> (8 * (slot % 4))) & 0xFFU;
            if (node.exponents >> (24 + slot) & 1U) {
                EXPECT_EQ(leaf, 0U);
                depth = std::max(depth, 1 + walk(child++, path));
            } else {
                EXPECT_LE(leaf >> 5U, BVH_MAX_LEAF);
                for (std::uint32_t i = 0; i < leaf >> 5U; ++i) find(node.primitive_base + (leaf & 31U) + i, path);
            }
            path.pop_back();
        }
        return depth;
    }
    void find(std::uint32_t place, const std::vector<Bounds3>& path) {
        ASSERT_LT(place, bvh_.order.size());
        const std::uint32_t primitive = bvh_.order[place];
        ASSERT_LT(primitive, boxes_.size());
        ++found_[primitive];
        for (const Bounds3& box : path) EXPECT_TRUE(contains(box, boxes_[primitive]));
    }

    const WideBvh& bvh_;
    const std::vector<Bounds3>& boxes_;
    std::vector<int> found_, visited_;
};

// Catches a builder that loses, doubles or leaves outside its boxes any primitive, for counts around every limit of
// leaf and node.
TEST(BvhBuild, HoldsEveryPrimitiveOnceInsideItsBoxes) {
    for (const std::size_t count : {1, 2, 3, 4, 7, 8, 9, 24, 25, 26, 63, 200, 5000, 40000}) {
        SCOPED_TRACE(count);
        const auto boxes = random_boxes(count, static_cast<unsigned>(count));
        Checker(build(boxes), boxes).check();
    }
}

// Catches a crash, or a root that claims children, where there is nothing to build over.
TEST(BvhBuild, OfNothingIsOneNodeWithoutChildren) {
    const WideBvh bvh = build({});
    ASSERT_EQ(bvh.nodes.size(), 1U);
    EXPECT_EQ(bvh.depth, 1U);
    EXPECT_EQ(bvh.nodes[0].exponents >> 24U, 0U);
    EXPECT_EQ(bvh.nodes[0].leaves[0] | bvh.nodes[0].leaves[1], 0U);
    EXPECT_TRUE(bvh.bounds.empty());
}

// Catches endless or too deep recursion where no split separates anything.
TEST(BvhBuild, TakesTenThousandIdenticalPrimitives) {
    const std::vector<Bounds3> boxes(10000, Bounds3{{1, 2, 3}, {4, 5, 6}});
    Checker(build(boxes), boxes).check();
    const std::vector<Bounds3> points(10000, Bounds3{{1, 2, 3}, {1, 2, 3}});
    Checker(build(points), points).check();
}

// Catches a depth without bound: sizes that grow geometrically make the heuristic peel off a few boxes at a time.
TEST(BvhBuild, BoundsTheDepthWhereSizesGrowGeometrically) {
    std::vector<Bounds3> boxes;
    for (int copy = 0; copy < 40; ++copy) {
        for (int i = 0; i < 240; ++i) {
            const float size = std::exp2(static_cast<float>(i) * 0.5F - 60);
            const Vec3 p{size * (1 + 1e-3F * static_cast<float>(copy)), 0, 0};
            boxes.push_back({p, p + Vec3{size, size, size} * 0.1F});
        }
    }
    Checker(build(boxes), boxes).check();
}

// Catches overflow of areas, of exponents and of centres, and underflow of the smallest steps.
TEST(BvhBuild, TakesHugeAndTinyBoxes) {
    std::vector<Bounds3> boxes{{{-1e37F, -1e37F, -1e37F}, {1e37F, 1e37F, 1e37F}},
                               {{9e36F, 9e36F, 9e36F}, {1e37F, 1e37F, 1e37F}}};
    for (int i = 0; i < 100; ++i) {
        const float p = 1e-40F * static_cast<float>(i);
        boxes.push_back({{p, p, p}, {p + 1e-42F, p, p}});
    }
    Checker(build(boxes), boxes).check();
    boxes.erase(boxes.begin(), boxes.begin() + 2);
    Checker(build(boxes), boxes).check();
}

// Catches results that depend on how the work was shared out: pictures must be the same on every machine.
TEST(BvhBuild, IsTheSameForAnyThreadCount) {
    const auto boxes = random_boxes(100000, 7);
    const auto build_with = [&](int threads) {
        tbb::task_arena arena(threads);
        return arena.execute([&] { return build(boxes); });
    };
    const WideBvh one = build_with(1);
    for (const int threads : {2, 4}) {
        const WideBvh several = build_with(threads);
        EXPECT_EQ(several.order, one.order);
        ASSERT_EQ(several.nodes.size(), one.nodes.size());
        EXPECT_EQ(std::memcmp(several.nodes.data(), one.nodes.data(), one.nodes.size() * sizeof(WideNode)), 0);
    }
}

// Catches a hierarchy that is correct and useless: on evenly spread boxes the nodes must fill well.
TEST(BvhBuild, FillsItsNodes) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(0, 1);
    std::vector<Bounds3> boxes(20000);
    for (Bounds3& box : boxes) {
        const Vec3 p{place(random), place(random), place(random)};
        box = {p, p + Vec3{0.01F, 0.01F, 0.01F}};
    }
    const WideBvh bvh = build(boxes);
    EXPECT_LT(bvh.nodes.size(), boxes.size() / 4);
    EXPECT_LE(bvh.depth, 8U);
}

}  // namespace
}  // namespace sundog::bvh
