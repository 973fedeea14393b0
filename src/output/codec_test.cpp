// SPDX-License-Identifier: Apache-2.0
#include "output/codec.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/diagnostics.h"
#include "output/test_files.h"

namespace sundog::output {
namespace {

Bytes bytes_of(const std::string& text) { return {reinterpret_cast<const unsigned char*>(text.data()), text.size()}; }

std::string from_hex(std::string_view hex) {
    std::string bytes;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
        bytes += static_cast<char>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16));
    return bytes;
}

/// Why `bytes` are refused, or "" where they aren't.
std::string refusal(const std::string& bytes) {
    try {
        decode(bytes_of(bytes), 12);
    } catch (const DecodeError& error) {
        return error.what();
    }
    return "";
}

// Pictures of 2x2 pixels, red, green / blue, white, written by another program (ImageMagick 6.9; it leaves out
// TGA's flag for rows from the top, which is set here).
struct Sample {
    const char* name;
    const char* hex;
};
constexpr Sample kBmp{
    "bmp",
    "424d46000000000000003600000028000000020000000200000001001800000000001000000000000000000000000000000000"
    "000000ff0000ffffff00000000ff00ff000000"};
constexpr Sample kGif{
    "gif", "47494638396102000200f10300ff000000ff000000ffffffff21f90400000000002c0000000002000200000203443405003b"};
constexpr Sample kTga{"tga", "0000020000000000000000000200020018200000ff00ff00ff0000ffffff"};
constexpr Sample kRunTga{"tga, run-length coded", "00000a000000000000000000020002001820010000ff00ff0001ff0000ffffff"};
constexpr Sample kPalettePng{
    "png, palette, interlaced",
    "89504e470d0a1a0a0000000d494844520000000200000002020300000178dfd5210000000c504c5445ff000000ff00"
    "0000fffffffffb0060f60000000e4944415408d76360607060d80000017600f12c03ba380000000049454e44ae4260"
    "82"};
constexpr Sample kTextPpm{"ppm as text", "50330a2320630a32203220310a312030203020203020312030203020302031203120312031"};
constexpr Sample kDeepPng{
    "png, 16 bits, red half transparent",
    "89504e470d0a1a0a0000000d49484452000000020000000210060000015521e1f10000001b4944415408d72dc1310100"
    "0008c0204c6ef4f9080a361435d0830301330f72841d090f0000000049454e44ae426082"};
constexpr Sample kCmykJpeg{
    "jpeg, cmyk",
    "ffd8ffee000e41646f626500640000000002ffdb0043000302020302020303030304030304050805050404050a070706080c0a0c0c0b0a0b0b"
    "0d0e12100d0e110e0b0b1016101113141515150c0f171816141812141514ffdb00430103040405040509050509140d0b0d1414141414141414"
    "141414141414141414141414141414141414141414141414141414141414141414141414141414141414ffc000140800100010040111000211"
    "01"
    "031101041100ffc400160001010100000000000000000000000000000708ffc40014100100000000000000000000000000000000ffc4001501"
    "01"
    "0100000000000000000000000000000008ffc40014110100000000000000000000000000000000ffda000e040100021103110400003f00962"
    "8d48ed80000000fffd9"};

/// One small file of each format and kind of coding.
std::vector<std::string> one_of_each() {
    const Image image = ramp_picture(11, 5);
    std::vector<std::string> files;
    for (const Format format : {Format::png, Format::jpg, Format::exr, Format::hdr, Format::ppm})
        files.push_back(encode(image, format));
    for (const Sample& sample : {kBmp, kGif, kTga, kRunTga, kPalettePng, kTextPpm, kDeepPng, kCmykJpeg})
        files.push_back(from_hex(sample.hex));
    return files;
}

