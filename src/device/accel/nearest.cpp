// SPDX-License-Identifier: Apache-2.0
#include "device/accel/nearest.h"

#include <algorithm>
#include <tuple>

#include "device/accel/primitive_tests.h"

namespace sundog::accel {
namespace {

bool comes_before(const Found& a, const Found& b) {
    return std::tuple(!a.leaves, a.geometry, a.primitive) < std::tuple(!b.leaves, b.geometry, b.primitive);
}

}  // namespace

void Nearest::enter(const Found& hit) {
    if (!(hit.t <= reach_)) return;
    const auto begin = hits_.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(count_);
    const auto beats_it = [&](const Found& other) { return other.t <= hit.t && !comes_before(hit, other); };
    if (std::any_of(begin, end, beats_it)) return;
    reach_ = std::min(reach_, hit.t * (1 + kCoincident));
    const auto is_useless = [&](const Found& other) {
        return other.t > reach_ || (other.t >= hit.t && comes_before(hit, other));
    };
    const auto kept = std::remove_if(begin, end, is_useless);
    const auto place = std::find_if(begin, kept, [&](const Found& other) { return other.t > hit.t; });
    std::move_backward(place, kept, kept + 1);
    *place = hit;
    count_ = static_cast<std::size_t>(kept + 1 - begin);
}

}  // namespace sundog::accel
