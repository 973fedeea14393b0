// SPDX-License-Identifier: Apache-2.0
// `sundog bench --accel`: every acceleration structure on the same scenes, in one run and in turn.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "device/acceleration.h"
#include "scene/scene.h"

namespace sundog::bench {

/// What to measure, and how.
struct AccelOptions {
    std::filesystem::path gallery;  ///< Empty: the one of the source tree.
    int threads = 2;                ///< 0: all.
    int rounds = 7;                 ///< Each round measures every structure once on a scene; medians count.
    std::string only;               ///< The name of one scene; empty: all.
};

/// One structure on one scene. Rays are those of a picture of 320x240: eye, mirrored, refracted and shadow rays, of
/// blocks of pixels spread over it, as many as there is time for; their shading is measured with them. Steps are those
/// of 600 pixels.
struct AccelTiming {
    std::string scene;
    std::size_t primitives = 0;
    Acceleration structure{};
    double build_s = 0;          ///< Processor seconds.
    std::size_t bytes = 0;       ///< Beside the scene's own arrays.
    double visits = 0;           ///< Nodes, cells and boxes a ray.
    double tests = 0;            ///< Primitives tested a ray.
    double rays_per_second = 0;  ///< A processor second.
};

struct AccelReport {
    std::string machine;
    int threads = 0, rounds = 0;
    std::vector<AccelTiming> timings;
};

/// The scenes that are measured: the gallery, the Standard Procedural Databases and a scanned mesh; by name.
std::vector<std::string> accel_scene_names();
/// One of them. Errors: InputError (no gallery).
scene::Scene accel_scene(const std::filesystem::path& gallery, std::string_view name);

/// Measures. `note` gets a line before each scene. Ends early, with what is done, when `stop` is requested.
AccelReport run_accel_bench(const AccelOptions& options, const std::function<void(std::string_view)>& note,
                            const StopFlag& stop);

/// The report as a plain text table.
std::string format_report(const AccelReport& report);

}  // namespace sundog::bench
