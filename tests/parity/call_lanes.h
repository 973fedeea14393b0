// SPDX-License-Identifier: Apache-2.0
// kernel_calls.h compiled for each number of lanes.
#pragma once

#include <array>
#include <span>

#include "device/render_scene.h"
#include "parity/call_numbers.h"

namespace sundog::parity {

/// Arguments or results of one call.
using CallValues = std::array<float, kernel::CALL_VALUES>;

/// Calls `function` for each of `arguments` (a multiple of CALL_BATCH; uniforms: one for each batch).
using CallLanes = void (*)(const RenderScene& scene, const Frame& frame, std::uint32_t function,
                           std::span<const kernel::UniformValues> uniforms, std::span<const CallValues> arguments,
                           std::span<CallValues> results);

void call_lanes_1(const RenderScene&, const Frame&, std::uint32_t, std::span<const kernel::UniformValues>,
                  std::span<const CallValues>, std::span<CallValues>);
void call_lanes_4(const RenderScene&, const Frame&, std::uint32_t, std::span<const kernel::UniformValues>,
                  std::span<const CallValues>, std::span<CallValues>);
void call_lanes_8(const RenderScene&, const Frame&, std::uint32_t, std::span<const kernel::UniformValues>,
                  std::span<const CallValues>, std::span<CallValues>);
void call_lanes_16(const RenderScene&, const Frame&, std::uint32_t, std::span<const kernel::UniformValues>,
                   std::span<const CallValues>, std::span<CallValues>);

}  // namespace sundog::parity
