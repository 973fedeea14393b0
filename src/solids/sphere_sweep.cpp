// SPDX-License-Identifier: Apache-2.0
// What a ball of changing size sweeps over along a spline.
//
// Along a ray, the ball at parameter u covers the interval m(u) -+ sqrt(D(u)), where m is a cubic and D a polynomial of
// degree six in u. Over a stretch of u on which D > 0 these intervals join into one, whose ends are the least and the
// greatest of theirs: at the stretch's ends, or where the derivative is 0, 4*m'^2*D = D'^2. All of that is polynomial.
#include <algorithm>
#include <cmath>

#include "solids/bounds_tree.h"
#include "solids/roots.h"
#include "solids/shape.h"

namespace sundog::solids {
namespace {

/// Power coefficients, lowest first, of a point and a radius for u in 0..1.
struct Segment {
    std::array<Vec3d, 4> center;
    std::array<double, 4> radius;

    [[nodiscard]] Vec3d center_at(double u) const {
        return ((center[3] * u + center[2]) * u + center[1]) * u + center[0];
    }
    [[nodiscard]] double radius_at(double u) const { return evaluate(radius, u); }
};

template <class T>
std::array<T, 4> linear(T a, T b) {
    return {a, b - a, a * 0.0, a * 0.0};
}
template <class T>
std::array<T, 4> catmull_rom(T a, T b, T c, T d) {
    return {b, (c - a) * 0.5, a - b * 2.5 + c * 2.0 - d * 0.5, (d - a) * 0.5 + (b - c) * 1.5};
}
template <class T>
std::array<T, 4> b_spline(T a, T b, T c, T d) {
    return {(a + b * 4.0 + c) * (1.0 / 6), (c - a) * 0.5, (a + c) * 0.5 - b, (d - a) * (1.0 / 6) + (b - c) * 0.5};
}

std::vector<Segment> segments_of(const scene::SphereSweep& sweep) {
    using Kind = scene::SphereSweep::Kind;
    const std::vector<scene::SphereSweep::Point>& p = sweep.points;
    std::vector<Segment> out;
    if (sweep.kind == Kind::linear) {
        for (std::size_t i = 1; i < p.size(); ++i)
            out.push_back({linear(p[i - 1].center, p[i].center), linear(p[i - 1].radius, p[i].radius)});
        return out;
    }
    for (std::size_t i = 3; i < p.size(); ++i) {
        const auto &a = p[i - 3], &b = p[i - 2], &c = p[i - 1], &d = p[i];
        if (sweep.kind == Kind::b_spline)
            out.push_back(
                {b_spline(a.center, b.center, c.center, d.center), b_spline(a.radius, b.radius, c.radius, d.radius)});
        else
            out.push_back({catmull_rom(a.center, b.center, c.center, d.center),
                           catmull_rom(a.radius, b.radius, c.radius, d.radius)});
    }
    return out;
}

/// sum += weight * a*b
void add_product(std::span<const double> a, std::span<const double> b, double weight, std::span<double> sum) {
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < b.size(); ++k) sum[i + k] += weight * a[i] * b[k];
}
template <std::size_t N>
std::array<double, N - 1> derivative(const std::array<double, N>& c) {
    std::array<double, N - 1> d;
    for (std::size_t i = 1; i < N; ++i) d[i - 1] = static_cast<double>(i) * c[i];
    return d;
}

class SphereSweep final : public Shape {
public:
    explicit SphereSweep(std::vector<Segment> segments) : segments_(std::move(segments)) {
        std::vector<Bounds3d> boxes;
        for (const Segment& s : segments_) {
            boxes.push_back(bounds_of(s));
            box_ = joined(box_, boxes.back());
        }
        tree_ = BoundsTree(boxes);
    }

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        Intervals intervals;
        Range whole{range.lower, kInfinity};
        tree_.along(ray, whole, [&](std::uint32_t i) { append_intervals(ray, i, intervals); });
        std::sort(intervals.begin(), intervals.end(),
                  [](const Interval& a, const Interval& b) { return a.lower.t < b.lower.t; });
        bool starts_inside = false;
        for (std::size_t i = 0; i < intervals.size();) {
            Interval joined = intervals[i++];
            // Segments end in the same ball, so their intervals touch at least.
            while (i < intervals.size() && intervals[i].lower.t <= joined.upper.t) {
                if (intervals[i].upper.t > joined.upper.t) joined.upper = intervals[i].upper;
                ++i;
            }
            if (append_interval(joined.lower, joined.upper, range, out)) starts_inside = true;
        }
        return starts_inside;
    }
    [[nodiscard]] bool inside(Vec3d p) const override {
        return tree_.any_at(p, [&](std::uint32_t i) { return inside_segment(segments_[i], p); });
    }
    [[nodiscard]] Vec3d normal(Vec3d p, const Crossing& c) const override {
        return p - segments_[c.part].center_at(c.u);
    }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override { return transformed(m, box_); }

private:
    struct Interval {
        Crossing lower, upper;
    };
    using Intervals = SmallVector<Interval, 16>;

