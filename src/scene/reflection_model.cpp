// SPDX-License-Identifier: Apache-2.0
#include "scene/reflection_model.h"

#include <array>

namespace sundog::scene {

std::span<const Metal> metals() {
    static constexpr std::array<Metal, 8> kMetals{{
        {"aluminium", {1.043F, 0.786F, 0.525F}, {6.477F, 5.841F, 4.932F}},
        {"chromium", {3.179F, 3.180F, 2.447F}, {3.300F, 3.330F, 3.205F}},
        {"copper", {0.367F, 1.016F, 1.246F}, {3.121F, 2.579F, 2.452F}},
        {"gold", {0.223F, 0.430F, 1.335F}, {3.204F, 2.460F, 1.872F}},
        {"iron", {2.890F, 2.950F, 2.642F}, {3.040F, 2.930F, 2.803F}},
        {"nickel", {1.985F, 1.920F, 1.763F}, {3.982F, 3.610F, 3.041F}},
        {"silver", {0.058F, 0.060F, 0.046F}, {4.103F, 3.589F, 2.792F}},
        {"titanium", {2.658F, 2.540F, 2.303F}, {3.696F, 3.430F, 3.079F}},
    }};
    return kMetals;
}

}  // namespace sundog::scene
