// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <numbers>

#include "base/test_folder.h"
#include "compile/compile.h"

namespace sundog {
namespace {

scene::Material mirror(float reflectance) {
    scene::Material m;
    m.mtl->specular = {reflectance, reflectance, reflectance};
    m.mtl->illum = 3;
    return m;
}
scene::Material glass(float ior) {
    scene::Material m;
    m.mtl->diffuse = {0, 0, 0};
    m.mtl->specular = {1, 1, 1};
    m.mtl->opacity = 0.1F;
    m.mtl->ior = ior;
    m.mtl->illum = 7;
    return m;
}
scene::Material principled(float roughness, float transmission, float thickness) {
    scene::Material m;
    m.principled.emplace();
    m.principled->metallic = 0;
    m.principled->roughness = roughness;
    m.principled->transmission = transmission;
    m.principled->thickness = thickness;
    return m;
}

/// A lamp, and photons that find their targets.
class FoundTargets : public testing::Test {
protected:
    FoundTargets() {
        scene_.lights.emplace_back();
        scene_.photons.emplace();
        scene_.photons->count = 100;
        scene_.photons->find_targets = true;
    }
    template <class Shape>
    scene::Object& add(Shape shape, const scene::Material& material) {
        scene::Object o;
        o.name = "object" + std::to_string(scene_.objects.size());
        o.shape = shape;
        o.material = static_cast<scene::Index>(scene_.materials.size());
        scene_.materials.push_back(material);
        scene_.objects.push_back(std::move(o));
        return scene_.objects.back();
    }
    scene::Object& add_ball(const scene::Material& material) { return add(scene::Sphere{{0, 0, 0}, 1}, material); }
    /// PHOTONS_* of the object added last, its target's number left out; and whether it is one.
    [[nodiscard]] std::pair<std::uint32_t, bool> last() const {
        const auto compiled = compile(scene_, {});
        const std::uint32_t photons = compiled->geometries.back().photons;
        return {photons & ((1U << kernel::PHOTONS_TARGET_SHIFT) - 1), photons >> kernel::PHOTONS_TARGET_SHIFT != 0};
    }

