// SPDX-License-Identifier: Apache-2.0
// `sundog bench --sampling`: error against time of each way to choose a pixel's samples, on the gallery.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "base/progress.h"

namespace sundog::bench {

struct SamplingOptions {
    std::filesystem::path gallery;  ///< Folder with table/ and the others; empty: the one of the source tree.
    std::string scene;              ///< Its name; empty: all of the gallery.
    int threads = 2;
    int rounds = 3;  ///< Medians count.
    int width = 320, height = 240;
    int reference_samples = 2025;  ///< A pixel's, of the picture that others are compared with.
};

/// One way on one scene.
struct SamplingTiming {
    std::string scene, way;
    double samples = 0;  ///< A pixel, on average.
    double seconds = 0;
    /// Root of the mean square of all channels' differences from the reference with the same filter, white being 1, as
    /// pictures show it; and as decibels.
    double rmse = 0, psnr_db = 0;
};

/// Measures on the CPU. `done` gets each line as soon as it is known. Errors: InputError (no gallery, no such scene),
/// DeviceError.
void run_sampling(const SamplingOptions& options, const std::function<void(const SamplingTiming&)>& done,
                  const StopFlag& stop);

/// A table's head, and its rows.
std::string sampling_head();
std::string sampling_row(const SamplingTiming& timing);

}  // namespace sundog::bench
