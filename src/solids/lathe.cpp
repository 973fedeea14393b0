// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "solids/bounds_tree.h"
#include "solids/shape.h"
#include "solids/spline_curve.h"

namespace sundog::solids {
namespace {

constexpr std::uint32_t kEnd = 0xffffffffU;

/// Below this slope against the horizontal, relative to the ray's length, a ray is taken as horizontal: its two
/// crossings of a wall are then one double root to double precision.
constexpr double kHorizontal = 1e-7;

using Cubic = std::array<double, 4>;
using Sextic = std::array<double, 7>;

/// Adds weight*c^2, in Bernstein form.
void add_square(const Cubic& c, double weight, Sextic& sum) {
    constexpr std::array<double, 4> three{1, 3, 3, 1};
    constexpr std::array<double, 7> six{1, 6, 15, 20, 15, 6, 1};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 4; ++k) sum[i + k] += weight * three[i] * three[k] / six[i + k] * c[i] * c[k];
}

Cubic minus(Cubic c, double v) {
    for (double& x : c) x -= v;
    return c;
}

// A curve turned about the y axis. What is inside is what an odd number of the curve's pieces lies outwards of; a curve
// that isn't closed thus has, at an end off the axis, a disc where there is no surface.
class Lathe final : public Shape {
public:
    explicit Lathe(Curve curve) : curves_{std::move(curve)} {
        std::vector<Bounds3d> boxes;
        for (const CurvePiece& piece : pieces()) {
            Bounds3d box;
            for (std::size_t i = 0; i < 4; ++i) {
                const double r = std::abs(piece.x[i]);
                box.include({r, piece.y[i], r});
                box.include({-r, piece.y[i], -r});
            }
            boxes.push_back(box);
            box_ = joined(box_, box);
        }
        if (!curves_[0].closed()) {
            const CurvePiece& first = pieces().front();
            const CurvePiece& last = pieces().back();
            ends_ = {{{std::abs(first.x[0]), first.y[0]}, {std::abs(last.x[3]), last.y[3]}}};
        }
        tree_ = BoundsTree(boxes);
    }

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        return find(ray, range, out, false);
    }
    bool first_crossing(const Ray& ray, Range range, CrossingList& out) const override {
        return find(ray, range, out, true);
    }
    [[nodiscard]] bool inside(Vec3d p) const override {
        return contains(box_, p) && inside_curves(curves_, std::hypot(p.x, p.z), p.y);
    }
    [[nodiscard]] Vec3d normal(Vec3d p, const Crossing& c) const override {
        if (c.part == kEnd) return {0, 1, 0};
        const std::array<double, 2> along = pieces()[c.part].derivative(c.u);
        const double around = std::hypot(p.x, p.z);
        if (around == 0) return {0, 1, 0};
        return {along[1] * p.x / around, -along[0], along[1] * p.z / around};
    }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override { return transformed(m, box_); }
    [[nodiscard]] std::array<double, 2> uv(Vec3d p, const Crossing& c) const override {
        double u = std::atan2(p.z, p.x) / (2 * std::numbers::pi);
        if (u < 0) u += 1;
        return {u, (c.part + c.u) / static_cast<double>(pieces().size())};
    }
    [[nodiscard]] ShapeNumbers numbers() const override {
        ShapeNumbers out{ShapeNumbers::Kind::lathe, {}};
        out.add(static_cast<double>(pieces().size()));
        for (std::size_t i = 0; i < 2; ++i)
            for (std::size_t k = 0; k < 2; ++k) out.add(i < ends_.size() ? ends_[i][k] : 0);
        for (const CurvePiece& piece : pieces()) out.add(piece.x).add(piece.y);
        return out;
    }

private:
    /// A ray seen from its point nearest to the axis: there it is `nearest` away at height y, and moves `speed`
    /// outwards per t.
    struct Path {
        explicit Path(const Ray& ray) : dy(ray.direction.y), length(sundog::length(ray.direction)) {
            const double a = ray.direction.x * ray.direction.x + ray.direction.z * ray.direction.z;
            square_speed = a;
            t = a > 0 ? -(ray.origin.x * ray.direction.x + ray.origin.z * ray.direction.z) / a : 0;
            const Vec3d p = ray.at(t);
            y = p.y;
            square_nearest = p.x * p.x + p.z * p.z;
        }
        double dy, length, square_speed, t, y, square_nearest;
    };