    /// By the points where each coordinate turns, with the greatest radius around.
    static Bounds3d bounds_of(const Segment& s) {
        double most = std::max(std::abs(s.radius_at(0)), std::abs(s.radius_at(1)));
        RootList turns;
        append_roots(derivative(s.radius), 0, 1, turns);
        for (const double u : turns) most = std::max(most, std::abs(s.radius_at(u)));
        turns.clear();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::array<double, 4> c;
            for (std::size_t i = 0; i < 4; ++i) c[i] = s.center[i][axis];
            append_roots(derivative(c), 0, 1, turns);
        }
        Bounds3d box;
        box.include(s.center_at(0));
        box.include(s.center_at(1));
        for (const double u : turns) box.include(s.center_at(u));
        const Vec3d reach{most, most, most};
        return {box.lower - reach, box.upper + reach};
    }

    void append_intervals(const Ray& ray, std::uint32_t index, Intervals& out) const {
        const Segment& s = segments_[index];
        const double square = dot(ray.direction, ray.direction);
        const double t0 = dot(s.center_at(0.5) - ray.origin, ray.direction) / square;
        const Vec3d o = ray.at(t0);
        const Vec3d d = ray.direction / std::sqrt(square);
        // m = (c - o)*d; D = r^2 - |c - o - m*d|^2: no large squares to cancel.
        std::array<double, 4> m;
        std::array<double, 7> inside_of{};
        for (std::size_t i = 0; i < 4; ++i) m[i] = dot(i == 0 ? s.center[0] - o : s.center[i], d);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::array<double, 4> off;
            for (std::size_t i = 0; i < 4; ++i) off[i] = s.center[i][axis] - (i == 0 ? o[axis] : 0) - m[i] * d[axis];
            add_product(off, off, -1, inside_of);
        }
        add_product(s.radius, s.radius, 1, inside_of);
        const std::array<double, 3> dm = derivative(m);
        const std::array<double, 6> d_inside = derivative(inside_of);
        std::array<double, 5> dm_square{};
        add_product(dm, dm, 1, dm_square);
        std::array<double, 11> turning{};
        add_product(dm_square, inside_of, 4, turning);
        add_product(d_inside, d_inside, -1, turning);

        RootList ends;
        append_roots(inside_of, 0, 1, ends);
        RootList turns;
        append_roots(turning, 0, 1, turns);
        // Both derivatives vanish at one place where the ray stands square on the path: a double root of `turning`.
        append_roots(d_inside, 0, 1, turns);
        append_roots(dm, 0, 1, turns);
        bool covered = inside_of[0] > 0;
        double begin = 0;
        ends.push_back(1);
        for (const double end : ends) {
            if (covered && end > begin)
                append_stretch(index, m, inside_of, turns, {begin, end}, t0, std::sqrt(square), out);
            covered = !covered;
            begin = end;
        }
    }
    static void append_stretch(std::uint32_t index, const std::array<double, 4>& m,
                               const std::array<double, 7>& inside_of, const RootList& turns, Range stretch, double t0,
                               double speed, Intervals& out) {
        Interval interval{{kInfinity}, {-kInfinity}};
        interval.lower.part = interval.upper.part = index;
        const auto consider = [&](double u) {
            const double middle = evaluate(m, u);
            const double half = std::sqrt(std::max(0.0, evaluate(inside_of, u)));
            if (middle - half < interval.lower.t) interval.lower.t = middle - half, interval.lower.u = u;
            if (middle + half > interval.upper.t) interval.upper.t = middle + half, interval.upper.u = u;
        };
        consider(stretch.lower);
        consider(stretch.upper);
        for (const double u : turns)
            if (u > stretch.lower && u < stretch.upper) consider(u);
        interval.lower.t = t0 + interval.lower.t / speed;
        interval.upper.t = t0 + interval.upper.t / speed;
        out.push_back(interval);
    }
    /// Whether |p - c(u)|^2 < r(u)^2 for some u.
    static bool inside_segment(const Segment& s, Vec3d p) {
        std::array<double, 7> distance{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::array<double, 4> off;
            for (std::size_t i = 0; i < 4; ++i) off[i] = s.center[i][axis] - (i == 0 ? p[axis] : 0);
            add_product(off, off, 1, distance);
        }
        add_product(s.radius, s.radius, -1, distance);
        if (evaluate(distance, 0) < 0 || evaluate(distance, 1) < 0) return true;
        RootList turns;
        append_roots(derivative(distance), 0, 1, turns);
        return std::any_of(turns.begin(), turns.end(), [&](double u) { return evaluate(distance, u) < 0; });
    }

    std::vector<Segment> segments_;
    BoundsTree tree_;
    Bounds3d box_;
};

}  // namespace

ShapePointer make_shape(const scene::SphereSweep& sweep, const SourceLocation& where) {
    std::vector<Segment> segments = segments_of(sweep);
    if (segments.empty())
        refuse_shape(where, "a sphere sweep needs at least 2 spheres, 4 for b_spline and cubic_spline");
    return std::make_shared<SphereSweep>(std::move(segments));
}

}  // namespace sundog::solids
