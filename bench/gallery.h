// SPDX-License-Identifier: Apache-2.0
// The gallery's scenes, which benchmarks find as NAME/NAME.scene.
#pragma once

#include <array>

namespace sundog::bench {

inline constexpr std::array<const char*, 5> kGalleryScenes{"table", "cornell", "mirrors", "glass", "textured"};

}  // namespace sundog::bench
