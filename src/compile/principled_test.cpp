// SPDX-License-Identifier: Apache-2.0
#include "compile/principled.h"

#include <gtest/gtest.h>

#include "compile/material.h"

namespace sundog {
namespace {

using scene::PrincipledSurface;

void expect_color(const kernel::vec3& got, Vec3 want) {
    EXPECT_NEAR(got.x, want.x, 1e-5F);
    EXPECT_NEAR(got.y, want.y, 1e-5F);
    EXPECT_NEAR(got.z, want.z, 1e-5F);
}

PrincipledSurface surface(float metallic, float roughness) {
    PrincipledSurface s;
    s.base_color = {0.8F, 0.4F, 0.2F};
    s.metallic = metallic;
    s.roughness = roughness;
    return s;
}

kernel::Material compiled(const PrincipledSurface& s, std::span<const scene::Texture> textures = {}) {
    return compile_material(s, compile_maps(s, textures), textures);
}

scene::Texture one_texel(std::uint32_t rgba) {
    scene::Texture texture;
    texture.width = texture.height = 1;
    texture.rgba8 = {rgba};
    return texture;
}

// Catches polished metals with a matt colour, rough ones that are black, and plastic that mirrors its own colour.
TEST(CompilePrincipled, SmoothnessSharesReflection) {
    const kernel::Material chrome = compiled(surface(1, 0));
    expect_color(chrome.reflectance, {0.8F, 0.4F, 0.2F});
    expect_color(chrome.diffuse, {0, 0, 0});
    const kernel::Material rough = compiled(surface(1, 1));
    expect_color(rough.reflectance, {0, 0, 0});
    expect_color(rough.diffuse, {0.8F, 0.4F, 0.2F});
    expect_color(rough.specular, {0, 0, 0});
    const kernel::Material plastic = compiled(surface(0, 0));
    expect_color(plastic.reflectance, {0.04F, 0.04F, 0.04F});
    expect_color(plastic.diffuse, Vec3{0.8F, 0.4F, 0.2F} / 0.96F);
    EXPECT_NE(plastic.flags & kernel::MATERIAL_FRESNEL, 0U);
    expect_color(compiled(surface(0, 0.5F)).reflectance, {0, 0, 0});
}

// Catches metalness and roughness that are read from the wrong channels of their map.
TEST(CompilePrincipled, MapsCountByTheirMeans) {
    const scene::Texture textures[]{one_texel(0xff00ff00U)};  // Green 1, blue 0: rough, no metal.
    PrincipledSurface s = surface(1, 1);
    s.metallic_roughness_map.texture = 0;
    const kernel::Material m = compiled(s, textures);
    expect_color(m.diffuse, {0.8F, 0.4F, 0.2F});
    expect_color(m.reflectance, {0, 0, 0});
}

// Catches glass that is opaque or loses its colour, and thin walls that refract.
TEST(CompilePrincipled, Transmission) {
    PrincipledSurface s = surface(0, 0);
    s.transmission = 1;
    const kernel::Material thin = compiled(s);
    EXPECT_EQ(thin.ior, 1);
    EXPECT_EQ(thin.flags & kernel::MATERIAL_FRESNEL, 0U);
    EXPECT_NEAR(thin.transmittance.x, 0.8F * (1 - 0.0769F), 1e-3F);
    EXPECT_NEAR(thin.reflectance.x, 0.0769F, 1e-3F);
    expect_color(thin.diffuse, {0, 0, 0});
    s.thickness = 2;
    s.attenuation_distance = 1;
    s.attenuation_color = {0.5F, 1, 1};
    const kernel::Material solid = compiled(s);
    EXPECT_EQ(solid.ior, 1.5F);
    expect_color(solid.transmittance, {0.4F, 0.4F, 0.2F});  // Twice through a depth of 1 in all.
    EXPECT_NE(solid.flags & kernel::MATERIAL_TRANSPARENT, 0U);
}

// Catches cut-outs that blend, cutoffs that forget the factor, and opaque surfaces that follow their picture's alpha.
TEST(CompilePrincipled, AlphaModes) {
    const scene::Texture textures[]{one_texel(0x80ffffffU)};
    PrincipledSurface s = surface(0, 1);
    s.base_color_map.texture = 0;
    s.alpha = 0.5F;
    EXPECT_EQ(compile_maps(s, textures).opacity.texture, kernel::NONE);
    expect_color(compiled(s, textures).transmittance, {0, 0, 0});
    s.alpha_mode = PrincipledSurface::Alpha::mask;
    s.alpha_cutoff = 0.4F;
    const kernel::MaterialMaps cut = compile_maps(s, textures);
    EXPECT_NE(cut.opacity.flags & kernel::TEXTURE_CUTOFF, 0U);
    EXPECT_EQ(cut.opacity.flags >> kernel::TEXTURE_CHANNEL_SHIFT & 7U, 3U);
    EXPECT_FLOAT_EQ(cut.opacity.strength, 0.8F);
    expect_color(compiled(s, textures).transmittance, {0, 0, 0});
    s.alpha_mode = PrincipledSurface::Alpha::blend;
    expect_color(compiled(s, textures).transmittance, {0.5F, 0.5F, 0.5F});
    EXPECT_EQ(compile_maps(s, textures).opacity.flags & kernel::TEXTURE_CUTOFF, 0U);
    s.base_color_map.texture = scene::kNone;
    s.alpha_mode = PrincipledSurface::Alpha::mask;
    s.alpha = 0.3F;
    expect_color(compiled(s).transmittance, {1, 1, 1});
}

// Catches unlit surfaces that are lit, and pictures of them that get lost.
TEST(CompilePrincipled, UnlitShowsItsColor) {
    const scene::Texture textures[]{one_texel(0xffffffffU)};
    PrincipledSurface s = surface(0, 0);
    s.unlit = true;
    s.base_color_map.texture = 0;
    const kernel::Material m = compiled(s, textures);
    expect_color(m.emission, {0.8F, 0.4F, 0.2F});
    expect_color(m.diffuse, {0, 0, 0});
    expect_color(m.reflectance, {0, 0, 0});
    EXPECT_EQ(compile_maps(s, textures).emission.texture, 0U);
}

// Catches samplers that are not told to the kernel.
TEST(CompilePrincipled, SamplersAndTransforms) {
    const scene::Texture textures[]{one_texel(0xffffffffU)};
    scene::TextureUse use;
    use.texture = 0;
    EXPECT_EQ(compile_use(use, textures).flags, 0U);
    using Wrap = scene::TextureUse::Wrap;
    use.wrap_u = Wrap::mirror;
    use.wrap_v = Wrap::clamp;
    use.nearest = true;
    use.shear = {0, 0.5F};
    EXPECT_EQ(compile_use(use, textures).flags,
              kernel::TEXTURE_MIRROR_U | kernel::TEXTURE_CLAMP_V | kernel::TEXTURE_NEAREST | kernel::TEXTURE_TURNED);
    EXPECT_EQ(compile_use(use, textures).shear.y, 0.5F);
}

// Catches backs that are hidden where light passes through, or where both sides are to be seen.
TEST(CompilePrincipled, WhatIsOneSided) {
    PrincipledSurface s = surface(0, 1);
    EXPECT_NE(compiled(s).flags & kernel::MATERIAL_ONE_SIDED, 0U);
    s.double_sided = true;
    EXPECT_EQ(compiled(s).flags & kernel::MATERIAL_ONE_SIDED, 0U);
    s.double_sided = false;
    s.transmission = 1;
    EXPECT_EQ(compiled(s).flags & kernel::MATERIAL_ONE_SIDED, 0U);
}

// Catches vertices' colours that a metal, an unlit surface or a mask doesn't get, and alpha that opaque ones do.
TEST(CompilePrincipled, WhatColorsOfVerticesMultiply) {
    const auto flags = [](const PrincipledSurface& s) {
        return compile_material(s, compile_maps(s, {}, true), {}, true).flags;
    };
    EXPECT_EQ(flags(surface(0, 1)) & (kernel::MATERIAL_VERTEX_SPECULAR | kernel::MATERIAL_VERTEX_ALPHA), 0U);
    EXPECT_NE(flags(surface(1, 1)) & kernel::MATERIAL_VERTEX_SPECULAR, 0U);
    PrincipledSurface s = surface(0, 1);
    s.unlit = true;
    EXPECT_NE(flags(s) & kernel::MATERIAL_VERTEX_EMISSION, 0U);
    s.alpha_mode = PrincipledSurface::Alpha::mask;
    EXPECT_NE(flags(s) & kernel::MATERIAL_VERTEX_ALPHA, 0U);
    EXPECT_NE(flags(s) & kernel::MATERIAL_TRANSPARENT, 0U);
    EXPECT_NE(compile_maps(s, {}, true).opacity.flags & kernel::TEXTURE_CUTOFF, 0U);
    EXPECT_EQ(compile_maps(s, {}, false).opacity.flags & kernel::TEXTURE_CUTOFF, 0U);
}

}  // namespace
}  // namespace sundog
