// SPDX-License-Identifier: Apache-2.0
#include "sampling/passes.h"

#include <gtest/gtest.h>

#include <vector>

namespace sundog::sampling {
namespace {

std::vector<std::uint32_t> passes(std::uint32_t total) {
    std::vector<std::uint32_t> sizes;
    std::uint32_t done = 0;
    while (pass_size(done, total) > 0) {
        sizes.push_back(pass_size(done, total));
        done += sizes.back();
    }
    return sizes;
}

// Catches passes that overshoot the wanted samples, never end, or grow so large that no progress shows.
TEST(Passes, DoubleUpToTheLargestAndEndExactly) {
    EXPECT_EQ(passes(0), (std::vector<std::uint32_t>{}));
    EXPECT_EQ(passes(1), (std::vector<std::uint32_t>{1}));
    EXPECT_EQ(passes(7), (std::vector<std::uint32_t>{1, 1, 2, 3}));
    EXPECT_EQ(passes(50), (std::vector<std::uint32_t>{1, 1, 2, 4, 8, 16, 16, 2}));
}

}  // namespace
}  // namespace sundog::sampling
