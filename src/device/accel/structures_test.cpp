// SPDX-License-Identifier: Apache-2.0
// All structures against none, on random and on nasty scenes: the same hits, to the bit, in bounded memory and steps.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <random>

#include "device/accel/world.h"

namespace sundog::accel {
namespace {

using kernel::vec3;

constexpr std::array kOurs{Acceleration::bvh, Acceleration::kdtree, Acceleration::octree, Acceleration::grid,
                           Acceleration::boxes};

/// A scene under construction: primitives of one object after the other.
struct TestScene {
    RenderScene scene;

    TestScene() { scene.materials.resize(1); }

    void add_object(std::uint32_t kind, std::uint32_t first) {
        const auto count_of = [&]() -> std::size_t {
            if (kind == kernel::GEOMETRY_SPHERE) return scene.spheres.size();
            return kind == kernel::GEOMETRY_BOX ? scene.boxes.size() : scene.triangles.size();
        };
        scene.geometries.push_back({kind, first, static_cast<std::uint32_t>(count_of()) - first, kernel::NONE, 0, 0, 0});
    }
    void add_triangle(Vec3 a, Vec3 b, Vec3 c) {
        const auto first = static_cast<std::uint32_t>(scene.positions.size());
        for (const Vec3 p : {a, b, c}) scene.positions.push_back({p.x, p.y, p.z});
        scene.triangles.push_back({first, first + 1, first + 2, 0});
    }
    void add_sphere(Vec3 center, float radius) {
        scene.spheres.push_back({{center.x, center.y, center.z}, radius, 0});
        add_object(kernel::GEOMETRY_SPHERE, static_cast<std::uint32_t>(scene.spheres.size()) - 1);
    }
    void add_box(Vec3 lower, Vec3 upper) {
        scene.boxes.push_back({{lower.x, lower.y, lower.z}, {upper.x, upper.y, upper.z}, 0});
        add_object(kernel::GEOMETRY_BOX, static_cast<std::uint32_t>(scene.boxes.size()) - 1);
    }
    /// All triangles added since the last call become one object.
    void end_mesh() {
        std::uint32_t first = 0;
        for (const kernel::Geometry& g : scene.geometries)
            if (g.kind == kernel::GEOMETRY_TRIANGLES) first = g.first_primitive + g.primitive_count;
        add_object(kernel::GEOMETRY_TRIANGLES, first);
    }
};

class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}
    float within(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine_); }
    Vec3 point(float size) { return {within(-size, size), within(-size, size), within(-size, size)}; }
    std::uint32_t below(std::uint32_t n) { return std::uniform_int_distribution<std::uint32_t>(0, n - 1)(engine_); }

private:
    std::mt19937 engine_;
};

kernel::Ray ray_from(Vec3 origin, Vec3 direction, float t_max = 3e38F) {
    kernel::Ray ray;
    ray.origin = vec3(origin.x, origin.y, origin.z);
    ray.direction = vec3(direction.x, direction.y, direction.z);
    ray.t_min = 0;
    ray.t_max = t_max;
    return ray;
}

Vec3 center_of(const Bounds3& b) { return b.lower * 0.5F + b.upper * 0.5F; }

