// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "solids/shape.h"

namespace sundog::solids {
namespace {

/// (a^p + b^p)^(1/p) for a, b >= 0, without overflow.
double norm(double a, double b, double p) {
    const double most = std::max(a, b);
    if (most == 0) return 0;
    const double least = std::min(a, b) / most;
    return most * std::pow(1 + std::pow(least, p), 1 / p);
}

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
    [[nodiscard]] double value(Vec3d p) const {
        return norm(norm(std::abs(p.x), std::abs(p.y), p_), std::abs(p.z), q_);
    }
    /// Of value(): its length is near 1, and it is 0 nowhere but at the centre.
    [[nodiscard]] Vec3d gradient(Vec3d p) const {
        const double around = norm(std::abs(p.x), std::abs(p.y), p_);
        const double all = norm(around, std::abs(p.z), q_);
        if (all == 0) return {};
        const double of_around = std::pow(around / all, q_ - 1);
        const auto part = [](double share, double exponent, double sign_of) {
            return share == 0 && exponent <= 0 ? 0 : std::copysign(std::pow(share, exponent), sign_of);
        };
        Vec3d g{0, 0, part(std::abs(p.z) / all, q_ - 1, p.z)};
        if (around > 0) {
            g.x = of_around * part(std::abs(p.x) / around, p_ - 1, p.x);
            g.y = of_around * part(std::abs(p.y) / around, p_ - 1, p.y);
        }
        return g;
    }
    [[nodiscard]] double slope(const Ray& ray, double t) const { return dot(gradient(ray.at(t)), ray.direction); }

    /// From a place outside towards the inside: Newton's steps on a convex function stay outside. `inner` is inside.
    [[nodiscard]] double root_from(const Ray& ray, double outer, double inner) const {
        for (int i = 0; i < 100; ++i) {
            const double f = value(ray.at(outer)) - 1;
            if (f <= 0) return outer;
            double next = outer - f / slope(ray, outer);
            const bool between = (next - outer) * (next - inner) <= 0;
            if (!between) next = 0.5 * (outer + inner);
            if (value(ray.at(next)) < 1 && next != outer) {
                if (std::abs(next - outer) <= 1e-14 * (std::abs(next) + std::abs(outer))) return next;
                inner = next;  // rounding, or a bisection, came too far
                next = 0.5 * (outer + inner);
                if (value(ray.at(next)) < 1) {
                    inner = next;
                    continue;
                }
            }
            if (std::abs(next - outer) <= 1e-15 * std::abs(outer)) return next;
            outer = next;
        }
        return outer;
    }

    bool convex_crossings(const Ray& ray, Range in_box, Range range, CrossingList& out) const {
        double a = in_box.lower;
        double b = in_box.upper;
        double fa = value(ray.at(a));
        double fb = value(ray.at(b));
        const bool starts_inside = fa < 1;
        double inner = a;
        if (!starts_inside && fb < 1) inner = b;
        // Tangents at both ends bound a convex function from below; where they meet is the next place to look.
        double sa = slope(ray, a);
        double sb = slope(ray, b);
        for (int i = 0; !(fa < 1) && !(fb < 1); ++i) {
            if (!(sa < 0 && sb > 0) || i > 200) return false;
            double t = (fb - fa + sa * a - sb * b) / (sa - sb);
            if (fa + sa * (t - a) >= 1) return false;
            if (i % 4 == 3 || !(t > a && t < b)) t = 0.5 * (a + b);
            if (!(t > a && t < b)) return false;
            const double f = value(ray.at(t));
            const double s = slope(ray, t);
            if (f < 1) {
                inner = t;
                break;
            }
            if (s < 0) a = t, fa = f, sa = s;
            else b = t, fb = f, sb = s;
        }
        if (!starts_inside) append({root_from(ray, in_box.lower, inner)}, range, out);
        if (value(ray.at(in_box.upper)) >= 1) append({root_from(ray, in_box.upper, inner)}, range, out);
        return starts_inside;
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
        for (std::size_t i = 1; i < cuts.size(); ++i) {
            if (cuts[i - 1] < cuts[i]) subdivide(ray, cuts[i - 1], cuts[i], 0, range, out);
        }
        return value(ray.at(in_box.lower)) < 1;
    }
    void subdivide(const Ray& ray, double a, double b, int depth, Range range, CrossingList& out) const {
        const Vec3d pa = ray.at(a);
        const Vec3d pb = ray.at(b);
        Vec3d least;
        Vec3d most;
        bool rises = true;
        bool falls = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double u = std::abs(pa[axis]);
            const double v = std::abs(pb[axis]);
            least[axis] = std::min(u, v);
            most[axis] = std::max(u, v);
            rises = rises && u <= v;
            falls = falls && u >= v;
        }
        if (value(least) >= 1 || value(most) < 1) return;
        const bool differ = (value(pa) < 1) != (value(pb) < 1);
        if (rises || falls || depth == 24) {
            if (differ) append({bisected(ray, a, b)}, range, out);
            return;
        }
        const double middle = 0.5 * (a + b);
        subdivide(ray, a, middle, depth + 1, range, out);
        subdivide(ray, middle, b, depth + 1, range, out);
    }
    [[nodiscard]] double bisected(const Ray& ray, double a, double b) const {
        const bool a_inside = value(ray.at(a)) < 1;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (a + b);
            if ((value(ray.at(middle)) < 1) == a_inside) a = middle;
            else b = middle;
        }
        return 0.5 * (a + b);
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
