// SPDX-License-Identifier: Apache-2.0
#include "output/encoding.h"

#include <gtest/gtest.h>

#include <cmath>

#include "output/codec.h"
#include "output/srgb.h"
#include "output/test_files.h"

namespace sundog::output {
namespace {

Decoded reread(const Image& image, Format format, const Encoding& encoding) {
    const std::string file = encode(image, format, {}, encoding);
    const std::vector<unsigned char> bytes(file.begin(), file.end());
    return decode(bytes, 4);
}

Image with_alpha(Image image) {
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.alpha.push_back(static_cast<float>(i) / static_cast<float>(image.pixels.size() - 1));
    return image;
}

std::uint32_t channel(std::uint32_t rgba, unsigned index) { return rgba >> (8 * index) & 0xFFU; }

// Catches 16-bit pictures with swapped bytes or only 8 bits of content.
TEST(Encoding, DeepPicturesKeepTheirDepth) {
    const Image image = ramp_picture(37, 11);
    for (const Format format : {Format::png, Format::ppm}) {
        Encoding encoding;
        encoding.bits = 16;
        const Decoded decoded = reread(image, format, encoding);
        ASSERT_EQ(decoded.rgba16.size(), image.pixels.size() * 4);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            EXPECT_NEAR(decoded.rgba16[4 * i], srgb_from_linear(image.pixels[i].x) * 65535, 0.51);
            EXPECT_NEAR(decoded.rgba16[4 * i + 2], srgb_from_linear(image.pixels[i].z) * 65535, 0.51);
        }
        encoding.bits = 12;
        EXPECT_NEAR(reread(image, format, encoding).rgba16[4], srgb_from_linear(image.pixels[1].x) * 65535, 9);
    }
}

// Catches depths under 8 bits that aren't spread over the whole range, or not coarser.
TEST(Encoding, ShallowPicturesUseTheWholeRange) {
    Image image(3, 1);
    image.pixels = {{0, 0, 0}, {0.5F, 0.5F, 0.5F}, {1, 1, 1}};
    Encoding encoding;
    encoding.bits = 5;
    const Decoded decoded = reread(image, Format::png, encoding);
    EXPECT_EQ(channel(decoded.rgba8[0], 0), 0U);
    // 23/31: the code of 5 bits next to sRGB's 0.735.
    EXPECT_EQ(channel(decoded.rgba8[1], 0), 189U);
    EXPECT_EQ(channel(decoded.rgba8[2], 0), 255U);
}

// Catches a gamma that is applied the wrong way round, or that a PNG doesn't say in its header.
TEST(Encoding, PowerLaw) {
    Image image(1, 1);
    image.pixels = {{0.25F, 0.25F, 0.25F}};
    Encoding encoding;
    encoding.gamma = 2.0;
    for (const Format format : {Format::png, Format::ppm, Format::tga, Format::bmp})
        EXPECT_EQ(channel(reread(image, format, encoding).rgba8[0], 1), 128U);
    EXPECT_NE(encode(image, Format::png, {}, encoding).find("gAMA"), std::string::npos);
    EXPECT_EQ(encode(image, Format::png, {}, encoding).find("sRGB"), std::string::npos);
    EXPECT_NE(encode(image, Format::png).find("sRGB"), std::string::npos);
    encoding.gamma = 1.0;
    EXPECT_EQ(channel(reread(image, Format::png, encoding).rgba8[0], 1), 64U);
}

// Catches alpha that is lost, gamma encoded or multiplied into the colours of formats that keep them apart.
TEST(Encoding, AlphaIsStraight) {
    const Image opaque = ramp_picture(13, 7);
    const Image image = with_alpha(opaque);
    for (const Format format : {Format::png, Format::tga, Format::bmp}) {
        for (const bool run_length : {false, true}) {
            Encoding encoding;
            encoding.run_length = run_length;
            const Decoded decoded = reread(image, format, encoding);
            const Decoded colors = reread(opaque, format, encoding);
            ASSERT_EQ(decoded.rgba8.size(), image.pixels.size());
            for (std::size_t i = 0; i < decoded.rgba8.size(); ++i) {
                EXPECT_EQ(decoded.rgba8[i] & 0xFFFFFFU, colors.rgba8[i] & 0xFFFFFFU);
                EXPECT_NEAR(channel(decoded.rgba8[i], 3), image.alpha[i] * 255, 0.501);
                EXPECT_EQ(channel(colors.rgba8[i], 3), 255U);
            }
        }
    }
    EXPECT_EQ(reread(image, Format::exr, {}).linear[5], image.pixels[5] * image.alpha[5]) << "EXR's are multiplied";
    EXPECT_EQ(encode(image, Format::jpg), encode(opaque, Format::jpg)) << "no alpha in this format";
    EXPECT_EQ(encode(image, Format::ppm), encode(opaque, Format::ppm));
}

// Catches rows upside down, swapped channels, and run lengths that are wrong at rows' ends or at 128 pixels.
TEST(Encoding, TargaAndBmpHoldThePicture) {
    Image image = ramp_picture(301, 5);
    for (int x = 10; x < 290; ++x) image.at(x, 2) = {0.5F, 0.25F, 0.75F};
    for (int x = 0; x < 301; ++x) image.at(x, 3) = {1, 0, 0};
    const Decoded png = reread(image, Format::png, {});
    for (const Format format : {Format::tga, Format::bmp})
        for (const bool run_length : {false, true}) {
            Encoding encoding;
            encoding.run_length = run_length;
            const Decoded decoded = reread(image, format, encoding);
            EXPECT_EQ(decoded.width, 301U);
            EXPECT_EQ(decoded.rgba8, png.rgba8);
        }
    Encoding compressed;
    compressed.run_length = true;
    EXPECT_LT(encode(image, Format::tga, {}, compressed).size(), encode(image, Format::tga).size());
}

// Catches shades of gray that aren't the luminance, or that differ between formats.
TEST(Encoding, Grayscale) {
    Image image(3, 1);
    image.pixels = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Encoding encoding;
    encoding.grayscale = true;
    for (const Format format : {Format::png, Format::ppm, Format::tga, Format::bmp}) {
        const Decoded decoded = reread(image, format, encoding);
        EXPECT_EQ(channel(decoded.rgba8[0], 0), 127U) << "sRGB of 0.2126";
        EXPECT_EQ(channel(decoded.rgba8[0], 2), 127U);
        EXPECT_EQ(channel(decoded.rgba8[1], 1), 220U);
        EXPECT_EQ(channel(decoded.rgba8[2], 1), 76U);
    }
}

// Catches a quality that doesn't reach the encoder.
TEST(Encoding, JpegQuality) {
    Encoding coarse;
    coarse.jpeg_quality = 20;
    const Image image = ramp_picture(64, 64);
    EXPECT_LT(encode(image, Format::jpg, {}, coarse).size(), encode(image, Format::jpg).size());
}

}  // namespace
}  // namespace sundog::output
