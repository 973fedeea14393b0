// SPDX-License-Identifier: Apache-2.0
// sor: the square of the radius is a cubic in the height, piece by piece (reference, section 3.4.5.1.15).
#include <algorithm>
#include <cmath>
#include <numbers>

#include "solids/roots.h"
#include "solids/shape.h"

namespace sundog::solids {
namespace {

constexpr std::uint32_t kBottom = 0xfffffffeU, kTop = 0xffffffffU;

/// r^2 = sum of square[i]*(h - lower)^i between two heights.
struct Piece {
    double lower, upper;
    std::array<double, 4> square;
};

/// The cubic through (r1^2, h1) and (r2^2, h2) whose slopes there are those of the chords between the points'
/// neighbours: 2*r1*(r2 - r0)/(h2 - h0), 2*r2*(r3 - r1)/(h3 - h1).
Piece piece_between(const std::array<double, 2>& p0, const std::array<double, 2>& p1, const std::array<double, 2>& p2,
                    const std::array<double, 2>& p3) {
    const double height = p2[1] - p1[1];
    const double f1 = p1[0] * p1[0];
    const double f2 = p2[0] * p2[0];
    const double s1 = 2 * p1[0] * (p2[0] - p0[0]) / (p2[1] - p0[1]);
    const double s2 = 2 * p2[0] * (p3[0] - p1[0]) / (p3[1] - p1[1]);
    const double chord = (f2 - f1) / height;
    return {p1[1], p2[1], {f1, s1, (3 * chord - 2 * s1 - s2) / height, (s1 + s2 - 2 * chord) / (height * height)}};
}

class SurfaceOfRevolution final : public Shape {
public:
    explicit SurfaceOfRevolution(const scene::SurfaceOfRevolution& sor) : open_(sor.open) {
        std::vector<std::array<double, 2>> p = sor.points;
        if (p[1][1] > p[2][1]) std::reverse(p.begin(), p.end());
        for (std::size_t i = 1; i + 2 < p.size(); ++i)
            pieces_.push_back(piece_between(p[i - 1], p[i], p[i + 1], p[i + 2]));
        double most = 0;
        for (const Piece& piece : pieces_) most = std::max(most, largest_square(piece));
        radius_ = std::sqrt(most);
        box_ = {{-radius_, pieces_.front().lower, -radius_}, {radius_, pieces_.back().upper, radius_}};
    }

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        const double y = ray.origin.y;
        const double dy = ray.direction.y;
        const double reach = 1e-6 * radius_;
        const Range near =
            clip({{-radius_ - reach, -kInfinity, -radius_ - reach}, {radius_ + reach, kInfinity, radius_ + reach}}, ray,
                 {-kInfinity, kInfinity});
        bool starts_inside = false;
        if (!(near.lower < near.upper)) return false;
        State state{range, out, starts_inside};
        if (dy == 0) {
            const std::size_t i = piece_at(y);
            if (i < pieces_.size()) along_piece(ray, i, near, state);
            return starts_inside;
        }
        // In the order in which the ray comes through them.
        for (std::size_t k = 0; k < pieces_.size(); ++k) {
            const std::size_t i = dy > 0 ? k : pieces_.size() - 1 - k;
            const double t_lower = (pieces_[i].lower - y) / dy;
            const double t_upper = (pieces_[i].upper - y) / dy;
            const Range within{std::max(near.lower, std::min(t_lower, t_upper)),
                               std::min(near.upper, std::max(t_lower, t_upper))};
            if (k == 0) state.cap = {std::min(t_lower, t_upper), 0, 0, dy > 0 ? kBottom : kTop, true, !open_};
            if (within.lower < within.upper) along_piece(ray, i, within, state);
            if (k + 1 == pieces_.size() && state.is_inside)
                state.toggle({std::max(t_lower, t_upper), 0, 0, dy > 0 ? kTop : kBottom, true, !open_});
        }
        return starts_inside;
    }
    [[nodiscard]] bool inside(Vec3d p) const override {
        const std::size_t i = piece_at(p.y);
        return i < pieces_.size() && p.x * p.x + p.z * p.z < evaluate(pieces_[i].square, p.y - pieces_[i].lower);
    }
    [[nodiscard]] Vec3d normal(Vec3d p, const Crossing& c) const override {
        if (c.part == kBottom) return {0, -1, 0};
        if (c.part == kTop) return {0, 1, 0};
        const Piece& piece = pieces_[c.part];
        const double h = p.y - piece.lower;
        const double slope = piece.square[1] + h * (2 * piece.square[2] + 3 * h * piece.square[3]);
        return {2 * p.x, -slope, 2 * p.z};
    }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override { return transformed(m, box_); }
    [[nodiscard]] std::array<double, 2> uv(Vec3d p, const Crossing&) const override {
        double u = std::atan2(p.z, p.x) / (2 * std::numbers::pi);
        if (u < 0) u += 1;
        return {u, (p.y - box_.lower.y) / (box_.upper.y - box_.lower.y)};
    }
    [[nodiscard]] ShapeNumbers numbers() const override {
        ShapeNumbers out{ShapeNumbers::Kind::revolution, {}};
        out.add(open_ ? 1 : 0).add(box_.lower.y).add(box_.upper.y).add(radius_);
        out.add(static_cast<double>(pieces_.size()));
        for (const Piece& piece : pieces_) {
            out.add(piece.lower).add(piece.upper).add(piece.square);
        }
        return out;
    }

private:
    /// How far the walk along a ray has come: crossings before the range are only counted.
    struct State {
        Range range;
        CrossingList& out;
        bool& starts_inside;
        bool is_inside = false;
        Crossing cap{};
        void toggle(const Crossing& c) {
            is_inside = !is_inside;
            if (c.t <= range.lower) starts_inside = is_inside;
            else if (c.t < range.upper) out.push_back(c);
        }
    };

