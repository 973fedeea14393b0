// SPDX-License-Identifier: Apache-2.0
// Host vectors to the kernel's.
#pragma once

#include "base/vec.h"
#include "kernel/shared.h"

namespace sundog {

constexpr kernel::vec3 to_kernel(Vec3 v) { return {v.x, v.y, v.z}; }
constexpr kernel::vec2 to_kernel(Vec2 v) { return {v.x, v.y}; }

}  // namespace sundog
