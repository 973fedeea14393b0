// SPDX-License-Identifier: Apache-2.0
// Random rays through the hierarchy, by the same node step as the GPU's, against brute force.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include "device/bvh/build.h"
#include "device/bvh/node_hits.h"

namespace sundog::bvh {
namespace {

using kernel::vec3;

vec3 to_kernel(Vec3 v) { return {v.x, v.y, v.z}; }

/// A ray that the tests shoot.
struct TestRay {
    Vec3 origin, direction;
    float t_max = 1e30F;
};

/// Which primitives' leaves the ray reaches.
std::vector<bool> reached(const WideBvh& bvh, const TestRay& ray) {
    std::vector<bool> hits(bvh.order.size(), false);
    const kernel::BoxRay box_ray = kernel::box_ray(to_kernel(ray.origin), to_kernel(ray.direction));
    std::vector<std::uint32_t> stack{0};
    while (!stack.empty()) {
        const kernel::WideNode& node = bvh.nodes[stack.back()];
        stack.pop_back();
        kernel::word inner = 0;
        kernel::word primitives = 0;
        kernel::node_hits(node, box_ray, 0.0F, ray.t_max, inner, primitives);
        for (; primitives != 0; primitives &= primitives - 1) {
            const auto place = static_cast<std::uint32_t>(std::countr_zero(primitives));
            hits[bvh.order[node.primitive_base + place]] = true;
        }
        const std::uint32_t inner_mask = node.exponents >> 24U;
        for (; inner != 0; inner &= inner - 1) {
            const std::uint32_t slot = static_cast<std::uint32_t>(std::countr_zero(inner)) ^ box_ray.octant;
            stack.push_back(node.child_base +
                            static_cast<std::uint32_t>(std::popcount(inner_mask & ((1U << slot) - 1))));
        }
    }
    return hits;
}

/// Whether the ray meets the box, in double; boundaries count.
bool meets(const Bounds3& box, const TestRay& ray) {
    double enter = 0;
    double leave = ray.t_max;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis];
        const double d = ray.direction[axis];
        if (d == 0) {
            if (o < box.lower[axis] || o > box.upper[axis]) return false;
            continue;
        }
        const double a = (box.lower[axis] - o) / d;
        const double b = (box.upper[axis] - o) / d;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
}

/// Rays from inside and outside, along axes, short ones, and ones that graze box corners exactly.
std::vector<TestRay> rays_for(const std::vector<Bounds3>& boxes, std::size_t count, float size) {
    std::mt19937 random(11);
    std::normal_distribution<float> normal;
    std::vector<TestRay> rays(count);
    for (std::size_t i = 0; i < count; ++i) {
        TestRay& ray = rays[i];
        ray.origin = Vec3{normal(random), normal(random), normal(random)} * (size * (i % 5 == 0 ? 20.0F : 1.0F));
        ray.direction = normalize(Vec3{normal(random), normal(random), normal(random)});
        const Bounds3& target = boxes[random() % boxes.size()];
        if (i % 4 == 1) ray.direction = normalize(target.lower - ray.origin);
        if (i % 4 == 2) {
            // Along an axis, in the plane of a face.
            ray.direction = i % 8 == 2 ? Vec3{0, 0, 1} : Vec3{-1, 0, 0};
            ray.origin = target.upper - ray.direction * size;
        }
        if (i % 4 == 3) ray.t_max = size * 0.5F;
    }
    return rays;
}

void check(const std::vector<Bounds3>& boxes, float size) {
    const WideBvh bvh = build(boxes);
    std::size_t met = 0;
    for (const TestRay& ray : rays_for(boxes, 2000, size)) {
        const auto hits = reached(bvh, ray);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            if (!meets(boxes[i], ray)) continue;
            ++met;
            EXPECT_TRUE(hits[i]) << "primitive " << i;
        }
    }
    EXPECT_GT(met, 100U);  // else the test would show nothing
}

