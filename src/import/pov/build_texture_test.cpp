// SPDX-License-Identifier: Apache-2.0
// Textures, and which of them an object gets.
#include "import/pov/build_texture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "import/pov/build_test_scene.h"

namespace sundog::pov {
namespace {

const scene::PatternedSurface& surface(const BuiltScene& built, std::size_t object = 0) {
    return *built.scene.materials.at(built.scene.objects.at(object).material).patterned;
}
const scene::TextureLayer& layer(const BuiltScene& built, std::size_t object = 0, std::size_t layer = 0) {
    return surface(built, object).texture->layers.at(layer);
}
const scene::Pigment& pigment(const BuiltScene& built, std::size_t object = 0) { return *layer(built, object).pigment; }

/// The colour of a plain texture.
scene::PigmentColor material_color(const BuiltScene& built, scene::Index material) {
    return built.scene.materials.at(material).patterned->color.value();
}
scene::PigmentColor object_color(const BuiltScene& built, std::size_t object) {
    return material_color(built, built.scene.objects.at(object).material);
}

/// A point of the world as the pigment's pattern sees it.
Vec3d pattern_point(const BuiltScene& built, Vec3d world, std::size_t object = 0) {
    const Affine3d& pattern = pigment(built, object).pattern.pattern_from_texture;
    return transform_point(pattern, transform_point(*surface(built, object).texture_from_world, world));
}
void expect_near(Vec3d actual, Vec3d expected) {
    EXPECT_NEAR(actual.x, expected.x, 1e-9);
    EXPECT_NEAR(actual.y, expected.y, 1e-9);
    EXPECT_NEAR(actual.z, expected.z, 1e-9);
}

// A million spheres of a few colours must not make a million materials.
TEST(BuildTexture, EqualPlainTexturesAreOneMaterial) {
    const BuiltScene built = build(
        "#declare I = 0; #while (I < 100) sphere { x*I, 1 pigment { rgb <mod(I, 2), 0, 0> } finish { phong 1 } }"
        " #declare I = I + 1; #end");
    EXPECT_EQ(built.scene.objects.size(), 100U);
    EXPECT_EQ(built.scene.materials.size(), 2U);
}

// Textures kept for each of a million colours, where one for each finish does; or colours mixed up among those that
// share one.
TEST(BuildTexture, TexturesOfOneFinishShareAllButTheirColour) {
    const BuiltScene built = build(
        "sphere { 0, 1 pigment { rgb x } } sphere { x, 1 pigment { rgbt <0, 1, 0, 0.5> } }"
        " sphere { y, 1 pigment { rgb x } finish { phong 1 } }");
    EXPECT_EQ(surface(built, 0).texture, surface(built, 1).texture);
    EXPECT_NE(surface(built, 0).texture, surface(built, 2).texture);
    EXPECT_EQ(object_color(built, 0).r, 1);
    EXPECT_EQ(object_color(built, 1).g, 1);
    EXPECT_EQ(object_color(built, 1).transmit, 0.5F);
    EXPECT_EQ(object_color(built, 2).r, 1);
}

TEST(BuildTexture, PatternsMakeAMaterialForEachPlace) {
    const BuiltScene built = build(
        "#declare T = texture { pigment { checker rgb 0 rgb 1 } }"
        "sphere { 0, 1 texture { T } } sphere { 0, 2 texture { T } } sphere { 0, 1 texture { T } translate x }");
    EXPECT_EQ(built.scene.objects[0].material, built.scene.objects[1].material);
    EXPECT_NE(built.scene.objects[0].material, built.scene.objects[2].material);
    EXPECT_EQ(surface(built, 0).texture, surface(built, 2).texture) << "the texture itself is shared";
}

// A texture that stays where it was while its object moves, or moves with what came before it.
TEST(BuildTexture, MovesWithWhatFollowsIt) {
    const BuiltScene built = build(
        "sphere { 0, 1 translate 5*y pigment { gradient x scale 2 } translate x }"
        "union { sphere { 0, 1 pigment { gradient x } } rotate 90*z }");
    expect_near(pattern_point(built, {3, 0, 0}), {1, 0, 0});
    expect_near(pattern_point(built, {0, 1, 0}, 1), {1, 0, 0});
}

// Rows of averages without their weights, and rows of maps in which a bare number comes before `green 0.4`.
TEST(BuildTexture, RowsWithoutWeightsAndColorsByTheirWords) {
    const BuiltScene built = build(
        "sphere { 0, 1 pigment { average pigment_map { [gradient y] [2 rgb 0.5] } } }"
        "sphere { 0, 1 pigment { gradient x color_map { [0.25 green 0.4] [1 rgb 1] } } }");
    ASSERT_EQ(pigment(built, 0).entries.size(), 2U);
    EXPECT_FLOAT_EQ(pigment(built, 0).entries[0].at, 1);
    ASSERT_EQ(pigment(built, 1).entries.size(), 2U);
    EXPECT_FLOAT_EQ(pigment(built, 1).entries[0].at, 0.25F);
    EXPECT_FLOAT_EQ(pigment(built, 1).entries[0].color.g, 0.4F);
}

// Transformations of a pigment reach the pigments in its map (povray's pictures show it).
TEST(BuildTexture, MapsMoveTheirEntries) {
    const BuiltScene built =
        build("sphere { 0, 1 pigment { gradient x pigment_map { [0 gradient y scale 2] [1 rgb 1] } scale 3 } }");
    const scene::Pigment& inner = *pigment(built).entries.at(0).pigment;
    expect_near(transform_point(inner.pattern.pattern_from_texture, {0, 6, 0}), {0, 1, 0});
}

TEST(BuildTexture, ChildrenWithoutTextureTakeTheParents) {
    const BuiltScene built = build(
        "union { sphere { 0, 1 } sphere { x, 1 pigment { rgb y } } pigment { rgb x } }"
        "difference { box { -1, 1 } sphere { 0, 1 pigment { rgb z } } pigment { rgb x } }");
    EXPECT_EQ(object_color(built, 0).r, 1);
    EXPECT_EQ(object_color(built, 1).g, 1);
    const auto& solid = *std::get<std::shared_ptr<const scene::Solid>>(built.scene.objects.at(2).shape);
    const auto& group = std::get<scene::SolidGroup>(solid.shape);
    EXPECT_EQ(material_color(built, group.children.at(0)->material).r, 1);
    EXPECT_EQ(material_color(built, group.children.at(1)->material).b, 1);
}

// texture { } on an object that has one lies over it; pigment { } replaces its pigment (both as povray draws them).
TEST(BuildTexture, TexturesLayerAndPigmentsReplace) {
    const BuiltScene built = build(
        "#declare S = sphere { 0, 1 texture { pigment { rgb x } finish { phong 1 } } }"
        "object { S texture { pigment { rgbt <0, 1, 0, 0.5> } } } object { S pigment { rgb z } }");
    ASSERT_EQ(surface(built, 0).texture->layers.size(), 2U);
    EXPECT_EQ(layer(built, 0, 1).pigment->color.transmit, 0.5F);
    ASSERT_EQ(surface(built, 1).texture->layers.size(), 1U);
    EXPECT_EQ(object_color(built, 1).b, 1);
    EXPECT_EQ(layer(built, 1).finish.phong, 1);
}

// An object takes the default of where it is used; a texture that of where it is written.
TEST(BuildTexture, DefaultsBindWherePovrayBindsThem) {
    const BuiltScene built = build(
        "#declare S = sphere { 0, 1 } #declare T = texture { pigment { rgb x } }"
        "#default { pigment { rgb y } finish { ambient 0.7 } } object { S } sphere { 0, 1 texture { T } }"
        "sphere { 0, 1 pigment { rgb z } }");
    EXPECT_EQ(object_color(built, 0).g, 1);
    EXPECT_FLOAT_EQ(layer(built, 0).finish.ambient.x, 0.7F);
    EXPECT_FLOAT_EQ(layer(built, 1).finish.ambient.x, 0.1F);
    EXPECT_FLOAT_EQ(layer(built, 2).finish.ambient.x, 0.7F);
}

TEST(BuildTexture, ColorMapsTakeBothFormsOfRows) {
    const BuiltScene built =
        build("sphere { 0, 1 pigment { gradient x color_map { [0.0 0.3 color rgb x color rgb y] [0.8 rgbt 1] } } }");
    const auto& entries = pigment(built).entries;
    ASSERT_EQ(entries.size(), 3U);
    EXPECT_FLOAT_EQ(entries[1].at, 0.3F);
    EXPECT_EQ(entries[1].color.g, 1);
    EXPECT_EQ(entries[2].color.transmit, 1);
}

TEST(BuildTexture, ChoicesFillInPovraysColors) {
    const BuiltScene built =
        build("sphere { 0, 1 pigment { checker rgb 1 scale 2 } } sphere { 0, 1 pigment { brick } }");
    EXPECT_EQ(pigment(built).kind, scene::Pigment::Kind::choice);
    ASSERT_EQ(pigment(built).entries.size(), 2U);
    EXPECT_EQ(pigment(built).entries[1].color.g, 1);
    EXPECT_FLOAT_EQ(pigment(built, 1).entries[1].color.r, 0.6F);
}

// A lobe of cos^n reflects 2/(n+1) of a diffuse surface: albedo divides by it.
TEST(BuildFinish, AlbedoIsWhatIsReflectedInAll) {
    const BuiltScene built = build(
        "sphere { 0, 1 finish { diffuse albedo 0.6 brilliance 3 phong albedo 0.2 phong_size 30"
        " specular albedo 0.4 roughness 0.1 } }");
    EXPECT_FLOAT_EQ(layer(built).finish.diffuse, 1.2F);
    EXPECT_FLOAT_EQ(layer(built).finish.phong, 3.1F);
    EXPECT_FLOAT_EQ(layer(built).finish.specular, 0.6F);
}

TEST(BuildFinish, ReflectionTakesOneColorOrTwo) {
    const BuiltScene built = build(
        "sphere { 0, 1 finish { reflection 0.3 } } sphere { 0, 1 finish { reflection { 0.1, rgb <0.5, 0.6, 0.7>"
        " fresnel falloff 2 metallic } conserve_energy } interior { ior 1.5 fade_distance 2 fade_power 1001 } }");
    EXPECT_FLOAT_EQ(layer(built, 0).finish.reflection_min.x, 0.3F);
    EXPECT_FLOAT_EQ(layer(built, 1).finish.reflection_min.z, 0.1F);
    EXPECT_FLOAT_EQ(layer(built, 1).finish.reflection_max.z, 0.7F);
    EXPECT_TRUE(layer(built, 1).finish.reflection_fresnel);
    EXPECT_TRUE(layer(built, 1).finish.conserve_energy);
    EXPECT_FLOAT_EQ(surface(built, 1).interior->ior, 1.5F);
    EXPECT_FLOAT_EQ(surface(built, 1).interior->fade_power, 1001);
}

// Finishes of before 3.1 said what interiors say since.
TEST(BuildFinish, OldFinishesMakeInteriors) {
    const BuiltScene built = build("#version 3.0; sphere { 0, 1 pigment { rgbf 1 } finish { refraction 1 ior 1.4 } }");
    EXPECT_FLOAT_EQ(surface(built).interior->ior, 1.4F);
}

// A texture_map is exact where its finishes are equal: its pigments in one map.
TEST(BuildTexture, TextureMapsBecomePigmentMaps) {
    const BuiltScene built = build(
        "sphere { 0, 1 texture { gradient y texture_map { [0.2 pigment { rgb x }] [0.8 pigment { rgb y }] } scale 2 } "
        "}");
    EXPECT_EQ(pigment(built).kind, scene::Pigment::Kind::mapped);
    ASSERT_EQ(pigment(built).entries.size(), 2U);
    EXPECT_EQ(pigment(built).entries[1].pigment->color.g, 1);
    expect_near(pattern_point(built, {0, 2, 0}), {0, 1, 0});
    EXPECT_TRUE(built.warnings.empty());
}

// Entries of different finishes keep theirs: they lie side by side, the first entry lowest, each with its share; also
// those of a map within a map.
TEST(BuildTexture, PartsKeepTheirFinishes) {
    const BuiltScene built = build(
        "#declare Inner = texture { checker texture { pigment { rgb x } finish { phong 1 } } texture { pigment { rgb y "
        "} } } "
        "sphere { 0, 1 texture { gradient y texture_map { [0.2 Inner] [0.8 pigment { rgb z } finish { ambient 1 }] } } "
        "}");
    const auto& layers = surface(built).texture->layers;
    ASSERT_EQ(layers.size(), 3U);
    EXPECT_TRUE(layers[0].parts_end);
    EXPECT_TRUE(layers[2].first_part);
    EXPECT_FALSE(layers[1].first_part || layers[1].parts_end);
    EXPECT_EQ(layers[0].finish.phong, 1);
    EXPECT_EQ(layers[2].finish.ambient.x, 1);
    ASSERT_TRUE(layers[1].share);
    ASSERT_EQ(layers[1].share->entries.size(), 2U);
    EXPECT_EQ(layers[1].share->kind, scene::Pigment::Kind::mapped);
    ASSERT_TRUE(layers[1].share->entries[0].pigment) << "the share within the inner texture";
    EXPECT_EQ(layers[1].share->entries[0].pigment->kind, scene::Pigment::Kind::choice);
    EXPECT_EQ(layers[1].share->entries[1].color.r, 0);
    EXPECT_TRUE(built.warnings.empty());
}

const scene::Normal& normal(const BuiltScene& built) { return *layer(built).normal; }

// A normal's amount, accuracy and scaling must come through, its transformation inverted, with no warning.
TEST(BuildNormal, KeepsWhatIsWritten) {
    const BuiltScene built = build(
        "sphere { 0, 1 pigment { rgb 1 } normal { gradient x 0.25 accuracy 0.1 scale 2 turbulence 0.5 } }"
        "#declare N = normal { ripples frequency 3 } sphere { 0, 1 normal { N bump_size 2 no_bump_scale } }");
    ASSERT_EQ(normal(built).parts.size(), 1U);
    const scene::PatternNormal& part = normal(built).parts[0];
    EXPECT_EQ(part.kind, scene::PatternNormal::Kind::pattern);
    EXPECT_EQ(part.amount, 0.25F);
    EXPECT_EQ(part.accuracy, 0.1);
    EXPECT_EQ(part.pattern.turbulence.y, 0.5);
    EXPECT_EQ(part.pattern.pattern_from_texture.x.x, 0.5);
    EXPECT_EQ(part.height->pattern.turbulence.y, 0) << "stirred once, before the differences";
    EXPECT_FALSE(part.keeps_depth);
    const scene::PatternNormal& ripples = layer(built, 1).normal->parts.at(0);
    EXPECT_EQ(ripples.kind, scene::PatternNormal::Kind::ripples);
    EXPECT_EQ(ripples.amount, 2);
    EXPECT_EQ(ripples.pattern.frequency, 3);
    EXPECT_TRUE(ripples.keeps_depth);
    EXPECT_TRUE(built.warnings.empty());
}

// The curve of a slope_map must pass its entries and have their slopes: this one is x(1-x).
TEST(BuildNormal, SlopeMapsAreCubic) {
    const BuiltScene built =
        build("sphere { 0, 1 pigment { rgb 1 } normal { gradient x slope_map { [0 <0, 1>] [1 <0, -1>] } } }");
    for (const scene::PigmentEntry& entry : normal(built).parts.at(0).height->entries)
        EXPECT_NEAR(entry.color.r, entry.at * (1 - entry.at), 1e-6);
}

// Normals in maps and lists are parts, each with its share; an average's shares add up to 1.
TEST(BuildNormal, MapsAreWeightedParts) {
    const BuiltScene built = build(
        "sphere { 0, 1 pigment { rgb 1 } normal { average normal_map { [1 bumps] [3 dents scale 2] } } }"
        "sphere { 0, 1 pigment { rgb 1 } normal { checker normal { bumps 1 } normal { wrinkles 2 } } }");
    ASSERT_EQ(normal(built).parts.size(), 2U);
    EXPECT_EQ(normal(built).parts[1].weight->color.r, 0.75F);
    EXPECT_EQ(normal(built).parts[1].pattern.pattern_from_texture.x.x, 0.5);
    const scene::Normal& choice = *layer(built, 1).normal;
    ASSERT_EQ(choice.parts.size(), 2U);
    EXPECT_EQ(choice.parts[1].weight->kind, scene::Pigment::Kind::choice);
    EXPECT_EQ(choice.parts[1].weight->entries[1].color.r, 1);
    EXPECT_EQ(choice.parts[1].weight->entries[0].color.r, 0);
}

// What isn't drawn yet is kept and told once, not at each use.
TEST(BuildTexture, WarnsOnceOfWhatIsNotDrawn) {
    const BuiltScene built = build(
        "#declare P = pigment { tiling 26 turbulence 0.5 color_map { [0 rgb 0] [1 rgb 1] } }"
        "sphere { 0, 1 pigment { P } normal { bumps 0.3 } } sphere { 0, 1 pigment { P } normal { dents 2 } }");
    EXPECT_EQ(pigment(built).pattern.kind, scene::Pattern::Kind::tiling);
    EXPECT_EQ(pigment(built).pattern.turbulence.x, 0.5);
    EXPECT_EQ(built.warnings.size(), 1U) << "tiling";
}

// A missing picture must not end the program: the scene is drawn with a stand-in that nobody overlooks.
TEST(BuildTexture, MissingImagesAreMagenta) {
    const BuiltScene built = build("sphere { 0, 1 pigment { image_map { png \"no-such-file.png\" once } } }");
    ASSERT_EQ(built.scene.textures.size(), 1U);
    EXPECT_TRUE(pigment(built).image.once);
    ASSERT_EQ(built.warnings.size(), 1U);
    EXPECT_NE(built.warnings[0].find("missing image file 'no-such-file.png'"), std::string::npos);
}

// What asks where parts are must not put their lights into the scene once more.
TEST(BuildTexture, CutPartsShineOnce) {
    const BuiltScene built = build(
        "difference { intersection { sphere { 0, 1 pigment { rgb 1 } } sphere { 0, 2 pigment { rgb 0 } }"
        " light_source { 5*y, rgb 1 } } box { 0, 3 } cutaway_textures }");
    EXPECT_TRUE(built.warnings.empty());
    EXPECT_EQ(built.scene.lights.size(), 1U);
    EXPECT_EQ(built.scene.objects.size(), 1U);
}

// More textures than can be drawn side by side: told once, and something is drawn.
TEST(BuildTexture, TooManyPartsAreTold) {
    std::string components, spheres;
    for (int i = 0; i < 9; ++i) {
        const std::string at = std::to_string(i) + "*x, 1";
        const std::string pigment = " pigment { rgb " + std::to_string(i) + "/9 }";
        components += "sphere { " + at + ", 1" + pigment + " } ";
        spheres += "sphere { " + at + pigment + " } ";
    }
    const BuiltScene blob = build("#declare B = blob { " + components + "} object { B } object { B }");
    EXPECT_EQ(blob.warnings, std::vector<std::string>{"a blob with more textures than can be blended"});
    EXPECT_GE(blob.scene.materials.size(), 9U) << "each component's shows where that is strongest";
    const BuiltScene cut = build("difference { union { " + spheres + "} box { 0, 3 } cutaway_textures }");
    EXPECT_EQ(cut.warnings, std::vector<std::string>{"more textures are cut through than can be drawn"});
}

}  // namespace
}  // namespace sundog::pov
