// SPDX-License-Identifier: Apache-2.0
// One ray at a time: varying types are plain ones. Included by cpp.h alone.
#pragma once

KERNEL_BEGIN

using real = float;
using word = uint;
using mask = bool;
using real2 = vec2;
using real3 = vec3;

FN mask mask_and(mask a, mask b) { return a & b; }
FN mask mask_or(mask a, mask b) { return a | b; }
FN mask mask_not(mask a) { return !a; }
FN mask select_mask(mask m, mask a, mask b) { return m ? a : b; }
FN bool any_lane(mask m) { return m; }
FN bool all_lanes(mask m) { return m; }

/// The value in the first of the lanes of m (some lane must be in it), as a uniform one.
FN uint first_lane(mask, word i) { return i; }
/// A uniform float from its bits.
FN float uniform_float(uint bits) { return std::bit_cast<float>(bits); }

FN word as_word(real x) { return std::bit_cast<word>(x); }
FN real as_real(word x) { return std::bit_cast<real>(x); }
/// Truncates; x must lie in [0, 2^31).
FN word word_from_real(real x) { return static_cast<word>(static_cast<std::int32_t>(x)); }
/// x must be under 2^31.
FN real real_from_word(word x) { return static_cast<real>(static_cast<std::int32_t>(x)); }

FN real sqrt(real x) { return std::sqrt(x); }
FN real abs(real x) { return std::fabs(x); }
FN real floor(real x) { return std::floor(x); }
FN real min(real a, real b) { return a < b ? a : b; }
FN real max(real a, real b) { return a > b ? a : b; }
FN uint min(uint a, uint b) { return a < b ? a : b; }
FN uint max(uint a, uint b) { return a > b ? a : b; }
FN real select(mask m, real a, real b) { return m ? a : b; }
FN word select(mask m, word a, word b) { return m ? a : b; }

FN word valid_index(mask m, word i) { return m ? i : 0u; }

template <class T>
FN T load(const T* first, std::size_t stride_bytes, word i) {
    return *reinterpret_cast<const T*>(reinterpret_cast<const char*>(first) + stride_bytes * i);
}

KERNEL_END
