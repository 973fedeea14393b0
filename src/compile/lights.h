// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "kernel/shared.h"
#include "scene/scene.h"

namespace sundog {

/// A light as the kernel wants it, at time_s.
kernel::Light light_at(const scene::Light& light, float time_s);

/// The same, or all lights of an area whose lights light one by one (at most 4096; a larger area is taken whole).
void append_lights(const scene::Light& light, float time_s, std::vector<kernel::Light>& out);

}  // namespace sundog
