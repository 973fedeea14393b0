// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>

#include "solids/shape.h"

namespace sundog::solids {
namespace {

constexpr std::uint32_t kNoCell = 0xffffffffU;

/// Least and greatest height of squares of cells; level k's squares are 2^k cells wide.
struct Level {
    std::uint32_t columns = 0, rows = 0;
    std::vector<std::array<float, 2>> extent;
};

// Solid from the water level up to the triangles between the pixels' heights, without walls or a bottom to be seen.
// Along a ray, its height over the ground is linear in each triangle: the ray is followed from one border to the next.
class HeightField final : public Shape {
public:
    explicit HeightField(const scene::HeightField& f)
        : columns_(f.width - 1), rows_(f.height - 1), heights_(f.heights), smooth_(f.smooth), water_(f.water_level) {
        Level level{columns_, rows_, {}};
        level.extent.resize(std::size_t{columns_} * rows_);
        for (std::uint32_t row = 0; row < rows_; ++row) {
            for (std::uint32_t column = 0; column < columns_; ++column) {
                const std::array<double, 4> h{height(column, row), height(column + 1, row), height(column, row + 1),
                                              height(column + 1, row + 1)};
                level.extent[std::size_t{row} * columns_ + column] = {
                    static_cast<float>(*std::min_element(h.begin(), h.end())),
                    static_cast<float>(*std::max_element(h.begin(), h.end()))};
            }
        }
        levels_.push_back(std::move(level));
        while (levels_.back().columns > 1 || levels_.back().rows > 1) levels_.push_back(coarser(levels_.back()));
        const std::array<float, 2> all = levels_.back().extent[0];
        box_ = {{0, std::min<double>(all[0], water_), 0}, {1, std::max<double>(all[1], water_), 1}};
        box_.lower.y = std::max(box_.lower.y, water_);
        margin_ = 1e-6 * (1 + std::abs(box_.upper.y));
        box_.lower.y -= margin_;
    }

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        return walk_along(ray, range, out, false);
    }
    bool first_crossing(const Ray& ray, Range range, CrossingList& out) const override {
        return walk_along(ray, range, out, true);
    }
    bool walk_along(const Ray& ray, Range range, CrossingList& out, bool only_first) const {
        // Over the ground square, above the water: its walls and its bottom are open, and its top is in the air. Ground
        // that is level with the water is seen from both sides.
        const Bounds3d column{{0, water_ - margin_, 0}, {1, box_.upper.y + margin_, 1}};
        const Range within = clip(column, ray, {-kInfinity, kInfinity});
        if (!(within.lower < within.upper) || within.upper <= range.lower || within.lower >= range.upper) return false;
        Walk walk{ray, range, within, out, 1 / ray.direction.x, 1 / ray.direction.z, only_first};
        // From the smallest square that holds all of the way.
        const Vec3d from = ray.at(within.lower);
        const Vec3d to = ray.at(within.upper);
        const std::array<std::uint32_t, 2> first = cell_at(from);
        const std::array<std::uint32_t, 2> last = cell_at(to);
        const auto level = static_cast<std::uint32_t>(std::bit_width((first[0] ^ last[0]) | (first[1] ^ last[1])));
        visit(level, first[0] >> level, first[1] >> level, within, {from.y, to.y}, walk);
        if (walk.below && !walk.done) walk.toggle({within.upper, 0, 0, kNoCell, true, false});
        return walk.starts_inside;
    }
    [[nodiscard]] bool inside(Vec3d p) const override {
        return p.y > water_ && p.x >= 0 && p.x <= 1 && p.z >= 0 && p.z <= 1 && p.y < height_at(p.x, p.z);
    }
    [[nodiscard]] Vec3d normal(Vec3d p, const Crossing& c) const override {
        if (c.part == kNoCell) return {0, 1, 0};
        const auto [column, row, u, v, right] = place_in_cell(p, c.part);
        if (!smooth_) return triangle_normal(column, row, right);
        // Between the normals of the triangle's corners, as between its heights.
        return blend(vertex_normal(column, row), vertex_normal(column + 1, row), vertex_normal(column, row + 1),
                     vertex_normal(column + 1, row + 1), u, v, right);
    }
    [[nodiscard]] std::optional<Vec3d> face_normal(Vec3d p, const Crossing& c) const override {
        if (!smooth_ || c.part == kNoCell) return std::nullopt;
        const Place at = place_in_cell(p, c.part);
        return triangle_normal(at.column, at.row, at.right);
    }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override { return transformed(m, box_); }

private:
    struct Walk {
        const Ray& ray;
        Range range, within;
        CrossingList& out;
        double inverse_x, inverse_z;  ///< Of the direction.
        bool only_first = false;
        bool done = false;   ///< Nothing more is asked for.
        bool below = false;  ///< Under the ground, where the walk has come to.
        bool started = false;
        bool starts_inside = false;
        void toggle(const Crossing& c) {
            below = !below;
            if (c.t <= range.lower) starts_inside = below;
            else if (c.t < range.upper) out.push_back(c), done = done || (only_first && c.visible);
            else done = true;
        }
        /// The walk goes on at t, where the ray is under the ground or not. A difference is a wall at the beginning,
        /// and rounding elsewhere.
        void arrive(double t, bool is_below, std::uint32_t cell) {
            if (is_below != below) {
                if (started) toggle({t, 0, 0, cell});
                else toggle({t, 0, 0, kNoCell, true, false});
            }
            started = true;
        }
    };

