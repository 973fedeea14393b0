// SPDX-License-Identifier: Apache-2.0
// One ray's question to a structure, and the tests against primitives that answer it.
#pragma once

#include <cstdint>
#include <limits>

#include "device/accel/line.h"
#include "device/accel/nearest.h"
#include "device/accel/primitives.h"
#include "kernel/rays.h"

namespace sundog::accel {

/// What it took to answer.
struct Steps {
    std::uint64_t visits = 0;  ///< Nodes, cells or boxes that were looked into.
    std::uint64_t tests = 0;   ///< Primitives that were tested.
};

/// What is asked of a ray.
struct Question {
    std::uint32_t kind = kernel::RAY_CAMERA;  ///< RAY_*: some geometries are hidden from some rays.
    bool culls = false;                       ///< Opaque surfaces are not seen from behind.
    bool one_sided = false;                   ///< The eye doesn't see MATERIAL_ONE_SIDED from behind.
    bool any = false;                         ///< Whether there is a hit, wherever it is, instead of the nearest.
};

/// A ray on its way through a structure over `primitives`. The structure calls test() for what the ray may hit, and
/// may end when reach() is behind it.
class Search {
public:
    /// `nearest` collects hits; `steps` is added to. Both, and the primitives, must outlive this.
    Search(const Primitives& primitives, const kernel::Ray& ray, Question question, Nearest& nearest, Steps& steps);

    [[nodiscard]] const Line& line() const { return line_; }
    [[nodiscard]] const kernel::Ray& ray() const { return ray_; }
    /// Hits beyond this don't matter any more; less than all t once done().
    [[nodiscard]] float reach() const { return blocked_ ? kNowhere : nearest_.reach(); }
    /// True when any hit was asked for and there is one.
    [[nodiscard]] bool done() const { return blocked_; }
    /// The stretch of the ray that still matters.
    [[nodiscard]] Interval range() const { return {ray_.t_min, reach()}; }

    /// Counts a node, cell or box.
    void visit() { ++steps_.visits; }
    /// Tests the item; where it is hit decides about reach(). The hit is moved into the item's box if rounding put it
    /// outside of it.
    void test(std::uint32_t item) { test(primitives_.item(item), primitives_.bounds(item)); }
    /// Tests an item that has no box.
    void test_endless(const Item& item);

private:
    static constexpr float kNowhere = -std::numeric_limits<float>::infinity();

    void test(const Item& item, const Bounds3& bounds);
    void test_within(const Item& item, Interval inside);
    bool hit_primitive(const Item& item, Found& found) const;
    bool hit_solid(const Item& item, Found& found) const;

    const Primitives& primitives_;
    kernel::Ray ray_;
    Line line_;
    Question question_;
    Nearest& nearest_;
    Steps& steps_;
    bool blocked_ = false;
};

}  // namespace sundog::accel