/// Rays from inside, from around and from far away, at primitives and past them, along axes and in the planes of boxes'
/// sides, some of them short.
std::vector<kernel::Ray> rays_for(const RenderScene& scene, int count) {
    Primitives all(scene);
    for (std::uint32_t i = 0; i < scene.geometries.size(); ++i) all.add(i);
    const Bounds3 box = all.total_bounds();
    const Vec3 extent = box.extent();
    const float size = std::max({extent.x, extent.y, extent.z, 1e-20F});
    Random random(11);
    std::vector<kernel::Ray> rays;
    for (int i = 0; i < count; ++i) {
        const Bounds3& target = all.bounds(random.below(all.size()));
        Vec3 origin = center_of(box) + random.point(i % 5 == 0 ? 50 * size : 0.7F * size);
        Vec3 direction = normalize(center_of(target) - origin);
        if (i % 3 == 1) direction = normalize(random.point(1));
        if (i % 7 == 0) {  // along an axis, in the plane of a side, through a corner
            direction = Vec3{0, 0, 0};
            direction[static_cast<std::size_t>(i / 7 % 3)] = i % 2 == 0 ? 1.0F : -1.0F;
            origin = (i % 4 < 2 ? target.lower : center_of(target)) - direction * size;
        }
        if (i % 11 == 0) origin = target.upper;
        rays.push_back(ray_from(origin, direction, i % 4 == 3 ? 0.5F * size : 3e38F));
    }
    return rays;
}

std::string bits_of(const std::optional<Found>& hit) {
    if (!hit) return "none";
    const auto bits = [](float v) { return std::to_string(std::bit_cast<std::uint32_t>(v)); };
    return std::to_string(hit->geometry) + "/" + std::to_string(hit->primitive) + " t " + bits(hit->t) + " u " +
           bits(hit->u) + " v " + bits(hit->v);
}

/// Every structure against none. Some ray must hit and some must miss, else nothing is shown.
void expect_same_hits(const RenderScene& scene, const std::vector<kernel::Ray>& rays) {
    const World reference(Acceleration::none, scene);
    Scratch scratch;
    Steps brute;
    std::vector<std::string> hits;
    std::vector<bool> blocked;
    std::size_t hit_count = 0;
    for (const kernel::Ray& ray : rays) {
        hits.push_back(bits_of(reference.nearest(ray, kernel::RAY_CAMERA, scratch, brute)));
        if (hits.back() != "none") ++hit_count;
    }
    for (const kernel::Ray& ray : rays) blocked.push_back(reference.any(ray, kernel::RAY_SHADOW, scratch, brute));
    EXPECT_GT(hit_count, 0U);
    for (const Acceleration which : kOurs) {
        SCOPED_TRACE(name_of(which));
        const World world(which, scene);
        Steps steps;
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const std::string hit = bits_of(world.nearest(rays[i], kernel::RAY_CAMERA, scratch, steps));
            if (hit != hits[i] && ++wrong < 4) ADD_FAILURE() << "ray " << i << ": " << hit << ", not " << hits[i];
            EXPECT_EQ((hits[i] != "none"), blocked[i]) << i;
            EXPECT_EQ(world.any(rays[i], kernel::RAY_SHADOW, scratch, steps), blocked[i]) << "ray " << i;
        }
        EXPECT_EQ(wrong, 0U);
    }
}

void expect_same_hits(const TestScene& test, int count = 600) {
    expect_same_hits(test.scene, rays_for(test.scene, count));
}

void add_triangle_cloud(TestScene& test, int count, float spread, float size, unsigned seed) {
    Random random(seed);
    for (int i = 0; i < count; ++i) {
        const Vec3 at = random.point(spread);
        test.add_triangle(at, at + random.point(size), at + random.point(size));
    }
    test.end_mesh();
}

// Catches a walk that skips what it should visit, ends too early, or takes the wrong one of two hits.
TEST(Structures, FindTheSameHitsOnRandomScenes) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE(seed);
        TestScene test;
        add_triangle_cloud(test, 500, 1, 0.3F, seed);
        Random random(seed);
        for (int i = 0; i < 100; ++i) test.add_sphere(random.point(1), random.within(0.01F, 0.2F));
        for (int i = 0; i < 100; ++i) {
            const Vec3 at = random.point(1);
            test.add_box(at, at + max(random.point(0.2F), Vec3{0, 0, 0}));
        }
        expect_same_hits(test);
    }
}