    /// Where in a cell a point is: u and v run from 0 to 1 through it.
    struct Place {
        std::uint32_t column, row;
        double u, v;
        bool right;  ///< In the right one of the cell's two triangles.
    };
    [[nodiscard]] Place place_in_cell(Vec3d p, std::uint32_t cell) const {
        const std::uint32_t column = cell % columns_;
        const std::uint32_t row = cell / columns_;
        const double u = std::clamp(p.x * columns_ - column, 0.0, 1.0);
        const double v = std::clamp((1 - p.z) * rows_ - row, 0.0, 1.0);
        return {column, row, u, v, right_triangle(u, v)};
    }
    [[nodiscard]] double height(std::uint32_t column, std::uint32_t row) const {
        return (*heights_)[std::size_t{row} * (columns_ + 1) + column];
    }
    /// Each cell's diagonal goes from its upper left to its lower right pixel as the picture is seen; u and v run from
    /// the first to the last column and row.
    static bool right_triangle(double u, double v) { return u >= v; }
    /// Between the corners' values in a triangle: a and b above, d and e below.
    template <class T>
    static T blend(T a, T b, T d, T e, double u, double v, bool right) {
        return right ? a + (b - a) * u + (e - b) * v : a + (e - d) * u + (d - a) * v;
    }
    [[nodiscard]] double height_in(std::uint32_t column, std::uint32_t row, double u, double v, bool right) const {
        return blend(height(column, row), height(column + 1, row), height(column, row + 1), height(column + 1, row + 1),
                     u, v, right);
    }
    /// Column and row of the cell that a point is over or under.
    [[nodiscard]] std::array<std::uint32_t, 2> cell_at(Vec3d p) const {
        return {static_cast<std::uint32_t>(std::clamp(p.x * columns_, 0.0, columns_ - 1.0)),
                static_cast<std::uint32_t>(std::clamp((1 - p.z) * rows_, 0.0, rows_ - 1.0))};
    }
    [[nodiscard]] double height_at(double x, double z) const {
        const double u = x * columns_;
        const double v = (1 - z) * rows_;
        const auto [column, row] = cell_at({x, 0, z});
        return height_in(column, row, u - column, v - row, right_triangle(u - column, v - row));
    }
    /// Normal of a triangle, of height 1.
    [[nodiscard]] Vec3d triangle_normal(std::uint32_t column, std::uint32_t row, bool right) const {
        const double a = height(column, row);
        const double b = height(column + 1, row);
        const double d = height(column, row + 1);
        const double e = height(column + 1, row + 1);
        return {-(right ? b - a : e - d) * columns_, 1, (right ? e - b : d - a) * rows_};
    }
    /// The mean of the unit normals of the triangles around a pixel.
    [[nodiscard]] Vec3d vertex_normal(std::uint32_t column, std::uint32_t row) const {
        Vec3d sum;
        for (std::uint32_t r = row > 0 ? row - 1 : 0; r <= row && r < rows_; ++r) {
            for (std::uint32_t c = column > 0 ? column - 1 : 0; c <= column && c < columns_; ++c) {
                // The diagonal's two pixels belong to both triangles, the others to one.
                const bool on_diagonal = (c == column) == (r == row);
                const bool at_right = c < column;
                if (on_diagonal || at_right) sum += normalize(triangle_normal(c, r, true));
                if (on_diagonal || !at_right) sum += normalize(triangle_normal(c, r, false));
            }
        }
        return normalize(sum);
    }
    static Level coarser(const Level& fine) {
        Level level{(fine.columns + 1) / 2, (fine.rows + 1) / 2, {}};
        level.extent.assign(std::size_t{level.columns} * level.rows, {INFINITY, -INFINITY});
        for (std::uint32_t row = 0; row < fine.rows; ++row) {
            for (std::uint32_t column = 0; column < fine.columns; ++column) {
                std::array<float, 2>& to = level.extent[std::size_t{row / 2} * level.columns + column / 2];
                const std::array<float, 2>& from = fine.extent[std::size_t{row} * fine.columns + column];
                to = {std::min(to[0], from[0]), std::max(to[1], from[1])};
            }
        }
        return level;
    }

