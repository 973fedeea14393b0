// SPDX-License-Identifier: Apache-2.0
// Slices of Julia sets of numbers of four parts (POV-Ray reference, section 3.4.5.1.7): inside where no h(n+1) =
// f(h(n)) + p, up to the last iteration, leaves the ball of radius 4. A ray goes on by estimates of how far the surface
// is (Hart, Sandin and Kauffman 1989), the changes between two steps are halved down.
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/four_lanes.h"
#include "solids/four_numbers.h"
#include "solids/shape.h"

namespace sundog::solids {
namespace {

constexpr double kEscape = 4;

class JuliaFractal final : public Shape {
public:
    explicit JuliaFractal(const scene::JuliaFractal& j)
        : j_(j),
          // As POV-Ray 3.7's pictures show, hypercomplex sequences end one number earlier.
          iterations_(j.hypercomplex ? j.max_iteration - 1 : j.max_iteration),
          guesses_(!j.hypercomplex || j.function == scene::JuliaFractal::Function::sqr),
          algebraic_(j.function == scene::JuliaFractal::Function::sqr ||
                     j.function == scene::JuliaFractal::Function::cube),
          exponent_(j.exponent[0], j.exponent[1]),
          parameter_pair_(FourNumber{j.parameter}),
          finest_(0.25 / std::max(j.precision, 1.0)),
          coarsest_(j.hypercomplex && j.function != scene::JuliaFractal::Function::sqr
                        ? std::max(1 / std::max(j.precision, 1.0), 0.02)
                        : 0.25) {
        for (double level = std::log(kEscape); levels_.size() <= static_cast<std::size_t>(iterations_);
             level /= j.function == scene::JuliaFractal::Function::cube ? 3 : 2)
            levels_.push_back(level);
        const double length_of_normal = std::sqrt(solids::squared(FourNumber{j.slice}));
        for (std::size_t i = 0; i < 4; ++i) normal_[i] = j.slice[i] / length_of_normal;
        radius_ = reach();
    }

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        return march(ray, range, out, false);
    }
    bool first_crossing(const Ray& ray, Range range, CrossingList& out) const override {
        return march(ray, range, out, true);
    }
    [[nodiscard]] bool inside(Vec3d p) const override { return dot(p, p) <= radius_ * radius_ && probe(p).inside; }
    [[nodiscard]] Vec3d normal(Vec3d p, const Crossing&) const override {
        if (dot(p, p) > radius_ * radius_ * (1 - 1e-9)) return p;
        const Vec3d n = j_.hypercomplex ? hypercomplex_slope(p) : quaternion_slope(p);
        return is_finite(n) && dot(n, n) > 0 ? n : p;
    }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override {
        return transformed(m, {{-radius_, -radius_, -radius_}, {radius_, radius_, radius_}});
    }

private:
    struct Probe {
        bool inside = false;
        double step = 0;  ///< How far the surface is, about.
        double excess =
            0;  ///< About ln|h(last)| - ln 4, which is 0 on the surface; 0 everywhere where that isn't known.
    };

    /// The point of the slice above p.
    [[nodiscard]] FourNumber lifted(Vec3d p) const {
        return {p.x, p.y, p.z, (j_.distance - normal_[0] * p.x - normal_[1] * p.y - normal_[2] * p.z) / normal_[3]};
    }
    /// How the slice's fourth part changes with x, y, z.
    [[nodiscard]] std::array<FourNumber, 3> tangents() const {
        return {FourNumber{1, 0, 0, -normal_[0] / normal_[3]}, FourNumber{0, 1, 0, -normal_[1] / normal_[3]},
                FourNumber{0, 0, 1, -normal_[2] / normal_[3]}};
    }
    /// How far from the origin the inside can be.
    [[nodiscard]] double reach() const {
        const double p = std::sqrt(solids::squared(FourNumber{j_.parameter}));
        using Function = scene::JuliaFractal::Function;
        // Squares and cubes of what is inside lie within 4 + |p|; hypercomplex ones can be up to twice as large.
        const double power = (kEscape + p) * (j_.hypercomplex ? 4 : 1);
        if (j_.function == Function::sqr) return std::min(std::sqrt(power), kEscape);
        if (j_.function == Function::cube) return std::min(std::cbrt(power), kEscape);
        return kEscape;
    }