std::vector<Bounds3> boxes_of_size(float size, std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(-size, size);
    std::uniform_real_distribution<float> extent(0, size * 0.1F);
    std::vector<Bounds3> boxes(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 p{place(random), place(random), place(random)};
        Vec3 e{extent(random), extent(random), extent(random)};
        if (i % 3 == 0) e.z = 0;
        boxes[i] = {p, p + e};
    }
    return boxes;
}

// Catches box tests that miss what a ray touches: by rounding, by flat boxes, by axis-parallel rays, by wrong order or
// numbering of children. (Reporting too much is allowed; the next test bounds it.)
TEST(BvhTraversal, ReachesEverythingThatARayTouches) {
    for (const float size : {1.0F, 1e-6F, 1e7F}) {
        SCOPED_TRACE(size);
        check(boxes_of_size(size, 500, 5), size);
    }
}

// Catches boxes that lie far from the origin, where one unit in the last place is as large as they are.
TEST(BvhTraversal, ReachesSmallThingsFarFromTheOrigin) {
    auto boxes = boxes_of_size(1, 300, 9);
    const Vec3 away{100000, -50000, 20000};
    for (Bounds3& box : boxes) box = {box.lower + away, box.upper + away};
    const WideBvh bvh = build(boxes);
    std::mt19937 random(4);
    for (int i = 0; i < 2000; ++i) {
        const Bounds3& target = boxes[random() % boxes.size()];
        const TestRay ray{{0, 0, 0}, normalize(target.center()), 1e30F};
        const auto hits = reached(bvh, ray);
        for (std::size_t b = 0; b < boxes.size(); ++b) {
            EXPECT_TRUE(hits[b] || !meets(boxes[b], ray));
        }
    }
}

// Catches box tests that let everything through, which brute force alone would not notice.
TEST(BvhTraversal, VisitsFewPrimitivesThatARayMisses) {
    const auto boxes = boxes_of_size(1, 5000, 6);
    const WideBvh bvh = build(boxes);
    std::size_t reported = 0;
    const auto rays = rays_for(boxes, 500, 1);
    for (const TestRay& ray : rays) {
        const auto hits = reached(bvh, ray);
        reported += static_cast<std::size_t>(std::count(hits.begin(), hits.end(), true));
    }
    EXPECT_LT(reported, rays.size() * boxes.size() / 50);
}

// Catches a wrong visiting order: the first inner child visited must not lie behind one that comes later, where the
// ray runs along a row of clusters.
TEST(BvhTraversal, VisitsNearChildrenFirst) {
    std::vector<Bounds3> boxes;
    for (int cluster = 0; cluster < 2; ++cluster) {
        for (int i = 0; i < 100; ++i) {
            const float x = static_cast<float>(cluster) * 100 + static_cast<float>(i % 10);
            const int row = i / 10;
            const auto y = static_cast<float>(row);
            boxes.push_back({{x, y, 0}, {x + 0.5F, y + 0.5F, 1}});
        }
    }
    const WideBvh bvh = build(boxes);
    for (const float direction : {1.0F, -1.0F}) {
        const kernel::BoxRay ray =
            kernel::box_ray(vec3(direction > 0 ? -10.0F : 210.0F, 4.2F, 0.5F), vec3(direction, 0, 0));
        kernel::word inner = 0;
        kernel::word primitives = 0;
        kernel::node_hits(bvh.nodes[0], ray, 0.0F, 1e30F, inner, primitives);
        ASSERT_GE(std::popcount(inner), 2);
        const auto origin_x = [&](std::uint32_t bit) {
            const std::uint32_t slot = bit ^ ray.octant;
            const std::uint32_t rank =
                static_cast<std::uint32_t>(std::popcount((bvh.nodes[0].exponents >> 24U) & ((1U << slot) - 1)));
            return bvh.nodes[bvh.nodes[0].child_base + rank].origin.x;
        };
        const float first = origin_x(static_cast<std::uint32_t>(std::countr_zero(inner)));
        const float last = origin_x(31U - static_cast<std::uint32_t>(std::countl_zero(inner)));
        EXPECT_LT(first * direction, last * direction);
    }
}

}  // namespace
}  // namespace sundog::bvh
