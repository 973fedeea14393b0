// SPDX-License-Identifier: Apache-2.0
// Opening a GPU for tests, and rendering on any device.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "compile/compile.h"
#include "device/device.h"
#include "device/vulkan/vulkan_device.h"
#include "test_scenes.h"

namespace sundog::parity {

/// A GPU under the validation layer, where that is installed; null where there is no usable GPU (`why` then says so).
/// Messages of the layer are added to `messages`, which must outlive the device.
std::unique_ptr<Device> open_gpu(std::vector<std::string>& messages, std::string& why, VulkanOptions options = {});

/// A scene with a frame of it, ready for devices.
struct Prepared {
    std::shared_ptr<const RenderScene> scene;
    Frame frame;
};

Prepared prepare(const TestScene& test, int width, int height);

/// The largest difference of a channel, in units of 1/255 of sRGB.
int difference(Vec3 a, Vec3 b);

/// All pixels of the frame, samples [0, samples), with the planes of `aovs`; `device` must have the scene loaded.
Film render(Device& device, const Frame& frame, std::uint32_t samples, std::uint32_t aovs = 0);

}  // namespace sundog::parity
