// SPDX-License-Identifier: Apache-2.0
// Boxes cut into cells, of which is found out once, when a ray first comes by, whether anything may be in them. What is
// found doesn't depend on who asks or when: rays meet the same cells in whatever order they come.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "solids/bounds.h"

namespace sundog::solids {

class LazyCells {
public:
    /// Cells on each side of a box; they are found out about in groups of 2 by 2 by 2 first.
    static constexpr std::uint32_t kSide = 4;

    LazyCells() = default;
    explicit LazyCells(std::size_t boxes) : boxes_(std::make_unique<Cells[]>(boxes)) {}

    /// Calls add(part) for the parts of `within` that lie in cells of a box in which something may be, from the first
    /// to the last. `within` is where the ray is in the box; may_hold(cell) tells of a box, at any time the same.
    template <class MayHold, class Add>
    void along(std::size_t number, const Bounds3d& box, const Ray& ray, Range within, const MayHold& may_hold,
               const Add& add) const {
        const Vec3d cell = (box.upper - box.lower) * (1.0 / kSide);
        // Where the ray passes from cell to cell.
        std::array<double, 3 * (kSide - 1) + 1> ends;
        std::size_t count = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double per_direction = 1 / ray.direction[axis];
            for (std::uint32_t k = 1; k < kSide; ++k) {
                const double t = (box.lower[axis] + k * cell[axis] - ray.origin[axis]) * per_direction;
                if (t > within.lower && t < within.upper) ends[count++] = t;
            }
        }
        std::sort(ends.begin(), ends.begin() + count);
        ends[count++] = within.upper;
        double begin = within.lower;
        for (std::size_t i = 0; i < count; ++i) {
            const Vec3d middle = ray.at(0.5 * (begin + ends[i]));
            std::array<std::uint32_t, 3> at{};
            for (std::size_t axis = 0; axis < 3; ++axis)
                at[axis] = static_cast<std::uint32_t>(
                    std::clamp((middle[axis] - box.lower[axis]) / cell[axis], 0.0, kSide - 1.0));
            if (is_open(boxes_[number], box.lower, cell, at, may_hold)) add(Range{begin, ends[i]});
            begin = ends[i];
        }
    }

private:
    /// A bit for each group and cell: whether it is known, and if so whether something may be there. The latter is
    /// written first.
    struct Cells {
        std::atomic<std::uint8_t> known_groups{0}, open_groups{0};
        std::atomic<std::uint64_t> known{0}, open{0};
    };
    using At = std::array<std::uint32_t, 3>;

    static std::uint64_t bit_of(const At& c) { return std::uint64_t{1} << ((c[2] * kSide + c[1]) * kSide + c[0]); }

    template <class MayHold>
    static bool is_open(Cells& cells, Vec3d lower, Vec3d size, const At& at, const MayHold& may_hold) {
        const std::uint64_t bit = bit_of(at);
        if ((cells.known.load(std::memory_order_acquire) & bit) != 0)
            return (cells.open.load(std::memory_order_relaxed) & bit) != 0;
        const auto box = [&](const At& first, std::uint32_t side) {
            Bounds3d b;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                b.lower[axis] = lower[axis] + first[axis] * size[axis];
                b.upper[axis] = lower[axis] + (first[axis] + side) * size[axis];
            }
            return padded(b);
        };
        const At group{at[0] / 2, at[1] / 2, at[2] / 2};
        const auto group_bit = static_cast<std::uint8_t>(1U << ((group[2] * 2 + group[1]) * 2 + group[0]));
        if ((cells.known_groups.load(std::memory_order_acquire) & group_bit) == 0) {
            if (may_hold(box({2 * group[0], 2 * group[1], 2 * group[2]}, 2)))
                cells.open_groups.fetch_or(group_bit, std::memory_order_relaxed);
            cells.known_groups.fetch_or(group_bit, std::memory_order_release);
        }
        const bool open = (cells.open_groups.load(std::memory_order_relaxed) & group_bit) != 0 && may_hold(box(at, 1));
        if (open) cells.open.fetch_or(bit, std::memory_order_relaxed);
        cells.known.fetch_or(bit, std::memory_order_release);
        return open;
    }

    std::unique_ptr<Cells[]> boxes_;  // NOLINT(modernize-avoid-c-arrays): atomics can't be moved into a vector
};

}  // namespace sundog::solids