    [[nodiscard]] std::size_t piece_at(double y) const {
        for (std::size_t i = 0; i < pieces_.size(); ++i)
            if (y >= pieces_[i].lower && y <= pieces_[i].upper) return i;
        return pieces_.size();
    }
    void along_piece(const Ray& ray, std::size_t i, Range within, State& state) const {
        const Piece& piece = pieces_[i];
        const Vec3d o = ray.at(within.lower);
        const Vec3d d = ray.direction * (within.upper - within.lower);
        std::array<double, 4> c = piece.square;
        change_interval(c, o.y - piece.lower, o.y - piece.lower + d.y);
        // Inside where x^2 + z^2 is less than the square of the radius.
        std::array<double, 4> f{o.x * o.x + o.z * o.z - c[0], 2 * (o.x * d.x + o.z * d.z) - c[1],
                                d.x * d.x + d.z * d.z - c[2], -c[3]};
        bernstein_from_power(f);
        const auto part = static_cast<std::uint32_t>(i);
        // Where a piece begins inside and the one before didn't end so, the ray came through the end's disc, or
        // rounding lost the surface at the joint.
        if (f[0] != 0 && (f[0] < 0) != state.is_inside) {
            const bool at_cap = state.cap.t >= within.lower - 1e-9 * (within.upper - within.lower);
            Crossing start = at_cap ? state.cap : Crossing{within.lower};
            if (!at_cap) start.part = part;
            state.toggle(start);
        }
        RootList roots;
        append_bernstein_roots(f, roots);
        for (const double s : roots) state.toggle({within.lower + s * (within.upper - within.lower), 0, 0, part});
    }
    static double largest_square(const Piece& p) {
        const double height = p.upper - p.lower;
        double most = std::max(evaluate(p.square, 0), evaluate(p.square, height));
        const std::array<double, 3> slope{p.square[1], 2 * p.square[2], 3 * p.square[3]};
        RootList roots;
        append_roots(slope, 0, height, roots);
        for (const double h : roots) most = std::max(most, evaluate(p.square, h));
        return most;
    }

    bool open_;
    std::vector<Piece> pieces_;
    double radius_ = 0;
    Bounds3d box_;
};

}  // namespace

ShapePointer make_shape(const scene::SurfaceOfRevolution& sor, const SourceLocation& where) {
    const std::vector<std::array<double, 2>>& p = sor.points;
    if (p.size() < 4) refuse_shape(where, "a surface of revolution needs at least 4 points");
    const bool rises = p[2][1] > p[1][1];
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (i > 0 && i + 2 < p.size() && !((p[i + 1][1] > p[i][1]) == rises && p[i + 1][1] != p[i][1]))
            refuse_shape(where, "the heights of a surface of revolution must rise from point to point",
                         "use a lathe for curves that turn back");
        if (i > 0 && i + 1 < p.size() && p[i + 1][1] == p[i - 1][1])
            refuse_shape(where,
                         "two points of a surface of revolution that are neighbours of one point are at one height");
    }
    return std::make_shared<SurfaceOfRevolution>(sor);
}

}  // namespace sundog::solids
