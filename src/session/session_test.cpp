// SPDX-License-Identifier: Apache-2.0
#include "session/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "base/diagnostics.h"

namespace sundog {
namespace {

/// What one sample of a pixel is worth: a third of a small integer, so that the order of additions shows in the sum.
float value_of(int x, int y, std::uint32_t sample) {
    return static_cast<float>((x * 7 + y * 13 + static_cast<int>(sample) * 29) % 101) / 3.0F;
}

/// Renders value_of, sums each pass before it adds it (as real devices do), and can be slow or interrupted.
class CountingDevice : public Device {
public:
    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] std::vector<std::string> unsupported(const RenderScene&) const override { return missing; }
    void load(std::shared_ptr<const RenderScene>) override { ++loads; }
    [[nodiscard]] std::size_t memory_bytes() const override { return 0; }
    RenderStats render(const Frame&, const RenderWork& work, Film& film, const StopFlag&) override {
        ++calls;
        std::this_thread::sleep_for(delay);
        for (int y = work.region.y0; y < work.region.y1; ++y)
            for (int x = work.region.x0; x < work.region.x1; ++x) {
                auto& sum = film.radiance[film.index(x, y)];
                if (work.first_sample == 0) sum = {0, 0, 0, 0};
                float pass = 0;
                for (std::uint32_t s = 0; s < work.sample_count; ++s) pass += value_of(x, y, work.first_sample + s);
                sum[0] += pass;
                sum[3] += static_cast<float>(work.sample_count);
            }
        if (stop_after == calls && stop) stop->request();
        const auto pixels =
            static_cast<std::uint64_t>(work.region.width()) * static_cast<std::uint64_t>(work.region.height());
        return {pixels * work.sample_count, 0, true};
    }

    std::vector<std::string> missing;
    std::chrono::milliseconds delay{0};
    StopFlag* stop = nullptr;
    int stop_after = 0;
    int calls = 0;
    int loads = 0;

private:
    DeviceInfo info_{"cpu", "counting device", "", false};
};

Frame frame_of(std::uint32_t width, std::uint32_t height) {
    Frame frame;
    frame.params.width = width;
    frame.params.height = height;
    return frame;
}

RenderResult render(std::unique_ptr<CountingDevice> device, std::uint32_t samples, const StopFlag& stop = {},
                    const ProgressSink& progress = {}) {
    Session session(std::move(device));
    return session.render(frame_of(37, 200), samples, progress, stop);
}

// Catches pixels of a region that lie elsewhere in its film, and work outside it.
TEST(Session, RegionsArePartsOfThePicture) {
    Session session(std::make_unique<CountingDevice>());
    const PixelRect region{5, 30, 20, 170};
    const RenderResult part = session.render(frame_of(37, 200), 3, {}, StopFlag{}, region);
    const RenderResult whole = session.render(frame_of(37, 200), 3, {}, StopFlag{});
    EXPECT_EQ(part.film.bounds, region);
    EXPECT_EQ(part.stats.rays, 15U * 140U * 3U);
    for (int y = region.y0; y < region.y1; ++y)
        for (int x = region.x0; x < region.x1; ++x)
            ASSERT_EQ(part.film.radiance[part.film.index(x, y)], whole.film.radiance[whole.film.index(x, y)]);
}

// Catches refined pixels that lose or repeat samples, and refinement that is stopped but counts as done.
TEST(Session, AdaptiveSamplingAddsSamplesAtEdges) {
    StopFlag stop;
    auto device = std::make_unique<CountingDevice>();
    Session session(std::move(device));
    const RenderResult result =
        session.render_adaptive(frame_of(37, 200), {.threshold = 0.1, .gamma = 1, .samples = 6}, {}, stop);
    EXPECT_FALSE(result.stopped);
    int refined = 0;
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 37; ++x) {
            const auto& sum = result.film.radiance[result.film.index(x, y)];
            ASSERT_TRUE(sum[3] == 1 || sum[3] == 6);
            refined += sum[3] == 6 ? 1 : 0;
            float want = 0;
            for (std::uint32_t s = 0; s < static_cast<std::uint32_t>(sum[3]); ++s) want += value_of(x, y, s);
            ASSERT_NEAR(sum[0], want, 1e-3F);
        }
    EXPECT_GT(refined, 0);
    const Film one = session.render(frame_of(37, 200), 1, {}, StopFlag{}).film;
    const Contrast contrast = contrast_of(one, {.threshold = 0.1, .gamma = 1, .samples = 6});
    EXPECT_EQ(refined, std::count(contrast.pixels.begin(), contrast.pixels.end(), 1)) << "not whole rectangles";
    stop.request();
    EXPECT_TRUE(session.render_adaptive(frame_of(37, 200), {}, {}, stop).stopped);
}

