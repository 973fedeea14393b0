// SPDX-License-Identifier: Apache-2.0
#include "output/filter.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sundog::output {

Kernel gaussian(float sigma, int radius) {
    Kernel kernel;
    for (int i = -radius; i <= radius; ++i)
        kernel.push_back(std::exp(-static_cast<float>(i * i) / (2 * sigma * sigma)));
    const float sum = std::accumulate(kernel.begin(), kernel.end(), 0.0F);
    for (float& weight : kernel) weight /= sum;
    return kernel;
}

Plane filtered(const Plane& plane, const Kernel& along_x, const Kernel& along_y) {
    const auto width = static_cast<std::size_t>(plane.width);
    const int radius_x = static_cast<int>(along_x.size() / 2);
    const int radius_y = static_cast<int>(along_y.size() / 2);
    Plane rows(plane.width, plane.height);
    std::vector<float> padded(width + along_x.size() - 1);
    for (int y = 0; y < plane.height; ++y) {
        const float* row = plane.values.data() + plane.index(0, y);
        for (int x = -radius_x; x < plane.width + radius_x; ++x)
            padded[static_cast<std::size_t>(x + radius_x)] = row[std::clamp(x, 0, plane.width - 1)];
        float* out = rows.values.data() + rows.index(0, y);
        // Weight by weight over a whole row: the compiler turns the inner loop into SIMD code.
        for (std::size_t k = 0; k < along_x.size(); ++k)
            for (std::size_t x = 0; x < width; ++x) out[x] += along_x[k] * padded[x + k];
    }
    Plane result(plane.width, plane.height);
    for (int y = 0; y < plane.height; ++y) {
        float* out = result.values.data() + result.index(0, y);
        for (int k = -radius_y; k <= radius_y; ++k) {
            const float weight = along_y[static_cast<std::size_t>(k + radius_y)];
            const float* in = rows.values.data() + rows.index(0, std::clamp(y + k, 0, plane.height - 1));
            for (std::size_t x = 0; x < width; ++x) out[x] += weight * in[x];
        }
    }
    return result;
}

}  // namespace sundog::output