// Catches swapped channels or rows, lost palettes and wrong run-length decoding in files that others wrote.
TEST(Codec, ReadsFilesOfOtherPrograms) {
    for (const Sample& sample : {kBmp, kGif, kTga, kRunTga, kPalettePng, kTextPpm}) {
        const Decoded decoded = decode(bytes_of(from_hex(sample.hex)), 4);
        EXPECT_EQ(decoded.width, 2U) << sample.name;
        EXPECT_EQ(decoded.rgba8, (std::vector<std::uint32_t>{0xFF0000FF, 0xFF00FF00, 0xFFFF0000, 0xFFFFFFFF}))
            << sample.name;
    }
    const Decoded deep = decode(bytes_of(from_hex(kDeepPng.hex)), 4);
    ASSERT_EQ(deep.rgba16.size(), 16U);
    EXPECT_EQ(deep.rgba16[0], 0xFFFF);
    EXPECT_NEAR(deep.rgba16[3], 0x8000, 1);
    EXPECT_EQ(deep.rgba16[4], 0);
    EXPECT_EQ(deep.rgba16[5], 0xFFFF);
}

// Catches inverted or unconverted ink: the file is a patch of the colour (200, 100, 50).
TEST(Codec, ReadsCmykJpeg) {
    const Decoded decoded = decode(bytes_of(from_hex(kCmykJpeg.hex)), 4);
    ASSERT_EQ(decoded.rgba8.size(), 256U);
    EXPECT_NEAR(decoded.rgba8[77] & 0xFF, 200, 3);
    EXPECT_NEAR(decoded.rgba8[77] >> 8 & 0xFF, 100, 3);
    EXPECT_NEAR(decoded.rgba8[77] >> 16 & 0xFF, 50, 3);
}

// Catches readers that crash, read past the end, or fill up what is missing. The text format may end anywhere in its
// last number, and a GIF needs no end mark after its picture.
TEST(Codec, CutFilesAreRefused) {
    for (const std::string& file : one_of_each()) {
        const bool lenient = file.starts_with("P3") || file.starts_with("GIF");
        for (std::size_t size = 0; size + (lenient ? 4 : 0) < file.size(); ++size)
            ASSERT_NE(refusal(file.substr(0, size)), "") << file.substr(0, 4) << " cut at " << size;
    }
}

// Catches crashes, endless loops and foreign exceptions on damaged files (most useful under the sanitizers).
TEST(Codec, DamagedFilesAreReadOrRefused) {
    for (const std::string& file : one_of_each()) {
        std::size_t refused = 0;
        for (std::size_t i = 0; i < file.size(); ++i) {
            for (const unsigned char flip : {0x01, 0x80, 0xFF}) {
                std::string damaged = file;
                damaged[i] = static_cast<char>(static_cast<unsigned char>(damaged[i]) ^ flip);
                refused += refusal(damaged).empty() ? 0 : 1;
            }
        }
        EXPECT_GT(refused, 0U) << file.substr(0, 4);
    }
}

// Catches colours instead of a palette's numbers, packed bits left packed, a wrong order of interlaced rows; cut or
// damaged files that crash, hang or are filled up; and palettes found where there is none.
TEST(Codec, ReadsNumbersOfPalettes) {
    const std::vector<std::uint8_t> expected{0, 1, 2, 3};
    const std::string gif = from_hex(kGif.hex);
    const std::string png = from_hex(kPalettePng.hex);
    EXPECT_EQ(decode_gif_indices(bytes_of(gif)).indices, expected);
    EXPECT_EQ(decode_png_indices(bytes_of(png)).value().indices, expected);
    EXPECT_FALSE(decode_png_indices(bytes_of(from_hex(kDeepPng.hex))));
    EXPECT_FALSE(png_tells_encoding(bytes_of(png)));
    const std::string written = encode_png(Image(1, 1), {});
    EXPECT_TRUE(png_tells_encoding(bytes_of(written)));
    for (std::size_t size = 0; size + 4 < gif.size(); ++size)
        EXPECT_THROW(decode_gif_indices(bytes_of(gif.substr(0, size))), DecodeError) << size;
    for (std::size_t i = 0; i < gif.size(); ++i) {
        std::string damaged = gif;
        damaged[i] = static_cast<char>(~static_cast<unsigned char>(damaged[i]));
        try {
            EXPECT_FALSE(decode_gif_indices(bytes_of(damaged)).indices.empty());
        } catch (const DecodeError&) {
        }
    }
}

