// SPDX-License-Identifier: Apache-2.0
// Grids of bounds of media, walked by the kernel, against its extinction.
#include "compile/media_bound.h"

#include <gtest/gtest.h>

#include <random>

#include "compile/compile.h"
#include "kernel/atmosphere/media.h"

namespace sundog {
namespace {

std::shared_ptr<scene::Pigment> density(scene::Pattern::Kind kind, double turbulence) {
    auto pigment = std::make_shared<scene::Pigment>();
    pigment->kind = scene::Pigment::Kind::mapped;
    pigment->pattern.kind = kind;
    pigment->pattern.turbulence = {turbulence, turbulence, turbulence};
    pigment->entries = {{0.3F, {0, 0, 0, 0, 0}, nullptr}, {0.9F, {1, 2, 1.5F, 0, 0}, nullptr}};
    return pigment;
}

/// A turned ball in a box, full of wisps of what absorbs, and of a second medium.
std::vector<scene::Medium> wisps() {
    scene::Medium stirred;
    stirred.scattering = {4, 3, 5};
    stirred.absorption = {0, 1, 0};
    stirred.densities = {density(scene::Pattern::Kind::spherical, 0.3)};
    scene::Medium noise;
    noise.absorption = {3, 3, 9};
    noise.densities = {density(scene::Pattern::Kind::bozo, 0.2), density(scene::Pattern::Kind::boxed, 0)};
    return {stirred, noise};
}

class MajorantGrids : public testing::Test {
protected:
    void fill_box(std::vector<scene::Medium> media, Vec3 lower, Vec3 upper) {
        auto pigment = std::make_shared<scene::Pigment>();
        pigment->color = {1, 1, 1, 0, 1};
        auto texture = std::make_shared<scene::LayeredTexture>();
        texture->layers.push_back({pigment, {}});
        scene::Material material;
        scene::PatternedSurface& surface = material.patterned.emplace();
        surface.texture = texture;
        surface.hollow = true;
        *surface.interior_from_world = {{0.8, 0.6, 0}, {-0.6, 0.8, 0}, {0, 0, 1.5}, {0.2, 0, 0.1}};
        scene::Interior interior;
        media_ = std::make_shared<const std::vector<scene::Medium>>(std::move(media));
        interior.media = media_;
        surface.interior = std::make_shared<const scene::Interior>(interior);
        scene_.materials = {material};
        scene::Object box;
        box.shape = scene::Box{lower, upper};
        scene_.objects = {box};
        compiled_ = compile(scene_, {});
        view_.code = compiled_->code.data();
        view_.host_fields = compiled_->host_fields.get();
        list_ = compiled_->patterned[0].medium;
        group_ = {};
        kernel::add_list(view_, list_, group_);
    }
    [[nodiscard]] bool has_grid() const { return compiled_->code[list_ + kernel::MEDIA_LIST_GRID] != kernel::NONE; }

