// SPDX-License-Identifier: Apache-2.0
// A RenderScene in structures of ours, in the shape of an Embree scene: it holds a single thing that is everywhere,
// whose callbacks ask the structure. So the kernel is the same whatever finds its hits, and knows nothing of it.
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include "device/accel/world.h"
#include "device/cpu/embree.h"
#include "device/cpu/traversal.h"

namespace sundog::cpu {

class StructureScene final : public Traversal {
public:
    /// Builds over the scene, which must outlive this. Errors: DeviceError (Embree fails).
    StructureScene(RTCDevice device, Acceleration which, const RenderScene& scene);

    void update(const Frame& frame) override { world_.update(frame); }
    [[nodiscard]] RTCScene handle() const override { return scene_.get(); }

    [[nodiscard]] std::size_t memory_bytes() const { return world_.memory_bytes(); }
    /// What the calling thread's rays took so far.
    [[nodiscard]] accel::Steps steps_of_this_thread() const { return workers_.local().steps; }
    /// What all rays took so far; no thread may be asking.
    [[nodiscard]] accel::Steps all_steps() const;

private:
    struct Worker {
        accel::Scratch scratch;
        accel::Steps steps;
    };

    static void bounds(const RTCBoundsFunctionArguments* args);
    static void intersect(const RTCIntersectFunctionNArguments* args);
    static void occluded(const RTCOccludedFunctionNArguments* args);

    accel::World world_;
    mutable tbb::enumerable_thread_specific<Worker> workers_;
    embree::Scene scene_;
};

}  // namespace sundog::cpu