    [[nodiscard]] FourNumber quaternion_next(const FourNumber& h) const {
        const double vector = h[1] * h[1] + h[2] * h[2] + h[3] * h[3];
        double real = 0;
        double factor = 0;
        if (j_.function == scene::JuliaFractal::Function::cube) {
            real = h[0] * (h[0] * h[0] - 3 * vector);
            factor = 3 * h[0] * h[0] - vector;
        } else {
            real = h[0] * h[0] - vector;
            factor = 2 * h[0];
        }
        return {real + j_.parameter[0], factor * h[1] + j_.parameter[1], factor * h[2] + j_.parameter[2],
                factor * h[3] + j_.parameter[3]};
    }

    [[nodiscard]] Probe probe(Vec3d p) const {
        if (j_.hypercomplex && j_.function != scene::JuliaFractal::Function::sqr) return hypercomplex_probe(p);
        const Iterates<double> last = iterates<double>(p.x, p.y, p.z);
        return told_by(last.squared, last.squared_slope, last.count);
    }

    /// Where sequences end: the first numbers beyond 4, or the last ones.
    template <class V>
    struct Iterates {
        V squared;        ///< Of their size.
        V squared_slope;  ///< How much farther apart they are than the points that they started at.
        V count;          ///< How many came before.
    };

    /// For points of the slice; of quaternions, and of squares of hypercomplex numbers. V: a number or FourLanes.
    template <class V>
    [[nodiscard]] Iterates<V> iterates(const V& x, const V& y, const V& z) const {
        const V w = (V(j_.distance) - x * V(normal_[0]) - y * V(normal_[1]) - z * V(normal_[2])) * V(1 / normal_[3]);
        if (j_.hypercomplex) return hypercomplex_squares<V>(x - w, y + z, x + w, y - z);
        if (j_.function == scene::JuliaFractal::Function::cube) return quaternions<V, true>(x, y, z, w);
        return quaternions<V, false>(x, y, z, w);
    }

    template <class V, bool cubes>
    [[nodiscard]] Iterates<V> quaternions(V a, V b, V c, V d) const {
        const V most(kEscape * kEscape);
        V vector = b * b + c * c + d * d;
        Iterates<V> out{a * a + vector, V(1), V(0)};
        for (int n = 0; n < iterations_; ++n) {
            const auto goes_on = out.squared <= most;
            if (!any(goes_on)) break;
            const V steeper = cubes ? V(9) * out.squared * out.squared : V(4) * out.squared;
            const V real = cubes ? a * (a * a - V(3) * vector) : a * a - vector;
            const V factor = cubes ? V(3) * a * a - vector : V(2) * a;
            a = choose(goes_on, real + V(j_.parameter[0]), a);
            b = choose(goes_on, factor * b + V(j_.parameter[1]), b);
            c = choose(goes_on, factor * c + V(j_.parameter[2]), c);
            d = choose(goes_on, factor * d + V(j_.parameter[3]), d);
            vector = b * b + c * c + d * d;
            out.squared_slope = choose(goes_on, out.squared_slope * steeper, out.squared_slope);
            out.count = choose(goes_on, out.count + V(1), out.count);
            out.squared = a * a + vector;
        }
        return out;
    }

