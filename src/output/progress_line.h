// SPDX-License-Identifier: Apache-2.0
// A line on the terminal that says how far a render is.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

#include "base/progress.h"

namespace sundog::output {

/// "0:07", "12:34", "1:02:03"; "-:--" for what can't be told (negative, not finite, over 1000 hours).
std::string format_duration(double seconds);
/// A number a second with three digits and a unit: "950", "12.3 k", "1.23 M", "45.6 G" followed by `what` and "/s".
std::string format_rate(double per_second, const std::string& what);
/// "[####------]  42%  12.3 Mrays/s  0:07 left"
std::string progress_text(const Progress& progress);

/// Draws progress_text() over itself, at most ten times a second, and only on terminals. Not for several threads at
/// once. Can be called as a ProgressSink.
class ProgressLine {
public:
    /// `out` must live as long as this. Where it is not a terminal, nothing is ever written.
    ProgressLine(std::ostream& out, bool is_terminal) : out_(out), is_terminal_(is_terminal) {}
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void operator()(const Progress& progress);
    /// Removes the line, so that other text can be written in its place.
    void clear();

private:
    std::ostream& out_;
    bool is_terminal_;
    double drawn_at_seconds_ = -1;
    std::size_t shown_length_ = 0;
};

}  // namespace sundog::output
