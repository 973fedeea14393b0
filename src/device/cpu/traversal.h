// SPDX-License-Identifier: Apache-2.0
// What finds hits for the kernel: Embree over the scene, or a structure of ours.
#pragma once

#include <cstddef>
#include <cstdint>

#include "device/cpu/embree.h"
#include "device/render_scene.h"

namespace sundog::cpu {

class Traversal {
public:
    Traversal() = default;
    Traversal(const Traversal&) = delete;
    Traversal& operator=(const Traversal&) = delete;
    virtual ~Traversal() = default;

    /// Brings moving geometries to their places, and culling to what the frame says.
    virtual void update(const Frame& frame) = 0;
    /// What the kernel asks. Embree's scene in either case, so that there is one kernel.
    [[nodiscard]] virtual RTCScene handle() const = 0;
};

}  // namespace sundog::cpu
