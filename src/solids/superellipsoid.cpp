// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "solids/shape.h"

namespace sundog::solids {
namespace {

/// (a^p + b^p)^(1/p) for a, b >= 0, without overflow, and its derivatives by a and b, which need no more powers.
struct Norm {
    double value = 0, by_a = 0, by_b = 0;
    Norm(double a, double b, double p) {
        const bool a_most = a >= b;
        const double most = a_most ? a : b;
        if (most == 0) return;
        const double share = (a_most ? b : a) / most;
        const double power = std::pow(share, p);
        const double growth = std::pow(1 + power, 1 / p);
        value = most * growth;
        const double by_most = growth / (1 + power);
        const double by_least = share > 0 ? by_most * power / share : p == 1 ? by_most : 0;
        by_a = a_most ? by_most : by_least;
        by_b = a_most ? by_least : by_most;
    }
};

// Inside where g(p) = ||(||(x, y)||_(2/e), z)||_(2/n) < 1: the reference's formula, brought to first degree. For e and
// n up to 2 both are norms, g is convex, and a ray has at most one interval inside. Otherwise it is subdivided.
class Superellipsoid final : public Shape {
public:
    explicit Superellipsoid(const scene::Superellipsoid& s)
        : p_(2 / s.east_west), q_(2 / s.north_south), convex_(p_ >= 1 && q_ >= 1) {}

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        const Vec3d roomy{1.001, 1.001, 1.001};
        const Range in_box = clip({-roomy, roomy}, ray, range);
        if (!(in_box.lower < in_box.upper)) return false;
        return convex_ ? convex_crossings(ray, in_box, range, out) : subdivided_crossings(ray, in_box, range, out);
    }
    [[nodiscard]] bool inside(Vec3d p) const override { return value(p) < 1; }
    [[nodiscard]] Vec3d normal(Vec3d p, const Crossing&) const override { return gradient(p); }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override {
        return transformed(m, {{-1, -1, -1}, {1, 1, 1}});
    }

private:
    struct ValueAndGradient {
        double value;
        Vec3d gradient;  ///< Its length is near 1, and it is 0 nowhere but at the centre.
    };
    [[nodiscard]] ValueAndGradient evaluate_at(Vec3d p) const {
        const Norm around(std::abs(p.x), std::abs(p.y), p_);
        const Norm all(around.value, std::abs(p.z), q_);
        return {all.value,
                {std::copysign(all.by_a * around.by_a, p.x), std::copysign(all.by_a * around.by_b, p.y),
                 std::copysign(all.by_b, p.z)}};
    }
    [[nodiscard]] double value(Vec3d p) const { return evaluate_at(p).value; }
    [[nodiscard]] Vec3d gradient(Vec3d p) const { return evaluate_at(p).gradient; }

    /// The value and its slope along a ray.
    struct Sample {
        double t, f, slope;
    };
    [[nodiscard]] Sample sample(const Ray& ray, double t) const {
        const ValueAndGradient v = evaluate_at(ray.at(t));
        return {t, v.value - 1, dot(v.gradient, ray.direction)};
    }

    /// From a place outside towards `inner`, which is inside: Newton's steps on a convex function stay outside.
    [[nodiscard]] double root_from(const Ray& ray, Sample outer, double inner) const {
        for (int i = 0; i < 100; ++i) {
            double next = outer.t - outer.f / outer.slope;
            if (!((next - outer.t) * (next - inner) <= 0)) next = 0.5 * (outer.t + inner);
            if (std::abs(next - outer.t) <= 4e-16 * std::abs(next)) return next;
            const Sample s = sample(ray, next);
            if (s.f > 0) {
                outer = s;
                continue;
            }
            // Rounding, or a bisection, came to the inside.
            if (std::abs(s.f) < 1e-15 || std::abs(next - outer.t) <= 1e-14 * std::abs(next)) return next;
            inner = next;
            const Sample middle = sample(ray, 0.5 * (outer.t + inner));
            if (middle.f > 0) outer = middle;
            else inner = middle.t;
        }
        return outer.t;
    }

    bool convex_crossings(const Ray& ray, Range in_box, Range range, CrossingList& out) const {
        const Sample first = sample(ray, in_box.lower);
        const Sample last = sample(ray, in_box.upper);
        const bool starts_inside = first.f < 0;
        double inner = starts_inside ? first.t : last.t;
        if (!starts_inside && !(last.f < 0)) {
            // Tangents at both ends bound a convex function from below; where they meet is the next place to look.
            Sample a = first;
            Sample b = last;
            for (int i = 0;; ++i) {
                if (!(a.slope < 0 && b.slope > 0) || i > 200) return false;
                double t = (b.f - a.f + a.slope * a.t - b.slope * b.t) / (a.slope - b.slope);
                if (a.f + a.slope * (t - a.t) >= 0) return false;
                if (i % 4 == 3 || !(t > a.t && t < b.t)) t = 0.5 * (a.t + b.t);
                if (!(t > a.t && t < b.t)) return false;
                const Sample s = sample(ray, t);
                if (s.f < 0) {
                    inner = t;
                    break;
                }
                (s.slope < 0 ? a : b) = s;
            }
        }
        if (!starts_inside) append({root_from(ray, first, inner)}, range, out);
        if (!(last.f < 0)) append({root_from(ray, last, inner)}, range, out);
        return starts_inside;
    }

