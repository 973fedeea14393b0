// SPDX-License-Identifier: Apache-2.0
#include "scene/pigment.h"

#include <algorithm>

namespace sundog::scene {

bool uses_uv(const Pigment& pigment) {
    return pigment.uv_mapping ||
           std::any_of(pigment.entries.begin(), pigment.entries.end(),
                       [](const PigmentEntry& entry) { return entry.pigment && uses_uv(*entry.pigment); });
}

bool uses_uv(const LayeredTexture& texture) {
    return std::any_of(texture.layers.begin(), texture.layers.end(), [](const TextureLayer& layer) {
        return (layer.pigment && uses_uv(*layer.pigment)) || (layer.normal && layer.normal->uv_mapping);
    });
}

}  // namespace sundog::scene
