// SPDX-License-Identifier: Apache-2.0
// Which frames there are and what the clock says in each (POV-Ray 3.7 reference, section 3.2.1 "Animation Options";
// where that leaves questions open, as povray 3.7 was seen to answer them).
#pragma once

#include "import/pov/pov_options.h"
#include "settings.h"

namespace sundog::app {

/// The frames first, first+step, … up to last. Without an animation there is one, number 0.
struct PovAnimation {
    bool animated = false;  ///< Frames are numbered, in their files' names too.
    int initial_frame = 0;
    int final_frame = 0;  ///< As scenes see it: one more than the last with Cyclic_Animation, as in povray.
    int first = 0, last = 0, step = 1;
    double initial_clock = 0, final_clock = 0, clock_delta = 0;
    bool clock_on = false;

    /// Of the frame of that number: initial_clock to final_clock in equal steps; with Cyclic_Animation the final clock
    /// would be that of the frame behind the last.
    [[nodiscard]] pov::PovClock clock_of(int frame) const;
    /// How many digits frame numbers have in file names: as many as final_frame.
    [[nodiscard]] int digits() const;
    [[nodiscard]] int count() const { return (last - first) / step + 1; }
};

/// Errors: UsageError where the subset of frames lies behind the final frame.
PovAnimation animation_of(const PovSettings& settings);

}  // namespace sundog::app
