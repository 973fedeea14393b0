// SPDX-License-Identifier: Apache-2.0
#include "device/vulkan/chunks.h"

#include <algorithm>
#include <cmath>

#include "device/vulkan/shaders/layout.h"

namespace sundog::vulkan {
namespace {

constexpr double kDispatchSeconds = 0.03;
constexpr double kMostGrowth = 8;
constexpr std::uint64_t kFewestPaths = std::uint64_t{1} << 10U;
constexpr std::uint64_t kMostPaths = std::uint64_t{1} << 26U;
constexpr int kGroupWidth = kernel::GROUP_WIDTH;
constexpr int kGroupHeight = kernel::GROUP_HEIGHT;

}  // namespace

PixelRect Chunks::next(std::uint64_t pixels) {
    const auto budget = static_cast<std::int64_t>(std::min(pixels, kMostPaths));
    if (x_ == region_.x0) {
        const std::int64_t rows = budget / region_.width();
        const std::int64_t left = region_.y1 - y_;
        if (rows >= std::min<std::int64_t>(left, kGroupHeight)) {
            const auto height =
                static_cast<int>(rows >= left ? left : std::max<std::int64_t>(rows / kGroupHeight, 1) * kGroupHeight);
            const PixelRect rect{region_.x0, y_, region_.x1, y_ + height};
            y_ = rect.y1;
            return rect;
        }
        row_height_ = static_cast<int>(std::min<std::int64_t>(left, kGroupHeight));
    }
    const std::int64_t columns = std::max<std::int64_t>(budget / row_height_ / kGroupWidth, 1) * kGroupWidth;
    const auto width = static_cast<int>(std::min<std::int64_t>(columns, region_.x1 - x_));
    const PixelRect rect{x_, y_, x_ + width, y_ + row_height_};
    x_ = rect.x1;
    if (x_ == region_.x1) {
        x_ = region_.x0;
        y_ += row_height_;
    }
    return rect;
}

void Pace::learn(std::uint64_t paths, double seconds) {
    const double growth = std::min(kDispatchSeconds / std::max(seconds, 1e-6), kMostGrowth);
    const double wanted = static_cast<double>(paths) * growth;
    // A dispatch smaller than allowed (the last rows of a picture) says little when it was fast.
    if (growth > 1 && wanted < static_cast<double>(paths_)) return;
    paths_ = std::clamp(static_cast<std::uint64_t>(wanted), kFewestPaths, kMostPaths);
}

}  // namespace sundog::vulkan
