// SPDX-License-Identifier: Apache-2.0
#include "viewer/render_thread.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <functional>

#include "viewer/fake_device.h"

namespace sundog::viewer {
namespace {

// Runs a render thread on the fake device and waits for what it has to say. The waiting ends by the test's own limit
// only if the thread never says it.
class RenderThreadTest : public testing::Test {
protected:
    RenderThreadOptions options() {
        RenderThreadOptions options;
        options.target_frame_s = 1.0;
        options.rest = std::chrono::milliseconds(1);
        options.max_samples = 3;
        options.open_device = fake_opener(control_);
        options.wake = [this] {
            const std::lock_guard lock(mutex_);
            ++wakes_;
            woken_.notify_all();
        };
        return options;
    }
    // Waits until `done` holds; it is asked again after each call of wake().
    void wait_for(const std::function<bool()>& done) {
        for (;;) {
            int seen = 0;
            {
                const std::lock_guard lock(mutex_);
                seen = wakes_;
            }
            if (done()) return;
            std::unique_lock lock(mutex_);
            woken_.wait_for(lock, std::chrono::milliseconds(50), [&] { return wakes_ != seen; });
        }
    }
    template <class Event>
    Event wait_for_event(RenderThread& thread) {
        std::optional<Event> found;
        wait_for([&] {
            for (const RenderEvent& event : thread.take_events())
                if (const auto* wanted = std::get_if<Event>(&event)) found = *wanted;
            return found.has_value();
        });
        return *found;
    }
    Picture wait_for_samples(RenderThread& thread, std::uint32_t samples) {
        Picture picture;
        wait_for([&] { return thread.take_picture(picture) && picture.samples == samples; });
        return picture;
    }

    std::shared_ptr<FakeDeviceControl> control_ = std::make_shared<FakeDeviceControl>();
    std::shared_ptr<const LoadedScene> scene_ = empty_scene();
    std::mutex mutex_;
    std::condition_variable woken_;
    int wakes_ = 0;
};

// Catches a thread that doesn't refine at rest, or goes on for ever.
TEST_F(RenderThreadTest, RefinesAtRestUntilDone) {
    RenderThread thread(options());
    thread.submit(fake_request(scene_, 1));
    const Picture picture = wait_for_samples(thread, 3);
    EXPECT_EQ(picture.argb[0] >> 16, 0xffffU);
    EXPECT_EQ(control_->renders, 3);
}

// Catches a refinement that keeps the window waiting when the view changes.
TEST_F(RenderThreadTest, AChangeStopsTheRefinement) {
    control_->endless = true;
    RenderThreadOptions slow = options();
    slow.target_frame_s = 1e-9;  // pictures at full size are for refining only
    RenderThread thread(slow);
    thread.submit(fake_request(scene_, 1, kLarge));
    wait_for([&] { return control_->full_renders == 1; });
    thread.submit(fake_request(scene_, 0.25F, kLarge));
    Picture picture;
    wait_for([&] { return thread.take_picture(picture) && (picture.argb[0] >> 16 & 0xff) == 137; });  // sRGB of 0.25
}

// Catches a destructor that waits for a picture to finish.
TEST_F(RenderThreadTest, EndsInTheMiddleOfARefinement) {
    control_->endless = true;
    RenderThreadOptions slow = options();
    slow.target_frame_s = 1e-9;  // pictures at full size are for refining only
    RenderThread thread(slow);
    thread.submit(fake_request(scene_, 1, kLarge));
    wait_for([&] { return control_->full_renders == 1; });
}

// Catches a destructor that waits for a quick picture which turns out slow, or for one to be saved.
TEST_F(RenderThreadTest, EndsInTheMiddleOfAQuickPicture) {
    RenderThread thread(options());
    thread.submit(fake_request(scene_, 1, kLarge));
    wait_for_samples(thread, 3);
    control_->endless = true;
    const int before = control_->full_renders;
    thread.submit(fake_request(scene_, 0, kLarge));  // by now, the full size is affordable
    thread.save(testing::TempDir(), "never_written");
    wait_for([&] { return control_->full_renders > before; });
}

// Catches a failing device that ends the program, or that is tried over and over.
TEST_F(RenderThreadTest, TellsOfAFailureAndGoesOnWithTheNextRequest) {
    RenderThread thread(options());
    control_->broken = true;
    thread.submit(fake_request(scene_, 1));
    EXPECT_EQ(wait_for_event<RenderFailed>(thread).message, "the fake device is broken");
    control_->broken = false;
    thread.submit(fake_request(scene_, 0));
    EXPECT_EQ(wait_for_samples(thread, 3).argb[0] >> 16, 0xff00U);
}

// Catches answers that get lost or speak of another view.
TEST_F(RenderThreadTest, AnswersPicksAndTellsTheDevice) {
    RenderThread thread(options());
    ViewRequest request = fake_request(scene_, 1);
    request.device = "gpu";
    thread.submit(request);
    EXPECT_EQ(wait_for_event<SceneReady>(thread).device.kind, "gpu");
    thread.pick(3, 4);
    const auto seen = wait_for_event<PixelSeen>(thread);
    EXPECT_EQ(seen.x, 3);
    EXPECT_EQ(seen.y, 4);
    EXPECT_EQ(seen.info.geometry, 7U);
    EXPECT_EQ(seen.request.device, "gpu");
}

// Catches a save that says nothing when it fails, or before there is a picture.
TEST_F(RenderThreadTest, TellsWhatBecameOfASave) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "render_thread_save";
    std::filesystem::create_directories(folder);
    RenderThread thread(options());
    thread.save(folder, "picture");
    EXPECT_EQ(wait_for_event<SaveFailed>(thread).message, "there is no picture to save");
    thread.submit(fake_request(scene_, 1));
    thread.save(folder, "picture");
    const auto saved = wait_for_event<PictureSaved>(thread);
    EXPECT_TRUE(std::filesystem::exists(saved.file));
    thread.save(folder / "missing", "picture");
    EXPECT_FALSE(wait_for_event<SaveFailed>(thread).message.empty());
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace sundog::viewer
