// SPDX-License-Identifier: Apache-2.0
#include "session/error_driven.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "session/pixel_errors.h"
#include "session/recursive.h"
#include "session/test_noise.h"

namespace sundog {
namespace {

/// A picture whose left half is flat and whose right half is noise around a known mean; single places see an edge.
class NoisyDevice : public Device {
public:
    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] std::vector<std::string> unsupported(const RenderScene&) const override { return {}; }
    void load(std::shared_ptr<const RenderScene>) override {}
    [[nodiscard]] std::size_t memory_bytes() const override { return 0; }
    RenderStats render(const Frame& frame, const RenderWork& work, Film& film, const StopFlag& stop) override {
        if (stop.requested()) return {.complete = false};
        for (int y = work.region.y0; y < work.region.y1; ++y)
            for (int x = work.region.x0; x < work.region.x1; ++x) {
                auto& sum = film.radiance[film.index(x, y)];
                if (work.first_sample == 0) sum = {0, 0, 0, 0};
                for (std::uint32_t s = 0; s < work.sample_count; ++s) {
                    const bool noisy = x >= static_cast<int>(frame.params.width) / 2;
                    const float value = noisy ? 0.5F * random_number(x, y, work.first_sample + s) : 0.25F;
                    for (std::size_t c = 0; c < 3; ++c) sum[c] += value;
                    sum[3] += 1;
                }
            }
        return {};
    }
    [[nodiscard]] bool can_trace_places(const Frame&) const override { return true; }
    RenderStats trace_places(const Frame&, std::span<const PicturePlace> places, std::span<Vec3> radiance,
                             const StopFlag&) override {
        for (std::size_t i = 0; i < places.size(); ++i) {
            const float value = places[i].x + 0.37F * places[i].y < 9.3F ? 1.0F : 0.0F;
            radiance[i] = {value, value, value};
        }
        return {places.size(), 0};
    }

private:
    DeviceInfo info_{"cpu", "noisy device", "", false};
};

Frame frame_of(std::uint32_t width, std::uint32_t height) {
    Frame frame;
    frame.params.width = width;
    frame.params.height = height;
    return frame;
}

// Catches intervals that are too narrow (bad pixels pass as good), too wide (time is wasted), and samples for pixels
// that are good already.
TEST(ErrorDriven, SamplesUntilTheIntervalHolds) {
    NoisyDevice device;
    ErrorTarget target;
    target.error = 0.03;
    const ErrorDrivenResult result = render_to_error(device, frame_of(64, 48), target, {}, StopFlag{});
    EXPECT_FALSE(result.stopped);
    EXPECT_EQ(result.met, 1);
    EXPECT_LE(result.largest_error, target.error);
    // A uniform variable's variance is w^2/12, so a mean of n has 1.96 * 0.5 / sqrt(12 n), and the root of 0.25 halves
    // that once more: n = 89 for 0.03.
    double outside = 0, flat = 0, noisy = 0;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) {
            const float samples = result.film.radiance[result.film.index(x, y)][3];
            if (x < 31) flat = std::max<double>(flat, samples);  // The neighbours of noise follow it.
            if (x >= 32) {
                noisy += samples / (32 * 48);
                outside += std::abs(std::sqrt(result.film.mean(x, y).x) - 0.5F) > target.error ? 1.0 / (32 * 48) : 0;
            }
        }
    EXPECT_EQ(flat, kSampleBlock * kFewestBlocks);
    EXPECT_GT(noisy, 80);
    EXPECT_LT(noisy, 180);
    EXPECT_LT(outside, 0.08);
}

