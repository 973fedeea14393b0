// SPDX-License-Identifier: Apache-2.0
#include "device/render_scene.h"

namespace sundog {

std::size_t memory_bytes(const RenderScene& scene) {
    std::size_t bytes = 0;
#define KERNEL_ARRAYS_SCENE_ONLY
#define KERNEL_ARRAY(type, name, binding) bytes += scene.name.size() * sizeof(scene.name[0]);
#include "kernel/arrays.h"
#undef KERNEL_ARRAY
#undef KERNEL_ARRAYS_SCENE_ONLY
    return bytes;
}

}  // namespace sundog
