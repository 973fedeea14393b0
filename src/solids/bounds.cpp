// SPDX-License-Identifier: Apache-2.0
#include "solids/bounds.h"

#include <algorithm>
#include <cmath>

namespace sundog::solids {

Bounds3d joined(const Bounds3d& a, const Bounds3d& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    Bounds3d out = a;
    out.include(b.lower);
    out.include(b.upper);
    return out;
}

Bounds3d common(const Bounds3d& a, const Bounds3d& b) {
    Bounds3d out;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        out.lower[axis] = std::max(a.lower[axis], b.lower[axis]);
        out.upper[axis] = std::min(a.upper[axis], b.upper[axis]);
        if (!(out.lower[axis] <= out.upper[axis])) return {};
    }
    return out;
}

Bounds3d transformed(const Affine3d& m, const Bounds3d& b) {
    if (b.empty()) return b;
    Bounds3d out{m.t, m.t};
    for (std::size_t to = 0; to < 3; ++to) {
        for (std::size_t from = 0; from < 3; ++from) {
            const double factor = (from == 0 ? m.x : from == 1 ? m.y : m.z)[to];
            if (factor == 0) continue;  // 0 * infinity has no value
            const double low = factor * b.lower[from];
            const double high = factor * b.upper[from];
            out.lower[to] += std::min(low, high);
            out.upper[to] += std::max(low, high);
        }
    }
    return out;
}

Bounds3d padded(const Bounds3d& b) {
    if (b.empty()) return b;
    Bounds3d out = b;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto reach = [](double v) { return std::isfinite(v) ? std::abs(v) : 0.0; };
        const double pad = 1e-9 * (reach(b.lower[axis]) + reach(b.upper[axis])) + 1e-30;
        out.lower[axis] -= pad;
        out.upper[axis] += pad;
    }
    return out;
}

}  // namespace sundog::solids