void replace_bytes(std::string& bytes, std::size_t at, const std::string& by) { bytes.replace(at, by.size(), by); }

/// CRC-32 of a PNG chunk (ISO 3309).
std::string png_crc(std::string_view chunk) {
    std::uint32_t crc = 0xFFFFFFFF;
    for (const char c : chunk) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0xEDB88320 : 0);
    }
    crc = ~crc;
    std::string text;
    for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(crc >> shift & 0xFF);
    return text;
}

/// Small files that claim 30000x30000 pixels (or `side` a side where the format can say so).
std::vector<std::string> liars(int side) {
    const auto big_endian = [side](int bytes) {
        std::string text;
        for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) text += static_cast<char>(side >> shift & 0xFF);
        return text;
    };
    const auto little_endian = [side](int bytes) {
        std::string text;
        for (int shift = 0; shift < 8 * bytes; shift += 8) text += static_cast<char>(side >> shift & 0xFF);
        return text;
    };
    std::vector<std::string> files;
    std::string png = encode(ramp_picture(8, 8), Format::png);
    replace_bytes(png, 16, big_endian(4) + big_endian(4));
    replace_bytes(png, 29, png_crc(std::string_view(png).substr(12, 17)));
    files.push_back(png);
    std::string exr = encode(ramp_picture(8, 8), Format::exr);
    replace_bytes(exr, exr.find("dataWindow") + 11 + 6 + 4 + 8, little_endian(4) + little_endian(4));
    files.push_back(exr);
    const std::string decimal = std::to_string(side);
    files.push_back("#?RADIANCE\n\n-Y " + decimal + " +X " + decimal + "\nabcd");
    files.push_back("P6 " + decimal + " " + decimal + " 255\nabc");
    files.push_back("P3 " + decimal + " " + decimal + " 255\n1 2 3");
    std::string bmp = from_hex(kBmp.hex);
    replace_bytes(bmp, 18, little_endian(4) + little_endian(4));
    files.push_back(bmp);
    if (side > 0xFFFF) return files;
    std::string jpeg = encode(ramp_picture(8, 8), Format::jpg);
    replace_bytes(jpeg, jpeg.find("\xFF\xC0") + 5, big_endian(2) + big_endian(2));
    files.push_back(jpeg);
    std::string gif = from_hex(kGif.hex);
    replace_bytes(gif, 6, little_endian(2) + little_endian(2));
    files.push_back(gif);
    std::string tga = from_hex(kTga.hex);
    replace_bytes(tga, 12, little_endian(2) + little_endian(2));
    files.push_back(tga);
    return files;
}

// Catches sizes that aren't checked before memory is taken: these would take 8 GB to 120 GB.
TEST(Codec, HugePicturesAreRefusedByTheirHeader) {
    for (const int side : {40'000, 100'000}) {
        for (const std::string& file : liars(side)) {
            const std::string why = refusal(file);
            EXPECT_TRUE(why.find("gigapixel") != std::string::npos || why.find("limit") != std::string::npos ||
                        why.find("4 GiB") != std::string::npos || why.find("too large") != std::string::npos)
                << file.substr(0, 4) << ": " << why;
        }
    }
}