// Catches structures that need something to divide.
TEST(Structures, TakeOneThingAndTwo) {
    TestScene one;
    one.add_sphere({1, 2, 3}, 0.5F);
    expect_same_hits(one);
    TestScene two;
    two.add_sphere({1, 2, 3}, 0.5F);
    two.add_box({0, 0, 0}, {1, 1, 1});
    expect_same_hits(two);
}

// Catches a crash where there is nothing at all.
TEST(Structures, TakeNothing) {
    TestScene test;
    Scratch scratch;
    Steps steps;
    for (const Acceleration which : kOurs) {
        const World world(which, test.scene);
        EXPECT_FALSE(world.nearest(ray_from({0, 0, 0}, {0, 0, 1}), kernel::RAY_CAMERA, scratch, steps));
        EXPECT_FALSE(world.any(ray_from({0, 0, 0}, {0, 0, 1}), kernel::RAY_CAMERA, scratch, steps));
    }
}

// Catches surfaces at one place of which each structure takes another, and planes of cells that fall into them.
TEST(Structures, CoplanarAndAxisAligned) {
    TestScene test;
    for (int copy = 0; copy < 3; ++copy) {
        for (int x = 0; x < 16; ++x)
            for (int y = 0; y < 16; ++y) {
                const Vec3 at{static_cast<float>(x), static_cast<float>(y), 0};
                test.add_triangle(at, at + Vec3{1, 0, 0}, at + Vec3{0, 1, 0});
                test.add_triangle(at + Vec3{1, 0, 0}, at + Vec3{1, 1, 0}, at + Vec3{0, 1, 0});
            }
        test.end_mesh();
    }
    for (int i = 0; i < 16; ++i) {
        const auto x = static_cast<float>(i);
        test.add_box({x, 0, 0}, {x + 1, 16, 1});
        test.add_box({0, x, 0}, {16, x + 1, 0});
    }
    expect_same_hits(test);
}

// Catches sizes of cells, areas and distances that overflow, vanish or lose all digits.
TEST(Structures, HugeAndTiny) {
    TestScene test;
    add_triangle_cloud(test, 200, 1, 0.3F, 5);
    add_triangle_cloud(test, 200, 1e-4F, 1e-5F, 6);
    add_triangle_cloud(test, 50, 1e6F, 1e6F, 7);
    test.add_sphere({0, 0, -1e7F}, 1e7F);
    test.add_box({-1e9F, -1e9F, -1e-3F}, {1e9F, 1e9F, 0});
    expect_same_hits(test);
    TestScene tiny;
    add_triangle_cloud(tiny, 300, 1e-15F, 3e-16F, 8);
    expect_same_hits(tiny);
    TestScene huge;
    add_triangle_cloud(huge, 300, 1e12F, 3e11F, 9);
    expect_same_hits(huge);
}

// Catches cells too small for the numbers of a ray from far away: many walls at one t.
TEST(Structures, FarFromTheOrigin) {
    TestScene test;
    Random random(3);
    const Vec3 away{1e6F, -2e6F, 5e5F};
    for (int i = 0; i < 300; ++i) {
        const Vec3 at = away + random.point(1);
        test.add_triangle(at, at + random.point(0.5F), at + random.point(0.5F));
    }
    test.end_mesh();
    auto rays = rays_for(test.scene, 400);
    for (int i = 0; i < 400; ++i) rays.push_back(ray_from({0, 0, 0}, normalize(away + random.point(2))));
    expect_same_hits(test.scene, rays);
}

