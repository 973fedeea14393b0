// SPDX-License-Identifier: Apache-2.0
// `sundog render`: how many samples a pixel gets, and where they go.
#pragma once

#include <cstdint>
#include <optional>

#include "kernel/shared.h"
#include "session/contrast.h"
#include "session/error_driven.h"
#include "session/recursive.h"

namespace CLI {
class App;
}

namespace sundog::app {

/// What the options say. Which way a picture is made follows from which of them are there: see way().
struct SamplingArguments {
    std::optional<int> samples;
    std::optional<float> preview;                    ///< Tolerance of refinement.
    std::optional<RefinementMethod> preview_method;  ///< Else the grid.
    std::optional<std::uint32_t> pattern;            ///< SAMPLES_*
    std::optional<std::uint32_t> pixel_filter;       ///< FILTER_*
    std::optional<float> filter_radius;
    std::optional<float> adaptive;  ///< Threshold of contrast.
    std::optional<int> adaptive_method, adaptive_depth;
    std::optional<bool> adaptive_by_object, adaptive_by_depth;  ///< Both set or neither.
    std::optional<float> target_error, time_limit_s;

    enum class Way : std::uint8_t {
        fixed,      ///< The same number for all pixels.
        preview,    ///< At most one, by grid refinement.
        adaptive,   ///< More where neighbours differ; where they don't, one or, with preview, fewer.
        recursive,  ///< Squares are divided where their corners differ.
        to_error,   ///< Until the error is small or time is over.
    };
    [[nodiscard]] Way way() const;
    /// Samples a pixel at most, or in all for the fixed way.
    [[nodiscard]] int most_samples() const;

    /// For FrameOptions. Valid once checked.
    [[nodiscard]] kernel::PixelSampling pixel_sampling() const;
    /// AOV_* bits that the way needs.
    [[nodiscard]] std::uint32_t planes() const;
    /// What the session needs for the way of that name. `gain`: what radiance is shown times.
    [[nodiscard]] AdaptiveSampling adaptive_sampling(float gain) const;
    [[nodiscard]] RecursiveSampling recursive_sampling() const;
    [[nodiscard]] ErrorTarget error_target(float gain) const;

    /// Errors: UsageError for options that don't go together.
    void check() const;
};

/// Gives a command the options; `arguments` must outlive it.
void add_sampling_options(CLI::App& command, SamplingArguments& arguments);

}  // namespace sundog::app
