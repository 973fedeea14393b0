// SPDX-License-Identifier: Apache-2.0
#include "viewer/scene_reloader.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace sundog::viewer {
namespace {

constexpr std::chrono::milliseconds kLookEvery{200};

}  // namespace

SceneReloader::SceneReloader(std::filesystem::path file, const std::shared_ptr<const LoadedScene>& now_shown,
                             SceneChange change, import::Choices choices)
    : file_(std::move(file)),
      change_(std::move(change)),
      choices_(std::move(choices)),
      watched_(now_shown->scene.files),
      next_look_(std::chrono::steady_clock::now()) {
    watch_.watch(watched_);
}

std::shared_ptr<const LoadedScene> SceneReloader::poll() {
    const auto now = std::chrono::steady_clock::now();
    if (loading()) {
        if (next_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return nullptr;
        return take_loaded();
    }
    if (now < next_look_) return nullptr;
    next_look_ = now + kLookEvery;
    if (watch_.changed()) next_ = std::async(std::launch::async, load_scene, file_, change_, choices_);
    return nullptr;
}

std::shared_ptr<const LoadedScene> SceneReloader::take_loaded() {
    try {
        auto scene = next_.get();
        error_.clear();
        watched_ = scene->scene.files;
        watch_.watch(watched_);
        return scene;
    } catch (const InputError& error) {
        error_ = error.what();
        // The fault may lie in a file that the last good scene didn't have.
        const auto& culprit = error.diagnostic().where.file;
        if (culprit && std::find(watched_.begin(), watched_.end(), *culprit) == watched_.end()) {
            watched_.push_back(*culprit);
            watch_.watch(watched_);
        }
    } catch (const std::exception& error) {  // out of memory, for one: the picture stays all the same
        error_ = error.what();
    }
    return nullptr;
}

}  // namespace sundog::viewer