    /// Goes through a square that the ray enters and leaves at heights `y`, by its quarters in the ray's order.
    [[gnu::always_inline]] void visit(std::uint32_t level, std::uint32_t column, std::uint32_t row, Range within,
                                      std::array<double, 2> y, Walk& walk) const {
        const std::array<float, 2>& extent = levels_[level].extent[std::size_t{row} * levels_[level].columns + column];
        const bool above = std::min(y[0], y[1]) > extent[1];
        if (above || std::max(y[0], y[1]) < extent[0]) {
            const std::size_t first_cell = (std::size_t{row} << level) * columns_ + (std::size_t{column} << level);
            return walk.arrive(within.lower, !above, static_cast<std::uint32_t>(first_cell));
        }
        if (level == 0) return walk_cell(column, row, within, walk);
        visit_quarters(level, column, row, within, y, walk);
    }
    void visit_quarters(std::uint32_t level, std::uint32_t column, std::uint32_t row, Range within,
                        std::array<double, 2> y, Walk& walk) const {
        // Cut at the two middle lines.
        const std::uint32_t below = level - 1;
        const double middle_x = static_cast<double>((2 * column + 1) << below) * cell_width_;
        const double middle_z = 1 - static_cast<double>((2 * row + 1) << below) * cell_depth_;
        const double t_x = (middle_x - walk.ray.origin.x) * walk.inverse_x;
        const double t_z = (middle_z - walk.ray.origin.z) * walk.inverse_z;
        std::array<double, 3> ends{within.upper, within.upper, within.upper};
        std::size_t count = 0;
        for (const double t : {std::min(t_x, t_z), std::max(t_x, t_z)})
            if (t > within.lower && t < within.upper) ends[count++] = t;
        double from = within.lower;
        double y_from = y[0];
        for (std::size_t i = 0; i <= count && !walk.done; ++i) {
            const double to = ends[i];
            if (!(from < to)) continue;
            const double half = 0.5 * (from + to);
            const bool right = walk.ray.origin.x + walk.ray.direction.x * half > middle_x;
            const bool front = walk.ray.origin.z + walk.ray.direction.z * half < middle_z;
            const double y_to = walk.ray.origin.y + walk.ray.direction.y * to;
            visit(below, std::min(2 * column + (right ? 1 : 0), levels_[below].columns - 1),
                  std::min(2 * row + (front ? 1 : 0), levels_[below].rows - 1), {from, to}, {y_from, y_to}, walk);
            from = to, y_from = y_to;
        }
    }
    void walk_cell(std::uint32_t column, std::uint32_t row, Range within, Walk& walk) const {
        const Ray& ray = walk.ray;
        const std::uint32_t cell = row * columns_ + column;
        const auto u_at = [&](double t) { return ray.at(t).x * columns_ - column; };
        const auto v_at = [&](double t) { return (1 - ray.at(t).z) * rows_ - row; };
        double start = within.lower;
        const double side_start = u_at(start) - v_at(start);
        const double side_end = u_at(within.upper) - v_at(within.upper);
        const bool cuts_diagonal = (side_start < 0) != (side_end < 0);
        const double diagonal =
            cuts_diagonal ? start + (within.upper - start) * std::clamp(side_start / (side_start - side_end), 0.0, 1.0)
                          : 0;
        for (int part = 0; part < (cuts_diagonal ? 2 : 1); ++part) {
            const double end = cuts_diagonal && part == 0 ? diagonal : within.upper;
            const bool right = cuts_diagonal ? (side_start >= 0) == (part == 0) : side_start + side_end >= 0;
            const auto above = [&](double t) { return ray.at(t).y - height_in(column, row, u_at(t), v_at(t), right); };
            const double at_start = above(start);
            const double at_end = above(end);
            walk.arrive(start, at_start < 0, cell);
            if ((at_start < 0) != (at_end < 0))
                walk.toggle({start + (end - start) * (at_start / (at_start - at_end)), 0, 0, cell});
            start = end;
        }
    }

    std::uint32_t columns_, rows_;  ///< Cells.
    double cell_width_ = 1.0 / columns_, cell_depth_ = 1.0 / rows_;
    std::shared_ptr<const std::vector<float>> heights_;
    bool smooth_;
    double water_;
    double margin_ = 0;  ///< Room under and over the ground, so that level ground isn't lost in rounding.
    std::vector<Level> levels_;
    Bounds3d box_;
};

}  // namespace

ShapePointer make_shape(const scene::HeightField& field, const SourceLocation& where) {
    if (field.width < 2 || field.height < 2 || !field.heights ||
        field.heights->size() != std::size_t{field.width} * field.height)
        refuse_shape(where, "a height field needs a picture of at least 2 by 2 pixels");
    if (std::size_t{field.width} * field.height > 0x7fffffffU)
        refuse_shape(where, "a height field's picture has at most 2147483647 pixels");
    return std::make_shared<HeightField>(field);
}

}  // namespace sundog::solids
