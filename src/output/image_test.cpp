// SPDX-License-Identifier: Apache-2.0
#include "output/image.h"

#include <gtest/gtest.h>

#include "base/diagnostics.h"
#include "output/test_files.h"

namespace sundog::output {
namespace {

std::string read_error(const std::filesystem::path& file) {
    try {
        read_image(file);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

std::string write_error(const std::filesystem::path& file, const Image& image) {
    try {
        write_image(file, image);
    } catch (const OutputError& error) {
        return error.what();
    }
    return "no error";
}

// Catches swapped channels, rows upside down, wrong strides and a wrong transfer function in writer or reader.
TEST(Image, PngKeepsEightBits) {
    const TemporaryFolder folder;
    const Image image = ramp_picture(37, 23);
    write_image(folder / "a.PNG", image);
    const Image read = read_image(folder / "a.PNG");
    ASSERT_EQ(read.width, 37);
    ASSERT_EQ(read.height, 23);
    EXPECT_EQ(to_srgb8(read), to_srgb8(image));
    EXPECT_EQ(folder.entries(), 1U);
}

// Catches alpha or channel order of textures being mixed up.
TEST(Image, Rgba8HasRedInTheLowestByte) {
    const TemporaryFolder folder;
    Image image(2, 1);
    image.at(0, 0) = {1, 0, 0};
    image.at(1, 0) = {0, 0.5F, 1};
    write_image(folder / "a.png", image);
    const Rgba8 texture = read_rgba8(folder / "a.png");
    EXPECT_EQ(texture.width, 2U);
    EXPECT_EQ(texture.height, 1U);
    EXPECT_EQ(texture.pixels, (std::vector<std::uint32_t>{0xFF0000FF, 0xFFFFBC00}));
}

// Catches messages without the file's name or the reason.
TEST(Image, ErrorsNameTheFile) {
    const TemporaryFolder folder;
    put(folder / "a.png", encode(ramp_picture(19, 7), Format::png).substr(0, 100));
    EXPECT_EQ(read_error(folder / "a.png"), (folder / "a.png").string() + ": error: damaged PNG: the file is cut off");
}

// Catches a format that is chosen by the file's ending instead of its content, and formats that lose colours.
TEST(Image, EveryFormatComesBack) {
    const TemporaryFolder folder;
    const Image image = ramp_picture(40, 30);
    for (const std::string ending : {"png", "jpg", "exr", "hdr", "ppm"}) {
        write_image(folder / ("a." + ending), image);
        std::filesystem::rename(folder / ("a." + ending), folder / "renamed");
        const Image read = read_image(folder / "renamed");
        ASSERT_EQ(read.width, 40);
        ASSERT_EQ(read.height, 30);
        const std::vector<std::uint8_t> expected = to_srgb8(image), codes = to_srgb8(read);
        const int allowed = ending == "jpg" || ending == "hdr" ? 8 : 0;
        for (std::size_t i = 0; i < codes.size(); ++i) ASSERT_NEAR(codes[i], expected[i], allowed) << ending << i;
        EXPECT_EQ(read_rgba8(folder / "renamed").pixels[50] & 0xFF, codes[150]) << ending;
    }
}

// Catches a message that doesn't say which endings there are, and a file made in spite of the error.
TEST(Image, UnknownEndingsAreNamed) {
    const TemporaryFolder folder;
    const std::string message = write_error(folder / "a.webp", ramp_picture(2, 2));
    EXPECT_NE(message.find("a.webp"), std::string::npos);
    EXPECT_NE(message.find(".png .jpg .jpeg .exr .hdr .ppm .tga .bmp"), std::string::npos);
    EXPECT_EQ(folder.entries(), 0U);
    EXPECT_EQ(format_of("x/y.JPeG"), Format::jpg);
}

// Catches empty pictures reaching the encoders, and devices without an ending being refused.
TEST(Image, OddTargets) {
    const TemporaryFolder folder;
    EXPECT_NE(write_error(folder / "a.png", Image()).find("without pixels"), std::string::npos);
    EXPECT_EQ(write_error("/dev/null", ramp_picture(2, 2)), "no error");
    EXPECT_NE(write_error("/dev/full", ramp_picture(2, 2)).find("No space left on device"), std::string::npos);
    EXPECT_EQ(folder.entries(), 0U);
}

}  // namespace
}  // namespace sundog::output
