// SPDX-License-Identifier: Apache-2.0
// `sundog bench --primary`: eye rays by scan conversion against tracing them, on the gallery and on meshes of a
// thousand to a million triangles.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "base/progress.h"

namespace sundog::bench {

struct PrimaryOptions {
    std::filesystem::path gallery;  ///< Folder with table/ and the others; empty: the one of the source tree.
    std::string scene;              ///< Its name, or "knot"; empty: all.
    int threads = 2;
    int rounds = 7;  ///< Each round makes a frame both ways, in turn; medians count.
};

/// One scene at one size, in processor seconds.
struct PrimaryTiming {
    std::string scene;
    std::size_t triangles = 0;
    int width = 0, height = 0;
    double traced_s = 0, rastered_s = 0;          ///< Whole frames.
    double eye_traced_s = 0, eye_rastered_s = 0;  ///< Without shadows and further rays.
    bool chosen = false;                          ///< Scan conversion is what the device chooses by itself.
};

/// Measures on the CPU; the eye moves a little from frame to frame. `done` gets each scene at each size as soon as it
/// is known. Errors: InputError (no gallery, no such scene), DeviceError.
void run_primary(const PrimaryOptions& options, const std::function<void(const PrimaryTiming&)>& done,
                 const StopFlag& stop);

/// A table's head, and its rows.
std::string primary_head();
std::string primary_row(const PrimaryTiming& timing);

}  // namespace sundog::bench
