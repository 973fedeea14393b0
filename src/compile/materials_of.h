// SPDX-License-Identifier: Apache-2.0
// Which materials an object shows.
#pragma once

#include <cstdint>
#include <functional>

#include "scene/scene.h"

namespace sundog {

/// Calls `visit` with the index of each material of the object's surface, some more than once.
void for_each_material(const scene::Object& object, const std::function<void(std::uint32_t)>& visit);

}  // namespace sundog