    scene::Scene scene_;
    std::shared_ptr<const std::vector<scene::Medium>> media_;
    std::shared_ptr<const RenderScene> compiled_;
    kernel::SceneView view_{};
    std::uint32_t list_ = 0;
    kernel::MediaGroup group_{};
};

// Along rays in all directions, from within and from without, the density that is walked by is no less than the
// extinction wherever a walk may look. Catches a cell that is found for a place in another one, bounds that don't hold
// in their cells, and walks that jump over one.
TEST_F(MajorantGrids, HoldAlongRays) {
    fill_box(wisps(), {-1.2F, -1, -0.9F}, {1.2F, 1.1F, 0.8F});
    ASSERT_TRUE(has_grid());
    std::mt19937 random(5);
    std::uniform_real_distribution<float> number(-1, 1);
    float mean = 0;
    int looks = 0, empty = 0;
    for (int i = 0; i < 3000; ++i) {
        kernel::Ray ray{};
        ray.origin = {1.6F * number(random), 1.6F * number(random), 1.6F * number(random)};
        ray.direction = {number(random), number(random), number(random)};
        // Some go along an axis, or nearly.
        if (i % 5 == 0) ray.direction.y = ray.direction.z = i % 2 == 0 ? 0 : 1e-6F * ray.direction.z;
        ray.direction = normalize(ray.direction);
        float t = 0;
        while (t < 3) {
            float until = kernel::BEYOND_ALL;
            const std::uint32_t grid = compiled_->code[list_ + kernel::MEDIA_LIST_GRID];
            const float share = kernel::share_along(view_, grid, ray, t, until);
            ASSERT_GT(until, t);
            const float bound = share * kernel::uniform_float(compiled_->code[list_ + kernel::MEDIA_LIST_MOST]);
            for (const float part : {0.0F, 0.5F, 1.0F}) {
                kernel::Scatterers scatterers;
                const kernel::real3 p = kernel::point_at(ray, t + part * (std::min(until, 3.0F) - t));
                const kernel::real3 extinction = kernel::media_at(view_, group_, p, scatterers).extinction;
                ASSERT_LE(kernel::largest(extinction), bound) << p.x << ' ' << p.y << ' ' << p.z;
            }
            mean += share, ++looks, empty += share == 0 ? 1 : 0;
            t = until;
        }
    }
    // And it is of use.
    EXPECT_LT(mean / static_cast<float>(looks), 0.5F);
    EXPECT_GT(empty, looks / 5);
}

// A walk of a depth ends where the bounds along the ray add up to it, cell after cell. Catches depths that are lost or
// counted twice where cells meet.
TEST_F(MajorantGrids, AreWalkedByTheirDepth) {
    fill_box(wisps(), {-1.2F, -1, -0.9F}, {1.2F, 1.1F, 0.8F});
    kernel::Ray ray{};
    ray.origin = {-1.2F, 0.1F, 0.05F};
    ray.direction = {1, 0, 0};
    const std::uint32_t grid = compiled_->code[list_ + kernel::MEDIA_LIST_GRID];
    const float most = kernel::uniform_float(compiled_->code[list_ + kernel::MEDIA_LIST_MOST]);
    float depth = 0;
    for (float t = 0; t < 2.4F;) {
        float until = kernel::BEYOND_ALL;
        const float share = kernel::share_along(view_, grid, ray, t, until);
        until = std::min(until, 2.4F);
        for (const float part : {0.25F, 0.75F}) {
            if (share == 0) continue;
            const float way = part * (until - t);
            kernel::Walk walk = kernel::begun_walk();
            kernel::walk_on(view_, group_, 1, 0, ray, depth + way * share * most, 2.4F, true, walk);
            EXPECT_NEAR(walk.t, t + way, 2e-4F);
            EXPECT_NEAR(walk.density, share * most, 1e-3F * most);
        }
        depth += (until - t) * share * most;
        t = until;
    }
    kernel::Walk walk = kernel::begun_walk();
    kernel::walk_on(view_, group_, 1, 0, ray, depth * 1.001F, 2.4F, true, walk);
    EXPECT_GE(walk.t, 2.4F);
}

// A medium that is the same everywhere, one that is nearly, and one in what has no end have no grid. Catches steps that
// cost time and save none.
TEST_F(MajorantGrids, AreOnlyWhereTheyBringSomething) {
    scene::Medium even;
    even.absorption = {5, 5, 5};
    fill_box({even}, {-1, -1, -1}, {1, 1, 1});
    EXPECT_FALSE(has_grid());

    scene::Medium hazy = even;
    hazy.densities = {density(scene::Pattern::Kind::bozo, 0)};
    auto full = density(scene::Pattern::Kind::bozo, 0);
    full->entries[0].color = {1, 1, 1, 0, 0};
    full->entries[1].color = {1.1F, 1.1F, 1.1F, 0, 0};
    hazy.densities = {full};
    fill_box({hazy}, {-1, -1, -1}, {1, 1, 1});
    EXPECT_FALSE(has_grid());
    fill_box(wisps(), {-1, -1, -INFINITY}, {1, 1, INFINITY});
    EXPECT_FALSE(has_grid());
    fill_box(wisps(), {-1, -1, -1}, {1, 1, 1});
    EXPECT_TRUE(has_grid());
    EXPECT_EQ(compile(scene_, {}, false)->code[list_ + kernel::MEDIA_LIST_GRID], kernel::NONE);
}

// In a container much larger than what it holds, the grid lies around that. Catches cells that are as large as a cloud.
TEST_F(MajorantGrids, LieAroundWhatIsThere) {
    scene::Medium cloud;
    cloud.absorption = {20, 20, 20};
    cloud.densities = {density(scene::Pattern::Kind::spherical, 0)};
    fill_box({cloud}, {-1000, -1000, -1000}, {1000, 1000, 1000});
    ASSERT_TRUE(has_grid());
    kernel::Ray ray{};
    ray.direction = {1, 0, 0};
    float until = kernel::BEYOND_ALL;
    const std::uint32_t grid = compiled_->code[list_ + kernel::MEDIA_LIST_GRID];
    EXPECT_GT(kernel::share_along(view_, grid, ray, 0, until), 0.5F);
    EXPECT_LT(until, 0.5F);
    ray.origin = {50, 60, 70};
    EXPECT_EQ(kernel::share_along(view_, grid, ray, 0, until), 0);
}

}  // namespace
}  // namespace sundog
