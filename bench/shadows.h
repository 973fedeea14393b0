// SPDX-License-Identifier: Apache-2.0
// `sundog bench --shadows`: frames with light buffers against frames that trace all shadow rays.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "base/progress.h"

namespace sundog::bench {

struct ShadowOptions {
    std::filesystem::path gallery;  ///< Folder with table/ and the others; empty: the one of the source tree.
    std::string scene;              ///< Its name; empty: all.
    int threads = 2;
    int rounds = 7;  ///< Each round makes a frame both ways, in turn; medians count.
};

/// One scene at one size.
struct ShadowTiming {
    std::string scene;
    int width = 0, height = 0;
    double shadow_share = 0;             ///< Shadow rays among all.
    double traced_s = 0;                 ///< Processor seconds of a frame, all shadow rays traced.
    double moving_s = 0, resting_s = 0;  ///< With light buffers, made anew for each frame, and kept.
};

/// Measures on the CPU. `done` gets each scene at each size as soon as it is known. Errors: InputError (no gallery, no
/// such scene), DeviceError.
void run_shadows(const ShadowOptions& options, const std::function<void(const ShadowTiming&)>& done,
                 const StopFlag& stop);

/// A table's head, and its rows.
std::string shadows_head();
std::string shadows_row(const ShadowTiming& timing);

}  // namespace sundog::bench
