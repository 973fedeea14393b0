// SPDX-License-Identifier: Apache-2.0
#include "session/contrast.h"

#include <algorithm>
#include <cmath>

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

float compared(float linear, float power) { return std::pow(std::clamp(linear, 0.0F, 1.0F), power); }

}  // namespace

Contrast contrast_of(const Film& film, const AdaptiveSampling& sampling) {
    const PixelRect& bounds = film.bounds;
    const auto power = static_cast<float>(sampling.gamma > 0 ? 1 / sampling.gamma : 1);
    const auto color = [&](int x, int y) {
        const Vec3 mean = film.mean(x, y);
        return Vec3{compared(mean.x, power), compared(mean.y, power), compared(mean.z, power)};
    };
    const auto differ = [&](Vec3 a, Vec3 b) {
        return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z) >= sampling.threshold;
    };
    Cells cells(bounds);
    Contrast contrast{std::vector<std::uint8_t>(film.radiance.size()), {}};
    const auto mark = [&](int x, int y) {
        cells.mark_pixel(x, y);
        contrast.pixels[film.index(x, y)] = 1;
    };
    std::vector<Vec3> above(static_cast<std::size_t>(bounds.width()));
    for (int y = bounds.y0; y < bounds.y1; ++y) {
        Vec3 left;
        for (int x = bounds.x0; x < bounds.x1; ++x) {
            const Vec3 here = color(x, y);
            Vec3& upper = above[static_cast<std::size_t>(x - bounds.x0)];
            if (x > bounds.x0 && differ(here, left)) {
                mark(x, y);
                mark(x - 1, y);
            }
            if (y > bounds.y0 && differ(here, upper)) {
                mark(x, y);
                mark(x, y - 1);
            }
            left = upper = here;
        }
    }
    contrast.regions = cells.rectangles();
    return contrast;
}

}  // namespace sundog
