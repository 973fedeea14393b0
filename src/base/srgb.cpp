// SPDX-License-Identifier: Apache-2.0
#include "base/srgb.h"

#include <cmath>
#include <cstddef>

namespace sundog {

double linear_from_srgb(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }

const std::array<float, 256>& linear_of_srgb8() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> linear{};
        for (std::size_t code = 0; code < linear.size(); ++code)
            linear[code] = static_cast<float>(linear_from_srgb(static_cast<double>(code) / 255));
        return linear;
    }();
    return table;
}

}  // namespace sundog
