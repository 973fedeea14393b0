// SPDX-License-Identifier: Apache-2.0
// `sundog pov` as a whole: exit statuses, files and their names, texts.
#include <gtest/gtest.h>

#include "output/image.h"
#include "program.h"

namespace sundog::tests {
namespace {

using Words = std::vector<std::string>;

constexpr const char* kScene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
#debug concat("clock ", str(clock, 0, 3), " frame ", str(frame_number, 0, 0), "\n")
camera { location <0, 0, -4> look_at 0 right x*image_width/image_height }
light_source { <5, 5, -5> rgb 1 }
sphere { <0, clock, 0>, 1 pigment { rgb <1, 0.5, 0> } }
plane { z, 10 pigment { rgb <0, 0, 1> } finish { ambient 1 diffuse 0 } }
)";

/// A folder with the scene a.pov, and calls of `sundog pov` in it without the machine's own INI files.
class PovCommand : public testing::Test {
protected:
    PovCommand() { write_bytes(folder_ / "a.pov", kScene); }
    Outcome pov(Words words) {
        words.insert(words.begin(), {"pov", "+W32", "+H24", "--device", "cpu", "+WT2"});
        return run(words, folder_.path());
    }
    [[nodiscard]] bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
    TemporaryFolder folder_;
};

// Catches a scene that isn't drawn, or drawn upside down or into the wrong file.
TEST_F(PovCommand, RendersToTheScenesName) {
    const Outcome outcome = pov({"a.pov"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    const output::Image image = output::read_image(folder_ / "a.png");
    EXPECT_EQ(image.width, 32);
    EXPECT_EQ(image.height, 24);
    EXPECT_GT(image.at(18, 10).x, 0.3F) << "the sphere, lit from the upper right";
    EXPECT_GT(image.at(19, 8).x, image.at(12, 15).x);
    EXPECT_GT(image.at(1, 1).z, 0.9F) << "the plane behind it";
}

// Catches other exit statuses than povray's, and errors without a message.
TEST_F(PovCommand, ExitStatuses) {
    write_bytes(folder_ / "error.pov", "#version 3.7; #error \"stop here\"\n");
    write_bytes(folder_ / "syntax.pov", "#version 3.7;\ncamera {");
    for (const auto& [words, said] :
         std::vector<std::pair<Words, std::string>>{{{}, "No input file"},
                                                    {{"a.pov", "+Znonsense"}, "+Znonsense"},
                                                    {{"nofile.pov"}, "nofile.pov"},
                                                    {{"error.pov"}, "stop here"},
                                                    {{"syntax.pov"}, "syntax.pov:2"},
                                                    {{"a.pov", "+Ono/such/a.png"}, "no/such"},
                                                    {{"a.pov", "+SC90"}, "Start_Column"}}) {
        const Outcome outcome = pov(words);
        EXPECT_EQ(outcome.status, 1) << testing::PrintToString(words);
        EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
    }
    for (const char* word : {"--help", "-?", "--version"}) {
        const Outcome outcome = pov({word});
        EXPECT_EQ(outcome.status, 0);
        EXPECT_NE(outcome.out, "");
    }
}

// Catches formats that are written under another's name.
TEST_F(PovCommand, Formats) {
    for (const auto& [type, ending, magic] :
         std::vector<std::array<std::string, 3>>{{"+FN", "png", "\x89PNG"},
                                                 {"+FJ", "jpg", "\xFF\xD8"},
                                                 {"+FP", "ppm", "P6"},
                                                 {"+FE", "exr", "\x76\x2F"},
                                                 {"+FH", "hdr", "#?RADIANCE"},
                                                 {"+FB", "bmp", "BM"},
                                                 {"+FT", "tga", std::string("\0\0\2", 3)},
                                                 {"+FC", "tga", std::string("\0\0\12", 3)}}) {
        EXPECT_EQ(pov({"a.pov", type, "+Oout"}).status, 0);
        EXPECT_TRUE(read_bytes(folder_ / ("out." + ending)).starts_with(magic)) << type;
    }
    EXPECT_EQ(pov({"a.pov", "+FN16", "+Odeep"}).status, 0);
    EXPECT_EQ(read_bytes(folder_ / "deep.png")[24], 16) << "bits a channel";
    const Outcome piped = pov({"a.pov", "+O-"});
    EXPECT_EQ(piped.status, 0);
    EXPECT_TRUE(piped.out.starts_with("\x89PNG"));
    EXPECT_EQ(pov({"a.pov", "-F", "+Onone"}).status, 0);
    EXPECT_FALSE(exists("none.png"));
}

// Catches frames that are missing, misnumbered, or show another moment; and files that +C renders again.
TEST_F(PovCommand, Animations) {
    const Outcome outcome = pov({"a.pov", "+KFF10", "+SF9"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_FALSE(exists("a08.png"));
    EXPECT_TRUE(exists("a09.png"));
    EXPECT_TRUE(exists("a10.png"));
    EXPECT_NE(outcome.err.find("clock 0.889 frame 9\n"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("clock 1.000 frame 10\n"), std::string::npos);
    EXPECT_NE(read_bytes(folder_ / "a09.png"), read_bytes(folder_ / "a10.png"));
    write_bytes(folder_ / "a09.png", "kept");
    EXPECT_EQ(pov({"a.pov", "+KFF10", "+SF9", "+C"}).status, 0);
    EXPECT_EQ(read_bytes(folder_ / "a09.png"), "kept");
    EXPECT_NE(pov({"a.pov", "+K2.5"}).err.find("clock 2.500 frame 0\n"), std::string::npos);
}

// Catches a region that is moved, scaled, or not surrounded by black.
TEST_F(PovCommand, PartOfThePicture) {
    EXPECT_EQ(pov({"a.pov", "+Owhole"}).status, 0);
    EXPECT_EQ(pov({"a.pov", "+Opart", "+SC9", "+EC20", "+SR0.25", "+ER18"}).status, 0);
    const output::Image whole = output::read_image(folder_ / "whole.png");
    const output::Image part = output::read_image(folder_ / "part.png");
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 32; ++x) {
            const bool inside = x >= 8 && x < 20 && y >= 6 && y < 18;
            EXPECT_EQ(part.at(x, y), inside ? whole.at(x, y) : Vec3{}) << x << " " << y;
        }
}

// Catches antialiasing that changes nothing, or pixels far from edges.
TEST_F(PovCommand, Antialiasing) {
    EXPECT_EQ(pov({"a.pov", "+Oplain"}).status, 0);
    EXPECT_EQ(pov({"a.pov", "+A0.1", "+Osmooth"}).status, 0);
    const output::Image plain = output::read_image(folder_ / "plain.png");
    const output::Image smooth = output::read_image(folder_ / "smooth.png");
    EXPECT_NE(plain.pixels, smooth.pixels);
    EXPECT_EQ(plain.at(0, 0), smooth.at(0, 0));
}

// Catches streams that can't be turned off or sent to files, and declarations that don't reach the scene.
TEST_F(PovCommand, Texts) {
    write_bytes(folder_ / "declared.pov",
                std::string(kScene) + "#debug concat(\"given \", str(Given, 0, 2), \"\\n\")\n");
    const Outcome quiet = pov({"declared.pov", "-GA", "+GDdebug.txt", "-GD", "Declare=Given=1.25"});
    EXPECT_EQ(quiet.status, 0);
    EXPECT_EQ(quiet.err, "");
    EXPECT_EQ(read_bytes(folder_ / "debug.txt"), "clock 0.000 frame 0\ngiven 1.25\n");
    EXPECT_EQ(pov({"a.pov", "+GIagain.ini", "+Oone"}).status, 0);
    EXPECT_EQ(run({"pov", "again.ini", "+Otwo"}, folder_.path()).status, 0);
    EXPECT_EQ(read_bytes(folder_ / "one.png"), read_bytes(folder_ / "two.png"));
}

// Catches scenes from standard input that aren't read.
TEST_F(PovCommand, StandardInput) {
    const Outcome outcome =
        Program({"pov", "+I-", "+W32", "+H24", "+Oin.png"}, folder_.path(), built_program(), folder_ / "a.pov").wait();
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(exists("in.png"));
}

}  // namespace
}  // namespace sundog::tests
