// SPDX-License-Identifier: Apache-2.0
#include "output/compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "output/flip.h"
#include "output/srgb.h"
#include "output/test_files.h"

namespace sundog::output {
namespace {

Image flat(int width, int height, Vec3 linear) {
    Image image(width, height);
    for (Vec3& pixel : image.pixels) pixel = linear;
    return image;
}

/// All channels the linear value of an sRGB code.
Vec3 gray(int code) {
    const float v = linear_of_srgb8()[static_cast<std::size_t>(code)];
    return {v, v, v};
}

/// Dark on the left of column `edge`, bright from there on.
Image edge_at(int edge) {
    Image image(96, 64);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) image.at(x, y) = gray(x < edge ? 60 : 200);
    return image;
}

// Catches any distance that isn't exactly zero for equal pictures.
TEST(Compare, EqualPicturesAreAtNoDistance) {
    const Image image = ramp_picture(70, 40);
    const Comparison c = compare(image, image);
    EXPECT_EQ(c.rmse, 0);
    EXPECT_EQ(c.psnr_db, INFINITY);
    EXPECT_EQ(c.ssim, 1);
    EXPECT_EQ(c.flip, 0);
    EXPECT_EQ(c.max_difference_8bit, 0);
    EXPECT_EQ(c.different_fraction, 0);
}

// Catches a distance that depends on which picture comes first.
TEST(Compare, IsSymmetric) {
    const Image a = ramp_picture(50, 40);
    Image b = a;
    for (std::size_t i = 0; i < b.pixels.size(); i += 3) b.pixels[i] = {b.pixels[i].y, b.pixels[i].x, 0.2F};
    const Comparison ab = compare(a, b), ba = compare(b, a);
    EXPECT_DOUBLE_EQ(ab.rmse, ba.rmse);
    EXPECT_DOUBLE_EQ(ab.ssim, ba.ssim);
    EXPECT_DOUBLE_EQ(ab.flip, ba.flip);
    EXPECT_GT(ab.flip, 0);
    EXPECT_EQ(ab.different_fraction, ba.different_fraction);
}

// Catches wrong scales. Black against white: RMSE 1; SSIM's contrast term is 1 and its brightness term
// C1 / (1 + C1) with C1 = 0.0001; FLIP has no features, and a HyAB distance of 100 where green and blue, the colours
// furthest apart, are at 203.2, so its error is 0.95 + 0.05 (100^0.7 - k) / (203.2^0.7 - k) = 0.9674 with the knee
// k = 0.4 * 203.2^0.7.
TEST(Compare, BlackAgainstWhite) {
    const Comparison c = compare(flat(40, 30, {0, 0, 0}), flat(40, 30, {1, 1, 1}));
    EXPECT_DOUBLE_EQ(c.rmse, 1);
    EXPECT_DOUBLE_EQ(c.psnr_db, 0);
    EXPECT_NEAR(c.ssim, 0.0001 / 1.0001, 1e-7);
    EXPECT_NEAR(c.flip, 0.9674, 1e-4);
    EXPECT_EQ(c.max_difference_8bit, 255);
    EXPECT_EQ(c.different_fraction, 1);
}

// Catches an error that isn't normalised by the largest: no two colours are further apart than green and blue.
TEST(Compare, GreenAgainstBlueIsTheLargestFlip) {
    EXPECT_NEAR(compare(flat(30, 30, {0, 1, 0}), flat(30, 30, {0, 0, 1})).flip, 1, 1e-5);
}

// Catches distances in linear light, missing channels, and pixels counted that differ by 2 codes or fewer.
TEST(Compare, CountsAreOfSrgbCodes) {
    const Image a = flat(10, 10, gray(100));
    Image b = a;
    b.pixels[7] = {gray(110).x, gray(100).x, gray(100).x};
    b.pixels[8] = gray(102);
    const Comparison c = compare(a, b);
    EXPECT_NEAR(c.rmse, std::sqrt((100 + 3 * 4) / 300.0) / 255, 1e-12);
    EXPECT_NEAR(c.psnr_db, 20 * std::log10(255 / std::sqrt(112 / 300.0)), 1e-9);
    EXPECT_EQ(c.max_difference_8bit, 10);
    EXPECT_DOUBLE_EQ(c.different_fraction, 0.01);
}

// Catches wrong windows: in a picture of 11x11 there is one window, whose formula is written out here.
TEST(Compare, SsimOfOneWindow) {
    const auto code_a = [](int x, int y) { return 20 * x + y; };
    const auto code_b = [](int x, int y) { return 15 * y + 3 * x + ((x ^ y) & 1) * 40; };
    Image a(11, 11), b(11, 11);
    double sum_w = 0, sum_a = 0, sum_b = 0, sum_aa = 0, sum_bb = 0, sum_ab = 0;
    for (int y = 0; y < 11; ++y) {
        for (int x = 0; x < 11; ++x) {
            a.at(x, y) = gray(code_a(x, y));
            b.at(x, y) = gray(code_b(x, y));
            const double w = std::exp(-((x - 5) * (x - 5) + (y - 5) * (y - 5)) / (2 * 1.5 * 1.5));
            const double va = code_a(x, y), vb = code_b(x, y);
            sum_w += w, sum_a += w * va, sum_b += w * vb;
            sum_aa += w * va * va, sum_bb += w * vb * vb, sum_ab += w * va * vb;
        }
    }
    const double ma = sum_a / sum_w, mb = sum_b / sum_w;
    const double c1 = 0.01 * 0.01 * 255 * 255, c2 = 0.03 * 0.03 * 255 * 255;
    const double expected = (2 * ma * mb + c1) * (2 * (sum_ab / sum_w - ma * mb) + c2) /
                            ((ma * ma + mb * mb + c1) * (sum_aa / sum_w - ma * ma + sum_bb / sum_w - mb * mb + c2));
    EXPECT_NEAR(compare(a, b).ssim, expected, 1e-4);
}

// Catches a FLIP without features or without the eye's blur: an edge that jumps is seen, and a fine checkerboard of
// two near grays looks like their mean.
TEST(Compare, FlipSeesWhatPeopleSee) {
    const std::vector<std::uint8_t> before = to_srgb8(edge_at(48));
    const Plane moved = flip_errors(before, to_srgb8(edge_at(50)), 96, 64);
    EXPECT_GT(moved.values[moved.index(49, 32)], 0.4F);
    EXPECT_LT(moved.values[moved.index(10, 32)], 1e-4F);
    Image faint = edge_at(48);
    for (int y = 0; y < faint.height; ++y)
        for (int x = 0; x < faint.width; ++x)
            if (((x + y) & 1) != 0) faint.at(x, y) = gray(x < 48 ? 62 : 202);
    const Plane unseen = flip_errors(before, to_srgb8(faint), 96, 64);
    EXPECT_GT(unseen.values[unseen.index(49, 32)], 0);
    EXPECT_LT(*std::max_element(unseen.values.begin(), unseen.values.end()), 0.1F);
}

// Catches pictures smaller than the filters reading outside.
TEST(Compare, TinyPictures) {
    EXPECT_GT(compare(flat(1, 1, {0, 0, 0}), flat(1, 1, {1, 1, 1})).flip, 0.9);
    EXPECT_LT(compare(flat(3, 20, {0, 0, 0}), flat(3, 20, {1, 1, 1})).ssim, 0.01);
}

// Catches sizes that aren't compared before pixels are.
TEST(Compare, SizesMustBeEqual) {
    EXPECT_THROW(compare(Image(4, 3), Image(3, 4)), std::invalid_argument);
    EXPECT_THROW(difference_image(Image(4, 3), Image(4, 4)), std::invalid_argument);
    EXPECT_THROW(flip_image(Image(), Image()), std::invalid_argument);
}

// Catches differences of linear values, a lost sign or a gain that wraps around.
TEST(Compare, DifferenceImage) {
    Image a = flat(2, 1, gray(100)), b = a;
    b.pixels[0] = {gray(90).x, gray(130).x, gray(100).x};
    EXPECT_EQ(to_srgb8(difference_image(a, b)), (std::vector<std::uint8_t>{10, 30, 0, 0, 0, 0}));
    EXPECT_EQ(to_srgb8(difference_image(a, b, 10)), (std::vector<std::uint8_t>{100, 255, 0, 0, 0, 0}));
}

// Catches a colour map that isn't ever brighter with the error.
TEST(Compare, FlipImageBrightensWithTheError) {
    double before = -1;
    for (int code = 0; code < 256; code += 5) {
        const Vec3 c = flip_image(flat(5, 5, gray(0)), flat(5, 5, gray(code))).at(2, 2);
        const double luminance = 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
        ASSERT_GT(luminance, before) << code;
        before = luminance;
    }
    EXPECT_GT(before, 0.7);
}

}  // namespace
}  // namespace sundog::output
