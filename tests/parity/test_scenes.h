// SPDX-License-Identifier: Apache-2.0
// Small scenes that between them use every feature of the kernel, for comparing devices.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace sundog::parity {

/// A scene with a name for messages.
struct TestScene {
    std::string name;
    scene::Scene scene;
    float time_s = 0;
};

std::vector<TestScene> test_scenes();

}  // namespace sundog::parity
