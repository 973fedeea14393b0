// SPDX-License-Identifier: Apache-2.0
// Bits that look random.
#ifndef SUNDOG_KERNEL_HASH_H
#define SUNDOG_KERNEL_HASH_H

#include "kernel/compat/compat.h"

KERNEL_BEGIN

/// A mixing function of 32 bits (Wellons, Prospecting for Hash Functions, 2018: lowbias32).
FN word hash_word(word x) {
    x = (x ^ (x >> 16u)) * word(0x7feb352du);
    x = (x ^ (x >> 15u)) * word(0x846ca68bu);
    return x ^ (x >> 16u);
}

/// The 32 bits in reverse order.
FN word reversed(word x) {
    x = (x >> 16u) | (x << 16u);
    x = ((x >> 8u) & word(0x00ff00ffu)) | ((x & word(0x00ff00ffu)) << 8u);
    x = ((x >> 4u) & word(0x0f0f0f0fu)) | ((x & word(0x0f0f0f0fu)) << 4u);
    x = ((x >> 2u) & word(0x33333333u)) | ((x & word(0x33333333u)) << 2u);
    return ((x >> 1u) & word(0x55555555u)) | ((x & word(0x55555555u)) << 1u);
}

KERNEL_END

#endif
