// SPDX-License-Identifier: Apache-2.0
// A kd-tree: space is divided in two by planes across one axis at a time, where the surface area heuristic finds it
// cheapest (MacDonald and Booth, "Heuristics for Ray Tracing Using Space Subdivision", The Visual Computer 1990), which
// also cuts off empty space. A ray goes to the near side of each plane first (Kaplan 1985).
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "device/accel/reference_budget.h"
#include "device/accel/structure.h"

namespace sundog::accel {
namespace {

constexpr std::uint32_t kLeaf = 3;
constexpr std::uint32_t kMostLevels = 60;
/// Planes that are tried across each axis, the sides of what is in the cell included.
constexpr std::size_t kPlanes = 33;
/// What a visit to a node costs where a test of a primitive costs 1.
constexpr float kVisitCost = 0.7F;
/// Empty halves are worth more than their area says: a ray through them ends soon.
constexpr float kEmptyBonus = 0.8F;

float half_area(const Vec3& e) { return e.x * e.y + e.y * e.z + e.z * e.x; }

/// Where to divide a cell.
struct Plane {
    std::uint32_t axis = kLeaf;
    float place = 0;
};

class KdTree final : public Structure {
public:
    explicit KdTree(const Primitives& primitives) : primitives_(primitives), box_(primitives.total_bounds()) {
        std::vector<std::uint32_t> all(primitives.size());
        std::iota(all.begin(), all.end(), 0U);
        nodes_.emplace_back();
        // As in Pharr, Jakob and Humphreys, Physically Based Rendering (3rd edition), section 4.4.1.
        const auto levels = static_cast<std::uint32_t>(8 + 1.3 * std::log2(double{1} + primitives.size()));
        build(0, box_, all, std::min(levels, kMostLevels), ReferenceBudget::for_items(primitives.size()));
        nodes_.shrink_to_fit();
        items_.shrink_to_fit();
    }

    void walk(Search& search, Scratch& scratch) const override {
        const Line& line = search.line();
        scratch.mailboxes.begin(primitives_.size());
        // One far side for each level.
        std::array<Place, kMostLevels + 1> stack;
        std::size_t depth = 0;
        Place place{0, clip(box_, line, search.range())};
        while (true) {
            // What was put aside may have come to lie beyond the nearest hit.
            if (!place.inside.empty() && place.inside.enter <= search.reach()) {
                const Node* node = &nodes_[place.node];
                search.visit();
                while (node->axis != kLeaf) {
                    const float t = line.at(node->axis, node->plane);
                    const std::uint32_t lower_first = line.inverse[node->axis] > 0 ? 0 : 1;
                    const Place near{node->first + lower_first, {place.inside.enter, std::min(place.inside.leave, t)}};
                    const Place far{node->first + 1 - lower_first,
                                    {std::max(place.inside.enter, t), place.inside.leave}};
                    if (near.inside.empty()) {
                        place = far;
                    } else {
                        if (!far.inside.empty()) stack[depth++] = far;
                        place = near;
                    }
                    node = &nodes_[place.node];
                    search.visit();
                }
                for (std::uint32_t i = 0; i < node->count && !search.done(); ++i)
                    if (scratch.mailboxes.is_first(items_[node->first + i])) search.test(items_[node->first + i]);
            }
            if (depth == 0 || search.done()) return;
            place = stack[--depth];
        }
    }
    [[nodiscard]] std::size_t memory_bytes() const override {
        return nodes_.capacity() * sizeof(Node) + items_.capacity() * sizeof(std::uint32_t);
    }

private:
    struct Node {
        float plane = 0;
        std::uint32_t first = 0;  ///< Leaf: into items_; else the lower child, before the upper one.
        std::uint32_t count : 30 = 0;
        std::uint32_t axis : 2 = kLeaf;
    };
    struct Place {
        std::uint32_t node;
        Interval inside;
    };

