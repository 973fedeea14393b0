// SPDX-License-Identifier: Apache-2.0
// Packets of random rays for tests of callbacks.
#pragma once

#include <array>
#include <cmath>
#include <random>

#include "device/cpu/embree.h"

namespace sundog::cpu {

enum class Aim { anywhere, at_the_middle };

/// A packet in Embree's layout, its rays from within a cube of side 4. Some run along axes, some end early, some lanes
/// don't ask, and some rays see other geometries.
template <class Packet, unsigned N>
struct Rays {
    alignas(64) Packet packet{};
    alignas(64) std::array<int, N> valid{};

    Rays(std::mt19937& random, Aim aim) {
        std::uniform_real_distribution<float> number(-2, 2);
        const bool at_middle = aim == Aim::at_the_middle;
        auto& ray = packet.ray;
        const auto toward = [&](float origin) { return at_middle ? 0.3F * number(random) - origin : number(random); };
        for (unsigned i = 0; i < N; ++i) {
            ray.org_x[i] = number(random), ray.org_y[i] = number(random), ray.org_z[i] = number(random);
            ray.dir_x[i] = toward(ray.org_x[i]);
            ray.dir_y[i] = at_middle && i % 5 == 1 ? 0 : toward(ray.org_y[i]);
            ray.dir_z[i] = i % 5 == 0 ? 0 : toward(ray.org_z[i]);
            if (at_middle && i % 16 == 9) ray.dir_x[i] = ray.dir_z[i] = 0;
            ray.tnear[i] = at_middle && i % 4 == 0 ? 0.25F : 0;
            ray.tfar[i] = i % 3 == 0 ? 1.5F : INFINITY;
            ray.mask[i] = i % 7 == 3 ? 1U : 3U;
            valid[i] = i % 6 == 5 ? 0 : -1;
            packet.hit.geomID[i] = packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
        }
    }
};

}  // namespace sundog::cpu
