// SPDX-License-Identifier: Apache-2.0
// Kernel functions over arrays of plain numbers, compiled for every width, so that widths can be compared.
#pragma once

#include <cstddef>
#include <string_view>

namespace sundog::test {

inline constexpr std::size_t kInputs = 12, kOutputs = 8;

/// inputs[k][i] and outputs[k][i]: number k of item i; `count` is a multiple of 16. Returns the function's name, or an
/// empty one where `function` is past the last.
struct Batch {
    std::size_t count;
    const float* const* inputs;
    float* const* outputs;
};
std::string_view evaluate_1(std::size_t function, const Batch& batch);
std::string_view evaluate_4(std::size_t function, const Batch& batch);
std::string_view evaluate_8(std::size_t function, const Batch& batch);
std::string_view evaluate_16(std::size_t function, const Batch& batch);

}  // namespace sundog::test
