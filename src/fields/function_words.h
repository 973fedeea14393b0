// SPDX-License-Identifier: Apache-2.0
// Functions as shaders run them (kernel/patterns/shader_function.h).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/function.h"

namespace sundog::fields {

/// A function's words, and which FIELD_* its operations need, as bits.
struct FunctionWords {
    std::vector<std::uint32_t> words;
    std::uint32_t fields = 0;
};
/// Of a function of a point; nothing where shaders can't run it: it has operations that they don't know (pigments,
/// splines, loops, bits, inverse hyperbolic functions), too many constants, or too many values that must be kept.
std::optional<FunctionWords> function_words(const scene::Function& function);

}  // namespace sundog::fields