// Catches bands that leave rows out or render them twice, and passes that repeat or skip samples.
TEST(Session, EveryPixelGetsEverySampleOnce) {
    const RenderResult result = render(std::make_unique<CountingDevice>(), 21);
    EXPECT_FALSE(result.stopped);
    EXPECT_EQ(result.stats.rays, 37U * 200U * 21U);
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 37; ++x) {
            float want = 0;
            for (std::uint32_t s = 0; s < 21; ++s) want += value_of(x, y, s);
            ASSERT_EQ(result.film.radiance[result.film.index(x, y)][3], 21);
            ASSERT_NEAR(result.film.radiance[result.film.index(x, y)][0], want, 1e-3F);
        }
}

// Catches work split by timing in a way that changes the order of float additions.
TEST(Session, ASlowDeviceGivesTheSameBits) {
    auto slow = std::make_unique<CountingDevice>();
    slow->delay = std::chrono::milliseconds(30);
    CountingDevice* seen = slow.get();
    Session slow_session(std::move(slow));
    const RenderResult a = slow_session.render(frame_of(37, 200), 3, {}, StopFlag{});
    const int slow_calls = seen->calls;
    auto fast = std::make_unique<CountingDevice>();
    seen = fast.get();
    Session fast_session(std::move(fast));
    const RenderResult b = fast_session.render(frame_of(37, 200), 3, {}, StopFlag{});
    EXPECT_NE(slow_calls, seen->calls) << "the two must have been split differently for this test to mean something";
    EXPECT_EQ(a.film.radiance, b.film.radiance);
}

// Catches progress that jumps back, exceeds 1 or stops short of it.
TEST(Session, ProgressGrowsToOne) {
    double last = 0;
    render(std::make_unique<CountingDevice>(), 9, StopFlag{}, [&](const Progress& p) {
        EXPECT_GT(p.fraction, last);
        last = p.fraction;
    });
    EXPECT_DOUBLE_EQ(last, 1);
}

// Catches a stop that is ignored, or that throws away what was done.
TEST(Session, StopKeepsWhatIsDone) {
    auto device = std::make_unique<CountingDevice>();
    StopFlag stop;
    device->stop = &stop;
    device->stop_after = 1;
    const RenderResult result = render(std::move(device), 4, stop);
    EXPECT_TRUE(result.stopped);
    EXPECT_EQ(result.film.radiance[result.film.index(5, 0)][3], 1);
    EXPECT_EQ(result.film.radiance[result.film.index(5, 199)][3], 0);
}

// Catches a scene that goes to a device that can't draw it.
TEST(Session, LoadRefusesWhatTheDeviceLacks) {
    auto device = std::make_unique<CountingDevice>();
    CountingDevice* seen = device.get();
    seen->missing = {"no tori"};
    Session session(std::move(device));
    EXPECT_THROW(session.load(std::make_shared<RenderScene>()), DeviceError);
    EXPECT_EQ(seen->loads, 0);
    seen->missing.clear();
    session.load(std::make_shared<RenderScene>());
    EXPECT_EQ(seen->loads, 1);
}

}  // namespace
}  // namespace sundog
