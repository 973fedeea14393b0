// SPDX-License-Identifier: Apache-2.0
// A uniform grid, walked cell by cell (Amanatides and Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing",
// Eurographics 1987). A hit beyond the current cell doesn't end the walk yet: something nearer may lie in the cells
// between; and an item that reaches into many cells is tested once a ray.
//
// Unlike in the paper, where the ray passes a wall between cells is computed from the wall's place, not added up, so
// that rounding doesn't pile up; and where it passes several at once (through an edge or corner of a cell, or in cells
// too small for its numbers to tell apart) all cells that meet there are visited.
#include <algorithm>
#include <array>
#include <cmath>

#include "device/accel/structure.h"

namespace sundog::accel {
namespace {

/// Cells for each item, about (Wald et al., "Ray Tracing Animated Scenes using Coherent Grid Traversal", SIGGRAPH
/// 2006).
constexpr double kCellsPerItem = 5;
constexpr double kMostCells = 1U << 26U;
/// Places in cells for each item at most; a grid that would take more gets fewer cells.
constexpr std::uint64_t kMostPlacesPerItem = 24;

using Cell = std::array<std::uint32_t, 3>;

/// Cells from `first` to `last`, both included.
struct Block {
    Cell first, last;
};

class Grid final : public Structure {
public:
    explicit Grid(const Primitives& primitives)
        : box_(primitives.total_bounds()), item_count_(primitives.size()), cells_(resolution()) {
        while (places_needed(primitives) > kMostPlacesPerItem * item_count_)
            for (std::uint32_t& n : cells_) n = (n + 1) / 2;
        fill(primitives);
    }

    void walk(Search& search, Scratch& scratch) const override {
        const Line& line = search.line();
        const Interval inside = clip(box_, line, search.range());
        if (inside.empty()) return;
        scratch.mailboxes.begin(item_count_);
        Way way{*this, line, {}};
        Block block;
        for (std::size_t axis = 0; axis < 3; ++axis) block.first[axis] = way.first_cell(axis, inside.enter);
        block.last = block.first;
        for (std::size_t axis = 0; axis < 3; ++axis)
            while (block.last[axis] + 1 < cells_[axis] && way.enters(axis, block.last[axis] + 1) <= inside.enter)
                ++block.last[axis];
        visit(way, block, search, scratch);
        way.cell = block.last;
        while (true) {
            const float t = std::min({way.leaves(0), way.leaves(1), way.leaves(2)});
            if (t > search.reach()) return;
            block.first = way.cell;
            bool ends = false;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                while (way.leaves(axis) <= t && way.cell[axis] + 1 < cells_[axis]) ++way.cell[axis];
                ends = ends || way.leaves(axis) <= t;
            }
            block.last = way.cell;
            if (block.first != block.last) visit(way, block, search, scratch, true);
            if (ends) return;
        }
    }
    [[nodiscard]] std::size_t memory_bytes() const override {
        return (starts_.capacity() + items_.capacity()) * sizeof(std::uint32_t);
    }

private:
    /// A ray's way through the grid. It counts cells as it comes to them, so that all its steps are forward.
    struct Way {
        const Grid& grid;
        const Line& line;
        Cell cell;

        [[nodiscard]] bool forward(std::size_t axis) const { return line.inverse[axis] > 0; }
        /// The grid's own count of the ray's cell `i`.
        [[nodiscard]] std::uint32_t own(std::size_t axis, std::uint32_t i) const {
            return forward(axis) ? i : grid.cells_[axis] - 1 - i;
        }
        /// Where it passes the wall before cell `i`, and that behind it.
        [[nodiscard]] float enters(std::size_t axis, std::uint32_t i) const {
            return line.at(axis, grid.wall(axis, forward(axis) ? i : grid.cells_[axis] - i));
        }
        [[nodiscard]] float leaves(std::size_t axis, std::uint32_t i) const { return enters(axis, i + 1); }
        [[nodiscard]] float leaves(std::size_t axis) const { return leaves(axis, cell[axis]); }
        /// The first cell that it hasn't left before `t`.
        [[nodiscard]] std::uint32_t first_cell(std::size_t axis, float t) const {
            std::uint32_t low = 0, high = grid.cells_[axis] - 1;
            while (low < high) {
                const std::uint32_t middle = (low + high) / 2;
                if (leaves(axis, middle) < t) low = middle + 1;
                else high = middle;
            }
            return low;
        }
    };

    /// Where the wall before cell `i` stands; the last one is the box's side.
    [[nodiscard]] float wall(std::size_t axis, std::uint32_t i) const {
        if (i == cells_[axis]) return box_.upper[axis];
        const float width = (box_.upper[axis] - box_.lower[axis]) / static_cast<float>(cells_[axis]);
        return std::min(box_.lower[axis] + width * static_cast<float>(i), box_.upper[axis]);
    }