    scene::Scene scene_;
};

constexpr std::uint32_t kReflects = kernel::PHOTONS_REFLECT, kRefracts = kernel::PHOTONS_REFRACT,
                        kCollects = kernel::PHOTONS_COLLECT;

// Catches mirrors and glass that photons aren't shot at, and gloss, alpha or thin walls that they are.
TEST_F(FoundTargets, MaterialsSayWhatIsShotAt) {
    const auto use_of = [&](const scene::Material& material) {
        add_ball(material);
        return last();
    };
    using Use = std::pair<std::uint32_t, bool>;
    EXPECT_EQ(use_of({}), Use(kCollects, false)) << "matt";
    EXPECT_EQ(use_of(mirror(0.5F)), Use(kReflects | kCollects, true));
    EXPECT_EQ(use_of(mirror(0.05F)), Use(kCollects, false)) << "too weak a mirror";
    EXPECT_EQ(use_of(glass(1.5F)), Use(kReflects | kRefracts, true));
    EXPECT_EQ(use_of(glass(1)), Use(kRefracts, false)) << "nothing is bent: others' photons pass it";
    EXPECT_EQ(use_of(principled(0, 0, 0)), Use(kCollects, false)) << "gloss";
    EXPECT_EQ(use_of(principled(0, 1, 1)), Use(kReflects | kRefracts, true));
    EXPECT_EQ(use_of(principled(0, 1, 0)).second, false) << "a thin wall";
}

// Catches panes that keep photons from what they are shot at; leaves, which are cut out of such, do.
TEST_F(FoundTargets, PanesAreInNobodysWay) {
    add_ball(glass(1));
    EXPECT_NE(compile(scene_, {})->geometries.back().hidden_from & kernel::RAY_PHOTON, 0U);
    EXPECT_EQ(compile(scene_, {})->geometries.back().hidden_from & kernel::RAY_LATER_PHOTON, 0U);
    scene_.textures.emplace_back();
    scene_.textures.back().width = scene_.textures.back().height = 1;
    scene_.textures.back().rgba8 = {0x80808080U};
    scene::Material leaf;
    leaf.mtl->map_opacity.texture = 0;
    add_ball(leaf);
    EXPECT_EQ(compile(scene_, {})->geometries.back().hidden_from, 0U);
    EXPECT_EQ(last(), std::pair(kRefracts | kCollects, false));
}

// Catches a scene's word on its objects that is overruled.
TEST_F(FoundTargets, WhatObjectsSayHolds) {
    add_ball(glass(1.5F)).photons->refraction = scene::PhotonSwitch::off;
    EXPECT_EQ(last().first & (kRefracts | kernel::PHOTONS_NEVER_REFRACT), kernel::PHOTONS_NEVER_REFRACT);
    add_ball(mirror(1)).photons->collect = false;
    EXPECT_EQ(last().first & kCollects, 0U);
    EXPECT_TRUE(last().second);
    scene_.objects.front().photons->target = true;
    EXPECT_FALSE(last().second) << "another object is marked as a target: then those alone are";
}

// A room and the glass in it may be one mesh. Catches photons that are spread over all of it.
TEST_F(FoundTargets, OfAMeshWhatIsGlassIsShotAt) {
    constexpr scene::Index n = scene::kNone;
    scene::Mesh mesh;
    mesh.positions = {{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}, {-1, -1, 2}, {1, -1, 2}, {0, 1, 3}};
    mesh.triangles.push_back({{0, 1, 2}, {n, n, n}, {n, n, n}, 0});
    mesh.triangles.push_back({{3, 4, 5}, {n, n, n}, {n, n, n}, 1});
    add(mesh, {});
    scene_.materials.push_back(glass(1.5F));
    const auto compiled = compile(scene_, {});
    ASSERT_EQ(compiled->photon_targets.size(), 1U);
    EXPECT_EQ(compiled->photon_targets[0].bounds, (Bounds3{{-1, -1, 2}, {1, 1, 3}}));
    EXPECT_EQ(compiled->bounds.lower.x, -9);
}

// Catches targets that are looked for where they were at first.
TEST_F(FoundTargets, TheyMove) {
    scene::Object& ball = add_ball(glass(1.5F));
    ball.motion->move_speed = {std::numbers::pi_v<float> / 2, 0, 0};
    ball.motion->move_amplitude = {10, 0, 0};
    const auto compiled = compile(scene_, {});
    FrameOptions options;
    for (const float time_s : {0.0F, 1.0F}) {
        options.time_s = time_s;
        const Frame frame = make_frame(scene_, *compiled, options);
        ASSERT_EQ(frame.photons->targets.size(), 1U);
        EXPECT_NEAR(frame.photons->targets[0].lower.x, 10 * time_s - 1, 1e-4F);
        EXPECT_NEAR(frame.photons->targets[0].upper.x, 10 * time_s + 1, 1e-4F);
    }
}

// Objects of one name in a row are one geometry, so that millions of them can be drawn. Catches each becoming its own.
TEST_F(FoundTargets, ARowOfOneNameIsOneTarget) {
    for (int i = 0; i < 3; ++i) {
        auto drop = std::make_shared<scene::Solid>();
        drop->shape = scene::SolidSphere{{4.0 * i, 0, 0}, 1};
        add(std::shared_ptr<const scene::Solid>(std::move(drop)), glass(1.5F)).name = "drop";
    }
    const auto compiled = compile(scene_, {});
    EXPECT_EQ(compiled->geometries.size(), 1U);
    ASSERT_EQ(compiled->photon_targets.size(), 1U);
    EXPECT_EQ(compiled->photon_targets[0].bounds, (Bounds3{{-1, -1, -1}, {9, 1, 1}}));
}

// Photons can't be aimed at what has no end: catches its shadow staying black, and silence about photons that nobody
// shoots, or that have nothing to be shot at.
TEST_F(FoundTargets, WhatCantBeShotIsSaid) {
    const auto said = [&] {
        Warnings warnings;
        compile(scene_, warnings.sink());
        std::string all;
        for (const std::string& text : warnings.texts) all += text + '\n';
        return all;
    };
    EXPECT_NE(said().find("nothing in the scene mirrors or refracts"), std::string::npos) << said();
    add(scene::Plane{{0, 0, 1}, 0}, glass(1.5F));
    EXPECT_NE(said().find("photons can't be shot at 'object0': it has no end"), std::string::npos) << said();
    EXPECT_FALSE(last().second);
    EXPECT_NE(last().first & kRefracts, 0U) << "other targets' photons pass it";
    scene_.objects.clear();
    add_ball(glass(1.5F));
    EXPECT_EQ(said(), "");
    scene_.lights.clear();
    EXPECT_NE(said().find("no lamp, sun or spot"), std::string::npos) << said();
}

}  // namespace
}  // namespace sundog
