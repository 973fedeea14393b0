// SPDX-License-Identifier: Apache-2.0
#include "viewer/frame_budget.h"

#include <algorithm>
#include <cmath>

namespace sundog::viewer {
namespace {

constexpr double kSmallestScale = 1.0 / 8;
constexpr double kFirstGuess_pixels = 320 * 240;
constexpr double kHeadroom = 0.9;  // aim under the target, since pictures vary

int scaled(int length, double scale) {
    // Multiples of 8 suit tiles and packets, and keep small changes of scale from changing the size.
    const int exact = static_cast<int>(std::lround(length * scale / 8)) * 8;
    return std::clamp(exact, std::min(8, length), length);
}

}  // namespace

PixelSize FrameBudget::size_for(PixelSize window) {
    const double pixels = std::max<double>(1, static_cast<double>(window.pixels()));
    const double affordable = seconds_per_pixel_ > 0 ? kHeadroom * target_s_ / seconds_per_pixel_ : kFirstGuess_pixels;
    const double ideal = std::clamp(std::sqrt(affordable / pixels), kSmallestScale, 1.0);
    const bool too_slow = ideal < scale_ * 0.93;
    const bool room_to_grow = ideal > scale_ * 1.12 || (ideal == 1.0 && scale_ < 1.0);
    if (too_slow || room_to_grow) scale_ = ideal;
    if (scale_ >= 1) return window;
    return {scaled(window.width, scale_), scaled(window.height, scale_)};
}

void FrameBudget::report(PixelSize rendered, double seconds) {
    if (rendered.pixels() <= 0 || !(seconds > 0)) return;
    const double measured = seconds / static_cast<double>(rendered.pixels());
    // A much slower view (the user turned towards glass) counts at once; else smooth over a few pictures.
    const bool sudden = seconds_per_pixel_ == 0 || measured > 2 * seconds_per_pixel_;
    seconds_per_pixel_ = sudden ? measured : seconds_per_pixel_ + (measured - seconds_per_pixel_) * 0.2;
}

void FrameBudget::forget() {
    seconds_per_pixel_ = 0;
    scale_ = 0;
}

}  // namespace sundog::viewer
