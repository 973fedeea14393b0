// SPDX-License-Identifier: Apache-2.0
// `sundog bench`: whole frames of the gallery's benchmark scenes, beside raw Embree packets on the same rays and beside
// Tachyon, all in one run and in turn, so that a machine's drift cancels; and the loading of a big model.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "million.h"

namespace sundog::bench {

/// What to measure, and how.
struct BenchOptions {
    std::filesystem::path gallery;            ///< Folder with table/ and cornell/; empty: the one of the source tree.
    std::vector<std::string> devices{"cpu"};  ///< "cpu", "gpu"
    int threads = 2;                          ///< Of the CPU device and of both peers; 0: all.
    int rounds = 7;                           ///< Each round measures every contestant once; medians count.
    bool tachyon = true;                      ///< Left out where the program isn't installed.
    bool load = true;                         ///< The 1,000,000-triangle model.
};

/// One scene at one size on one device.
struct FrameTiming {
    std::string scene;
    int width = 0, height = 0;
    std::uint32_t depth = 0;      ///< Reflections at most.
    std::string device;           ///< "cpu", or the GPU's name.
    double frame_s = 0;           ///< Median time of a frame, every pixel traced once, lights and camera made anew.
    double rays = 0;              ///< Of one frame.
    std::optional<double> raw_s;  ///< Median time of raw Embree packets (CPU device only).
    double raw_rays = 0;
    std::optional<double> ratio;  ///< Median over rounds of frame time to raw time.
    std::optional<double> tachyon_s;
};

struct BenchReport {
    std::string machine;
    std::string raw_name;  ///< Version and packet width of the raw measurement.
    int threads = 0;
    int rounds = 0;
    std::vector<FrameTiming> frames;
    std::vector<std::pair<std::string, LoadTimes>> loads;  ///< By device.
    std::vector<std::string> notes;                        ///< What was left out, and why.
};

/// Measures. `note` gets a line before each step. Ends early, with what is done, when `stop` is requested.
/// Errors: InputError (no gallery), DeviceError.
BenchReport run_bench(const BenchOptions& options, const std::function<void(std::string_view)>& note,
                      const StopFlag& stop);

/// The report as plain text tables.
std::string format_report(const BenchReport& report);

}  // namespace sundog::bench
