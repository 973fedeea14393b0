// SPDX-License-Identifier: Apache-2.0
#include "session/blocks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "denoise/denoise.h"
#include "session/guides.h"
#include "session/test_noise.h"

namespace sundog {
namespace {

/// Uniform noise in red, a flat green; what is seen has its column in its albedo and depth. In
/// columns 6 to 8 of the first row something without albedo is seen.
class NoisyDevice : public Device {
public:
    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] std::vector<std::string> unsupported(const RenderScene&) const override { return {}; }
    void load(std::shared_ptr<const RenderScene>) override {}
    [[nodiscard]] std::size_t memory_bytes() const override { return 0; }
    RenderStats render(const Frame& frame, const RenderWork& work, Film& film, const StopFlag& stop) override {
        if (stop.requested()) return {.complete = false};
        last = frame;
        for (int y = work.region.y0; y < work.region.y1; ++y)
            for (int x = work.region.x0; x < work.region.x1; ++x) {
                auto& sum = film.radiance[film.index(x, y)];
                if (work.first_sample == 0) sum = {0, 0, 0, 0};
                for (std::uint32_t s = 0; s < work.sample_count; ++s) {
                    sum[0] += random_number(x, y, work.first_sample + s);
                    sum[1] += 0.5F;
                    sum[3] += 1;
                }
                if (film.aovs == 0) continue;
                const bool clear = y == 0 && x / 3 == 2;
                film.albedo[film.index(x, y)] =
                    clear ? Vec3{} : Vec3{static_cast<float>(x + 1), static_cast<float>(y + 1), 0};
                film.normal[film.index(x, y)] = {0, 0, 1};
                film.depth[film.index(x, y)] = x < 3 ? 2 : INFINITY;
            }
        return {};
    }
    Frame last;

private:
    DeviceInfo info_{"cpu", "noisy device", "", false};
};

Frame frame_of(std::uint32_t width, std::uint32_t height) {
    Frame frame;
    frame.params.width = width;
    frame.params.height = height;
    return frame;
}

// Catches numbers of samples that get fewer than were asked for, or a single block, whose spread tells nothing.
TEST(Blocks, CutSamplesEvenly) {
    for (std::uint32_t samples = 1; samples < 2000; ++samples) {
        const SampleBlocks blocks = blocks_of(samples);
        ASSERT_GE(blocks.count, 2U);
        ASSERT_GE(blocks.count * blocks.size, samples);
        ASSERT_LT(blocks.count * blocks.size, samples + blocks.count + 1);
    }
    EXPECT_EQ(blocks_of(16).count, 4U);
    EXPECT_EQ(blocks_of(16).size, 4U);
    EXPECT_EQ(blocks_of(64).count, 8U);
}

// Catches a variance of samples or of blocks where that of the mean is meant, and means that lose samples.
TEST(Blocks, TellTheVarianceOfTheMean) {
    NoisyDevice device;
    const RenderResult result = render_in_blocks(device, frame_of(64, 80), 64, {}, StopFlag{});
    EXPECT_FALSE(result.stopped);
    ASSERT_EQ(result.variance.size(), 64U * 80U);
    EXPECT_EQ(device.last.params.sampling.pattern, kernel::SAMPLES_SOBOL);
    EXPECT_EQ(device.last.params.sampling.cells, 0U) << "one sequence";
    double variance = 0, error2 = 0;
    for (std::size_t i = 0; i < result.variance.size(); ++i) {
        const auto& sum = result.film.radiance[i];
        ASSERT_EQ(sum[3], 64);
        const double error = sum[0] / 64 - 0.5;
        error2 += error * error;
        variance += result.variance[i].x;
        ASSERT_EQ(result.variance[i].y, 0);
    }
    const double pixels = 64 * 80;
    EXPECT_NEAR(variance / pixels, 1.0 / 12 / 64, 0.05 / 12 / 64);
    EXPECT_NEAR(error2 / pixels, 1.0 / 12 / 64, 0.05 / 12 / 64);
}

// Catches a stop that isn't answered.
TEST(Blocks, StopEndsThem) {
    NoisyDevice device;
    StopFlag stop;
    stop.request();
    EXPECT_TRUE(render_in_blocks(device, frame_of(8, 8), 16, {}, stop).stopped);
    EXPECT_TRUE(trace_guides(device, frame_of(8, 8), stop).albedo.empty());
}

// Catches guides of the wrong pixels, and light or a path that is computed for nothing.
TEST(Guides, AreMeansOverEachPixel) {
    NoisyDevice device;
    Frame frame = frame_of(5, 70);
    frame.params.max_depth = 9;
    frame.params.light_count = 3;
    const PictureGuides guides = trace_guides(device, frame, StopFlag{});
    EXPECT_EQ(device.last.params.light_count, 0U);
    EXPECT_EQ(device.last.params.max_depth, 0U);
    ASSERT_EQ(guides.albedo.size(), 5U * 70U);
    ASSERT_EQ(guides.depth.size(), 5U * 70U);
    EXPECT_NEAR(guides.albedo[0].x, 2, 1e-5);
    EXPECT_NEAR(guides.albedo[5 * 69 + 4].x, 14, 1e-4);
    EXPECT_NEAR(guides.albedo[5 * 69 + 4].y, 209, 1e-3);
    EXPECT_NEAR(guides.depth[0], 2, 1e-5);
    EXPECT_TRUE(std::isinf(guides.depth[1]));
}

// Catches pixels at rims of what has no albedo, mirrors or glass or the sky, whose light is divided by less than that
// of either side: they came out dark.
TEST(Guides, TakeWhatHasNoAlbedoForWhite) {
    NoisyDevice device;
    const PictureGuides guides = trace_guides(device, frame_of(5, 70), StopFlag{});
    const float least = denoise::divisor({8, 8, 0}).z;
    EXPECT_LT(least, 0.1F);
    EXPECT_NEAR(guides.albedo[2].x, (6 * 8 + 3 * 1) / 9.0F, 1e-5);
    EXPECT_NEAR(guides.albedo[2].z, (6 * least + 3 * 1) / 9.0F, 1e-5);
}

}  // namespace
}  // namespace sundog
