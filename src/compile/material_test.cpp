// SPDX-License-Identifier: Apache-2.0
#include "compile/material.h"

#include <gtest/gtest.h>

namespace sundog {
namespace {

scene::MtlSurface material(int illum) {
    scene::MtlSurface m;
    m.diffuse = {0.5F, 0.25F, 0.125F};
    m.specular = {0.6F, 0.7F, 0.8F};
    m.shininess = 50;
    m.illum = illum;
    return m;
}

void expect_color(const kernel::vec3& got, Vec3 want) {
    EXPECT_FLOAT_EQ(got.x, want.x);
    EXPECT_FLOAT_EQ(got.y, want.y);
    EXPECT_FLOAT_EQ(got.z, want.z);
}

// Catches a highlight or mirror on the models that have none, and a missing one on those that have it.
TEST(CompileMaterial, IlluminationModelsSwitchHighlightAndMirror) {
    for (int illum = 0; illum <= 10; ++illum) {
        SCOPED_TRACE(illum);
        const kernel::Material m = compile_material(material(illum), no_maps());
        EXPECT_EQ((m.flags & kernel::MATERIAL_HIGHLIGHT) != 0, illum >= 2);
        const bool mirror = illum >= 3 && illum <= 8;
        expect_color(m.reflectance, mirror ? Vec3{0.6F, 0.7F, 0.8F} : Vec3{});
        EXPECT_EQ((m.flags & kernel::MATERIAL_FRESNEL) != 0, illum == 5 || illum == 7);
        EXPECT_EQ((material_features(m, no_maps()) & kernel::FEATURE_MIRRORS) != 0, mirror);
    }
}

// Catches ambient light that ignores Ka, or that goes missing where a file leaves Ka out.
TEST(CompileMaterial, AmbientIsKaOrElseKd) {
    scene::MtlSurface m = material(2);
    expect_color(compile_material(m, no_maps()).ambient, m.diffuse);
    m.ambient = Vec3{0, 0, 0};
    expect_color(compile_material(m, no_maps()).ambient, {0, 0, 0});
}

// Catches a constant colour that is shaded by lights.
TEST(CompileMaterial, Illum0IsAConstantColour) {
    scene::MtlSurface m = material(0);
    m.emission = {0.1F, 0, 0};
    const kernel::Material k = compile_material(m, no_maps());
    expect_color(k.emission, {0.6F, 0.25F, 0.125F});
    expect_color(k.diffuse, {0, 0, 0});
    expect_color(k.ambient, {0, 0, 0});
}

// Catches transparency that ignores d, tints where the model has no filter, or refracts where it shouldn't.
TEST(CompileMaterial, DissolvePassesStraightUnlessTheModelRefracts) {
    scene::MtlSurface m = material(2);
    m.opacity = 0.25F;
    m.ior = 1.5F;
    m.transmission_filter = {1, 0.5F, 0};
    kernel::Material k = compile_material(m, no_maps());
    expect_color(k.transmittance, {0.75F, 0.75F, 0.75F});
    EXPECT_EQ(k.ior, 1);
    m.illum = 9;
    k = compile_material(m, no_maps());
    expect_color(k.transmittance, {0.75F, 0.375F, 0});
    EXPECT_EQ(k.ior, 1.5F);
    EXPECT_NE(material_features(k, no_maps()) & kernel::FEATURE_TRANSPARENT, 0U);
}

// Catches energy made from nothing: mirror and transparency together above 1.
TEST(CompileMaterial, MirrorGetsWhatTransparencyLeaves) {
    scene::MtlSurface m = material(4);
    m.specular = {1, 1, 1};
    m.opacity = 0.25F;
    expect_color(compile_material(m, no_maps()).reflectance, {0.25F, 0.25F, 0.25F});
    // With Fresnel the two share by F and 1-F, so both may be 1.
    m.illum = 7;
    expect_color(compile_material(m, no_maps()).reflectance, {1, 1, 1});
}

// Catches opaque Maya surfaces (illum 4, white Tf) that turn to glass, and glass written with d 1 that stays opaque.
TEST(CompileMaterial, GlassWrittenWithD1) {
    scene::MtlSurface m = material(4);
    expect_color(compile_material(m, no_maps()).transmittance, {0, 0, 0});
    m.transmission_filter = {0.5F, 1, 1};
    expect_color(compile_material(m, no_maps()).transmittance, {0.5F, 1, 1});
    m = material(7);
    m.ior = 1.5F;
    const kernel::Material glass = compile_material(m, no_maps());
    expect_color(glass.transmittance, {1, 1, 1});
    EXPECT_EQ(glass.ior, 1.5F);
}

// Catches PBR metals that keep a diffuse colour, and rough plastic that mirrors.
TEST(CompileMaterial, PbrKeys) {
    scene::MtlSurface m = material(2);
    m.metallic = 1;
    m.roughness = 0.5F;
    const kernel::Material metal = compile_material(m, no_maps());
    expect_color(metal.diffuse, {0, 0, 0});
    expect_color(metal.reflectance, {0.125F, 0.0625F, 0.03125F});
    EXPECT_FLOAT_EQ(metal.shininess, 30);
    m.metallic = 0;
    const kernel::Material plastic = compile_material(m, no_maps());
    expect_color(plastic.diffuse, m.diffuse);
    EXPECT_EQ(material_features(plastic, no_maps()) & kernel::FEATURE_MIRRORS, 0U);
    m.roughness = 0;
    const kernel::Material polished = compile_material(m, no_maps());
    expect_color(polished.reflectance, {0.04F, 0.04F, 0.04F});
    EXPECT_NE(polished.flags & kernel::MATERIAL_FRESNEL, 0U);
}

// Catches texture uses whose clamping or channel gets lost, and reads from a texture without pixels.
TEST(CompileMaterial, TextureUses) {
    scene::Texture empty;
    scene::Texture one;
    one.width = one.height = 1;
    one.rgba8 = {0xffffffffU};
    const scene::Texture textures[]{empty, one};
    scene::MtlSurface m = material(2);
    m.map_diffuse.texture = 0;
    m.map_opacity.texture = 1;
    m.map_opacity.wrap_u = m.map_opacity.wrap_v = scene::TextureUse::Wrap::clamp;
    m.map_opacity.channel = 4;
    const kernel::MaterialMaps maps = compile_maps(m, textures);
    const kernel::Material k = compile_material(m, maps);
    EXPECT_EQ(maps.diffuse.texture, kernel::NONE);
    EXPECT_EQ(maps.opacity.texture, 1U);
    EXPECT_EQ(maps.opacity.flags, kernel::TEXTURE_CLAMP | (4U << kernel::TEXTURE_CHANNEL_SHIFT));
    EXPECT_EQ(material_features(k, maps) & (kernel::FEATURE_TEXTURES | kernel::FEATURE_TRANSPARENT),
              kernel::FEATURE_TEXTURES | kernel::FEATURE_TRANSPARENT);
}

}  // namespace
}  // namespace sundog
