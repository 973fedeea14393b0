// SPDX-License-Identifier: Apache-2.0
// Numbers among the words of programs.
#ifndef SUNDOG_KERNEL_PATTERNS_CODE_H
#define SUNDOG_KERNEL_PATTERNS_CODE_H

#include "kernel/compat/compat.h"

KERNEL_BEGIN

FN float code_float(SCENE uint at) { return uniform_float(AT(code, at)); }
FN vec3 code_vec3(SCENE uint at) {
    return vec3(code_float(SCENE_ at), code_float(SCENE_ at + 1u), code_float(SCENE_ at + 2u));
}

KERNEL_END

#endif
