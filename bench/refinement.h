// SPDX-License-Identifier: Apache-2.0
// `sundog bench --refine`: refinement against tracing every pixel, on the gallery in motion.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "device/device.h"

namespace sundog::bench {

struct RefinementOptions {
    std::filesystem::path gallery;  ///< Folder with table/ and the others; empty: the one of the source tree.
    std::string scene;              ///< Its name; empty: all of the gallery.
    int threads = 2;
    int frames = 24;         ///< Of each scene at each size, spread over its first 8 seconds.
    float tolerance = 0.1F;  ///< RefinedWork::tolerance.
    RefinementMethod method = RefinementMethod::grid;
};

/// One scene at one size.
struct RefinementTiming {
    std::string scene;
    int width = 0, height = 0;
    double traced_s = 0, refined_s = 0;      ///< Medians over frames.
    double pixels_per_point = 0;             ///< Pixels over points traced, of all frames.
    double rays_ratio = 0;                   ///< Rays of all kinds.
    double psnr_db = 0, ssim = 0, flip = 0;  ///< Means over frames, against the traced ones.
    double worst_psnr_db = 0;
};

/// Measures on the CPU; each frame is made both ways in turn. `done` gets each scene at each size as soon as it is
/// known. Errors: InputError (no gallery, no such scene), DeviceError.
void run_refinement(const RefinementOptions& options, const std::function<void(const RefinementTiming&)>& done,
                    const StopFlag& stop);

/// A table's head, and its rows.
std::string refinement_head();
std::string refinement_row(const RefinementTiming& timing);

}  // namespace sundog::bench
