// SPDX-License-Identifier: Apache-2.0
// Bounds of patterns over boxes, as the kernel computes them (kernel/patterns/fields.h), rounding included.
#pragma once

#include "compile/noise_range.h"
#include "scene/pattern.h"

namespace sundog {

/// Of a field of which nothing is known.
inline constexpr Range kAnyValue{-1e30, 1e30};

/// Where the points of a box may be when a pattern is asked: after its warps, transforms and turbulence.
RangeBox pattern_box(const scene::Pattern& pattern, const RangeBox& box);
/// A field before its wave form, over a box of its own points; kAnyValue for patterns that have no bounds there.
Range field_over(const scene::Pattern& pattern, const RangeBox& at);
/// What a pattern's wave form makes of values.
Range wave_over(const scene::Pattern& pattern, Range value);
/// About how many sums of noise a point takes; 1 for patterns without any.
int pattern_cost(const scene::Pattern& pattern);

}  // namespace sundog
