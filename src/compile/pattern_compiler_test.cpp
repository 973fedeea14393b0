// SPDX-License-Identifier: Apache-2.0
// Pigments compiled to programs and run by the kernel, one point at a time.
#include "compile/pattern_compiler.h"

#include "compile/compile.h"

#include <gtest/gtest.h>

#include "kernel/patterns/program.h"

namespace sundog {
namespace {

using scene::Pattern;
using scene::Pigment;
using scene::PigmentColor;
using scene::PigmentEntry;

constexpr PigmentColor kRed{1, 0, 0, 0, 0};
constexpr PigmentColor kBlue{0, 0, 1, 0, 0};
constexpr PigmentColor kGlass{0.5F, 1, 0.5F, 0.25F, 0.5F};

std::shared_ptr<Pigment> solid(PigmentColor color) {
    auto pigment = std::make_shared<Pigment>();
    pigment->color = color;
    return pigment;
}

std::shared_ptr<Pigment> gradient(std::vector<PigmentEntry> entries) {
    auto pigment = std::make_shared<Pigment>();
    pigment->kind = Pigment::Kind::mapped;
    pigment->pattern.kind = Pattern::Kind::gradient;
    pigment->entries = std::move(entries);
    return pigment;
}

std::shared_ptr<Pigment> choice(Pattern::Kind kind, std::vector<PigmentEntry> entries) {
    auto pigment = std::make_shared<Pigment>();
    pigment->kind = Pigment::Kind::choice;
    pigment->pattern.kind = kind;
    pigment->entries = std::move(entries);
    return pigment;
}

/// A compiled texture of one layer, and its pigment asked at points.
class Compiled {
public:
    explicit Compiled(std::shared_ptr<const Pigment> pigment) {
        auto texture = std::make_shared<scene::LayeredTexture>();
        texture->layers.push_back({std::move(pigment), {}});
        scene::Material material;
        material.patterned.emplace().texture = texture;
        PatternCompiler compiler(scene_, copies_, out_);
        material_ = compiler.compile_surface(material);
        view_.code = out_.code.data();
    }
    [[nodiscard]] kernel::PigmentColor at(float x, float y, float z) const {
        const kernel::Layer& layer = out_.layers[out_.patterned[material_.patterned].first_layer];
        return kernel::run_program(view_, layer.program, {x, y, z});
    }
    [[nodiscard]] const kernel::Material& material() const { return material_; }

private:
    scene::Scene scene_;
    InteriorCopies copies_;
    RenderScene out_;
    kernel::Material material_{};
    kernel::SceneView view_{};
};

void expect_color(const kernel::PigmentColor& c, float r, float g, float b) {
    // Patterns repeat after a little more than 1.
    EXPECT_NEAR(c.rgb.x, r, 5e-5F);
    EXPECT_NEAR(c.rgb.y, g, 5e-5F);
    EXPECT_NEAR(c.rgb.z, b, 5e-5F);
}

// Catches a map that mixes the wrong neighbours, drops what lies before the first or behind the last entry, or blurs a
// hard edge (two entries at one position).
TEST(Patterns, AColorMapMixesNeighboursAndKeepsHardEdges) {
    const Compiled c(gradient({{0.2F, kRed, {}}, {0.6F, kBlue, {}}, {0.6F, kRed, {}}, {0.9F, kBlue, {}}}));
    expect_color(c.at(0.1F, 0, 0), 1, 0, 0);
    expect_color(c.at(0.3F, 0, 0), 0.75F, 0, 0.25F);
    expect_color(c.at(0.5999F, 0, 0), 0.00025F, 0, 0.99975F);
    expect_color(c.at(0.6001F, 0, 0), 0.99966F, 0, 0.00033F);
    expect_color(c.at(0.95F, 0, 0), 0, 0, 1);
    expect_color(c.at(-0.70001F, 0, 0), 0.75F, 0, 0.25F);  // the ramp repeats below 0, too, every 1.00001
}

// Catches checkers whose squares change sides at the origin.
TEST(Patterns, ACheckerAlternatesInAllDirections) {
    const Compiled c(choice(Pattern::Kind::checker, {{0, kRed, {}}, {0, kBlue, {}}}));
    expect_color(c.at(0.5F, 0.5F, 0.5F), 1, 0, 0);
    expect_color(c.at(-0.5F, 0.5F, 0.5F), 0, 0, 1);
    expect_color(c.at(-0.5F, -0.5F, 0.5F), 1, 0, 0);
    expect_color(c.at(-0.5F, -0.5F, -0.5F), 0, 0, 1);
}

// Catches nested maps whose inner values or colours land in the outer one's slots.
TEST(Patterns, PigmentMapsNest) {
    const auto inner = choice(Pattern::Kind::checker, {{0, kRed, {}}, {0, kBlue, {}}});
    const Compiled c(
        gradient({{0, {}, gradient({{0, kBlue, {}}, {1, kRed, {}}})}, {0.5F, {}, inner}, {1, kGlass, {}}}));
    // x = 0.25: half of the inner gradient at 0.25, half of the checker's red.
    expect_color(c.at(0.25F, 0.5F, 0.5F), 0.5F * 0.25F + 0.5F, 0, 0.5F * 0.75F);
    const kernel::PigmentColor mixed = c.at(0.75F, 0.5F, 0.5F);
    expect_color(mixed, 0.75F, 0.5F, 0.25F);
    EXPECT_NEAR(mixed.filtered, 0.125F, 1e-6F);
    EXPECT_NEAR(mixed.transmitted, 0.25F, 1e-6F);
}

// Catches a transform applied the wrong way round.
TEST(Patterns, PatternsAreAskedInTheirOwnSpace) {
    auto pigment = gradient({{0, kRed, {}}, {1, kBlue, {}}});
    pigment->pattern.pattern_from_texture.x = {0.5, 0, 0};    // scaled by 2 ...
    pigment->pattern.pattern_from_texture.t = {-0.25, 0, 0};  // ... then moved by 0.5
    const Compiled c(pigment);
    expect_color(c.at(1.5F, 0, 0), 0.5F, 0, 0.5F);
}

// Catches glass that is taken for opaque (and casts a full shadow), and the reverse.
TEST(Patterns, KnowsWhatLetsLightThrough) {
    EXPECT_EQ(Compiled(solid(kRed)).material().flags & kernel::MATERIAL_TRANSPARENT, 0U);
    EXPECT_NE(Compiled(solid(kGlass)).material().flags & kernel::MATERIAL_TRANSPARENT, 0U);
    EXPECT_NE(
        Compiled(gradient({{0, kRed, {}}, {1, {}, solid(kGlass)}})).material().flags & kernel::MATERIAL_TRANSPARENT,
        0U);
}

// Catches colours that surfaces of one finish would share, glass of one that makes opaque ones clear, and layers made
// for each colour anew.
TEST(Patterns, SurfacesOfOneTextureKeepTheirOwnColors) {
    auto texture = std::make_shared<scene::LayeredTexture>();
    texture->layers.push_back({solid(kRed), {}});
    scene::Scene scene;
    for (const std::optional<scene::PigmentColor>& color : {std::optional{kBlue}, std::optional{kGlass}, {}}) {
        scene.materials.emplace_back();
        scene.materials.back().patterned->texture = texture;
        scene.materials.back().patterned->color = color;
    }
    const auto compiled = compile(scene, {});
    EXPECT_EQ(compiled->layers.size(), 2U) << "one for all colours, one that has its own";
    EXPECT_EQ(compiled->patterned[0].look, 0U);
    EXPECT_EQ(compiled->patterned[1].look, 0U);
    EXPECT_EQ(compiled->patterned[2].look, 2U);
    EXPECT_EQ(compiled->patterned[0].color.z, kBlue.b);
    EXPECT_EQ(compiled->materials[0].flags & kernel::MATERIAL_TRANSPARENT, 0U);
    EXPECT_NE(compiled->materials[1].flags & kernel::MATERIAL_TRANSPARENT, 0U);
}

// Catches turbulence that moves marble to and fro, as it moves other patterns: povray's pictures show that it goes
// forwards only, by half of the amount in the middle, and only along x.
TEST(Patterns, TurbulenceMovesMarbleForwards) {
    const auto marble = [](Vec3d turbulence) {
        auto pigment = std::make_shared<Pigment>(*gradient({{0, {}, {}}, {1, {1, 1, 1, 0, 0}, {}}}));
        pigment->pattern.kind = Pattern::Kind::marble;
        pigment->pattern.wave = Pattern::Wave::ramp;
        pigment->pattern.frequency = 0.01;
        pigment->pattern.turbulence = turbulence;
        pigment->pattern.octaves = 1;
        return Compiled(pigment);
    };
    const Compiled along = marble({1, 0, 0}), across = marble({0, 1, 1});
    double sum = 0;
    constexpr int kPoints = 1000;
    for (int i = 0; i < kPoints; ++i) {
        const float x = 0.0713F * static_cast<float>(i) + 1, y = 0.37F * static_cast<float>(i);
        const float moved = along.at(x, y, -y).rgb.x * 100 - x;
        EXPECT_GE(moved, -0.001F);
        EXPECT_LE(moved, 1.001F);
        EXPECT_NEAR(across.at(x, y, -y).rgb.x * 100, x, 0.001F);
        sum += static_cast<double>(moved);
    }
    EXPECT_NEAR(sum / kPoints, 0.5, 0.05);
}

// Catches texture coordinates left out of a mesh whose only texture is a pigment on them: the kernel would read past
// their end.
TEST(Patterns, MeshesKeepTheCoordinatesThatPigmentsAskFor) {
    auto pigment = std::make_shared<Pigment>();
    pigment->uv_mapping = true;
    auto texture = std::make_shared<scene::LayeredTexture>();
    texture->layers.push_back({pigment, {}});
    scene::Scene scene;
    scene.materials.emplace_back();
    scene.materials[0].patterned.emplace().texture = texture;
    scene::Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.texcoords = {{0, 0}, {1, 0}, {0, 1}};
    mesh.triangles.push_back({{0, 1, 2}, {scene::kNone, scene::kNone, scene::kNone}, {0, 1, 2}, 0});
    scene::Object object;
    object.shape = mesh;
    scene.objects.push_back(object);
    const auto compiled = compile(scene, {});
    EXPECT_NE(compiled->features & kernel::FEATURE_TEXTURES, 0U);
    EXPECT_EQ(compiled->triangle_uvs.size(), compiled->triangles.size());
    EXPECT_EQ(compiled->uvs.size(), 3U);
}

// Catches a program that writes over the kernel's slots where maps nest too deep.
TEST(Patterns, RefusesMapsNestedTooDeep) {
    std::shared_ptr<const Pigment> pigment = solid(kRed);
    for (int i = 0; i < 7; ++i) pigment = gradient({{0, {}, pigment}, {1, kBlue, {}}});
    EXPECT_NO_THROW(Compiled{pigment});
    EXPECT_THROW(Compiled{gradient({{0, {}, pigment}})}, InputError);
}

}  // namespace
}  // namespace sundog