// Catches boxes without a volume, areas of 0 that costs are divided by, and triangles without a normal.
TEST(Structures, DegenerateTriangles) {
    TestScene test;
    Random random(4);
    for (int i = 0; i < 300; ++i) {
        const Vec3 at = random.point(1), along = random.point(0.5F);
        test.add_triangle(at, at, at);
        test.add_triangle(at, at + along, at + along * 2.0F);
        test.add_triangle(at, at + Vec3{1e-20F, 0, 0}, at + Vec3{0, 1e-20F, 0});
        test.add_triangle(at, at + along, at + along * 0.5F + Vec3{0, 1e-6F, 0});
        test.add_triangle(at, at + Vec3{0.2F, 0, 0}, at + Vec3{0, 0.2F, 0});
    }
    test.end_mesh();
    expect_same_hits(test);
    TestScene points;
    for (int i = 0; i < 50; ++i) points.add_triangle({1, 1, 1}, {1, 1, 1}, {1, 1, 1});
    points.end_mesh();
    points.add_sphere({0, 0, 0}, 1);
    expect_same_hits(points);
}

// Catches numbers that are none, which would make every comparison false.
TEST(Structures, LeaveOutWhatIsNotFinite) {
    TestScene test;
    add_triangle_cloud(test, 50, 1, 0.3F, 5);
    test.add_triangle({NAN, 0, 0}, {1, 0, 0}, {0, 1, 0});
    test.add_triangle({0, 0, 0}, {INFINITY, 0, 0}, {0, 1, 0});
    test.add_triangle({0, 0, 0}, {3e38F, 0, 0}, {0, 3e38F, 0});
    test.end_mesh();
    test.add_sphere({NAN, 0, 0}, 1);
    test.add_sphere({0, 0, 0}, NAN);
    test.add_sphere({0, 0, 0}, INFINITY);
    test.add_sphere({0, INFINITY, 0}, 1);
    test.add_box({NAN, 0, 0}, {1, 1, 1});
    test.add_box({0, 0, 0}, {1, NAN, 1});
    test.add_box({-INFINITY, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY});
    const Primitives all = [&] {
        Primitives p(test.scene);
        for (std::uint32_t i = 0; i < test.scene.geometries.size(); ++i) p.add(i);
        return p;
    }();
    EXPECT_EQ(all.size(), 50U);
    expect_same_hits(test);
}

/// That a structure takes for each primitive, with the primitives' own boxes (docs/acceleration.md says so).
constexpr std::size_t kMostBytes = 200;

/// Steps and memory stay within what no structure would take: `rays` rays against n items.
void expect_no_worse_than_none(const TestScene& test, int ray_count) {
    const auto rays = rays_for(test.scene, ray_count);
    Primitives all(test.scene);
    for (std::uint32_t i = 0; i < test.scene.geometries.size(); ++i) all.add(i);
    EXPECT_LE(World(Acceleration::none, test.scene).memory_bytes(), kMostBytes * all.size());
    for (const Acceleration which : kOurs) {
        SCOPED_TRACE(name_of(which));
        const World world(which, test.scene);
        EXPECT_LE(world.memory_bytes(), 4096 + kMostBytes * all.size());
        Scratch scratch;
        for (const kernel::Ray& ray : rays) {
            Steps steps;
            (void)world.nearest(ray, kernel::RAY_CAMERA, scratch, steps);
            EXPECT_LE(steps.tests, all.size() + 100);
            EXPECT_LE(steps.visits, all.size() + 1000);
        }
    }
}

// Catches divisions that go on where nothing can be told apart, lists of references that multiply, and items that are
// tested again in every cell.
TEST(Structures, TenThousandIdenticalTriangles) {
    TestScene test;
    for (int i = 0; i < 10000; ++i) test.add_triangle({0, 0, 0}, {1, 0.1F, 0.2F}, {0.3F, 1, 0.5F});
    test.end_mesh();
    expect_no_worse_than_none(test, 40);
    expect_same_hits(test, 60);
}

// Catches the same with a distant speck, which puts all of them into one cell of a grid or octree.
TEST(Structures, TenThousandIdenticalTrianglesInOneCell) {
    TestScene test;
    for (int i = 0; i < 10000; ++i) test.add_triangle({0, 0, 0}, {1, 0.1F, 0.2F}, {0.3F, 1, 0.5F});
    test.end_mesh();
    test.add_sphere({1e4F, 1e4F, 1e4F}, 1);
    expect_no_worse_than_none(test, 40);
    expect_same_hits(test, 60);
}