    void build(std::uint32_t node, const Bounds3& cell, std::vector<std::uint32_t>& items, std::uint32_t levels,
               ReferenceBudget budget) {
        const Plane plane = levels > 0 ? cheapest_plane(cell, items) : Plane{};
        std::vector<std::uint32_t> lower, upper;
        if (plane.axis != kLeaf) {
            for (const std::uint32_t item : items) {
                if (primitives_.bounds(item).lower[plane.axis] <= plane.place) lower.push_back(item);
                if (primitives_.bounds(item).upper[plane.axis] >= plane.place) upper.push_back(item);
            }
        }
        const std::size_t copies = lower.size() + upper.size();
        if (plane.axis == kLeaf || !budget.affords(2, copies)) {
            nodes_[node].first = static_cast<std::uint32_t>(items_.size());
            nodes_[node].count = static_cast<std::uint32_t>(items.size());
            items_.insert(items_.end(), items.begin(), items.end());
            return;
        }
        items = {};  // frees what the levels below don't need
        const auto first = static_cast<std::uint32_t>(nodes_.size());
        nodes_.resize(nodes_.size() + 2);
        nodes_[node].plane = plane.place;
        nodes_[node].first = first;
        nodes_[node].axis = plane.axis;
        Bounds3 lower_cell = cell, upper_cell = cell;
        lower_cell.upper[plane.axis] = upper_cell.lower[plane.axis] = plane.place;
        const ReferenceBudget lower_budget = budget.share(2, lower.size(), copies);
        const ReferenceBudget upper_budget = budget.share(2, upper.size(), copies);
        build(first, lower_cell, lower, levels - 1, lower_budget);
        build(first + 1, upper_cell, upper, levels - 1, upper_budget);
    }

    /// The plane where a visit costs least by the heuristic; none where testing everything costs less.
    [[nodiscard]] Plane cheapest_plane(const Bounds3& cell, const std::vector<std::uint32_t>& items) const {
        Plane best;
        if (items.empty()) return best;
        const Vec3 extent = cell.extent();
        const float scale = 1 / std::max({extent.x, extent.y, extent.z, 1e-30F});  // no overflow of areas
        const float area = half_area(extent * scale);
        auto best_cost = static_cast<float>(items.size());
        for (std::uint32_t axis = 0; axis < 3; ++axis) {
            const Planes planes(primitives_, cell, items, axis);
            for (std::size_t i = 0; i < kPlanes; ++i) {
                const float place = planes.place[i];
                if (!(place > cell.lower[axis] && place < cell.upper[axis])) continue;
                Vec3 lower = extent * scale, upper = lower;
                lower[axis] = (place - cell.lower[axis]) * scale;
                upper[axis] = (cell.upper[axis] - place) * scale;
                const bool empty = planes.lower_count[i] == 0 || planes.upper_count[i] == 0;
                const float tests = (half_area(lower) * static_cast<float>(planes.lower_count[i]) +
                                     half_area(upper) * static_cast<float>(planes.upper_count[i])) /
                                    area;
                const float cost = kVisitCost + (empty ? kEmptyBonus : 1.0F) * tests;
                if (cost < best_cost) {
                    best_cost = cost;
                    best = {axis, place};
                }
            }
        }
        return best;
    }

    /// Evenly spaced planes from one end of what is in the cell to the other, and how many items would be on each side
    /// (about: bins round). The first and the last plane stand just off all items.
    struct Planes {
        std::array<float, kPlanes> place;
        std::array<std::uint32_t, kPlanes> lower_count{}, upper_count{};

        Planes(const Primitives& primitives, const Bounds3& cell, const std::vector<std::uint32_t>& items,
               std::uint32_t axis) {
            constexpr float kInfinity = std::numeric_limits<float>::infinity();
            float from = kInfinity, to = -kInfinity;
            for (const std::uint32_t item : items) {
                from = std::min(from, primitives.bounds(item).lower[axis]);
                to = std::max(to, primitives.bounds(item).upper[axis]);
            }
            from = std::max(from, cell.lower[axis]);
            to = std::min(to, cell.upper[axis]);
            const float step = (to - from) / static_cast<float>(kPlanes - 1);
            for (std::size_t i = 0; i < kPlanes; ++i) place[i] = from + step * static_cast<float>(i);
            place.front() = std::nextafter(from, -kInfinity);
            place.back() = std::nextafter(to, kInfinity);
            const auto bin = [&](float at, float rounding) {
                const float position = step > 0 ? (at - from) / step + rounding : 0.0F;
                return static_cast<std::size_t>(std::clamp(position, 0.0F, static_cast<float>(kPlanes - 1)));
            };
            for (const std::uint32_t item : items) {
                const Bounds3& box = primitives.bounds(item);
                ++lower_count[std::max<std::size_t>(bin(box.lower[axis], 0.999F), 1)];
                ++upper_count[std::min(bin(box.upper[axis], 0), kPlanes - 2)];
            }
            std::partial_sum(lower_count.begin(), lower_count.end(), lower_count.begin());
            std::partial_sum(upper_count.rbegin(), upper_count.rend(), upper_count.rbegin());
        }
    };

    const Primitives& primitives_;
    Bounds3 box_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> items_;
};

}  // namespace

std::unique_ptr<Structure> make_kd_tree(const Primitives& primitives) { return std::make_unique<KdTree>(primitives); }

}  // namespace sundog::accel
