// SPDX-License-Identifier: Apache-2.0
// How a picture is split into dispatches.
#pragma once

#include <cstdint>

#include "device/film.h"

namespace sundog::vulkan {

/// Walks over a region in rectangles of a number of pixels that may change on the way. Each pixel comes once.
class Chunks {
public:
    explicit Chunks(PixelRect region) : region_(region), x_(region.x0), y_(region.y0) {}
    [[nodiscard]] bool done() const { return region_.width() <= 0 || y_ >= region_.y1; }
    /// The next rectangle: whole rows of workgroups where `pixels` allows, else a part of one row; at most `pixels`
    /// where that is a workgroup or more.
    PixelRect next(std::uint64_t pixels);

private:
    PixelRect region_;
    int x_, y_;
    int row_height_ = 0;  // of the row that is partly done
};

/// How many paths (pixels times samples) to trace in one dispatch, learnt from how long the last ones took: short
/// enough that a stop is answered soon and that no driver takes the GPU for hung, long enough to keep it busy.
class Pace {
public:
    /// Starts small, since nothing is known of the scene.
    [[nodiscard]] std::uint64_t paths() const { return paths_; }
    /// `paths` took `seconds`.
    void learn(std::uint64_t paths, double seconds);

private:
    std::uint64_t paths_ = std::uint64_t{1} << 14U;
};

}  // namespace sundog::vulkan