// Catches memory for the claimed size being filled before it is noticed that the pixels aren't there.
TEST(Codec, SmallFilesCanNotClaimLargePictures) {
    for (const std::string& file : liars(15'000)) EXPECT_NE(refusal(file), "") << file.substr(0, 4);
}

// Catches JPEG with subsampled colour (a red line on blue would smear) or low quality.
TEST(Codec, JpegKeepsThinColouredLines) {
    Image image(32, 32);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) image.at(x, y) = x == 9 ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
    const Decoded decoded = decode(bytes_of(encode(image, Format::jpg)), 4);
    EXPECT_NEAR(decoded.rgba8[32 * 5 + 9] & 0xFF, 255, 25);
    EXPECT_NEAR(decoded.rgba8[32 * 5 + 8] & 0xFF, 0, 25);
}

// Catches lost precision or range: floats must come back bit for bit.
TEST(Codec, ExrIsExact) {
    Image image = ramp_picture(13, 300, 1e6F);
    image.at(3, 3) = {-1, 1e-20F, INFINITY};
    EXPECT_EQ(decode(bytes_of(encode(image, Format::exr)), 12).linear, image.pixels);
}

// Catches planes under wrong names or types, interleaved wrongly, or ids that lose their low bits.
TEST(Codec, ExrKeepsLayers) {
    const TemporaryFolder folder;
    const Image image = ramp_picture(3, 2);
    const std::vector<Layer> layers{{"depth", {"Z"}, {1, 2, 3, 4, 5, INFINITY}},
                                    {"normal", {"X", "Y"}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}},
                                    {"object", {"id"}, {0, 1, 16'777'215, -1, NAN, 4294967296.0F}},
                                    {"cost", {""}, {6, 5, 4, 3, 2, 1}}};
    write_image(folder / "a.exr", image, layers);
    Imf::InputFile file((folder / "a.exr").c_str());
    std::vector<std::string> names;
    for (auto c = file.header().channels().begin(); c != file.header().channels().end(); ++c)
        names.emplace_back(c.name());
    EXPECT_EQ(names, (std::vector<std::string>{"B", "G", "R", "cost", "depth.Z", "normal.X", "normal.Y", "object.id"}));
    EXPECT_EQ(file.header().channels()["object.id"].type, Imf::UINT);
    std::vector<float> normal_y(6), depth(6);
    std::vector<std::uint32_t> id(6);
    Imf::FrameBuffer planes;
    planes.insert("normal.Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(normal_y.data()), 4, 12));
    planes.insert("depth.Z", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(depth.data()), 4, 12));
    planes.insert("object.id", Imf::Slice(Imf::UINT, reinterpret_cast<char*>(id.data()), 4, 12));
    file.setFrameBuffer(planes);
    file.readPixels(0, 1);
    EXPECT_EQ(normal_y, (std::vector<float>{1, 3, 5, 7, 9, 11}));
    EXPECT_EQ(depth, (std::vector<float>{1, 2, 3, 4, 5, INFINITY}));
    EXPECT_EQ(id, (std::vector<std::uint32_t>{0, 1, 16'777'215, 0, 0, 0xFFFFFFFF}));
    EXPECT_EQ(read_image(folder / "a.exr").pixels, image.pixels);
}

// Catches layers of a wrong size being read past their end, and two channels of one name.
TEST(Codec, ExrRefusesBadLayers) {
    const Image image = ramp_picture(2, 2);
    EXPECT_THROW(encode(image, Format::exr, {{"depth", {"Z"}, {1, 2, 3}}}), OutputError);
    EXPECT_THROW(encode(image, Format::exr, {{"R", {""}, {1, 2, 3, 4}}}), OutputError);
}

