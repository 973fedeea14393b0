// SPDX-License-Identifier: Apache-2.0
// Reads the scene again when its files change, without making the window wait.
#pragma once

#include <chrono>
#include <filesystem>
#include <future>
#include <memory>
#include <string>

#include "viewer/file_watch.h"
#include "viewer/loaded_scene.h"

namespace sundog::viewer {

/// Watches the files of a scene.
class SceneReloader {
public:
    /// `now_shown` was read from `file` with `choices` and changed by `change`.
    SceneReloader(std::filesystem::path file, const std::shared_ptr<const LoadedScene>& now_shown, SceneChange change,
                  import::Choices choices);

    /// To be called often. Looks at the disk every 200 ms, reads what changed on another thread, and returns the scene
    /// once it is read; else null.
    [[nodiscard]] std::shared_ptr<const LoadedScene> poll();
    /// Why the files as they are now can't be shown (an InputError's text); empty if they can.
    [[nodiscard]] const std::string& error() const { return error_; }
    /// True while a scene is being read.
    [[nodiscard]] bool loading() const { return next_.valid(); }

private:
    std::shared_ptr<const LoadedScene> take_loaded();

    std::filesystem::path file_;
    SceneChange change_;
    import::Choices choices_;
    std::vector<std::string> watched_;
    FileWatch watch_;
    std::chrono::steady_clock::time_point next_look_;
    std::future<std::shared_ptr<const LoadedScene>> next_;
    std::string error_;
};

}  // namespace sundog::viewer
