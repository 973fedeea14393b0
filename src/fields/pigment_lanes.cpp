// SPDX-License-Identifier: Apache-2.0
// Compiled once for each width (SUNDOG_KERNEL_LANES); pigment_colors_N is the name of the function here.
#include "fields/pigment_lanes.h"

#include <algorithm>

#include "kernel/patterns/program.h"

namespace sundog::fields {
namespace {

using Lanes = std::array<float, kernel::kLanes>;

kernel::real real_of(const Lanes& lanes) { return kernel::real(reinterpret_cast<const kernel::vfloat&>(lanes)); }

}  // namespace

void SUNDOG_KERNEL_PASTE(pigment_colors_, , SUNDOG_KERNEL_LANES)(const kernel::SceneView& view, std::uint32_t start,
                                                                 std::span<const kernel::vec3> points,
                                                                 std::span<std::array<float, 5>> colors) {
    constexpr std::size_t kWidth = kernel::kLanes;
    for (std::size_t first = 0; first < points.size(); first += kWidth) {
        const std::size_t size = std::min(kWidth, points.size() - first);
        alignas(64) Lanes x, y, z;
        for (std::size_t lane = 0; lane < kWidth; ++lane) {
            const kernel::vec3& p = points[first + std::min(lane, size - 1)];
            x[lane] = p.x, y[lane] = p.y, z[lane] = p.z;
        }
        const kernel::PigmentColor c =
            kernel::run_program(view, start, kernel::real3(real_of(x), real_of(y), real_of(z)));
        for (std::size_t lane = 0; lane < size; ++lane)
            colors[first + lane] = {c.rgb.x.v[lane], c.rgb.y.v[lane], c.rgb.z.v[lane], c.filtered.v[lane],
                                    c.transmitted.v[lane]};
    }
}

}  // namespace sundog::fields
