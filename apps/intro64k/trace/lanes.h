// SPDX-License-Identifier: Apache-2.0
// The kernel's vectors, by their own names, in the units that are compiled with them (SUNDOG_KERNEL_LANES).
#pragma once

#include "kernel/compat/compat.h"

namespace sundog::intro {

using namespace kernel;

}  // namespace sundog::intro
