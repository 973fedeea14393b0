// SPDX-License-Identifier: Apache-2.0
// Animations through the ffmpeg program, where it is installed.
#pragma once

#include <filesystem>
#include <memory>

#include "output/image.h"

namespace sundog::output {

/// True for .mp4 .webm .gif.
bool is_video(const std::filesystem::path& file);

/// Takes frames of one size in order. The file appears whole when finish() returns; dropped without it, what was
/// there stays. finish() after fewer frames than planned keeps those.
class VideoWriter {
public:
    /// Errors: OutputError (no ffmpeg: says how to install it or to write numbered images instead).
    VideoWriter(const std::filesystem::path& file, int width, int height, double fps);
    ~VideoWriter();
    VideoWriter(VideoWriter&&) noexcept;
    void add(const Image& frame);
    void finish();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace sundog::output
