// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/shared.h"
#include "scene/scene.h"

namespace sundog {

/// A light as the kernel wants it, at time_s.
kernel::Light light_at(const scene::Light& light, float time_s);

}  // namespace sundog
