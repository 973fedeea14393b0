// SPDX-License-Identifier: Apache-2.0
#include "device/choose/gpu_nodes.h"

#include <algorithm>
#include <array>
#include <system_error>

namespace sundog {

bool may_have_hardware_gpu(const std::filesystem::path& devices) {
    // DRM (AMD, Intel, most others), NVIDIA's own, Windows' GPU in WSL, and mobile GPUs' own: Adreno, Mali, PowerVR.
    constexpr std::array names{"dri", "nvidiactl", "dxg", "kgsl-3d0", "mali0", "pvr_sync"};
    return std::ranges::any_of(names, [&](const char* name) {
        std::error_code unreadable;
        return std::filesystem::exists(devices / name, unreadable) || unreadable;
    });
}

}  // namespace sundog
