// SPDX-License-Identifier: Apache-2.0
// What guides see through surfaces that don't bend light; each derivation stands with its test.
#include <gtest/gtest.h>

#include <cmath>

#include "scenes/media_builder.h"
#include "session/guides.h"

namespace sundog {
namespace {

using namespace test;

/// The eye looks along +y at a wall of albedo (0.2, 0.4, 0.6) in y = 4.
class SeenThrough : public testing::Test {
protected:
    SeenThrough() {
        scene_.sky = {1, 1, 1};
        options_.camera = narrow_camera(0.001F);
    }
    void add_wall() { add_wall(4, add_material(scene_, matt({0.2F, 0.4F, 0.6F}))); }
    /// A wall across the view.
    void add_wall(float y, scene::Index material) {
        add_quad(scene_, {-9, y, -9}, {9, y, -9}, {9, y, 9}, {-9, y, 9}, material);
    }
    /// A pigment of a colour that lets a share pass through unchanged, and what is behind it.
    scene::Index pane(Vec3 color, float transmitted, float ior = 1) {
        scene::Material material = clear_material({});
        auto pigment = std::make_shared<scene::Pigment>();
        pigment->color = {color.x, color.y, color.z, 0, transmitted};
        auto texture = std::make_shared<scene::LayeredTexture>();
        texture->layers.push_back({pigment, {}});
        texture->layers[0].finish.diffuse = 1;
        material.patterned->texture = texture;
        scene::Interior interior;
        interior.ior = ior;
        material.patterned->interior = std::make_shared<const scene::Interior>(interior);
        return add_material(scene_, material);
    }
    PictureGuides guides(std::uint32_t integrator = kernel::INTEGRATOR_PATH) {
        options_.integrator = integrator;
        const std::shared_ptr<const RenderScene> compiled = compile(scene_, {});
        device_->load(compiled);
        return trace_guides(*device_, make_frame(scene_, *compiled, options_), StopFlag{});
    }

    scene::Scene scene_ = empty_scene();
    FrameOptions options_ = size(4, 4);
    std::unique_ptr<Device> device_ = make_cpu_device({.threads = 1});
};

void expect_albedo(const PictureGuides& guides, Vec3 expected) {
    ASSERT_EQ(guides.albedo.size(), 16U);
    for (const Vec3& albedo : guides.albedo)
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(albedo[c], expected[c], 2e-4) << c;
}

// Catches guides that stop at the boundary of something that lets all light pass.
TEST_F(SeenThrough, ClearBoundariesAreNotSeen) {
    add_wall();
    add_shape(scene_, scene::Box{{-1, 1, -1}, {1, 3, 1}}, add_material(scene_, clear_material({emitting(0.5F)})));
    for (const std::uint32_t integrator : {kernel::INTEGRATOR_WHITTED, kernel::INTEGRATOR_PATH}) {
        const PictureGuides seen = guides(integrator);
        expect_albedo(seen, {0.2F, 0.4F, 0.6F});
        EXPECT_NEAR(seen.depth[5], 4, 1e-3);
        EXPECT_NEAR(seen.normal[5].y, -1, 1e-4);
    }
}

// A medium that lets the share T pass has the rest for itself, as white: T times the wall's albedo and 1 - T, and the
// wall's normal times T. Its nearness counts from where it begins. Catches patterns of what a dense cloud hides.
TEST_F(SeenThrough, MediaHideByTheirExtinction) {
    add_wall();
    add_shape(scene_, scene::Box{{-1, 1, -1}, {1, 3, 1}}, add_material(scene_, clear_material({absorbing(0.4F)})));
    const float passes = std::exp(-0.8F);
    const PictureGuides seen = guides();
    expect_albedo(seen, {0.2F * passes + 1 - passes, 0.4F * passes + 1 - passes, 0.6F * passes + 1 - passes});
    EXPECT_NEAR(seen.normal[5].y, -passes, 1e-3);
    EXPECT_NEAR(1 / seen.depth[5], passes / 4 + (1 - passes) / 1, 1e-3);
}

// A pane of colour c that lets half pass: half its own albedo, half the wall's; so for normals and nearness. Catches
// shares that don't add up, and panes that are seen at their back as well.
TEST_F(SeenThrough, AVeilIsMixedWithWhatIsBehindIt) {
    add_wall();
    add_wall(2, pane({0.8F, 0.4F, 0}, 0.5F));
    const PictureGuides seen = guides();
    expect_albedo(seen, {0.4F + 0.1F, 0.2F + 0.2F, 0.3F});
    EXPECT_NEAR(seen.normal[5].y, -1, 1e-3);
    EXPECT_NEAR(1 / seen.depth[5], 0.5F / 4 + 0.5F / 2, 1e-4);
}

// Behind a veil the sky counts as white and has no depth. Catches a black or a finite sky.
TEST_F(SeenThrough, TheSkyBehindAVeilIsWhite) {
    add_wall(2, pane({0.8F, 0.4F, 0}, 0.5F));
    expect_albedo(guides(), {0.9F, 0.7F, 0.5F});
    EXPECT_NEAR(guides().depth[5], 4, 1e-3);
    scene_.objects.clear();
    add_wall(2, add_material(scene_, clear_material({})));
    expect_albedo(guides(), {1, 1, 1});
    EXPECT_TRUE(std::isinf(guides().depth[5]));
}

// Catches guides that look through glass, whose picture of what is behind is another one.
TEST_F(SeenThrough, GlassIsASurface) {
    add_wall();
    add_shape(scene_, scene::Box{{-1, 1, -1}, {1, 3, 1}}, pane({1, 1, 1}, 1, 1.5F));
    const PictureGuides seen = guides();
    expect_albedo(seen, {1, 1, 1});
    EXPECT_NEAR(seen.depth[5], 1, 1e-3);
}

// What an opaque surface shows stays as it was. Catches a divisor that is applied twice, or to the wrong lanes.
TEST_F(SeenThrough, OpaqueSurfacesStayWhatTheyAre) {
    add_wall();
    add_shape(scene_, scene::Box{{-9, 5, -9}, {9, 6, 9}}, pane({1, 1, 1}, 1));
    const PictureGuides seen = guides();
    expect_albedo(seen, {0.2F, 0.4F, 0.6F});
    EXPECT_NEAR(seen.depth[5], 4, 1e-3);
}

// Behind more veils than shadow rays pass, nothing is seen: the last one counts as white. Catches endless ways.
TEST_F(SeenThrough, ThereIsAnEndToVeils) {
    add_wall();
    const scene::Index clear = add_material(scene_, clear_material({}));
    for (int i = 0; i < 31; ++i) add_wall(1 + static_cast<float>(i) * 0.05F, clear);
    expect_albedo(guides(), {0.2F, 0.4F, 0.6F});
    for (int i = 0; i < 4; ++i) add_wall(2.8F + static_cast<float>(i) * 0.05F, clear);
    expect_albedo(guides(), {1, 1, 1});
}

}  // namespace
}  // namespace sundog
