// SPDX-License-Identifier: Apache-2.0
// Pigments as programs of the kernel (kernel/patterns/program.h).
#pragma once

#include <cstdint>
#include <vector>

#include "scene/pigment.h"

namespace sundog::fields {

/// Appends the program of a pigment. Errors: InputError for pigment maps nested deeper than PROGRAM_SLOTS.
void write_pigment_code(const scene::Pigment& pigment, std::vector<std::uint32_t>& code);

}  // namespace sundog::fields
