// SPDX-License-Identifier: Apache-2.0
#include "animation.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "../usage_error.h"

namespace sundog::app {
namespace {

/// A frame's number from Subset_Start_Frame or Subset_End_Frame: what is under 1 is a share of the number of frames.
/// (It isn't counted from the initial frame; for animations that begin with frame 1, as most do, that is the same.)
int subset_frame(double given, int frames) {
    return static_cast<int>(std::floor(given < 1 ? given * frames : std::min(given, 1e9)));
}

}  // namespace

pov::PovClock PovAnimation::clock_of(int frame) const {
    pov::PovClock clock;
    clock.clock = animated ? initial_clock + clock_delta * (frame - initial_frame) : initial_clock;
    clock.clock_delta = clock_delta;
    clock.clock_on = clock_on;
    clock.frame_number = frame;
    clock.initial_frame = initial_frame;
    clock.final_frame = final_frame;
    clock.initial_clock = animated ? initial_clock : 0;
    clock.final_clock = final_clock;
    return clock;
}

int PovAnimation::digits() const { return static_cast<int>(std::to_string(final_frame).size()); }

PovAnimation animation_of(const PovSettings& settings) {
    PovAnimation animation;
    animation.animated = settings.final_frame.value_or(0) > 0 || settings.initial_frame.value_or(0) > 0;
    if (!animation.animated) {
        animation.initial_clock = settings.clock.value_or(0);
        animation.clock_on = settings.clock.has_value();
        return animation;
    }
    animation.clock_on = true;
    animation.initial_frame = std::max(0, settings.initial_frame.value_or(1));
    const int final_frame = std::max(animation.initial_frame, settings.final_frame.value_or(0));
    animation.initial_clock = settings.initial_clock.value_or(0);
    animation.final_clock = settings.final_clock.value_or(1);
    animation.final_frame = final_frame + (settings.cyclic_animation ? 1 : 0);
    const int steps = animation.final_frame - animation.initial_frame;
    // povray divides by zero where there is one frame; its clock is the initial one here.
    if (steps > 0) animation.clock_delta = (animation.final_clock - animation.initial_clock) / steps;

    const int frames = final_frame - animation.initial_frame + 1;
    animation.first = animation.initial_frame;
    animation.last = final_frame;
    if (settings.subset_start_frame)
        animation.first = std::max(animation.first, subset_frame(*settings.subset_start_frame, frames));
    if (animation.first > final_frame)
        throw UsageError("the subset starts at frame " + std::to_string(animation.first) + ", but the final frame is " +
                             std::to_string(final_frame),
                         "+SF and +EF take numbers from the initial to the final frame, or fractions under 1");
    if (settings.subset_end_frame)
        animation.last = std::clamp(subset_frame(*settings.subset_end_frame, frames), animation.first, final_frame);
    animation.step = settings.frame_step;
    return animation;
}

}  // namespace sundog::app
