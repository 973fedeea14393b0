// SPDX-License-Identifier: Apache-2.0
// Random arguments for every function of kernel_calls.h, and how far results may lie apart on a GPU.
#pragma once

#include <string>
#include <vector>

#include "call_lanes.h"

namespace sundog::parity {

/// One function under test.
struct FunctionCase {
    std::string name;
    std::uint32_t function = 0;
    /// A GPU's result may differ from the CPU's by relative * |value| + absolute: GPUs divide within 2.5 units in the
    /// last place, take square roots within 3, and may fuse multiplications with additions.
    float relative = 0, absolute = 0;
    /// Result 0 is a yes or no; where it is no, the other results mean nothing.
    bool decides = false;
};

/// All of them, in the order of their numbers.
std::vector<FunctionCase> function_cases();

/// Arguments of many calls.
struct Arguments {
    std::vector<kernel::UniformValues> uniforms;
    std::vector<CallValues> varying;
};

/// Arguments in the range that the function is meant for: `batches` times CALL_BATCH calls, the same every time.
Arguments random_arguments(const FunctionCase& function, std::size_t batches);

}  // namespace sundog::parity
