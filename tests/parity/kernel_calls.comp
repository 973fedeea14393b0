// SPDX-License-Identifier: Apache-2.0
// Calls one function of the kernel for each invocation's arguments.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "device/vulkan/shaders/scene.glsl"
#include "parity/kernel_calls.h"

layout(local_size_x = CALL_BATCH) in;

layout(scalar, set = 0, binding = BINDING_NODES) readonly restrict buffer uniform_values_buffer {
    UniformValues uniform_arguments[];
};
layout(scalar, set = 0, binding = BINDING_RADIANCE) readonly restrict buffer arguments_buffer { Varying arguments[]; };
layout(scalar, set = 0, binding = BINDING_AOVS) writeonly restrict buffer results_buffer { Varying results[]; };
layout(scalar, push_constant) uniform function_block { uint function; };

void main() {
    results[gl_GlobalInvocationID.x] =
        call_kernel(function, uniform_arguments[gl_WorkGroupID.x], arguments[gl_GlobalInvocationID.x]);
}