    /// A place on a ray with what its coordinates have in the formula: |x|^p, |y|^p, |z|^q. They are monotone in the
    /// coordinates, so the least and most of two places bound the surface's value between them.
    struct Place {
        double t = 0;
        Vec3d size;   ///< |x|, |y|, |z|
        Vec3d terms;  ///< |x|^p, |y|^p, |z|^q
        double f = 0;
    };
    /// Below 0 inside.
    [[nodiscard]] double of_terms(Vec3d terms) const {
        const double around = terms.x + terms.y;
        return (p_ == q_ ? around : std::pow(around, q_ / p_)) + terms.z - 1;
    }
    [[nodiscard]] Place place(const Ray& ray, double t) const {
        Place at;
        at.t = t;
        const Vec3d p = ray.at(t);
        at.size = {std::abs(p.x), std::abs(p.y), std::abs(p.z)};
        at.terms = {std::pow(at.size.x, p_), std::pow(at.size.y, p_), std::pow(at.size.z, q_)};
        at.f = of_terms(at.terms);
        return at;
    }

    bool subdivided_crossings(const Ray& ray, Range in_box, Range range, CrossingList& out) const {
        // Between the places where a coordinate is 0, all coordinates' magnitudes are monotone.
        SmallVector<double, 5> cuts;
        cuts.push_back(in_box.lower);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double t = -ray.origin[axis] / ray.direction[axis];
            if (t > in_box.lower && t < in_box.upper) cuts.push_back(t);
        }
        cuts.push_back(in_box.upper);
        std::sort(cuts.begin(), cuts.end());
        const Place first = place(ray, cuts[0]);
        Place from = first;
        for (std::size_t i = 1; i < cuts.size(); ++i) {
            const Place to = place(ray, cuts[i]);
            if (from.t < to.t) subdivide(ray, from, to, 0, range, out);
            from = to;
        }
        return first.f < 0;
    }
    void subdivide(const Ray& ray, const Place& a, const Place& b, int depth, Range range, CrossingList& out) const {
        Vec3d least;
        Vec3d most;
        bool rises = true;
        bool falls = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            least[axis] = std::min(a.terms[axis], b.terms[axis]);
            most[axis] = std::max(a.terms[axis], b.terms[axis]);
            rises = rises && a.size[axis] <= b.size[axis];
            falls = falls && a.size[axis] >= b.size[axis];
        }
        const bool differ = (a.f < 0) != (b.f < 0);
        if (rises || falls || depth == 24) {
            if (differ) append({root_between(ray, a, b)}, range, out);
            return;
        }
        if (of_terms(least) >= 0 || of_terms(most) < 0) return;
        const Place middle = place(ray, 0.5 * (a.t + b.t));
        subdivide(ray, a, middle, depth + 1, range, out);
        subdivide(ray, middle, b, depth + 1, range, out);
    }
    /// Between two places on different sides: the rule of false position, where an end that stays gets half its value
    /// (the Illinois variant; Dowell & Jarratt: A Modified Regula Falsi Method, BIT 11, 1971), and halving if that is
    /// slow.
    [[nodiscard]] double root_between(const Ray& ray, const Place& a, const Place& b) const {
        double lower = a.t;
        double upper = b.t;
        double at_lower = a.f;
        double at_upper = b.f;
        int stayed = 0;  // steps for which the lower (negative) or the upper (positive) end has stayed
        for (int i = 0; i < 120 && upper - lower > 4e-16 * std::abs(upper); ++i) {
            double t = lower - at_lower * (upper - lower) / (at_upper - at_lower);
            if (i % 4 == 3 || !(t > lower && t < upper)) t = 0.5 * (lower + upper);
            const double f = place(ray, t).f;
            if (std::abs(f) < 1e-15) return t;
            if ((f < 0) == (a.f < 0)) {
                lower = t;
                at_lower = f;
                stayed = std::max(stayed, 0) + 1;
                if (stayed > 1) at_upper *= 0.5;
            } else {
                upper = t;
                at_upper = f;
                stayed = std::min(stayed, 0) - 1;
                if (stayed < -1) at_lower *= 0.5;
            }
        }
        return 0.5 * (lower + upper);
    }
    static void append(const Crossing& c, Range range, CrossingList& out) {
        if (range.contains(c.t)) out.push_back(c);
    }

    double p_, q_;
    bool convex_;
};

}  // namespace

ShapePointer make_shape(const scene::Superellipsoid& s, const SourceLocation& where) {
    if (!(s.east_west > 0 && s.north_south > 0))
        refuse_shape(where, "a superellipsoid's two exponents must be greater than 0");
    return std::make_shared<Superellipsoid>(s);
}

}  // namespace sundog::solids
