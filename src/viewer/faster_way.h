// SPDX-License-Identifier: Apache-2.0
// Whether pictures in motion are made faster by grid refinement or by tracing every pixel.
#pragma once

namespace sundog::viewer {

/// Told how long pictures took, it says which way to make the next one. Where few points are traced refinement is
/// faster for certain; on glass, bumps and mirrors it may not be, and both ways are tried now and then.
class FasterWay {
public:
    [[nodiscard]] bool refine_next() const {
        if (traced_share_ <= kSurelyFewer) return true;
        if (traced_s_ == 0) return false;
        const bool refined_is_faster = refined_s_ <= traced_s_;
        return since_other_ < kTrials ? refined_is_faster : !refined_is_faster;
    }
    /// A picture took so many seconds a pixel; of a refined one, so large a share of its pixels was traced.
    void report_refined(double seconds_a_pixel, double traced_share) {
        traced_share_ = traced_share;
        report(refined_s_, seconds_a_pixel, refined_s_ <= traced_s_);
    }
    void report_traced(double seconds_a_pixel) { report(traced_s_, seconds_a_pixel, traced_s_ < refined_s_); }
    /// Another scene or device: what was learnt no longer holds.
    void forget() { *this = {}; }

private:
    static constexpr double kSurelyFewer = 0.2;
    static constexpr int kTrials = 60;  // A second's pictures.

    void report(double& known_s, double measured_s, bool was_faster) {
        known_s = known_s == 0 ? measured_s : known_s + (measured_s - known_s) * 0.3;
        since_other_ = was_faster ? since_other_ + 1 : 0;
    }

    double refined_s_ = 0, traced_s_ = 0;  ///< A pixel; 0: not known.
    double traced_share_ = 0;
    int since_other_ = 0;  ///< Pictures since one was made the slower way.
};

}  // namespace sundog::viewer
