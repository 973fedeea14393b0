// SPDX-License-Identifier: Apache-2.0
#include "session/marked_regions.h"

#include <algorithm>

namespace sundog {
namespace {

/// Side of the squares in which a picture is refined: a multiple of every device's blocks, so that no ray is traced
/// only to be thrown away.
constexpr int kCellSide = 8;
/// Longest row of squares in one rectangle, to leave enough rectangles for all threads.
constexpr int kMostCells = 4;

/// The squares of a film that are marked.
class Cells {
public:
    explicit Cells(const PixelRect& bounds)
        : bounds_(bounds),
          x0_(bounds.x0 / kCellSide),
          y0_(bounds.y0 / kCellSide),
          width_((bounds.x1 + kCellSide - 1) / kCellSide - x0_),
          height_((bounds.y1 + kCellSide - 1) / kCellSide - y0_),
          marked_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

    void mark_pixel(int x, int y) { marked_[index(x / kCellSide - x0_, y / kCellSide - y0_)] = true; }

    [[nodiscard]] std::vector<PixelRect> rectangles() const {
        std::vector<PixelRect> found;
        for (int cy = 0; cy < height_; ++cy) {
            for (int cx = 0; cx < width_;) {
                int end = cx;
                while (end < width_ && end - cx < kMostCells && marked_[index(end, cy)]) ++end;
                if (end > cx) found.push_back(rectangle(cx, end, cy));
                cx = std::max(end, cx + 1);
            }
        }
        return found;
    }

private:
    [[nodiscard]] std::size_t index(int cx, int cy) const {
        return static_cast<std::size_t>(cy) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(cx);
    }
    [[nodiscard]] PixelRect rectangle(int begin, int end, int cy) const {
        return {std::max(bounds_.x0, (x0_ + begin) * kCellSide), std::max(bounds_.y0, (y0_ + cy) * kCellSide),
                std::min(bounds_.x1, (x0_ + end) * kCellSide), std::min(bounds_.y1, (y0_ + cy + 1) * kCellSide)};
    }
    PixelRect bounds_;
    int x0_, y0_, width_, height_;
    std::vector<bool> marked_;
};

}  // namespace

std::vector<PixelRect> marked_regions(const PixelRect& bounds, std::span<const std::uint8_t> marks) {
    Cells cells(bounds);
    std::size_t i = 0;
    for (int y = bounds.y0; y < bounds.y1; ++y)
        for (int x = bounds.x0; x < bounds.x1; ++x, ++i)
            if (marks[i] != 0) cells.mark_pixel(x, y);
    return cells.rectangles();
}

}  // namespace sundog
