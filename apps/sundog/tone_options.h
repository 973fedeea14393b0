// SPDX-License-Identifier: Apache-2.0
// `sundog render`: how radiance becomes what a picture of 8 or 16 bits shows.
#pragma once

#include <optional>

#include "output/tone.h"

namespace CLI {
class App;
}

namespace sundog::app {

/// What the options say.
struct ToneArguments {
    std::optional<output::ToneCurve> curve;
    std::optional<float> white_point, white_balance_k;

    [[nodiscard]] output::ToneMapping mapping() const;
    /// `format`: of the pictures; none of a video. Errors: UsageError for options that don't go together.
    void check(const std::optional<output::Format>& format) const;
};

/// Gives a command the options; `arguments` must outlive it.
void add_tone_options(CLI::App& command, ToneArguments& arguments);

}  // namespace sundog::app
