// SPDX-License-Identifier: Apache-2.0
// An octree (Glassner, "Space Subdivision for Fast Ray Tracing", IEEE Computer Graphics and Applications 1984): a cube
// around everything; a cell with too much in it is divided into eight, as often as it takes. A ray visits the cells
// that it passes from near to far.
#include <array>
#include <numeric>

#include "device/accel/reference_budget.h"
#include "device/accel/structure.h"

namespace sundog::accel {
namespace {

/// Cells with no more than this are not divided.
constexpr std::size_t kFewItems = 6;
/// Divisions from the whole down to the smallest cell.
constexpr std::uint32_t kMostLevels = 18;
/// Dividing must not make more places for items than this times what there were: else they overlap, or are as large as
/// the cell.
constexpr std::size_t kMostCopies = 3;

bool overlap(const Bounds3& a, const Bounds3& b) {
    return a.lower.x <= b.upper.x && a.upper.x >= b.lower.x && a.lower.y <= b.upper.y && a.upper.y >= b.lower.y &&
           a.lower.z <= b.upper.z && a.upper.z >= b.lower.z;
}

/// Bit 0 of `which`: the upper half in x; bits 1 and 2 in y and z.
Bounds3 eighth(const Bounds3& cell, std::uint32_t which) {
    const Vec3 middle = cell.lower * 0.5F + cell.upper * 0.5F;
    Bounds3 part;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool upper = ((which >> axis) & 1U) != 0;
        part.lower[axis] = upper ? middle[axis] : cell.lower[axis];
        part.upper[axis] = upper ? cell.upper[axis] : middle[axis];
    }
    return part;
}

class Octree final : public Structure {
public:
    explicit Octree(const Primitives& primitives) : primitives_(primitives), box_(cube(primitives.total_bounds())) {
        std::vector<std::uint32_t> all(primitives.size());
        std::iota(all.begin(), all.end(), 0U);
        nodes_.emplace_back();
        build(0, box_, all, 0, ReferenceBudget::for_items(primitives.size()));
        nodes_.shrink_to_fit();
        items_.shrink_to_fit();
    }

    void walk(Search& search, Scratch& scratch) const override {
        const Line& line = search.line();
        scratch.mailboxes.begin(primitives_.size());
        // Bits by which the ray's own order of eighths, from near to far, differs from theirs.
        const std::uint32_t mirrored =
            (line.inverse.x < 0 ? 1U : 0U) | (line.inverse.y < 0 ? 2U : 0U) | (line.inverse.z < 0 ? 4U : 0U);
        // Each level adds eight cells and takes one.
        std::array<Place, 7 * kMostLevels + 8> stack;
        std::size_t depth = 0;
        stack[depth++] = {0, box_};
        while (depth > 0) {
            const Place place = stack[--depth];
            if (clip(place.cell, line, search.range()).empty()) continue;
            search.visit();
            const Node& node = nodes_[place.node];
            if (node.is_leaf) {
                for (std::uint32_t i = 0; i < node.count && !search.done(); ++i)
                    if (scratch.mailboxes.is_first(items_[node.first + i])) search.test(items_[node.first + i]);
                if (search.done()) return;
                continue;
            }
            for (std::uint32_t i = 8; i-- > 0;) {  // the nearest is put on top
                const std::uint32_t which = i ^ mirrored;
                const Node& child = nodes_[node.first + which];
                if (!child.is_leaf || child.count > 0) stack[depth++] = {node.first + which, eighth(place.cell, which)};
            }
        }
    }
    [[nodiscard]] std::size_t memory_bytes() const override {
        return nodes_.capacity() * sizeof(Node) + items_.capacity() * sizeof(std::uint32_t);
    }

private:
    struct Node {
        std::uint32_t first = 0;  ///< Leaf: into items_; else the first of eight children.
        std::uint32_t count : 31 = 0;
        std::uint32_t is_leaf : 1 = 1;
    };
    struct Place {
        std::uint32_t node;
        Bounds3 cell;
    };

    static Bounds3 cube(Bounds3 box) {
        const Vec3 extent = box.extent();
        const float side = std::max({extent.x, extent.y, extent.z});
        box.upper = max(box.upper, box.lower + Vec3{side, side, side});
        return box;
    }

    void build(std::uint32_t node, const Bounds3& cell, std::vector<std::uint32_t>& items, std::uint32_t level,
               ReferenceBudget budget) {
        std::array<std::vector<std::uint32_t>, 8> parts;
        std::size_t copies = 0;
        bool divides = items.size() > kFewItems && level < kMostLevels;
        for (std::uint32_t which = 0; which < 8 && divides; ++which) {
            const Bounds3 part = eighth(cell, which);
            for (const std::uint32_t item : items)
                if (overlap(part, primitives_.bounds(item))) parts[which].push_back(item);
            copies += parts[which].size();
            divides = copies <= kMostCopies * items.size();
        }
        if (!divides || !budget.affords(8, copies)) {
            nodes_[node].first = static_cast<std::uint32_t>(items_.size());
            nodes_[node].count = static_cast<std::uint32_t>(items.size());
            items_.insert(items_.end(), items.begin(), items.end());
            return;
        }
        items = {};  // frees what the levels below don't need
        const auto first = static_cast<std::uint32_t>(nodes_.size());
        nodes_[node].first = first;
        nodes_[node].is_leaf = 0;
        nodes_.resize(nodes_.size() + 8);
        for (std::uint32_t which = 0; which < 8; ++which)
            build(first + which, eighth(cell, which), parts[which], level + 1,
                  budget.share(8, parts[which].size(), copies));
    }

    const Primitives& primitives_;
    Bounds3 box_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> items_;
};

}  // namespace

std::unique_ptr<Structure> make_octree(const Primitives& primitives) { return std::make_unique<Octree>(primitives); }

}  // namespace sundog::accel
