// SPDX-License-Identifier: Apache-2.0
// Whether this machine may have a GPU at all, found out without loading any driver.
#pragma once

#include <filesystem>

namespace sundog {

/// False only where no kernel driver of a GPU has made a device node: then every Vulkan driver here is software.
/// Loading all of the drivers to learn the same takes longer than many a picture. `devices` is for tests.
bool may_have_hardware_gpu(const std::filesystem::path& devices = "/dev");

}  // namespace sundog
