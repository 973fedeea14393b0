// SPDX-License-Identifier: Apache-2.0
// Eggs: a sphere around the origin, one around its top, and between them an arc, turned about the y axis, that touches
// both. The arc's radius is twice the larger sphere's, as silhouettes by POV-Ray 3.7 show.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "solids/convex_revolution.h"
#include "solids/shape.h"

namespace sundog::solids {
namespace {

class Ovus final : public Shape {
public:
    explicit Ovus(const scene::Ovus& o) : bottom_(o.bottom_radius), top_(o.top_radius) {
        if (top_ >= 2 * bottom_) {  // the upper sphere holds the other
            box_ = {{-top_, bottom_ - top_, -top_}, {top_, bottom_ + top_, top_}};
            only_top_ = true;
        } else {
            arc_ = 2 * std::max(bottom_, top_);
            const double to_bottom = arc_ - bottom_;
            const double to_top = arc_ - top_;
            arc_y_ = (to_bottom * to_bottom - to_top * to_top + bottom_ * bottom_) / (2 * bottom_);
            arc_x_ = -std::sqrt(std::max(to_bottom * to_bottom - arc_y_ * arc_y_, 0.0));
            const double reach = std::max(bottom_, arc_x_ + arc_);
            const double wide = std::max(reach, top_);
            box_ = {{-wide, -bottom_, -wide}, {wide, bottom_ + top_, wide}};
        }
        const double margin = 1e-3 * (bottom_ + top_);
        roomy_ = {box_.lower - Vec3d{margin, margin, margin}, box_.upper + Vec3d{margin, margin, margin}};
    }

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        const Range in_box = clip(roomy_, ray, {-kInfinity, kInfinity});
        if (!(in_box.lower < in_box.upper)) return false;
        Crossing enters;
        Crossing leaves;
        const auto f = [&](double t) { return distance(ray.at(t)); };
        if (!convex_interval(f, in_box.lower, in_box.upper, enters.t, leaves.t)) return false;
        return append_interval(enters, leaves, range, out);
    }
    [[nodiscard]] bool inside(Vec3d p) const override { return distance(p) < 0; }
    [[nodiscard]] Vec3d normal(Vec3d p, const Crossing&) const override {
        const double around = std::hypot(p.x, p.z);
        switch (part_of(around, p.y)) {
            case Part::bottom:
                return p;
            case Part::top:
                return {p.x, p.y - bottom_, p.z};
            default: {
                const double share = around > 0 ? (around - arc_x_) / around : 0;
                return {p.x * share, p.y - arc_y_, p.z * share};
            }
        }
    }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override { return transformed(m, box_); }
    /// As on a sphere, about a place that moves from one sphere's middle to the other's with their radii.
    [[nodiscard]] std::array<double, 2> uv(Vec3d p, const Crossing&) const override {
        const double middle = bottom_ * std::min(top_ / (2 * bottom_), 1.0);
        const Vec3d from = p - Vec3d{0, middle, 0};
        const double radius = length(from);
        const double v = 0.5 + std::asin(std::clamp(radius > 0 ? from.y / radius : 0, -1.0, 1.0)) / std::numbers::pi;
        double u = std::atan2(from.z, from.x) / (2 * std::numbers::pi);
        if (u < 0) u += 1;
        return {u, v};
    }

private:
    enum class Part : std::uint8_t { bottom, arc, top };
    /// Which circle of the profile a point of the half plane is nearest to: rays from the arc's middle through the
    /// spheres' part them.
    [[nodiscard]] Part part_of(double around, double y) const {
        if (only_top_) return Part::top;
        const double px = around - arc_x_;
        const double py = y - arc_y_;
        if (-arc_x_ * py - px * -arc_y_ < 0) return Part::bottom;          // under the way to (0, 0)
        if (-arc_x_ * py - px * (bottom_ - arc_y_) > 0) return Part::top;  // above the way to (0, bottom)
        return Part::arc;
    }
    /// From the surface; negative inside. Convex.
    [[nodiscard]] double distance(Vec3d p) const {
        const double around = std::hypot(p.x, p.z);
        switch (part_of(around, p.y)) {
            case Part::bottom:
                return length(p) - bottom_;
            case Part::top:
                return std::hypot(around, p.y - bottom_) - top_;
            default:
                return std::hypot(around - arc_x_, p.y - arc_y_) - arc_;
        }
    }

    double bottom_, top_;
    double arc_ = 0, arc_x_ = 0, arc_y_ = 0;  ///< Radius and middle of the arc, in the half plane of x >= 0.
    bool only_top_ = false;
    Bounds3d box_, roomy_;
};

}  // namespace

ShapePointer make_shape(const scene::Ovus& ovus, const SourceLocation& where) {
    if (!(ovus.bottom_radius > 0) || !(ovus.top_radius > 0))
        refuse_shape(where, "an ovus has two radii greater than 0");
    return std::make_shared<Ovus>(ovus);
}

}  // namespace sundog::solids
