// SPDX-License-Identifier: Apache-2.0
#include "viewer/playback.h"

namespace sundog::viewer {

float Playback::range_s() const {
    constexpr double kRanges_s[] = {20, 60, 300, 1200, 3600};
    for (const double range : kRanges_s)
        if (time_s_ < range) return static_cast<float>(range);
    double range = kRanges_s[4];
    while (range <= time_s_) range *= 4;
    return static_cast<float>(range);
}

}  // namespace sundog::viewer
