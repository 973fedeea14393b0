// SPDX-License-Identifier: Apache-2.0
// Compiled once for each width (SUNDOG_KERNEL_LANES); call_lanes_N is the name of the function here.
#include "call_lanes.h"

#include "device/cpu/tile_kernel.h"
#include "parity/kernel_calls.h"

namespace sundog::parity {
namespace {

using namespace kernel;

#if SUNDOG_KERNEL_LANES == 1
constexpr std::size_t kWidth = 1;
float& lane_of(real& value, std::size_t) { return value; }
#else
constexpr std::size_t kWidth = kLanes;
auto& lane_of(real& value, std::size_t lane) { return reinterpret_cast<std::array<float, kLanes>&>(value.v)[lane]; }
#endif

}  // namespace

void SUNDOG_KERNEL_PASTE(call_lanes_, ,
                         SUNDOG_KERNEL_LANES)(const RenderScene& render_scene, const Frame& frame,
                                              std::uint32_t function, std::span<const UniformValues> uniforms,
                                              std::span<const CallValues> arguments, std::span<CallValues> results) {
    const SceneView scene = cpu::view_of(render_scene, frame, nullptr);
    for (std::size_t first = 0; first < arguments.size(); first += kWidth) {
        Varying values;
        for (std::size_t lane = 0; lane < kWidth; ++lane) {
            for (std::size_t i = 0; i < CALL_VALUES; ++i) lane_of(values.v[i], lane) = arguments[first + lane][i];
        }
        values = call_kernel(scene, function, uniforms[first / CALL_BATCH], values);
        for (std::size_t lane = 0; lane < kWidth; ++lane) {
            for (std::size_t i = 0; i < CALL_VALUES; ++i) results[first + lane][i] = lane_of(values.v[i], lane);
        }
    }
}

}  // namespace sundog::parity