// Catches a cell that holds a whole model and isn't divided, or divided for ever.
TEST(Structures, AllInOneCell) {
    TestScene test;
    add_triangle_cloud(test, 10000, 1e-3F, 1e-3F, 5);
    test.add_sphere({1e4F, 1e4F, 1e4F}, 1);
    expect_no_worse_than_none(test, 40);
    expect_same_hits(test, 60);
}

// Catches trees that put large overlapping things on both sides of every division.
TEST(Structures, LargeOverlappingTriangles) {
    TestScene test;
    add_triangle_cloud(test, 3000, 0.2F, 10, 5);
    expect_no_worse_than_none(test, 40);
    expect_same_hits(test, 100);
}

// Catches a choice of planes, cells or centres that has nothing to go by where solid shapes all stand at one place.
TEST(Structures, TenThousandIdenticalSpheresAndBoxes) {
    TestScene test;
    for (int i = 0; i < 5000; ++i) {
        test.add_sphere({0.1F, 0.2F, 0.3F}, 1);
        test.add_box({-0.5F, -0.6F, -0.7F}, {0.5F, 0.6F, 0.7F});
    }
    expect_no_worse_than_none(test, 40);
    expect_same_hits(test, 60);
}

// Catches shapes around shapes: all overlap, each reaches into every cell of the next, and centres tell nothing apart.
TEST(Structures, TenThousandNestedSpheresAndBoxes) {
    TestScene test;
    for (int i = 1; i <= 5000; ++i) {
        const float size = static_cast<float>(i) / 1000;
        test.add_sphere({0, 0, 0}, size);
        test.add_box({-size, -size, -size}, {size, size, size});
    }
    expect_no_worse_than_none(test, 40);
    expect_same_hits(test, 60);
}

// Catches a depth or a stack that has no limit: each step of a thousand towards a corner halves what is left, down to
// where numbers of floats end, so trees are as deep as they can be.
TEST(Structures, SizesThatHalveForever) {
    TestScene test;
    for (int copy = 0; copy < 10; ++copy)
        for (int i = 0; i < 100; ++i) {
            const float s = std::ldexp(1.0F, 20 - i);
            test.add_triangle({s, s, s}, {1.5F * s, s, s}, {s, 1.5F * s, 1.2F * s});
        }
    test.end_mesh();
    for (int i = 0; i < 100; ++i) {
        const float s = std::ldexp(1.0F, 20 - i);
        test.add_sphere({s, s, 0}, s / 4);
    }
    expect_no_worse_than_none(test, 60);
    expect_same_hits(test, 300);
}

// Catches numbers of items that don't fit into 16 bits, and a depth, a stack or a memory that grows faster than they
// do.
TEST(Structures, AHundredThousandTriangles) {
    TestScene test;
    constexpr int kSide = 240;
    const auto height = [&](int x, int y) {
        return 0.02F * std::sin(0.05F * static_cast<float>(x)) * std::cos(0.07F * static_cast<float>(y));
    };
    for (int x = 0; x < kSide; ++x)
        for (int y = 0; y < kSide; ++y) {
            const auto at = [&](int i, int j) {
                return Vec3{static_cast<float>(i) / kSide, static_cast<float>(j) / kSide, height(i, j)};
            };
            test.add_triangle(at(x, y), at(x + 1, y), at(x, y + 1));
            test.add_triangle(at(x + 1, y), at(x + 1, y + 1), at(x, y + 1));
        }
    test.end_mesh();
    expect_no_worse_than_none(test, 12);
    expect_same_hits(test, 12);
}

