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
/// there stays. MP4 has even sizes: there the last column or row of odd ones is doubled.
class VideoWriter {
public:
    /// Errors: OutputError (no ffmpeg: says how to install it or to write numbered images instead; an unknown ending;
    /// a place that can't be written), std::invalid_argument (a size or frame rate that isn't positive and finite).
    VideoWriter(const std::filesystem::path& file, int width, int height, double fps);
    ~VideoWriter();
    VideoWriter(VideoWriter&&) noexcept;
    /// Errors: OutputError with ffmpeg's own words, if it fails; std::invalid_argument if the size is another.
    void add(const Image& frame);
    /// Waits for ffmpeg and puts the file in its place. Errors: OutputError (also if there was no frame).
    void finish();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace sundog::output
