// SPDX-License-Identifier: Apache-2.0
// The values of command line options, read strictly. All throw UsageError naming the option, the value and its range.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "device/acceleration.h"
#include "device/device.h"
#include "device/primary_hits.h"
#include "kernel/shared.h"

namespace sundog::app {

/// Largest width and height of a picture: that of a JPEG.
inline constexpr int kLargestSide = 65535;

struct Size {
    int width = 0, height = 0;
};
/// "1920x1080", each from 1 to kLargestSide.
Size parse_size(std::string_view text);

/// Pixel coordinates, x to the right and y downwards from the upper left corner, from 0.
struct Pixel {
    int x = 0, y = 0;
};
/// "120,45"
Pixel parse_pixel(std::string_view text, std::string_view option = "--pixel");

/// Numbers of the first and last frame, both included.
struct FrameRange {
    int first = 0, last = 0;
};
/// "1..250", "7"
FrameRange parse_frames(std::string_view text);

/// A whole number from `least` to `most`.
int parse_int(std::string_view option, std::string_view text, int least, int most);
/// A finite number from `least` to `most`.
float parse_float(std::string_view option, std::string_view text, float least, float most);
/// "on" or "off"
bool parse_switch(std::string_view option, std::string_view text);
/// One of `valid`, which is returned.
std::string parse_choice(std::string_view option, std::string_view text, const std::vector<std::string_view>& valid);

/// What `--aov` asks for beside the colours.
struct AovChoice {
    std::uint32_t planes = 0;  ///< AOV_* bits
    bool samples = false;      ///< The number of samples of each pixel, which every film has.
};
/// Names separated by commas: depth normal albedo object samples cost, or all.
AovChoice parse_aovs(std::string_view text);

/// "embree", "bvh", …: kAccelerationNames.
Acceleration parse_acceleration(std::string_view text);

/// "grid", "scanline" or "scanline-assumed"
RefinementMethod parse_refinement_method(std::string_view text);

/// "auto", "trace" or "raster": kPrimaryHitsNames.
PrimaryHits parse_primary(std::string_view text);

/// "cpu", "gpu" or "auto"
std::string parse_device(std::string_view text);

}  // namespace sundog::app
