// SPDX-License-Identifier: Apache-2.0
// Colours of pigments at many points together, by the kernel's lanes; compiled once for each width.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "kernel/compat/types.h"

namespace sundog::kernel {
struct SceneView;
}

namespace sundog::fields {

/// The colours (red, green, blue, filter, transmit) that the program at `start` gives for points in the pigment's
/// space: the same bits as one by one. `colors` holds as many as `points`.
void pigment_colors_4(const kernel::SceneView& view, std::uint32_t start, std::span<const kernel::vec3> points,
                      std::span<std::array<float, 5>> colors);
/// The same, for processors that have AVX2.
void pigment_colors_8(const kernel::SceneView& view, std::uint32_t start, std::span<const kernel::vec3> points,
                      std::span<std::array<float, 5>> colors);

}  // namespace sundog::fields
