// SPDX-License-Identifier: Apache-2.0
// Baking by radiosity.
#include "bake/radiosity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bake/matt.h"
#include "bake_scenes.h"

namespace sundog::bake {
namespace {

using namespace test;

BakeOptions by_radiosity(float longest_edge, std::uint32_t samples = 64) {
    BakeOptions options;
    options.method = Method::radiosity;
    options.longest_edge = longest_edge;
    options.samples = samples;
    return options;
}

void add_room(scene::Scene& s, Vec3 low, Vec3 high, scene::Index material) {
    const Vec3 x{high.x - low.x, 0, 0}, y{0, high.y - low.y, 0}, z{0, 0, high.z - low.z};
    const auto add = [&](Vec3 corner, Vec3 u, Vec3 v) {
        add_quad(s, corner, corner + u, corner + u + v, corner + v, material);
    };
    add(low, x, y), add(low, y, z), add(low, z, x), add(low + z, y, x), add(low + x, z, y), add(low + y, x, z);
}

void expect_furnace(const BakedScene& room) {
    double mean = 0, count = 0;
    for (const Part& part : room.parts)
        for (std::size_t v = 0; v < part.light.size(); ++v) {
            // Below a block's bottom it's dark.
            if (part.positions[v].z == -1 && part.normals[v].z < -0.5F) continue;
            const Vec3 light = part.light[v];
            mean += light.x;
            count += 1;
            EXPECT_NEAR(light.x, 1.25F, 0.06F);
            EXPECT_NEAR(light.y, light.x / 2, 1e-4F);
            EXPECT_EQ(light.z, 0);
        }
    EXPECT_NEAR(mean / count, 1.25, 0.01);
}

// As the furnace of paths: e / (1 - r). The box's own light goes with the exchange, that of triangles, which paths aim
// at, is direct light already. Catches light that is sent twice, or never, and bounces that are missing.
TEST(Radiosity, AFurnace) {
    const scene::Material wall = shining({0.5F, 0.25F, 0}, {0.6F, 0.6F, 0.6F});
    scene::Scene box = empty_scene();
    add_shape(box, scene::Box{{-1, -1, -1}, {1, 1, 1}}, add_material(box, wall));
    expect_furnace(baked(box, by_radiosity(0.25F)));
    scene::Scene triangles = empty_scene();
    add_room(triangles, {-1, -1, -1}, {1, 1, 1}, add_material(triangles, wall));
    expect_furnace(baked(triangles, by_radiosity(0.25F, 1024)));
}

// A block's bottom lies on the floor. Catches light that both of them send into the block, as if they were two.
TEST(Radiosity, SurfacesUponEachOtherAreOne) {
    scene::Scene s = empty_scene();
    const scene::Index wall = add_material(s, shining({0.5F, 0.25F, 0}, {0.6F, 0.6F, 0.6F}));
    add_room(s, {-1, -1, -1}, {1, 1, 1}, wall);
    add_shape(s, scene::Box{{-0.5F, -0.45F, -1}, {0.4F, 0.5F, -0.2F}}, wall);
    expect_furnace(baked(s, by_radiosity(0.25F)));
}

// With n surfaces on its way, light of a furnace is e (1 + r + … + r^n+1) where paths aim at it: catches a bounce too
// many or too few.
TEST(Radiosity, BouncesAreCounted) {
    scene::Scene room = empty_scene();
    add_room(room, {-1, -1, -1}, {1, 1, 1}, add_material(room, shining({0.5F, 0.5F, 0.5F}, {0.6F, 0.6F, 0.6F})));
    double expected = 0.5 + 0.3, term = 0.3;
    for (int depth = 0; depth < 4; ++depth) {
        BakeOptions options = by_radiosity(0.4F, 256);
        options.max_depth = depth;
        const BakedScene scene = baked(room, options);
        double mean = 0;
        for (const Part& part : scene.parts)
            for (const Vec3& light : part.light) mean += light.x / static_cast<double>(scene.vertices);
        EXPECT_NEAR(mean, expected, 0.01);
        term *= 0.6;
        expected += term;
    }
}

// Below a shining square, a floor gets its share from that and the rest from the sky. Catches skies that are lost, that
// are added where something hides them, and squares that light twice: as emitters and as what rays to the sky meet.
TEST(Radiosity, ASkyAndALamp) {
    scene::Scene s = empty_scene();
    s.sky = {0.4F, 0.4F, 0.4F};
    add_quad(s, {-1, -1, 2}, {-1, 1, 2}, {1, 1, 2}, {1, -1, 2}, add_material(s, shining({3, 3, 3}, {0, 0, 0})));
    add_quad(s, {-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}, add_material(s, matt({0.5F, 0.5F, 0.5F})));
    const BakedScene scene = baked(s, by_radiosity(0.4F, 1024));
    const double a = 0.5, r = std::sqrt(1 + a * a);
    const double share = 4 / (2 * std::numbers::pi) * 2 * (a / r * std::atan(a / r));
    const Part& floor = scene.parts[1];
    int seen = 0;
    for (std::size_t i = 0; i < floor.positions.size(); ++i) {
        if (length(floor.positions[i]) > 0.01F) continue;
        EXPECT_NEAR(floor.light[i].x, 0.5 * (3 * share + 0.4 * (1 - share)), 0.01);
        ++seen;
    }
    EXPECT_GT(seen, 0);
}

// Lamps without size light vertices by a formula, the same for neighbours. Catches noise where there can't be any.
TEST(Radiosity, LampsMakeNoNoise) {
    scene::Scene s = empty_scene();
    s.lights.clear();
    add_light(s, scene::Light::Kind::lamp, {0, 0, 3}, {0.7F, 0.7F, 0.7F});
    add_light(s, scene::Light::Kind::lamp, {2, 1, 2}, {0.2F, 0.2F, 0.2F});
    add_quad(s, {-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}, add_material(s, matt({0.5F, 0.5F, 0.5F})));
    const BakedScene scene = baked(s, by_radiosity(0.5F, 4));
    const Part& floor = scene.parts[0];
    for (std::size_t i = 0; i < floor.positions.size(); ++i) {
        const auto cosine = [&](Vec3 lamp) { return normalize(lamp - floor.inside[i]).z; };
        const float expected = 0.5F * (0.7F * cosine({0, 0, 3}) + 0.2F * cosine({2, 1, 2}));
        EXPECT_NEAR(floor.light[i].x, expected, 1e-4F);
    }
}

// Catches sums that depend on who was first.
TEST(Radiosity, ThreadsDontChangeBits) {
    const scene::Scene s = cornell_box();
    const BakedScene one = baked(s, by_radiosity(0.6F, 4), 1), three = baked(s, by_radiosity(0.6F, 4), 3);
    ASSERT_EQ(one.parts.size(), three.parts.size());
    for (std::size_t p = 0; p < one.parts.size(); ++p) {
        ASSERT_EQ(one.parts[p].light.size(), three.parts[p].light.size());
        for (std::size_t i = 0; i < one.parts[p].light.size(); ++i)
            EXPECT_EQ(length(one.parts[p].light[i] - three.parts[p].light[i]), 0);
    }
}

double sum_of(Vec3 c) { return c.x + c.y + c.z; }

/// How far two bakings of a scene are apart: the sum of all vertices' differences over that of their light.
double difference(const BakedScene& a, const BakedScene& b) {
    double apart = 0, all = 0;
    for (std::size_t p = 0; p < a.parts.size(); ++p)
        for (std::size_t i = 0; i < a.parts[p].light.size(); ++i) {
            const Vec3 x = a.parts[p].light[i], y = b.parts[p].light[i];
            apart += std::abs(x.x - y.x) + std::abs(x.y - y.y) + std::abs(x.z - y.z);
            all += sum_of(y);
        }
    return apart / all;
}

// The Cornell box, its mirror and its glass made matt, as paths see it. Catches all that makes the exchange differ from
// light: reflectances, sides, blocks that stop too much.
TEST(Radiosity, IsWhatPathsFindInTheCornellBox) {
    scene::Scene s = cornell_box();
    make_matt(s);
    BakeOptions paths;
    paths.longest_edge = 0.35F;
    paths.samples = 1024;
    const BakedScene expected = baked(s, paths), found = baked(s, by_radiosity(0.35F, 256));
    EXPECT_LT(difference(found, expected), 0.025);
    // Red light on white walls came by exchange alone.
    BakeOptions direct = by_radiosity(0.35F, 256);
    direct.max_depth = 0;
    EXPECT_GT(difference(baked(s, direct), expected), 0.1);
}

/// The bake that is stopped once progress says so.
BakedScene stopped_at(const scene::Scene& s, double fraction) {
    StopFlag stop;
    bool reached = false;
    const ProgressSink watch = [&](const Progress& p) {
        if (p.fraction < fraction) return;
        reached = true;
        stop.request();
    };
    const BakedScene scene = baked(s, by_radiosity(0.3F, 16), 2, watch, stop);
    EXPECT_TRUE(reached);
    return scene;
}

// Catches an interrupt that loses what there was: direct light, then all patches' light, then that of vertices.
TEST(Radiosity, KeepsWhatIsDone) {
    scene::Scene s = cornell_box();
    make_matt(s);
    const BakedScene whole = baked(s, by_radiosity(0.3F, 16));
    EXPECT_FALSE(whole.stopped);
    const BakedScene early = stopped_at(s, 0.61), late = stopped_at(s, 0.71);
    BakeOptions direct = by_radiosity(0.3F, 16);
    direct.max_depth = 0;
    EXPECT_TRUE(early.stopped);
    EXPECT_TRUE(late.stopped);
    // An ambient term is better than nothing.
    EXPECT_LT(difference(early, whole), 0.8 * difference(baked(s, direct), whole));
    EXPECT_LT(difference(late, whole), 0.05);
    StopFlag at_once;
    at_once.request();
    EXPECT_THROW((void)baked(s, by_radiosity(0.3F, 16), 2, {}, at_once), StoppedEarly);
}

// Catches mirrors and glass that swallow light where they should be taken for matt surfaces, and others that change.
TEST(Radiosity, MirrorsAndGlassAreMadeMatt) {
    scene::Scene s = empty_scene();
    const scene::Index mirror = add_material(s, glowing_mirror({1, 2, 3}, {0.8F, 0.7F, 0.6F}));
    scene::Material clear;
    clear.mtl->diffuse = {0, 0, 0};
    clear.mtl->transmission_filter = {0.9F, 0.8F, 0.7F};
    clear.mtl->opacity = 0;
    clear.mtl->ior = 1.5F;
    clear.mtl->illum = 7;
    const scene::Index glass = add_material(s, clear);
    // As some programs write each opaque surface.
    scene::Material maya = matt({0.4F, 0.3F, 0.2F});
    maya.mtl->ior = 1.5F;
    maya.mtl->illum = 4;
    const scene::Index opaque = add_material(s, maya);
    scene::Material thin;
    thin.mtl->opacity = 0.5F;
    const scene::Index veil = add_material(s, thin);
    scene::Material gold;
    gold.principled.emplace();
    gold.principled->base_color = {1, 0.8F, 0.3F};
    const scene::Index metal = add_material(s, gold);
    make_matt(s);
    const auto compiled = compile(s, {});
    const auto is = [](const kernel::vec3& c, Vec3 expected) {
        return std::abs(c.x - expected.x) + std::abs(c.y - expected.y) + std::abs(c.z - expected.z) < 1e-3F;
    };
    const auto& m = compiled->materials;
    EXPECT_TRUE(is(m[mirror].diffuse, {0.8F, 0.7F, 0.6F}));
    EXPECT_TRUE(is(m[mirror].reflectance, {0, 0, 0}));
    EXPECT_TRUE(is(m[mirror].emission, {1, 2, 3}));
    EXPECT_TRUE(is(m[glass].diffuse, {0.9F, 0.8F, 0.7F}));
    EXPECT_TRUE(is(m[glass].transmittance, {0, 0, 0}));
    EXPECT_TRUE(is(m[opaque].diffuse, {0.4F, 0.3F, 0.2F}));
    EXPECT_TRUE(is(m[veil].transmittance, {0.5F, 0.5F, 0.5F}));
    EXPECT_GT(m[metal].diffuse.x, 0.9F);
    EXPECT_TRUE(is(m[metal].reflectance, {0, 0, 0}));
}

}  // namespace
}  // namespace sundog::bake
