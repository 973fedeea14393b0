// SPDX-License-Identifier: Apache-2.0
// Renders for the window on a thread of its own, so that input never waits for a picture.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "base/progress.h"
#include "viewer/picture_maker.h"

namespace sundog::viewer {

/// What the render thread has to say beside pictures.
struct SceneReady {
    DeviceInfo device;                         ///< That has taken
    std::shared_ptr<const LoadedScene> scene;  ///< this one.
};
struct RenderFailed {
    std::string device;   ///< That was asked for.
    std::string message;  ///< Why there is no new picture; the last one stays.
};
struct PixelSeen {
    int x = 0, y = 0;
    PixelInfo info;
    ViewRequest request;  ///< What was shown when it was picked.
};
struct PictureSaved {
    std::filesystem::path file;
};
struct SaveFailed {
    std::string message;
};
using RenderEvent = std::variant<SceneReady, RenderFailed, PixelSeen, PictureSaved, SaveFailed>;

/// How the thread works.
struct RenderThreadOptions {
    double target_frame_s = 1.0 / 60;     ///< While things move.
    std::chrono::milliseconds rest{150};  ///< Without change before refining begins.
    std::uint32_t max_samples = 64;       ///< A pixel, at rest.
    DeviceOpener open_device;
    std::function<void()> wake;  ///< Called from the render thread when there is something to take.
};

/// Pictures follow the latest request: as soon as it changes, one of reduced size within the frame budget; when it
/// rests, the full size, and then sample after sample. A device that can't be opened is reported, and the one before
/// goes on.
class RenderThread {
public:
    explicit RenderThread(RenderThreadOptions options);
    /// Stops what is under way and joins.
    ~RenderThread();
    RenderThread(const RenderThread&) = delete;
    RenderThread& operator=(const RenderThread&) = delete;

    /// The latest request is the one that counts; those not yet begun are forgotten.
    void submit(ViewRequest request);
    /// Asks what full-size pixel (x, y) of the present request sees; answered by PixelSeen.
    void pick(int x, int y);
    /// Asks for a full-size picture as the first free of STEM-0001.png, … in `folder`; answered by PictureSaved or
    /// SaveFailed.
    void save(std::filesystem::path folder, std::string stem);

    /// Swaps the newest picture into `picture`; false if there is none since the last call.
    bool take_picture(Picture& picture);
    std::vector<RenderEvent> take_events();

private:
    using Clock = std::chrono::steady_clock;
    struct Quit {};
    struct Refine {};
    struct Pick {
        int x = 0, y = 0;
    };
    struct Save {
        std::filesystem::path folder;
        std::string stem;
    };
    using Task = std::variant<Quit, ViewRequest, Pick, Save, Refine>;

    void loop();
    [[nodiscard]] Task next_task(bool can_refine, Clock::time_point rest_ends);
    void do_task(PictureMaker& maker, ViewRequest& request);
    void do_task(PictureMaker& maker, const Pick& order);
    void do_task(PictureMaker& maker, const Save& order);
    void do_task(PictureMaker& maker, const Refine& order);
    void publish(const PictureMaker& maker);
    void announce(RenderEvent event);

    const RenderThreadOptions options_;
    StopFlag quit_;
    StopFlag stop_refining_;  // also when quitting

    std::mutex mutex_;  // guards what follows
    std::condition_variable news_;
    bool refining_ = false;              // what is under way may be stopped
    std::optional<ViewRequest> latest_;  // as submitted last
    bool latest_taken_ = true;
    std::deque<Task> orders_;
    Picture ready_;
    bool ready_is_new_ = false;
    std::vector<RenderEvent> events_;

    // The render thread's own.
    Picture back_;
    Clock::time_point last_shown_;

    std::jthread thread_;  // last: it begins when all else is there
};

}  // namespace sundog::viewer
