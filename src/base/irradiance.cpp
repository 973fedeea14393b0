// SPDX-License-Identifier: Apache-2.0
#include "base/irradiance.h"

#include <algorithm>

namespace sundog {

void IrradianceSample::limit_gradients() {
    const std::array<float, 3> channels{light.x, light.y, light.z};
    for (std::size_t i = 0; i < 3; ++i) {
        const float most = length(by_move[i]) * reach;
        if (most > channels[i]) by_move[i] *= std::max(channels[i], 0.0F) / most;
    }
}

}  // namespace sundog
