// SPDX-License-Identifier: Apache-2.0
#include "viewer/render_thread.h"

#include <exception>
#include <type_traits>
#include <utility>

#include "viewer/save_picture.h"

namespace sundog::viewer {

RenderThread::RenderThread(RenderThreadOptions options) : options_(std::move(options)), thread_([this] { loop(); }) {}

RenderThread::~RenderThread() {
    const std::lock_guard lock(mutex_);
    quit_.request();
    stop_refining_.request();
    news_.notify_one();
}

void RenderThread::submit(ViewRequest request) {
    const std::lock_guard lock(mutex_);
    const bool keeps_radiance = latest_ && same_radiance(*latest_, request);
    if (keeps_radiance && latest_->exposure == request.exposure) return;
    if (refining_ && !keeps_radiance) stop_refining_.request();
    latest_ = std::move(request);
    latest_taken_ = false;
    news_.notify_one();
}

void RenderThread::pick(int x, int y) {
    const std::lock_guard lock(mutex_);
    orders_.emplace_back(Pick{x, y});
    news_.notify_one();
}

void RenderThread::save(std::filesystem::path folder, std::string stem) {
    const std::lock_guard lock(mutex_);
    orders_.emplace_back(Save{std::move(folder), std::move(stem)});
    news_.notify_one();
}

bool RenderThread::take_picture(Picture& picture) {
    const std::lock_guard lock(mutex_);
    if (!ready_is_new_) return false;
    std::swap(picture, ready_);
    ready_is_new_ = false;
    return true;
}

std::vector<RenderEvent> RenderThread::take_events() {
    const std::lock_guard lock(mutex_);
    return std::exchange(events_, {});
}

RenderThread::Task RenderThread::next_task(bool can_refine, Clock::time_point rest_ends) {
    std::unique_lock lock(mutex_);
    refining_ = false;
    for (;;) {
        if (quit_.requested()) return Quit{};
        if (!latest_taken_) {
            latest_taken_ = true;
            return *latest_;
        }
        if (!orders_.empty()) {
            Task order = std::move(orders_.front());
            orders_.pop_front();
            return order;
        }
        if (!can_refine) {
            news_.wait(lock);
        } else if (Clock::now() < rest_ends) {
            news_.wait_until(lock, rest_ends);
        } else {
            refining_ = true;
            stop_refining_.clear();
            return Refine{};
        }
    }
}

void RenderThread::loop() {
    PictureMaker maker(options_.open_device, options_.target_frame_s, options_.max_samples);
    Clock::time_point rest_ends = Clock::now();
    bool failed = false;  // nothing more to try until another request comes
    for (;;) {
        Task task = next_task(!failed && maker.can_refine(), rest_ends);
        if (std::holds_alternative<Quit>(task)) return;
        const bool is_change = std::holds_alternative<ViewRequest>(task);
        try {
            std::visit(
                [&](auto& what) {
                    if constexpr (!std::is_same_v<std::decay_t<decltype(what)>, Quit>) do_task(maker, what);
                },
                task);
            if (is_change) failed = false;
        } catch (const std::exception& error) {
            failed = true;
            announce(RenderFailed{maker.request().device, error.what()});
        }
        if (is_change) rest_ends = Clock::now() + options_.rest;
    }
}

void RenderThread::do_task(PictureMaker& maker, ViewRequest& request) {
    const bool only_exposure = maker.request().scene && same_radiance(maker.request(), request);
    if (auto device = maker.set_request(std::move(request))) {
        announce(SceneReady{*std::move(device), maker.request().scene});
    }
    if (only_exposure || maker.render_quickly(quit_)) publish(maker);
}

void RenderThread::do_task(PictureMaker& maker, const Pick& order) {
    if (!maker.ready()) return;
    announce(PixelSeen{order.x, order.y, maker.pick(order.x, order.y), maker.request()});
}

void RenderThread::do_task(PictureMaker& maker, const Save& order) {
    try {
        if (!maker.ready()) throw OutputError("there is no picture to save");
        const auto image = maker.full_image(quit_);
        if (image) announce(PictureSaved{save_numbered_png(order.folder, order.stem, *image)});
    } catch (const OutputError& error) {
        announce(SaveFailed{error.what()});
    }
}

void RenderThread::do_task(PictureMaker& maker, const Refine&) {
    if (!maker.refine(stop_refining_)) return;
    // Showing costs time too; beyond the first sample, ten pictures a second are plenty.
    const bool due = Clock::now() - last_shown_ >= std::chrono::milliseconds(100);
    if (maker.samples() == 1 || due || !maker.can_refine()) publish(maker);
}

void RenderThread::publish(const PictureMaker& maker) {
    maker.show(back_);
    last_shown_ = Clock::now();
    {
        const std::lock_guard lock(mutex_);
        std::swap(back_, ready_);
        ready_is_new_ = true;
    }
    if (options_.wake) options_.wake();
}

void RenderThread::announce(RenderEvent event) {
    {
        const std::lock_guard lock(mutex_);
        events_.push_back(std::move(event));
    }
    if (options_.wake) options_.wake();
}

}  // namespace sundog::viewer
