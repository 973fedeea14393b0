// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/tile_kernel.h"

namespace sundog::cpu {

kernel::SceneView view_of(const RenderScene& scene, const Frame& frame, const void* traversal) {
    kernel::SceneView view{};
    view.frame = frame.params;
#define KERNEL_ARRAYS_SCENE_ONLY
#define KERNEL_ARRAY(type, name, binding) view.name = scene.name.data();
#include "kernel/arrays.h"
#undef KERNEL_ARRAY
#undef KERNEL_ARRAYS_SCENE_ONLY
    view.lights = frame.lights.data();
    view.instances = frame.instances.data();
    view.emitters = frame.emitters.data();
    view.traversal = traversal;
    view.host_fields = scene.host_fields.get();
    return view;
}

}  // namespace sundog::cpu
