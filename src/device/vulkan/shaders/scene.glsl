// SPDX-License-Identifier: Apache-2.0
// Declares what kernel/compat/glsl.h expects of a shader: the scene's buffers, the frame, the features.
#extension GL_EXT_scalar_block_layout : require

#include "kernel/shared.h"
#include "device/bvh/node.h"
#include "device/vulkan/shaders/layout.h"

#define KERNEL_ARRAY(type, name, number) \
    layout(scalar, set = 0, binding = number) readonly restrict buffer name##_buffer { type name[]; };
#include "kernel/arrays.h"
#undef KERNEL_ARRAY

layout(scalar, set = 0, binding = BINDING_FRAME) uniform frame_buffer { FrameParams frame; };

/// FrameParams::features, known when the pipeline is made.
layout(constant_id = 0) const uint frame_features = 0u;
/// FrameParams::aovs likewise.
layout(constant_id = 1) const uint frame_aovs = 0u;
/// Entries of the traversal's stack: what the hierarchies at hand need at most.
layout(constant_id = 2) const uint stack_size = 16u;
/// FrameParams::integrator likewise.
layout(constant_id = 3) const uint frame_integrator = 0u;
/// RenderScene::program_ops and program_fields likewise.
layout(constant_id = 6) const uint program_ops = 0xffffffffu;
layout(constant_id = 7) const uint program_fields = 0xffffffffu;
