// SPDX-License-Identifier: Apache-2.0
// The very command lines with which other programs call povray, through a link of that name.
#include <gtest/gtest.h>

#include "output/image.h"
#include "program.h"

namespace sundog::tests {
namespace {

using Words = std::vector<std::string>;

constexpr const char* kScene = R"(#version 3.6;
camera { location <0, 0, -4> look_at 0 }
light_source { <5, 5, -5> color rgb 1 }
sphere { 0, 1 pigment { color rgb <1, 0.5, 0> } finish { ambient 0.3 } }
)";

class Tools : public testing::Test {
protected:
    Tools() {
        std::filesystem::create_symlink(built_program(), folder_ / "povray");
        for (const char* name : {"scene.pov", "vmdscene.pov", "tmp_pymol.pov"}) write_bytes(folder_ / name, kScene);
    }
    Outcome povray(const Words& words) { return run(words, folder_.path(), folder_ / "povray"); }
    void expect_picture(const std::string& name, int width, int height) {
        const output::Image image = output::read_image(folder_ / name);
        EXPECT_EQ(image.width, width);
        EXPECT_EQ(image.height, height);
        EXPECT_GT(image.at(width / 2, height / 2).x, 0.2F);
    }
    TemporaryFolder folder_;
};

// Catches INI files of ASE that are refused (ase.io.pov writes one beside the scene and calls `povray scene.ini`).
TEST_F(Tools, Ase) {
    write_bytes(folder_ / "scene.ini",
                "Input_File_Name=scene.pov\nOutput_to_File=True\nOutput_File_Type=N\nOutput_Alpha=off\n"
                "; if you adjust Height, and width, you must preserve the ratio\n; Width / Height = 1.333333\n"
                "Width=64\nHeight=48.0\nAntialias=True\nAntialias_Threshold=0.1\nDisplay=False\nDisplay_Gamma=2.2\n"
                "Pause_When_Done=False\nVerbose=False\nMax_Image_Buffer_Memory=1024\n");
    const Outcome outcome = povray({"scene.ini"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    expect_picture("scene.png", 64, 48);
}

// Catches PyMOL's call (modules/pymol/povray.py).
TEST_F(Tools, Pymol) {
    const Outcome outcome = povray({"-D", "+Itmp_pymol.pov", "+Otmp_pymol.png", "+W80", "+H60", "+A"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    expect_picture("tmp_pymol.png", 80, 60);
}

// Catches VMD's default render commands, of old and of today.
TEST_F(Tools, Vmd) {
    EXPECT_EQ(povray({"+W80", "+H60", "-Ivmdscene.pov", "-Ovmdscene.pov.tga", "+D", "+X", "+A", "+FT"}).status, 0);
    expect_picture("vmdscene.pov.tga", 80, 60);
    EXPECT_EQ(povray({"+H50", "+W40", "-Ivmdscene.pov", "-Oother.tga", "+D", "+X", "+A", "+FT"}).status, 0);
    expect_picture("other.tga", 40, 50);
    EXPECT_EQ(povray({"+W80", "+H60", "-Ivmdscene.pov", "-Ovmdscene.pov.png", "+X", "+A", "+FN", "+UA"}).status, 0);
    expect_picture("vmdscene.pov.png", 80, 60);
}

// Catches Jmol's INI file (written beside the scene by `write povray`), and the command line of its dialog.
TEST_F(Tools, Jmol) {
    write_bytes(folder_ / "scene.pov.ini",
                "; Created by: Jmol 14.6\n; Creation date: 22 November\n; File created: scene.pov (218 bytes)\n\n\n"
                "; Jmol state: (embedded in input file)\nInput_File_Name=scene.pov\nOutput_to_File=true\n"
                "Output_File_Type=N\nOutput_File_Name=scene.pov.png\nWidth=80\nHeight=60\nAntialias=true\n"
                "Antialias_Threshold=0.1\nDisplay=true\nPause_When_Done=true\nWarning_Level=5\nVerbose=false\n");
    const Outcome outcome = povray({"scene.pov.ini"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    expect_picture("scene.pov.png", 80, 60);
    const std::string scene = (folder_ / "scene.pov").string();
    const std::string picture = (folder_ / "dialog.png").string();
    const Outcome dialog = povray({"+I" + scene, "+O" + picture, "+FN", "+H60", "+W80", "+A0.0", "+D", "+P", "-V"});
    EXPECT_EQ(dialog.status, 0) << dialog.err;
    expect_picture("dialog.png", 80, 60);
}

// Catches a program that is povray under no other name, and one that forgets its own commands under that name.
TEST_F(Tools, TheNameDecides) {
    std::filesystem::create_symlink(built_program(), folder_ / "povray3.7");
    EXPECT_EQ(run({"scene.pov", "+W16", "+H12"}, folder_.path(), folder_ / "povray3.7").status, 0);
    std::filesystem::create_symlink(built_program(), folder_ / "sundog2");
    EXPECT_EQ(run({"scene.pov", "+W16", "+H12"}, folder_.path(), folder_ / "sundog2").status, 2);
}

}  // namespace
}  // namespace sundog::tests
