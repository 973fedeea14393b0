// SPDX-License-Identifier: Apache-2.0
#include "device/choose/gpu_nodes.h"

#include <gtest/gtest.h>

namespace sundog {
namespace {

// A node that isn't known would leave a machine's GPU unused without a word.
TEST(GpuNodes, AnyDriversNodeIsFound) {
    const std::filesystem::path devices = std::filesystem::path(testing::TempDir()) / "sundog_gpu_nodes";
    std::filesystem::remove_all(devices);
    std::filesystem::create_directories(devices / "shm");
    EXPECT_FALSE(may_have_hardware_gpu(devices));
    for (const char* name : {"dri", "nvidiactl", "dxg"}) {
        std::filesystem::create_directory(devices / name);
        EXPECT_TRUE(may_have_hardware_gpu(devices)) << name;
        std::filesystem::remove(devices / name);
    }
    EXPECT_FALSE(may_have_hardware_gpu(devices / "missing"));
    std::filesystem::remove_all(devices);
}

}  // namespace
}  // namespace sundog