    /// Of pairs of complex numbers (ComplexPair).
    template <class V>
    [[nodiscard]] Iterates<V> hypercomplex_squares(V ur, V ui, V vr, V vi) const {
        const V pur(parameter_pair_.u.real()), pui(parameter_pair_.u.imag());
        const V pvr(parameter_pair_.v.real()), pvi(parameter_pair_.v.imag());
        const V most(kEscape * kEscape);
        V u = ur * ur + ui * ui, v = vr * vr + vi * vi;
        Iterates<V> out{V(0.5) * (u + v), V(1), V(0)};
        for (int n = 0; n < iterations_; ++n) {
            const auto goes_on = out.squared <= most;
            if (!any(goes_on)) break;
            out.squared_slope = choose(goes_on, out.squared_slope * V(4) * larger(u, v), out.squared_slope);
            const V next_ui = V(2) * ur * ui + pui, next_vi = V(2) * vr * vi + pvi;
            ur = choose(goes_on, V(2) * ur * ur - u + pur, ur);
            vr = choose(goes_on, V(2) * vr * vr - v + pvr, vr);
            ui = choose(goes_on, next_ui, ui);
            vi = choose(goes_on, next_vi, vi);
            u = ur * ur + ui * ui;
            v = vr * vr + vi * vi;
            out.count = choose(goes_on, out.count + V(1), out.count);
            out.squared = V(0.5) * (u + v);
        }
        return out;
    }

    /// What the end of a sequence says of its start.
    [[nodiscard]] Probe told_by(double squared, double squared_slope, double count) const {
        // Not told by the root, which rounds what is just outside to the border.
        const bool inside = squared <= kEscape * kEscape;
        const double size = std::sqrt(squared);
        const double slope = std::sqrt(squared_slope);
        if (inside) return {true, slope > 0 ? (kEscape - size) / slope : coarsest_, excess_inside(size)};
        return outside_by_potential(size, slope, static_cast<int>(count));
    }

    /// By other functions of hypercomplex numbers.
    [[nodiscard]] Probe hypercomplex_probe(Vec3d p) const {
        ComplexPair h(lifted(p));
        double slope = 1;
        double size = h.squared();
        for (int n = 0; n < iterations_ && size <= kEscape * kEscape; ++n) {
            if (!algebraic_) {
                h.u = julia_value(j_.function, h.u, exponent_) + parameter_pair_.u;
                h.v = julia_value(j_.function, h.v, exponent_) + parameter_pair_.v;
                size = h.squared();
                continue;
            }
            const ComplexValue u = julia_function(j_.function, h.u, exponent_);
            const ComplexValue v = julia_function(j_.function, h.v, exponent_);
            slope *= std::sqrt(std::max(std::norm(u.slope), std::norm(v.slope)));
            h.u = u.value + parameter_pair_.u;
            h.v = v.value + parameter_pair_.v;
            size = h.squared();
        }
        if (!algebraic_) return {size <= kEscape * kEscape, 2 * coarsest_};
        if (!(size <= kEscape * kEscape)) return {false, (std::sqrt(size) - kEscape) / slope};
        return {true, (kEscape - std::sqrt(size)) / slope};
    }

    /// By the potential ln|h(n)| / 2^n, which on the surface is about ln 4 / 2^last.
    [[nodiscard]] Probe outside_by_potential(double size, double slope, int n) const {
        const double level = levels_[static_cast<std::size_t>(iterations_ - n)];
        const double over = std::log(size) - level;
        return {false, size * over / slope, over * (levels_[0] / level)};
    }
    /// A line near ln(size / 4) that costs less than the logarithm, and ends.
    static double excess_inside(double size) { return size / kEscape - 1; }

    /// The slope of |h|^2 at the iteration that comes nearest to the surface.
    [[nodiscard]] Vec3d quaternion_slope(Vec3d p) const {
        FourNumber h = lifted(p);
        std::array<FourNumber, 3> by = tangents();
        const bool cube = j_.function == scene::JuliaFractal::Function::cube;
        for (int n = 0; n < iterations_ && squared_under_escape(solids::squared(h)); ++n) {
            for (FourNumber& d : by) {
                const FourNumber a = quaternion_product(h, d);
                const FourNumber b = quaternion_product(d, h);
                FourNumber sum{a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]};
                if (cube) {  // h*h*d + h*d*h + d*h*h
                    const FourNumber hhd = quaternion_product(h, a);
                    const FourNumber hdh = quaternion_product(a, h);
                    const FourNumber dhh = quaternion_product(b, h);
                    for (std::size_t i = 0; i < 4; ++i) sum[i] = hhd[i] + hdh[i] + dhh[i];
                }
                d = sum;
            }
            h = quaternion_next(h);
        }
        const auto along = [&](const FourNumber& d) { return h[0] * d[0] + h[1] * d[1] + h[2] * d[2] + h[3] * d[3]; };
        return scaled({along(by[0]), along(by[1]), along(by[2])});
    }

