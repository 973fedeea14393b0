// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "solids/shape.h"
#include "solids/spline_curve.h"

namespace sundog::solids {
namespace {

constexpr std::uint32_t kBottom = 0xfffffffeU, kTop = 0xffffffffU;

// The outline lies in the xz plane (its y is the space's z); a conic sweep scales it by the height.
class Prism final : public Shape {
public:
    Prism(const scene::Prism& prism, const std::vector<Curve>& curves)
        : conic_(prism.conic),
          lower_(std::min(prism.lower, prism.upper)),
          upper_(std::max(prism.lower, prism.upper)),
          open_(prism.open) {
        for (const Curve& curve : curves) pieces_.insert(pieces_.end(), curve.pieces.begin(), curve.pieces.end());
        for (std::size_t first = 0; first < pieces_.size(); first += kRunLength) {
            Rectangle run;
            for (std::size_t i = first; i < std::min(first + kRunLength, pieces_.size()); ++i) {
                Rectangle around;
                for (std::size_t k = 0; k < 4; ++k) around.include(pieces_[i].x[k], pieces_[i].y[k]);
                around_pieces_.push_back(around);
                run.include(around);
            }
            runs_.push_back(run);
            outline_.include(run);
        }
        for (const CurvePiece& piece : pieces_) {
            for (std::size_t i = 0; i < 4; ++i) {
                for (const double y : {lower_, upper_}) {
                    const double scale = conic_ ? y : 1;
                    box_.include({scale * piece.x[i], y, scale * piece.y[i]});
                }
            }
        }
    }

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        Crossing enter{-kInfinity};
        Crossing leave{kInfinity};
        const double y = ray.origin.y;
        const double dy = ray.direction.y;
        if (dy == 0) {
            if (!(y > lower_ && y < upper_)) return false;
        } else {
            enter = {((dy > 0 ? lower_ : upper_) - y) / dy, 0, 0, dy > 0 ? kBottom : kTop, true, !open_};
            leave = {((dy > 0 ? upper_ : lower_) - y) / dy, 0, 0, dy > 0 ? kTop : kBottom, true, !open_};
        }
        const double start = std::max(enter.t, range.lower);
        if (!(start < leave.t && start < range.upper)) return false;
        // Crossings with the walls, which go on above and below; where the outline tells what lies before them, those
        // between the two planes alone.
        CrossingList walls;
        Rectangle way;
        const bool on_the_way = !conic_ && dy != 0;
        if (on_the_way) {
            way = rectangle_around(ray.at(start), ray.at(std::min(leave.t, range.upper)));
            if (!way.meets(outline_)) return false;
        }
        append_walls(ray, on_the_way ? &way : nullptr, walls);
        std::sort(walls.begin(), walls.end(), [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
        // Far behind, the ray is outside of an outline that is finite, unless it runs along the walls; in the slab's
        // beginning it is where the outline says.
        bool within = conic_ || dy != 0 ? inside_outline(ray.at(start)) : parity_before(walls, start);
        const bool starts_inside = enter.t <= range.lower && within;
        if (within && range.contains(enter.t)) out.push_back(enter);
        for (const Crossing& c : walls) {
            if (c.t <= start || c.t >= leave.t) continue;
            if (range.contains(c.t)) out.push_back(c);
            within = !within;
        }
        if (within && range.contains(leave.t)) out.push_back(leave);
        return starts_inside;
    }
    [[nodiscard]] bool inside(Vec3d p) const override { return p.y > lower_ && p.y < upper_ && inside_outline(p); }
    [[nodiscard]] Vec3d normal(Vec3d, const Crossing& c) const override {
        if (c.part == kBottom) return {0, -1, 0};
        if (c.part == kTop) return {0, 1, 0};
        const CurvePiece& piece = pieces_[c.part];
        const std::array<double, 2> along = piece.derivative(c.u);
        if (!conic_) return {along[1], 0, -along[0]};
        // Perpendicular to the outline, and to the line to the apex.
        const std::array<double, 2> at = piece.at(c.u);
        return cross(Vec3d{along[0], 0, along[1]}, Vec3d{at[0], 1, at[1]});
    }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override { return transformed(m, box_); }
    [[nodiscard]] ShapeNumbers numbers() const override {
        if (conic_) return {};
        ShapeNumbers out{ShapeNumbers::Kind::prism, {}};
        out.add(lower_).add(upper_).add(open_ ? 1 : 0).add(static_cast<double>(pieces_.size()));
        for (const CurvePiece& piece : pieces_) out.add(piece.x).add(piece.y);
        return out;
    }

private:
    /// Around control points of the outline, or a ray's way past it.
    struct Rectangle {
        std::array<double, 2> lower{kInfinity, kInfinity}, upper{-kInfinity, -kInfinity};
        void include(double x, double y) {
            lower = {std::min(lower[0], x), std::min(lower[1], y)};
            upper = {std::max(upper[0], x), std::max(upper[1], y)};
        }
        void include(const Rectangle& r) {
            include(r.lower[0], r.lower[1]);
            include(r.upper[0], r.upper[1]);
        }
        [[nodiscard]] bool meets(const Rectangle& r) const {
            return lower[0] <= r.upper[0] && r.lower[0] <= upper[0] && lower[1] <= r.upper[1] && r.lower[1] <= upper[1];
        }
        /// Whether a*x + b + c*y has one sign on all of it, beyond what rounding could change; `size` is about b's
        /// terms.
        [[nodiscard]] bool is_beside(double a, double b, double c, double size) const {
            const double reach_x = std::max(std::abs(lower[0]), std::abs(upper[0]));
            const double reach_y = std::max(std::abs(lower[1]), std::abs(upper[1]));
            const double middle = 0.5 * (a * (lower[0] + upper[0]) + c * (lower[1] + upper[1])) + b;
            const double spread = 0.5 * (std::abs(a) * (upper[0] - lower[0]) + std::abs(c) * (upper[1] - lower[1]));
            return std::abs(middle) > spread + 1e-12 * (std::abs(a) * reach_x + std::abs(c) * reach_y + size);
        }
    };
    static constexpr std::size_t kRunLength = 8;

    /// Around two points, with room for rounding.
    static Rectangle rectangle_around(Vec3d a, Vec3d b) {
        Rectangle r;
        for (const Vec3d& p : {a, b}) {
            const double room = 1e-9 * (std::abs(p.x) + std::abs(p.z));
            r.include(p.x - room, p.z - room);
            r.include(p.x + room, p.z + room);
        }
        return r;
    }
    [[nodiscard]] bool inside_outline(Vec3d p) const {
        if (!conic_) return inside_pieces(p.x, p.z);
        return p.y != 0 && inside_pieces(p.x / p.y, p.z / p.y);
    }
    /// Whether a line in +x direction meets an odd number of pieces.
    [[nodiscard]] bool inside_pieces(double x, double y) const {
        const auto may_be_met = [&](const Rectangle& r) {
            return r.lower[1] <= y && y <= r.upper[1] && x <= r.upper[0];
        };
        bool odd = false;
        for (std::size_t run = 0; run < runs_.size(); ++run) {
            if (!may_be_met(runs_[run])) continue;
            const std::size_t end = std::min((run + 1) * kRunLength, pieces_.size());
            for (std::size_t i = run * kRunLength; i < end; ++i)
                if (may_be_met(around_pieces_[i]) && is_met_oddly(pieces_[i], x, y)) odd = !odd;
        }
        return odd;
    }
    static bool parity_before(const CrossingList& walls, double t) {
        bool odd = false;
        for (const Crossing& c : walls)
            if (c.t <= t) odd = !odd;
        return odd;
    }
    /// Points of the outline in the plane through the ray and the apex (or the vertical): Bernstein coefficients of
    /// their distance have one root for each wall that the ray meets.
    /// With a rectangle around the ray's way, those in it alone need be there.
    void append_walls(const Ray& ray, const Rectangle* way, CrossingList& out) const {
        const Vec3d o = ray.origin;
        const Vec3d d = ray.direction;
        const Vec3d plane = conic_ ? cross(o, d) : cross(Vec3d{d.x, 0, d.z}, Vec3d{0, 1, 0});
        if (!conic_ && d.x == 0 && d.z == 0) return;
        const double constant = conic_ ? plane.y : -(plane.x * o.x + plane.z * o.z);
        const double size = conic_ ? std::abs(plane.y) : std::abs(plane.x * o.x) + std::abs(plane.z * o.z);
        for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
            const Rectangle& run = runs_[i / kRunLength];
            if (i % kRunLength == 0 && ((way && !way->meets(run)) || run.is_beside(plane.x, constant, plane.z, size))) {
                i += kRunLength - 1;
                continue;
            }
            if (way && !way->meets(around_pieces_[i])) continue;
            const CurvePiece& piece = pieces_[i];
            std::array<double, 4> distance{};
            for (std::size_t k = 0; k < 4; ++k)
                distance[k] = conic_ ? plane.x * piece.x[k] + plane.y + plane.z * piece.y[k]
                                     : plane.x * (piece.x[k] - o.x) + plane.z * (piece.y[k] - o.z);
            RootList roots;
            append_piece_roots(piece, distance, roots);
            const bool changes = (distance[0] >= 0) != (distance[3] >= 0);
            // A ray through the joint of two pieces: one of them takes it, by the same rule as in inside_curves.
            if ((roots.size() % 2 == 1) != changes) roots.push_back(distance[0] == 0 ? 0.0 : 1.0);
            for (const double u : roots) {
                Crossing c;
                c.part = i;
                c.u = u;
                const std::array<double, 2> at = piece.at(u);
                if (conic_) {
                    // Where o + t*d is parallel to the line from the apex to the outline's point.
                    const Vec3d q{at[0], 1, at[1]};
                    const Vec3d across = cross(d, q);
                    const double square = dot(across, across);
                    if (square == 0) continue;
                    c.t = -dot(cross(o, q), across) / square;
                } else {
                    c.t = ((at[0] - o.x) * d.x + (at[1] - o.z) * d.z) / (d.x * d.x + d.z * d.z);
                }
                out.push_back(c);
            }
        }
    }

    bool conic_;
    double lower_, upper_;
    bool open_;
    std::vector<CurvePiece> pieces_;        ///< Of all outlines.
    std::vector<Rectangle> around_pieces_;  ///< Around each.
    std::vector<Rectangle> runs_;           ///< Around each kRunLength neighbours.
    Rectangle outline_;                     ///< Around all.
    Bounds3d box_;
};

}  // namespace

ShapePointer make_shape(const scene::Prism& prism, const SourceLocation& where) {
    const std::vector<Curve> curves = closed_curves(prism.spline, prism.points);
    if (curves.empty()) refuse_shape(where, "a prism needs more points for this kind of spline");
    if (prism.lower == prism.upper) refuse_shape(where, "a prism's two heights must differ");
    return std::make_shared<Prism>(prism, curves);
}

}  // namespace sundog::solids
