// SPDX-License-Identifier: Apache-2.0
// The namespace for code that is compiled once for each width of vectors, as the kernel's own is (kernel/compat/cpp.h).
#pragma once

#include "kernel/compat/compat.h"

#define INTRO_LANES_BEGIN     \
    namespace sundog::intro { \
    inline namespace SUNDOG_KERNEL_SPACE {
#define INTRO_LANES_END \
    }                   \
    }

INTRO_LANES_BEGIN

using namespace kernel;

INTRO_LANES_END