    /// About cubes, kCellsPerItem for each item; flat scenes get a flat grid.
    [[nodiscard]] Cell resolution() const {
        const Vec3 extent = box_.extent();
        const double wanted = std::min(kCellsPerItem * item_count_, kMostCells);
        const double largest = std::max({extent.x, extent.y, extent.z, 1e-30F});
        // The side of a cell: found by halving, since axes with less than one cell still count as one.
        double low = largest / wanted, high = largest;
        const auto count = [&](double side) {
            double n = 1;
            for (std::size_t axis = 0; axis < 3; ++axis) n *= std::max(1.0, std::floor(extent[axis] / side));
            return n;
        };
        for (int i = 0; i < 60 && high > low * 1.001; ++i) {
            const double middle = std::sqrt(low * high);
            (count(middle) > wanted ? low : high) = middle;
        }
        Cell cells;
        for (std::size_t axis = 0; axis < 3; ++axis)
            cells[axis] = static_cast<std::uint32_t>(std::max(1.0, std::floor(extent[axis] / high)));
        return cells;
    }

    /// Which cells an item's box touches.
    [[nodiscard]] Block cells_of(const Bounds3& box) const {
        Block block;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::uint32_t n = cells_[axis];
            const auto cell_at = [&](float place) {
                const float width = (box_.upper[axis] - box_.lower[axis]) / static_cast<float>(n);
                const float cell = width > 0 ? (place - box_.lower[axis]) / width : 0.0F;
                return std::min(static_cast<std::uint32_t>(std::clamp(cell, 0.0F, 1e9F)), n - 1);
            };
            std::uint32_t first = cell_at(box.lower[axis]), last = cell_at(box.upper[axis]);
            // As the walls stand, not as the division rounds.
            while (first > 0 && wall(axis, first) >= box.lower[axis]) --first;
            while (first + 1 < n && wall(axis, first + 1) < box.lower[axis]) ++first;
            while (last + 1 < n && wall(axis, last + 1) <= box.upper[axis]) ++last;
            while (last > 0 && wall(axis, last) > box.upper[axis]) --last;
            block.first[axis] = first, block.last[axis] = std::max(first, last);
        }
        return block;
    }

    template <class Visit>
    static void for_each_cell(const Block& block, const Visit& visit) {
        for (std::uint32_t z = block.first[2]; z <= block.last[2]; ++z)
            for (std::uint32_t y = block.first[1]; y <= block.last[1]; ++y)
                for (std::uint32_t x = block.first[0]; x <= block.last[0]; ++x) visit(Cell{x, y, z});
    }

    [[nodiscard]] std::size_t index_of(const Cell& c) const {
        return (std::size_t{c[2]} * cells_[1] + c[1]) * cells_[0] + c[0];
    }

    [[nodiscard]] std::uint64_t places_needed(const Primitives& primitives) const {
        std::uint64_t places = 0;
        for (const Bounds3& box : primitives.bounds()) {
            const Block b = cells_of(box);
            places +=
                std::uint64_t{b.last[0] - b.first[0] + 1} * (b.last[1] - b.first[1] + 1) * (b.last[2] - b.first[2] + 1);
        }
        return places;
    }

    void fill(const Primitives& primitives) {
        starts_.assign(std::size_t{cells_[0]} * cells_[1] * cells_[2] + 1, 0);
        for (const Bounds3& box : primitives.bounds())
            for_each_cell(cells_of(box), [&](const Cell& c) { ++starts_[index_of(c) + 1]; });
        for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
        items_.resize(starts_.back());
        // Filled from the back, each cell's start moves down from its end to where it belongs.
        for (std::size_t i = 0; i + 1 < starts_.size(); ++i) starts_[i] = starts_[i + 1];
        for (std::uint32_t item = item_count_; item-- > 0;)
            for_each_cell(cells_of(primitives.bounds(item)),
                          [&](const Cell& c) { items_[--starts_[index_of(c)]] = item; });
    }

    /// Tests what is in the block's cells, but in the first one if that was visited before.
    void visit(const Way& way, const Block& block, Search& search, Scratch& scratch, bool but_first = false) const {
        for_each_cell(block, [&](const Cell& c) {
            if (search.done() || (but_first && c == block.first)) return;
            search.visit();
            const std::size_t cell = index_of({way.own(0, c[0]), way.own(1, c[1]), way.own(2, c[2])});
            for (std::uint32_t i = starts_[cell]; i < starts_[cell + 1] && !search.done(); ++i)
                if (scratch.mailboxes.is_first(items_[i])) search.test(items_[i]);
        });
    }

    Bounds3 box_;
    std::uint32_t item_count_;
    Cell cells_;                         ///< How many along each axis.
    std::vector<std::uint32_t> starts_;  ///< Of each cell's items in items_, and the end of the last.
    std::vector<std::uint32_t> items_;
};

}  // namespace

std::unique_ptr<Structure> make_grid(const Primitives& primitives) { return std::make_unique<Grid>(primitives); }

}  // namespace sundog::accel
