// SPDX-License-Identifier: Apache-2.0
// The animation's clock.
#pragma once

namespace sundog::viewer {

/// Time as the window shows it: runs with the real clock while playing, stands where the user scrubbed it otherwise.
class Playback {
public:
    [[nodiscard]] float time_s() const { return static_cast<float>(time_s_); }
    [[nodiscard]] bool playing() const { return playing_; }
    void set_playing(bool playing) { playing_ = playing; }
    void toggle() { playing_ = !playing_; }
    /// Real seconds passed. Frames may be late, time isn't.
    void advance(double seconds) {
        if (playing_) time_s_ += seconds;
    }
    /// To a moment chosen by hand (not under 0).
    void scrub(float time_s) { time_s_ = time_s > 0 ? time_s : 0; }
    /// How long the time line should be: the shortest of 20 s, 1, 5, 20 min, … that still holds the present moment.
    [[nodiscard]] float range_s() const;

private:
    double time_s_ = 0;  // double: after hours, a float no longer moves smoothly
    bool playing_ = true;
};

}  // namespace sundog::viewer