// Catches rays that are not carried into the space of what moves, and moved things that stay behind.
TEST(Structures, MovingObjects) {
    TestScene test;
    add_triangle_cloud(test, 200, 1, 0.3F, 5);
    add_triangle_cloud(test, 200, 1, 0.3F, 6);
    test.add_sphere({0, 0, 0}, 0.5F);
    test.scene.geometries[1].instance = 0;
    test.scene.geometries[2].instance = 1;
    Frame frame;
    frame.instances.push_back(
        {{0, 2, 0}, {-2, 0, 0}, {0, 0, 2}, {3, 0, 0}, {0, -0.5F, 0}, {0.5F, 0, 0}, {0, 0, 0.5F}, {0, 1.5F, 0}});
    frame.instances.push_back(
        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 5}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -5}});
    const auto rays = rays_for(test.scene, 500);
    World reference(Acceleration::none, test.scene);
    reference.update(frame);
    Scratch scratch;
    Steps steps;
    const auto ball = reference.nearest(ray_from({0, 0, 10}, {0, 0, -1}), kernel::RAY_CAMERA, scratch, steps);
    ASSERT_TRUE(ball);
    EXPECT_EQ(ball->geometry, 2U);
    EXPECT_NEAR(ball->t, 4.5F, 1e-5F);
    for (const Acceleration which : kOurs) {
        SCOPED_TRACE(name_of(which));
        World world(which, test.scene);
        world.update(frame);
        for (const kernel::Ray& ray : rays) {
            EXPECT_EQ(bits_of(world.nearest(ray, kernel::RAY_CAMERA, scratch, steps)),
                      bits_of(reference.nearest(ray, kernel::RAY_CAMERA, scratch, steps)));
            EXPECT_EQ(world.any(ray, kernel::RAY_CAMERA, scratch, steps),
                      reference.any(ray, kernel::RAY_CAMERA, scratch, steps));
        }
    }
}

// Catches structures that are correct and useless: on an evenly spread scene a ray must need few steps.
TEST(Structures, SaveWork) {
    TestScene test;
    Random random(2);
    for (int i = 0; i < 20000; ++i) test.add_sphere(random.point(1), 0.004F);
    const auto rays = rays_for(test.scene, 200);
    Scratch scratch;
    for (const Acceleration which :
         {Acceleration::bvh, Acceleration::kdtree, Acceleration::octree, Acceleration::grid}) {
        SCOPED_TRACE(name_of(which));
        const World world(which, test.scene);
        Steps steps;
        for (const kernel::Ray& ray : rays) (void)world.nearest(ray, kernel::RAY_CAMERA, scratch, steps);
        EXPECT_LT(steps.tests, 60U * rays.size());
        EXPECT_LT(steps.visits, 200U * rays.size());
    }
}

// Catches a choice among hits at one place that depends on the order in which they were found.
TEST(Nearest, DoesNotDependOnOrder) {
    Random random(1);
    for (int round = 0; round < 2000; ++round) {
        std::vector<Found> hits;
        for (int i = 0; i < 30; ++i) {
            Found hit;
            hit.t = 1.9F * (1 + 2e-7F * static_cast<float>(random.below(20)));
            hit.geometry = random.below(8);
            hit.primitive = static_cast<std::uint32_t>(i);
            hit.leaves = random.below(4) == 0;
            hits.push_back(hit);
        }
        const auto chosen = [&] {
            Nearest nearest(100);
            for (const Found& hit : hits) nearest.enter(hit);
            return nearest.best();
        };
        const Found first = chosen();
        std::shuffle(hits.begin(), hits.end(), std::mt19937(static_cast<unsigned>(round)));
        const Found second = chosen();
        ASSERT_EQ(first.primitive, second.primitive);
        const auto nearest_t =
            std::min_element(hits.begin(), hits.end(), [](const Found& a, const Found& b) { return a.t < b.t; })->t;
        ASSERT_LE(first.t, nearest_t * (1 + 1.1e-6F));
    }
}

}  // namespace
}  // namespace sundog::accel
