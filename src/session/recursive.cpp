// SPDX-License-Identifier: Apache-2.0
#include "session/recursive.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <unordered_map>
#include <vector>

#include "session/contrast.h"

namespace sundog {
namespace {

/// Rows of pixels that are made together.
constexpr int kBandRows = 32;

/// The squares and their corners of a few rows of pixels. Coordinates count the finest squares, from the band's upper
/// left corner.
class Band {
public:
    Band(const PixelRect& pixels, const RecursiveSampling& sampling)
        : pixels_(pixels),
          contrast_(sampling.threshold, sampling.gamma),
          depth_(std::clamp(sampling.depth, 0, kMostRecursion)) {}

    /// False if it was stopped.
    bool render(Device& device, const Frame& frame, Film& film, RenderStats& stats, const StopFlag& stop) {
        const int side = 1 << depth_;
        std::vector<Square> squares, divided;
        for (int y = 0; y < pixels_.height(); ++y)
            for (int x = 0; x < pixels_.width(); ++x) squares.push_back({x * side, y * side});
        for (int half = side / 2, step = side;; step = half, half /= 2) {
            for (const Square& square : squares)
                for (const Square& corner : corners_of(square, step)) want(corner);
            if (!trace_wanted(device, frame, stats, stop)) return false;
            divided.clear();
            for (const Square& square : squares) {
                const auto corners = corners_of(square, step);
                if (half > 0 && differ(corners)) {
                    for (const Square& child : corners_of(square, half)) divided.push_back(child);
                    continue;
                }
                add(square, step, corners, film);
            }
            if (divided.empty()) return true;
            squares.swap(divided);
        }
    }

private:
    struct Square {
        int x, y;  // of its upper left corner
    };
    struct Corner {
        Vec3 radiance, compared;
    };

    static std::array<Square, 4> corners_of(const Square& s, int step) {
        return {{{s.x, s.y}, {s.x + step, s.y}, {s.x, s.y + step}, {s.x + step, s.y + step}}};
    }
    [[nodiscard]] std::uint64_t key_of(const Square& place) const {
        return static_cast<std::uint64_t>(place.y) << 32U | static_cast<std::uint64_t>(place.x);
    }
    void want(const Square& place) {
        if (!numbers_.try_emplace(key_of(place), corners_.size() + places_.size()).second) return;
        const float part = 1.0F / static_cast<float>(1 << depth_);
        places_.push_back({static_cast<float>(pixels_.x0) + static_cast<float>(place.x) * part,
                           static_cast<float>(pixels_.y0) + static_cast<float>(place.y) * part});
    }
    bool trace_wanted(Device& device, const Frame& frame, RenderStats& stats, const StopFlag& stop) {
        std::vector<Vec3> radiance(places_.size());
        const RenderStats done = device.trace_places(frame, places_, radiance, stop);
        stats.rays += done.rays;
        stats.shadow_rays += done.shadow_rays;
        stats.points += places_.size();
        for (const Vec3& one : radiance) corners_.push_back({one, contrast_.compared(one)});
        places_.clear();
        return done.complete;
    }
    [[nodiscard]] const Corner& corner(const Square& place) const { return corners_[numbers_.at(key_of(place))]; }
    [[nodiscard]] bool differ(const std::array<Square, 4>& corners) const {
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = i + 1; k < 4; ++k)
                if (contrast_.differ(corner(corners[i]).compared, corner(corners[k]).compared)) return true;
        return false;
    }
    /// A square that isn't divided, into its pixel: its mean for as large a share as it has of it. The sum is kept for
    /// as many samples as there are squares so far.
    void add(const Square& square, int step, const std::array<Square, 4>& corners, Film& film) const {
        const int side = 1 << depth_;
        const float share = static_cast<float>(step) / static_cast<float>(side);
        std::array<float, 4>& sum =
            film.radiance[film.index(pixels_.x0 + square.x / side, pixels_.y0 + square.y / side)];
        const float before = std::max(sum[3], 1.0F);
        const float now = sum[3] + 1;
        std::array<float, 3> mean{};
        for (const Square& place : corners) {
            const Vec3& radiance = corner(place).radiance;
            mean[0] += radiance.x, mean[1] += radiance.y, mean[2] += radiance.z;
        }
        for (std::size_t i = 0; i < 3; ++i) sum[i] = (sum[i] / before + mean[i] * 0.25F * share * share) * now;
        sum[3] = now;
    }

    PixelRect pixels_;
    ColorContrast contrast_;
    int depth_;
    std::unordered_map<std::uint64_t, std::size_t> numbers_;  // of places, in corners_
    std::vector<Corner> corners_;
    std::vector<PicturePlace> places_;  // wanted, and not traced yet
};

}  // namespace

RenderResult render_recursively(Device& device, const Frame& frame, const RecursiveSampling& sampling,
                                const ProgressSink& progress, const StopFlag& stop,
                                const std::optional<PixelRect>& region) {
    const PixelRect picture = picture_of(frame, region);
    RenderResult result{Film(picture), {}, 0, false};
    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    for (int y = picture.y0; y < picture.y1 && !result.stopped; y += kBandRows) {
        const PixelRect rows{picture.x0, y, picture.x1, std::min(picture.y1, y + kBandRows)};
        result.stopped =
            stop.requested() || !Band(rows, sampling).render(device, frame, result.film, result.stats, stop);
        if (result.stopped)  // Pixels that have some of their squares only would be too dark.
            std::fill_n(result.film.radiance.begin() + static_cast<std::ptrdiff_t>(result.film.index(rows.x0, rows.y0)),
                        static_cast<std::ptrdiff_t>(rows.width()) * rows.height(), std::array<float, 4>{});
        if (progress && !result.stopped)
            progress({static_cast<double>(rows.y1 - picture.y0) / picture.height(), seconds(), result.stats.rays});
    }
    result.stats.complete = !result.stopped;
    result.seconds = seconds();
    return result;
}

}  // namespace sundog
