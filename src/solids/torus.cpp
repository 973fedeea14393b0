// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "solids/roots.h"
#include "solids/shape.h"

namespace sundog::solids {
namespace {

// Inside where (|p|^2 + R^2 - r^2)^2 < 4*R^2*(x^2 + z^2). Where r > R its inner part is outside again, as in POV-Ray.
class Torus final : public Shape {
public:
    explicit Torus(const scene::Torus& t) : major_(std::abs(t.major_radius)), minor_(std::abs(t.minor_radius)) {
        const double reach = major_ + minor_;
        box_ = {{-reach, -minor_, -reach}, {reach, minor_, reach}};
        // Where a ray enters this larger one, it is outside beyond doubt.
        const double margin = 1e-6 * reach;
        roomy_box_ = {box_.lower - Vec3d{margin, margin, margin}, box_.upper + Vec3d{margin, margin, margin}};
    }

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        return find(ray, range, out, false);
    }
    bool first_crossing(const Ray& ray, Range range, CrossingList& out) const override {
        return find(ray, range, out, true);
    }
    bool find(const Ray& ray, Range range, CrossingList& out, bool only_first) const {
        const Range in_box = clip(roomy_box_, ray, range);
        if (!(in_box.lower < in_box.upper)) return false;
        // In units of the torus and of the way through its box, where all coefficients are of one size.
        const double unit = 1 / (major_ + minor_);
        const Vec3d o = ray.at(in_box.lower) * unit;
        const Vec3d d = ray.direction * ((in_box.upper - in_box.lower) * unit);
        const double big = major_ * unit;
        const double small = minor_ * unit;
        // |p|^2 + R^2 - r^2 = a*s^2 + 2*b*s + c
        const double a = dot(d, d);
        const double b = dot(o, d);
        const double c = dot(o, o) + (big - small) * (big + small);
        const double k = 4 * big * big;
        std::array<double, 5> quartic{c * c - k * (o.x * o.x + o.z * o.z), 4 * b * c - 2 * k * (o.x * d.x + o.z * d.z),
                                      4 * b * b + 2 * a * c - k * (d.x * d.x + d.z * d.z), 4 * a * b, a * a};
        bernstein_from_power(quartic);
        RootList roots;
        if (only_first) append_first_bernstein_root(quartic, roots);
        else append_bernstein_roots(quartic, roots);
        for (const double s : roots) {
            const double t = in_box.lower + s * (in_box.upper - in_box.lower);
            if (range.contains(t)) out.push_back({t});
            else if (only_first) return find(ray, range, out, false);
        }
        return quartic[0] < 0;
    }
    [[nodiscard]] bool inside(Vec3d p) const override {
        const double around = std::hypot(p.x, p.z);
        const double k = dot(p, p) + (major_ - minor_) * (major_ + minor_);
        return std::abs(k) < 2 * major_ * around;
    }
    [[nodiscard]] Vec3d normal(Vec3d p, const Crossing&) const override {
        const double k = dot(p, p) + (major_ - minor_) * (major_ + minor_);
        const double flat = k - 2 * major_ * major_;
        return {p.x * flat, p.y * k, p.z * flat};
    }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override { return transformed(m, box_); }
    // u once around the y axis, v once around the ring.
    [[nodiscard]] std::array<double, 2> uv(Vec3d p, const Crossing&) const override {
        const double around = std::hypot(p.x, p.z);
        double u = 1 - (std::numbers::pi + std::atan2(p.z, p.x)) / (2 * std::numbers::pi);
        const double v = (std::numbers::pi + std::atan2(p.y, around - major_)) / (2 * std::numbers::pi);
        if (u < 0) u += 1;
        return {u, v};
    }
    [[nodiscard]] ShapeNumbers numbers() const override {
        return ShapeNumbers{ShapeNumbers::Kind::torus, {}}.add(major_).add(minor_);
    }

private:
    double major_, minor_;
    Bounds3d box_, roomy_box_;
};

}  // namespace

ShapePointer make_shape(const scene::Torus& torus, const SourceLocation& where) {
    if (torus.minor_radius == 0) refuse_shape(where, "a torus must have a minor radius other than 0");
    return std::make_shared<Torus>(torus);
}

}  // namespace sundog::solids
