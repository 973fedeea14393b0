// SPDX-License-Identifier: Apache-2.0
// Holds the frame time while things move, by rendering fewer pixels.
#pragma once

#include <cstdint>

namespace sundog::viewer {

/// Width and height in pixels.
struct PixelSize {
    int width = 0, height = 0;
    friend bool operator==(const PixelSize&, const PixelSize&) = default;
    [[nodiscard]] std::int64_t pixels() const { return std::int64_t{width} * height; }
};

/// A controller: told how long pictures took, it says how large the next one may be. Sizes only change when they
/// must by a good tenth, so that the picture doesn't shimmer between two of them.
class FrameBudget {
public:
    /// target_s: seconds a picture may take.
    explicit FrameBudget(double target_s) : target_s_(target_s) {}

    /// How large to render for a window of this size: its own size where that is affordable, never under an eighth
    /// of its width and height. A guess (small) until the first report.
    [[nodiscard]] PixelSize size_for(PixelSize window);
    /// A whole picture of `rendered` pixels took `seconds`.
    void report(PixelSize rendered, double seconds);
    /// Another scene or device: what was learnt no longer holds.
    void forget();

private:
    double target_s_;
    double seconds_per_pixel_ = 0;  // 0: not known yet
    double scale_ = 0;              // of width and height; 0: not chosen yet
};

}  // namespace sundog::viewer