    [[nodiscard]] const std::vector<CurvePiece>& pieces() const { return curves_[0].pieces; }

    bool find(const Ray& ray, Range range, CrossingList& out, bool only_first) const {
        const Path path(ray);
        const std::size_t first = out.size();
        Range whole = range;
        tree_.along(ray, whole, [&](std::uint32_t i) {
            const std::size_t before = out.size();
            append_piece(path, i, range, out);
            // What lies behind a surface isn't asked for.
            for (std::size_t k = before; only_first && k < out.size(); ++k)
                whole.upper = std::min(whole.upper, out[k].t);
        });
        for (const std::array<double, 2>& end : ends_) {
            const double t = (end[1] - ray.origin.y) / ray.direction.y;
            if (!range.contains(t)) continue;
            const Vec3d p = ray.at(t);
            if (!(p.x * p.x + p.z * p.z < end[0] * end[0])) continue;
            Crossing c{t};
            c.part = kEnd;
            c.visible = false;
            out.push_back(c);
        }
        std::sort(out.begin() + first, out.end(), [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
        return inside(ray.at(range.lower));
    }
    void append_piece(const Path& path, std::uint32_t i, Range range, CrossingList& out) const {
        const CurvePiece& piece = pieces()[i];
        const Cubic height = minus(piece.y, path.y);
        const bool horizontal = std::abs(path.dy) <= kHorizontal * path.length;
        // On the ray, the square of the distance from the axis is nearest^2 + speed^2*(t - t0)^2, and y - y0 = dy*(t -
        // t0): speed^2*(y(u) - y0)^2 = dy^2*(r(u)^2 - nearest^2).
        Sextic distance{};
        if (!horizontal) {
            const double scale = 1 / (path.length * path.length);
            add_square(height, path.square_speed * scale, distance);
            add_square(piece.x, -path.dy * path.dy * scale, distance);
            for (double& c : distance) c += path.dy * path.dy * scale * path.square_nearest;
        }
        const std::span<const double> f =
            horizontal ? std::span<const double>(height) : std::span<const double>(distance);
        RootList roots;
        append_bernstein_roots(f, roots);
        // A ray through the joint of two pieces: one of them takes it.
        const bool changes = (f.front() >= 0) != (f.back() >= 0);
        if ((roots.size() % 2 == 1) != changes) roots.push_back(f.front() == 0 ? 0.0 : 1.0);
        for (const double u : roots) {
            const std::array<double, 2> at = piece.at(u);
            const double beyond = at[0] * at[0] - path.square_nearest;
            Crossing c;
            c.part = i;
            c.u = u;
            if (horizontal) {
                if (!(beyond > 0)) continue;
                const double half = std::sqrt(beyond / path.square_speed);
                for (const double s : {-half, half}) {
                    c.t = path.t + s;
                    if (range.contains(c.t)) out.push_back(c);
                }
                continue;
            }
            const double by_height = (at[1] - path.y) / path.dy;
            // By the one of both coordinates that the ray moves faster in.
            c.t = path.dy * path.dy > 0.01 * path.square_speed || !(beyond > 0)
                      ? path.t + by_height
                      : path.t + std::copysign(std::sqrt(beyond / path.square_speed), by_height);
            if (range.contains(c.t)) out.push_back(c);
        }
    }

    std::vector<Curve> curves_;  ///< One, in the form that inside_curves takes.
    std::vector<std::array<double, 2>> ends_;
    BoundsTree tree_;
    Bounds3d box_;
};

}  // namespace

ShapePointer make_shape(const scene::Lathe& lathe, const SourceLocation& where) {
    Curve curve = curve_through(lathe.spline, lathe.points);
    if (curve.pieces.empty()) refuse_shape(where, "a lathe needs more points for this kind of spline");
    return std::make_shared<Lathe>(std::move(curve));
}

}  // namespace sundog::solids
