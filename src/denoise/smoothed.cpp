// SPDX-License-Identifier: Apache-2.0
#include "denoise/smoothed.h"

#include <algorithm>
#include <cstddef>

namespace sundog::denoise {

std::vector<float> smoothed(const std::vector<float>& values, int width, int height, int radius) {
    const auto index = [width](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    };
    std::vector<float> rows(values.size()), out(values.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int first = std::max(x - radius, 0), last = std::min(x + radius, width - 1);
            float sum = 0;
            for (int i = first; i <= last; ++i) sum += values[index(i, y)];
            rows[index(x, y)] = sum / static_cast<float>(last - first + 1);
        }
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int first = std::max(y - radius, 0), last = std::min(y + radius, height - 1);
            float sum = 0;
            for (int i = first; i <= last; ++i) sum += rows[index(x, i)];
            out[index(x, y)] = sum / static_cast<float>(last - first + 1);
        }
    return out;
}

}  // namespace sundog::denoise
