// SPDX-License-Identifier: Apache-2.0
#include "import/obj/mtl.h"

#include <gtest/gtest.h>

#include "base/test_folder.h"
#include "import/obj/obj_import.h"
#include "output/image.h"

namespace sundog::import {
namespace {

class Mtl : public testing::Test {
protected:
    scene::Scene import_text(std::string_view text) {
        scene::Scene scene;
        import_mtl(folder_.write("a.mtl", text), scene, warnings_.sink());
        return scene;
    }
    scene::Material material(std::string_view statements) {
        return import_text("newmtl m\n" + std::string(statements)).materials.at(0);
    }
    std::string error_of(std::string_view statements) {
        try {
            material(statements);
        } catch (const InputError& error) {
            const Diagnostic& d = error.diagnostic();
            return std::to_string(d.where.line) + ':' + std::to_string(d.where.column) + ": " + d.message;
        }
        return "no error";
    }
    /// A picture of 2x1 pixels.
    void write_picture(const std::string& name) {
        output::Image image(2, 1);
        image.at(0, 0) = {1, 1, 1};
        std::filesystem::create_directories((folder_.path() / name).parent_path());
        output::write_image(folder_.path() / name, image);
    }

    TestFolder folder_;
    Warnings warnings_;
};

// Catches a statement that is read into another one's place.
TEST_F(Mtl, ReadsEachStatement) {
    const scene::Material m = material(
        "Ka 0.1 0.2 0.3\nKd 0.4 0.5 0.6\nKs 0.7\n Ke 1 2 3 \nTf 0.9 0.8 0.7\nNs 50\nNi 1.5\nd 0.25\nTr 0.1\nillum 7\n"
        "Pr 0.3\nPm 0.6\nPc 0.9\nchecker_Kd 4 2 0.1 0.2 0.3\nhighlight phong\r\n");
    EXPECT_EQ(m.mtl->ambient, (Vec3{0.1F, 0.2F, 0.3F}));
    EXPECT_EQ(m.mtl->diffuse, (Vec3{0.4F, 0.5F, 0.6F}));
    EXPECT_EQ(m.mtl->specular, (Vec3{0.7F, 0.7F, 0.7F}));
    EXPECT_EQ(m.mtl->emission, (Vec3{1, 2, 3}));
    EXPECT_EQ(m.mtl->transmission_filter, (Vec3{0.9F, 0.8F, 0.7F}));
    EXPECT_EQ(m.mtl->shininess, 50.0F);
    EXPECT_EQ(m.mtl->ior, 1.5F);
    EXPECT_EQ(m.mtl->opacity, 0.25F) << "d wins over Tr";
    EXPECT_EQ(m.mtl->illum, 7);
    EXPECT_EQ(m.mtl->roughness, 0.3F);
    EXPECT_EQ(m.mtl->metallic, 0.6F);
    EXPECT_EQ(m.mtl->clearcoat, 0.9F);
    ASSERT_TRUE(m.mtl->checker.has_value());
    EXPECT_EQ(m.mtl->checker->cells_u, 4.0F);
    EXPECT_EQ(m.mtl->checker->cells_v, 2.0F);
    EXPECT_EQ(m.mtl->checker->other, (Vec3{0.1F, 0.2F, 0.3F}));
    EXPECT_TRUE(m.mtl->phong_highlight);
    EXPECT_EQ(material("Tr 0.75\n").mtl->opacity, 0.25F);
    EXPECT_TRUE(warnings_.texts.empty()) << warnings_.texts.front();
}

// Catches a model whose numbers are read in another order, and names that are let through.
TEST_F(Mtl, ReadsReflectionModels) {
    using Kind = scene::ReflectionModel::Kind;
    const scene::Material ward = material("bsdf ward 0.1 0.4\n");
    ASSERT_TRUE(ward.mtl->model.has_value());
    EXPECT_EQ(ward.mtl->model->kind, Kind::ward);
    EXPECT_EQ(ward.mtl->model->first, 0.1F);
    EXPECT_EQ(ward.mtl->model->second, 0.4F);
    const scene::Material gold = material("bsdf ggx 0.2 0.3 gold\n");
    ASSERT_TRUE(gold.mtl->model.has_value());
    EXPECT_GT(gold.mtl->model->n.z, gold.mtl->model->n.x) << "gold swallows blue";
    EXPECT_NEAR(material("bsdf oren-nayar 90\n").mtl->model->first, 1.5707963F, 1e-6F);
    EXPECT_EQ(error_of("bsdf wards 1 1\n"), "2:6: unknown reflection model 'wards'");
    EXPECT_EQ(error_of("bsdf ggx 0.2 0.3 golt\n"), "2:18: unknown metal 'golt'");
    EXPECT_EQ(error_of("bsdf glass 3\n"), "2:12: a number out of its range in 'bsdf glass roughness'");
}

// Catches the wrong matrix: D65 white in XYZ is white, and colours outside of RGB don't turn negative.
TEST_F(Mtl, ConvertsXyz) {
    const Vec3 white = material("Kd xyz 0.9505 1 1.089\n").mtl->diffuse;
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(white[i], 1, 1e-3F);
    const Vec3 green = material("Kd xyz 0.1 0.6 0.1\n").mtl->diffuse;
    EXPECT_EQ(green.x, 0.0F);
    EXPECT_GT(green.y, 0.5F);
}

// Catches options that are taken for the file name, names with blanks or backslashes, and files read twice.
TEST_F(Mtl, ReadsTexturesWithOptions) {
    write_picture("my maps/wood.png");
    const scene::Scene scene = import_text(
        "newmtl m\nmap_Kd -s 2 3 1 -o 0.5 -clamp on -blendu off -mm 0 1 my maps\\wood.png\n"
        "map_Bump -bm 0.5 -imfchan g my maps/wood.png\nnorm \"my maps/wood.png\"\n"
        "newmtl n\nmap_d my maps/wood.png\nmap_Ks C:\\lost\\..\\my maps\\wood.png\n");
    const scene::Material& m = scene.materials.at(0);
    EXPECT_EQ(m.mtl->map_diffuse.scale, (Vec2{2, 3}));
    EXPECT_EQ(m.mtl->map_diffuse.offset, (Vec2{0.5F, 0}));
    EXPECT_EQ(m.mtl->map_diffuse.wrap_u, scene::TextureUse::Wrap::clamp);
    EXPECT_EQ(m.mtl->map_bump.strength, 0.5F);
    EXPECT_EQ(m.mtl->map_bump.channel, 1);
    EXPECT_EQ(scene.materials.at(1).mtl->map_opacity.channel, 4);
    EXPECT_EQ(m.mtl->map_bump.texture, m.mtl->map_normal.texture) << "the same file, used the same way, is one texture";
    ASSERT_GE(scene.textures.size(), 2U);
    EXPECT_TRUE(scene.textures[m.mtl->map_diffuse.texture].srgb);
    EXPECT_FALSE(scene.textures[m.mtl->map_bump.texture].srgb);
    EXPECT_EQ(scene.textures[m.mtl->map_bump.texture].rgba8, scene.textures[m.mtl->map_diffuse.texture].rgba8);
    EXPECT_EQ(scene.files.size(), 2U);
    EXPECT_EQ(warnings_.texts, (std::vector<std::string>{"7: missing texture 'C:\\lost\\..\\my maps\\wood.png'"}));
}

// Catches a missing texture that goes unseen, and one whose damage ends the import.
TEST_F(Mtl, BadTexturesAreWarningsWithAStandIn) {
    folder_.write("broken.png", "no picture");
    const scene::Scene scene =
        import_text("newmtl m\nmap_Kd lost.png\nmap_Ks broken.png\nmap_Bump lost2.png\nmap_Ke .\n");
    const scene::Material& m = scene.materials.at(0);
    ASSERT_LT(m.mtl->map_diffuse.texture, scene.textures.size());
    EXPECT_EQ(scene.textures[m.mtl->map_diffuse.texture].rgba8.front(), 0xffff00ffU);
    EXPECT_EQ(m.mtl->map_specular.texture, m.mtl->map_diffuse.texture);
    EXPECT_EQ(m.mtl->map_bump.texture, scene::kNone);
    ASSERT_EQ(warnings_.texts.size(), 4U);
    EXPECT_EQ(warnings_.texts[0], "2: missing texture 'lost.png'");
    EXPECT_TRUE(warnings_.texts[1].starts_with("3: unreadable texture 'broken.png'")) << warnings_.texts[1];
}

// Catches warnings that flood or fall silent, and values out of range that go through.
TEST_F(Mtl, OddThingsAreWarnings) {
    const scene::Scene scene = import_text(
        "Kd 1 1 1\nnewmtl m\nKdd 1 1 1\nKdd 1 1 1\nPs 1\nd 1.5\nNi 0\nillum 99\nKs spectral file.rfl\nKd -1 0 "
        "0\nnewmtl m\n");
    EXPECT_EQ(scene.materials.at(0).mtl->opacity, 1.0F);
    EXPECT_EQ(scene.materials.at(0).mtl->ior, 1.0F);
    EXPECT_EQ(scene.materials.at(0).mtl->diffuse, (Vec3{0, 0, 0}));
    EXPECT_EQ(warnings_.texts,
              (std::vector<std::string>{
                  "1: 'Kd' before the first newmtl is skipped", "3: unknown statement 'Kdd' is skipped",
                  "5: 'Ps' is not used", "6: number out of its range; the nearest possible one is used",
                  "7: an index of refraction under 0.001; 1 is used", "8: no such illumination model; 2 is used",
                  "9: spectral curves are not used; 'Ks' stays as it was",
                  "10: number out of its range; the nearest possible one is used", "11: a second material 'm'"}));
}

// Catches errors in another place, or none.
TEST_F(Mtl, LocatesErrors) {
    EXPECT_EQ(error_of("Kd 1 2\n"), "2:7: the line ends too early");
    EXPECT_EQ(error_of("Kd 1 2 x\n"), "2:8: bad number 'x'");
    EXPECT_EQ(error_of("Kd 1 2 inf\n"), "2:8: bad number 'inf'");
    EXPECT_EQ(error_of("Kd 1 2 3 4\n"), "2:10: unexpected '4' at the end of the line");
    EXPECT_EQ(error_of("illum 2.5\n"), "2:7: bad whole number '2.5'");
    EXPECT_EQ(error_of("highlight fong\n"), "2:11: unknown highlight 'fong'");
    EXPECT_EQ(error_of("map_Kd\n"), "2:7: the line ends too early");
    EXPECT_EQ(error_of("map_Kd -clamp maybe a.png\n"), "2:15: expected on or off, found 'maybe'");
    EXPECT_EQ(error_of("map_Kd -zoom 2 a.png\n"), "2:8: unknown texture option '-zoom'");
    EXPECT_EQ(error_of("newmtl\n"), "2:7: the line ends too early");
}

}  // namespace
}  // namespace sundog::import