// Catches errors over half a step of the shared exponent, in coded and in plain lines (under 8 pixels), at all scales.
TEST(Codec, RadianceKeepsEightBitsOfTheBrightestChannel) {
    for (const int width : {5, 400}) {
        for (const float scale : {1e-6F, 1.0F, 5e7F}) {
            const Image image = ramp_picture(width, 9, scale);
            const Decoded decoded = decode(bytes_of(encode(image, Format::hdr)), 12);
            ASSERT_EQ(decoded.linear.size(), image.pixels.size());
            for (std::size_t i = 0; i < image.pixels.size(); ++i) {
                const Vec3 p = image.pixels[i];
                // A largest mantissa over 255.5 rounds up to the next exponent.
                const float largest = std::max({p.x, p.y, p.z}) * (256 / 255.5F);
                const float step = std::exp2(std::floor(std::log2(largest)) - 7);
                for (std::size_t c = 0; c < 3; ++c) ASSERT_LE(std::abs(decoded.linear[i][c] - p[c]), 0.51F * step);
            }
        }
    }
}

// Catches run-length coding that doesn't shorten flat pictures or breaks long runs and literals.
TEST(Codec, RadianceCodesRuns) {
    Image image(1000, 3);
    for (int x = 0; x < 1000; ++x) image.at(x, 1) = Vec3{1, 2, 4} * (x % 300 < 200 ? 1.0F : static_cast<float>(x % 7));
    image.at(999, 2) = {0.5F, 0.25F, 1};
    const std::string file = encode(image, Format::hdr);
    EXPECT_LT(file.size(), 1000U * 3);
    EXPECT_EQ(decode(bytes_of(file), 12).linear, image.pixels);
}

// Catches negative, infinite and undefined values that turn into other colours.
TEST(Codec, RadianceStoresOddValues) {
    Image image(8, 1);
    image.pixels[0] = {-1, NAN, 1};
    image.pixels[1] = {INFINITY, 0, 0};
    image.pixels[2] = {0.99999F, 0, 0};
    const Decoded decoded = decode(bytes_of(encode(image, Format::hdr)), 12);
    EXPECT_EQ(decoded.linear[0], (Vec3{0, 0, 1}));
    EXPECT_GT(decoded.linear[1].x, 1e38F);
    EXPECT_EQ(decoded.linear[2], (Vec3{1, 0, 0}));
}

// Catches the older run-length coding (repeat pixels) and rows from the bottom being misread.
TEST(Codec, RadianceReadsOlderFiles) {
    const std::string pixel("\x80\x40\x20\x81", 4), other("\x10\x20\x40\x81", 4), repeat("\1\1\1\4", 4);
    const std::string file = "#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n+Y 2 +X 5\n" + pixel + repeat + other + repeat;
    const Decoded decoded = decode(bytes_of(file), 12);
    ASSERT_EQ(decoded.linear.size(), 10U);
    EXPECT_EQ(decoded.linear[0], (Vec3{0.125F, 0.25F, 0.5F}));
    EXPECT_EQ(decoded.linear[9], (Vec3{1, 0.5F, 0.25F}));
}

// Catches 16-bit samples in the wrong byte order and unusual largest samples that aren't scaled.
TEST(Codec, PpmScalesItsSamples) {
    const Decoded deep = decode(bytes_of(std::string("P5 2 1 65535\n\x12\x34\xFF\xFF", 17)), 4);
    EXPECT_EQ(deep.rgba16,
              (std::vector<std::uint16_t>{0x1234, 0x1234, 0x1234, 0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF}));
    const Decoded coarse = decode(bytes_of(std::string("P6\n1 1\n3\n\0\1\3", 12)), 4);
    EXPECT_EQ(coarse.rgba8, (std::vector<std::uint32_t>{0xFFFF5500}));
    EXPECT_NE(refusal("P6\n1 1\n3\nzzz"), "");
}

// Catches text, scripts and web pages being taken for a picture.
TEST(Codec, OtherFilesAreRefused) {
    for (const std::string file : {"", "P", "P6", "P9 1 1 1 ", "#?RADIANCE", "hello world, this is no picture at all",
                                   "<!DOCTYPE html><html><body></body></html>"})
        EXPECT_NE(refusal(file), "") << file;
}

}  // namespace
}  // namespace sundog::output
