// SPDX-License-Identifier: Apache-2.0
#include "viewer/picture_maker.h"

#include <gtest/gtest.h>

#include "base/diagnostics.h"
#include "viewer/fake_device.h"

namespace sundog::viewer {
namespace {

constexpr std::uint32_t kMaxSamples = 4;

class PictureMakerTest : public testing::Test {
protected:
    Picture shown() const {
        Picture picture;
        maker_.show(picture);
        return picture;
    }
    std::shared_ptr<FakeDeviceControl> control_ = std::make_shared<FakeDeviceControl>();
    std::shared_ptr<const LoadedScene> scene_ = empty_scene();
    // What is installed where the test runs must not matter.
    PictureMaker maker_{fake_opener(control_), 1.0, kMaxSamples, denoise::Method::filter};
    StopFlag stop_;
};

// Catches a picture of another request, size or sample count than it says.
TEST_F(PictureMakerTest, ShowsTheRequest) {
    maker_.set_request(fake_request(scene_, 1));
    maker_.render_quickly(stop_);
    const Picture picture = shown();
    EXPECT_EQ(picture.size, (PixelSize{64, 48}));  // small enough for the first guess
    EXPECT_EQ(picture.samples, 1U);
    EXPECT_EQ(picture.rays, 100U);
    ASSERT_EQ(picture.argb.size(), 64U * 48U);
    EXPECT_EQ(picture.argb[100], 0xffff0000U);
}

// Catches samples rendered twice (sample 0 again after the quick picture), left out, or without end.
TEST_F(PictureMakerTest, RefinesSampleAfterSample) {
    maker_.set_request(fake_request(scene_, 1));
    maker_.render_quickly(stop_);
    for (std::uint32_t samples = 2; samples <= kMaxSamples; ++samples) {
        ASSERT_TRUE(maker_.can_refine());
        ASSERT_TRUE(maker_.refine(stop_));
        EXPECT_EQ(maker_.samples(), samples);
    }
    EXPECT_FALSE(maker_.can_refine());
    EXPECT_FLOAT_EQ(maker_.full_image(stop_).value().at(5, 5).y, (0 + 1 + 2 + 3) / 4.0F);
}

// Catches samples of two views mixed in one picture.
TEST_F(PictureMakerTest, AnotherViewBeginsAnew) {
    maker_.set_request(fake_request(scene_, 1));
    maker_.render_quickly(stop_);
    maker_.refine(stop_);
    maker_.set_request(fake_request(scene_, 0));
    ASSERT_TRUE(maker_.refine(stop_));
    EXPECT_EQ(maker_.samples(), 1U);
    EXPECT_EQ(shown().argb[0], 0xff000000U);
}

// Catches a stopped pass that counts, or samples added twice to some pixels.
TEST_F(PictureMakerTest, AStoppedPassDoesNotCount) {
    maker_.set_request(fake_request(scene_, 1, kLarge));
    maker_.render_quickly(stop_);
    ASSERT_TRUE(maker_.refine(stop_));
    control_->endless = true;
    stop_.request();
    EXPECT_FALSE(maker_.refine(stop_));  // the second sample
    EXPECT_FALSE(maker_.refine(stop_));  // the first, begun anew
    control_->endless = false;
    stop_.clear();
    EXPECT_TRUE(maker_.refine(stop_));
    EXPECT_EQ(maker_.samples(), 1U);
    EXPECT_FLOAT_EQ(maker_.full_image(stop_).value().at(5, 5).y, 1.5F);
}

// Catches interpolated pixels that stay in the picture at rest.
TEST_F(PictureMakerTest, AnInterpolatedPictureIsTracedAnew) {
    control_->refines = true;
    maker_.set_request(fake_request(scene_, 1));
    maker_.render_quickly(stop_);
    EXPECT_EQ(maker_.samples(), 1U);
    ASSERT_TRUE(maker_.can_refine());
    ASSERT_TRUE(maker_.refine(stop_));
    EXPECT_EQ(maker_.samples(), 1U);
    ASSERT_TRUE(maker_.refine(stop_));
    EXPECT_EQ(maker_.samples(), 2U);
}

// Catches rays that aren't shown, that vanish at rest, stay in a saved picture or when they are no longer asked for.
TEST_F(PictureMakerTest, ShowsRaysInMotionAndAtRest) {
    control_->refines = true;
    ViewRequest request = fake_request(scene_, 0.5F, kLarge);
    request.show_rays = true;
    maker_.set_request(request);
    const auto expect_rays = [&](bool wanted) {
        const Picture picture = shown();
        EXPECT_NE(picture.argb[0], 0xffffffffU);
        EXPECT_EQ(picture.argb[1] == 0xffffffffU, wanted);
    };
    maker_.render_quickly(stop_);
    ASSERT_LT(shown().size.width, 1280);
    expect_rays(true);
    for (int again = 0; again < 2; ++again) {
        ASSERT_TRUE(maker_.can_refine());
        ASSERT_TRUE(maker_.refine(stop_));
        EXPECT_EQ(shown().size, kLarge);
        expect_rays(true);
        EXPECT_FALSE(maker_.can_refine());
        EXPECT_FLOAT_EQ(maker_.full_image(stop_).value().at(1, 0).x, 0.5F);
    }
    request.show_rays = false;
    EXPECT_FALSE(same_radiance(request, maker_.request()));
    maker_.set_request(request);
    maker_.render_quickly(stop_);
    expect_rays(false);
    ASSERT_TRUE(maker_.refine(stop_));
    expect_rays(false);
}

// Catches rays that are shown where every pixel is one: all would be white.
TEST_F(PictureMakerTest, ShowsNoRaysWhereAllIsTraced) {
    ViewRequest request = fake_request(scene_, 0.5F);
    request.show_rays = true;
    maker_.set_request(request);
    maker_.render_quickly(stop_);
    EXPECT_NE(shown().argb[1], 0xffffffffU);
    while (maker_.can_refine()) ASSERT_TRUE(maker_.refine(stop_));
    EXPECT_EQ(maker_.samples(), kMaxSamples);
}

// Catches a change of exposure that throws the samples away.
TEST_F(PictureMakerTest, ExposureKeepsTheSamples) {
    maker_.set_request(fake_request(scene_, 0.5F));
    maker_.render_quickly(stop_);
    maker_.refine(stop_);
    ViewRequest brighter = fake_request(scene_, 0.5F);
    brighter.exposure.ev = 1;
    EXPECT_FALSE(maker_.set_request(brighter).has_value());
    EXPECT_EQ(maker_.samples(), 2U);
    EXPECT_EQ(shown().argb[0] >> 16, 0xffffU);
    EXPECT_FLOAT_EQ(maker_.full_image(stop_).value().at(0, 0).x, 1);
}

// Catches noise that stays at rest, samples that are lost when it is taken out, and a picture that is never done.
TEST_F(PictureMakerTest, TakesTheNoiseOutAtRest) {
    ViewRequest request = fake_request(scene_, 0.5F);
    request.denoise = true;
    maker_.set_request(request);
    maker_.render_quickly(stop_);
    int steps = 0;
    while (maker_.can_refine()) {
        ASSERT_TRUE(maker_.refine(stop_));
        ASSERT_LT(++steps, 100);
    }
    EXPECT_EQ(maker_.samples(), kMaxSamples);
    EXPECT_EQ(steps, static_cast<int>(kMaxSamples)) << "the first sample is there, and the last step cleans";
    // All pixels are alike, so their mean stays.
    EXPECT_NEAR(maker_.full_image(stop_).value().at(9, 9).x, 0.5F, 1e-4F);
    EXPECT_NEAR(maker_.full_image(stop_).value().at(9, 9).y, (kMaxSamples - 1) / 2.0F, 1e-3F);
    request.denoise = false;
    EXPECT_FALSE(same_radiance(request, maker_.request()));
}

// Catches a saved picture with the few pixels of a moving view.
TEST_F(PictureMakerTest, SavesTheFullSize) {
    maker_.set_request(fake_request(scene_, 1, kLarge));
    maker_.render_quickly(stop_);
    ASSERT_LT(shown().size.width, 1280);
    const output::Image image = maker_.full_image(stop_).value();
    EXPECT_EQ(image.width, 1280);
    EXPECT_EQ(image.height, 960);
    EXPECT_EQ(image.at(1279, 959).x, 1);
}

// Catches a device that can't be opened taking the working one with it.
TEST_F(PictureMakerTest, AMissingDeviceLeavesTheOneInUse) {
    const auto opened = maker_.set_request(fake_request(scene_, 1));
    ASSERT_TRUE(opened.has_value());
    EXPECT_EQ(opened->kind, "cpu");
    ViewRequest other = fake_request(scene_, 1);
    other.device = "abacus";
    EXPECT_THROW(maker_.set_request(other), DeviceError);
    EXPECT_TRUE(maker_.ready());
    EXPECT_FALSE(maker_.set_request(fake_request(scene_, 1)).has_value());  // not opened again
    maker_.render_quickly(stop_);
    EXPECT_EQ(shown().argb[0], 0xffff0000U);
}

// Catches a pick of the wrong size or without the object.
TEST_F(PictureMakerTest, PicksThroughTheDevice) {
    maker_.set_request(fake_request(scene_, 1));
    const PixelInfo info = maker_.pick(63, 47);
    EXPECT_EQ(info.geometry, 7U);
    EXPECT_EQ(info.radiance.x, 1);
}

}  // namespace
}  // namespace sundog::viewer