    [[nodiscard]] Vec3d hypercomplex_slope(Vec3d p) const {
        ComplexPair h(lifted(p));
        std::complex<double> by_u = 1;
        std::complex<double> by_v = 1;
        for (int n = 0; n < iterations_ && squared_under_escape(h.squared()); ++n) {
            const ComplexValue u = julia_function(j_.function, h.u, exponent_);
            const ComplexValue v = julia_function(j_.function, h.v, exponent_);
            by_u *= u.slope;
            by_v *= v.slope;
            h.u = u.value + parameter_pair_.u;
            h.v = v.value + parameter_pair_.v;
        }
        Vec3d slope;
        const std::array<FourNumber, 3> along = tangents();
        for (std::size_t i = 0; i < 3; ++i) {
            const ComplexPair d(along[i]);
            slope[i] = std::real(std::conj(h.u) * by_u * d.u) + std::real(std::conj(h.v) * by_v * d.v);
        }
        return scaled(slope);
    }
    /// Points of the surface may be found a little outside or inside.
    static bool squared_under_escape(double size) { return size <= kEscape * kEscape * (1 - 1e-6); }
    /// Slopes grow with every iteration; of them only the direction counts.
    static Vec3d scaled(Vec3d v) {
        const double most = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
        return most > 0 && std::isfinite(most) ? v * (1 / most) : v;
    }

    [[nodiscard]] double step_of(const Probe& here) const {
        const double wanted = 0.5 * here.step;
        return std::clamp(wanted > 0 ? wanted : finest_, finest_, coarsest_);
    }

    /// Places along a ray, each a step farther than the last, the steps growing alike.
    struct Ahead {
        static constexpr std::size_t kCount = 4;
        Ahead(const Ray& on, double t, double step, double growth, double end) : ray(on) {
            for (double& next : place) {
                t = next = std::min(t + step, end);
                step *= growth;
            }
        }
        void probe(const JuliaFractal& of) {
            const FourLanes t(place[0], place[1], place[2], place[3]);
            found = of.iterates<FourLanes>(FourLanes(ray.origin.x) + t * FourLanes(ray.direction.x),
                                           FourLanes(ray.origin.y) + t * FourLanes(ray.direction.y),
                                           FourLanes(ray.origin.z) + t * FourLanes(ray.direction.z));
        }
        [[nodiscard]] Probe told(const JuliaFractal& of, std::size_t k) const {
            return of.told_by(found.squared[k], found.squared_slope[k], found.count[k]);
        }
        const Ray& ray;
        std::array<double, kCount> place{};
        Iterates<FourLanes> found{0, 0, 0};
    };