// Catches a limit that isn't heeded, and pixels without samples because of it.
TEST(ErrorDriven, TimeAndSamplesAreLimits) {
    NoisyDevice device;
    ErrorTarget target;
    target.error = 0;
    target.time_limit_s = 0.01;
    const ErrorDrivenResult hurried = render_to_error(device, frame_of(64, 48), target, {}, StopFlag{});
    EXPECT_FALSE(hurried.stopped);
    for (const auto& pixel : hurried.film.radiance) ASSERT_GE(pixel[3], kSampleBlock);

    target = {};
    target.error = 0.0001;
    target.most_samples = 34;
    const ErrorDrivenResult limited = render_to_error(device, frame_of(64, 48), target, {}, StopFlag{});
    for (const auto& pixel : limited.film.radiance) ASSERT_LE(pixel[3], 34);
    EXPECT_LT(limited.met, 0.6);
    EXPECT_GT(limited.largest_error, 0.03);

    StopFlag stop;
    stop.request();
    EXPECT_TRUE(render_to_error(device, frame_of(64, 48), {}, {}, stop).stopped);
}

// Catches a picture that depends on anything but its arguments.
TEST(ErrorDriven, GivesTheSameBitsAgain) {
    NoisyDevice device;
    const auto a = render_to_error(device, frame_of(40, 30), {.error = 0.05}, {}, StopFlag{});
    const auto b = render_to_error(device, frame_of(40, 30), {.error = 0.05}, {}, StopFlag{});
    EXPECT_EQ(a.film.radiance, b.film.radiance);
}

// Catches a spread that isn't one of means, a wrong quantile, and white pixels that never end.
TEST(PixelErrors, AreHalfTheIntervalOfTheRoot) {
    const PixelRect one{0, 0, 1, 1};
    Film film(one);
    PixelErrors errors(one, 1);
    EXPECT_TRUE(std::isinf(errors.error(0)));
    const std::vector<std::uint32_t> all{0};
    float sum = 0;
    for (const float block : {0.2F, 0.3F, 0.2F, 0.3F}) {
        sum += block * 4;
        film.radiance[0] = {sum, sum, sum, film.radiance[0][3] + 4};
        errors.add_blocks(film, all);
    }
    // Mean 0.25, standard deviation 0.057735; half the width: 3.182 * 0.057735 / 2; the root's slope there is 1.
    EXPECT_NEAR(errors.error(0), 0.0919F, 0.001F);
    PixelErrors bright(one, 8);
    bright.add_blocks(film, all);  // A block of 0.25; the same again, four times
    for (int i = 0; i < 4; ++i) {
        for (std::size_t c = 0; c < 4; ++c) film.radiance[0][c] += c < 3 ? 1.0F + 0.1F * static_cast<float>(i) : 4.0F;
        bright.add_blocks(film, all);
    }
    EXPECT_EQ(bright.error(0), 0);
}

// Catches corners that are traced twice, squares that aren't divided down to the edge, wrong shares of squares, and
// places that aren't where the pixel is.
TEST(Recursive, ConvergesToTheCoveredShare) {
    NoisyDevice device;
    const Frame frame = frame_of(16, 40);  // two bands
    for (const int depth : {1, 3, 6}) {
        const RenderResult result = render_recursively(device, frame, {0.3, 2.5, depth}, {}, StopFlag{});
        const double finest = std::exp2(-depth);
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 16; ++x) {
                // The edge is x = 9.3 - 0.37 y: its mean over the pixel's height, cut to the pixel, by many rows.
                double share = 0;
                for (int i = 0; i < 1000; ++i)
                    share += std::clamp(9.3 - 0.37 * (y + (i + 0.5) / 1000) - x, 0.0, 1.0) / 1000;
                ASSERT_NEAR(result.film.mean(x, y).x, share, 0.6 * finest) << depth << ' ' << x << ' ' << y;
            }
        if (depth == 1) {
            EXPECT_LT(result.stats.points, 17U * 42 + 2 * 5 * 45);
        }
    }
    const RenderResult plain = render_recursively(device, frame, {4, 2.5, 3}, {}, StopFlag{});
    EXPECT_EQ(plain.stats.points, 17U * (33 + 9));
}

}  // namespace
}  // namespace sundog