    bool march(const Ray& ray, Range range, CrossingList& out, bool only_first) const {
        const double a = dot(ray.direction, ray.direction);
        const double middle = -dot(ray.origin, ray.direction) / a;
        const Vec3d nearest = ray.at(middle);
        const double room = radius_ * radius_ - dot(nearest, nearest);
        if (!(room > 0)) return false;
        const double half = std::sqrt(room / a);
        const Range within{std::max(middle - half, range.lower), std::min(middle + half, range.upper)};
        if (!(within.lower < within.upper)) return false;
        const double unit = 1 / std::sqrt(a);

        Probe here = probe(ray.at(within.lower));
        const bool starts_inside = middle - half <= range.lower && here.inside;
        if (here.inside && !starts_inside && range.contains(within.lower)) {
            out.push_back({within.lower});  // the ball's own surface
            if (only_first) return false;
        }
        double t = within.lower;
        double last_step = 0;
        while (t < within.upper) {
            // Further probes are made where the next steps are likely to lead: they cost hardly anything beside one.
            const double step = step_of(here) * unit;
            const double growth = last_step > 0 ? std::clamp(step / last_step, 0.5, 2.0) : 1;
            Ahead ahead(ray, t, step, growth, within.upper);
            if (!(ahead.place[0] > t)) break;
            if (guesses_) ahead.probe(*this);
            for (std::size_t k = 0; k < Ahead::kCount && t < within.upper; ++k) {
                const double next = ahead.place[k];
                // One that lies farther than the last one allows says nothing.
                if (k > 0 && (!guesses_ || next - t > step_of(here) * unit * (1 + 1e-9))) break;
                const Probe there = guesses_ ? ahead.told(*this, k) : probe(ray.at(next));
                if (there.inside != here.inside) {
                    const double place = change_between(ray, t, here, next, there);
                    if (range.contains(place)) out.push_back({place});
                    if (only_first && !out.empty()) return starts_inside;
                }
                last_step = next - t;
                t = next;
                here = there;
            }
        }
        const bool was_inside = here.inside;
        // What is still inside ends with the ball.
        if (was_inside && middle + half <= range.upper && range.contains(middle + half)) out.push_back({middle + half});
        return starts_inside;
    }
    /// Where the inside begins or ends between two places, a little beyond: by the ITP method (Oliveira and Takahashi
    /// 2020), which draws both ends together about as fast as the secant does, and never slower than halving.
    [[nodiscard]] double change_between(const Ray& ray, double a, const Probe& at_a, double b,
                                        const Probe& at_b) const {
        double fa = at_a.excess, fb = at_b.excess;
        // What single precision can't tell apart by far.
        const double tolerance = 5e-11 * std::max(std::abs(a), std::abs(b));
        const double kappa = 0.2 / (b - a);
        double slack = tolerance * std::exp2(std::ceil(std::log2((b - a) / (2 * tolerance))) + 1);
        for (; b - a > 2 * tolerance; slack *= 0.5) {
            const double middle = 0.5 * (a + b);
            if (!(middle > a && middle < b)) break;
            double t = middle;
            // Where the excess isn't known, halving is left.
            if ((fa < 0) != (fb < 0)) {
                const double secant = (fb * a - fa * b) / (fb - fa);
                const double towards = middle < secant ? -1 : 1;
                const double off = std::abs(middle - secant);
                const double truncation = kappa * (b - a) * (b - a);
                t = truncation <= off ? secant + towards * truncation : middle;
                const double most_off = slack - 0.5 * (b - a);
                if (std::abs(t - middle) > most_off) t = middle - towards * most_off;
                if (!(t > a && t < b)) t = middle;
            }
            const Probe there = probe(ray.at(t));
            if (there.inside == at_a.inside) a = t, fa = there.excess;
            else b = t, fb = there.excess;
        }
        return b;
    }

    scene::JuliaFractal j_;
    int iterations_;
    bool guesses_;    ///< Several steps are tried at a time.
    bool algebraic_;  ///< A function without edges, whose slope tells how far the surface is.
    std::complex<double> exponent_;
    ComplexPair parameter_pair_;
    double finest_, coarsest_;    ///< Steps along a ray.
    std::vector<double> levels_;  ///< ln 4 / 2^k (3^k of cubes): the surface's potential k numbers before the last.
    FourNumber normal_{};
    double radius_ = kEscape;
};

}  // namespace

ShapePointer make_shape(const scene::JuliaFractal& fractal, const SourceLocation& where) {
    if (fractal.slice[3] == 0) refuse_shape(where, "a julia_fractal's slice must have a fourth component other than 0");
    using Function = scene::JuliaFractal::Function;
    if (!fractal.hypercomplex && fractal.function != Function::sqr && fractal.function != Function::cube)
        refuse_shape(where, "quaternions have the functions sqr and cube alone", "write hypercomplex");
    return std::make_shared<JuliaFractal>(fractal);
}

}  // namespace sundog::solids
