// SPDX-License-Identifier: Apache-2.0
// Lemons (POV-Ray 3.8): an arc over the way between two discs, turned about that way.
#include <algorithm>
#include <cmath>

#include "solids/convex_revolution.h"
#include "solids/shape.h"

namespace sundog::solids {
namespace {

constexpr std::uint32_t kSide = 0, kBase = 1, kApex = 2;

// In a space of its own with the axis along y from 0 to height: inside where the arc, the base and the apex all say so.
class Lemon final : public Shape {
public:
    explicit Lemon(const scene::Lemon& l) : open_(l.open) {
        base_radius_ = std::abs(l.base_radius);
        apex_radius_ = std::abs(l.apex_radius);
        const Vec3d axis = l.apex - l.base;
        height_ = length(axis);
        const Vec3d up = axis * (1 / height_);
        const Vec3d side = std::abs(up.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
        const Vec3d x = normalize(cross(side, up));
        shape_from_own_ = {x, up, cross(x, up), l.base};
        own_from_shape_ = inverse(shape_from_own_);
        // The arc's middle is on the middle line of its two ends.
        const double dx = apex_radius_ - base_radius_;
        const double half = 0.5 * std::hypot(height_, dx);
        arc_ = std::max(std::abs(l.inner_radius), half);  // a smaller circle doesn't reach from end to end
        const double back = std::sqrt(std::max(arc_ * arc_ - half * half, 0.0)) / (2 * half);
        arc_x_ = 0.5 * (base_radius_ + apex_radius_) - back * height_;
        arc_y_ = 0.5 * height_ + back * dx;
        // Widest at the arc's middle, unless that lies beyond an end.
        const double widest = std::clamp(arc_y_, 0.0, height_);
        const double wide = arc_x_ + std::sqrt(std::max(arc_ * arc_ - (widest - arc_y_) * (widest - arc_y_), 0.0));
        box_ = {{-wide, 0, -wide}, {wide, height_, wide}};
        const double margin = 1e-3 * (wide + height_);
        roomy_ = {box_.lower - Vec3d{margin, margin, margin}, box_.upper + Vec3d{margin, margin, margin}};
    }

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        const Ray own = transform_ray(own_from_shape_, ray);
        const Range in_box = clip(roomy_, own, {-kInfinity, kInfinity});
        if (!(in_box.lower < in_box.upper)) return false;
        Crossing enters;
        Crossing leaves;
        const auto f = [&](double t) { return distance(own.at(t)); };
        if (!convex_interval(f, in_box.lower, in_box.upper, enters.t, leaves.t)) return false;
        for (Crossing* crossing : {&enters, &leaves}) {
            crossing->part = part_of(own.at(crossing->t));
            crossing->visible = !open_ || crossing->part == kSide;
        }
        return append_interval(enters, leaves, range, out);
    }
    [[nodiscard]] bool inside(Vec3d p) const override { return distance(transform_point(own_from_shape_, p)) < 0; }
    [[nodiscard]] Vec3d normal(Vec3d p, const Crossing& crossing) const override {
        if (crossing.part != kSide) return shape_from_own_.y * (crossing.part == kBase ? -1.0 : 1.0);
        const Vec3d own = transform_point(own_from_shape_, p);
        const double around = std::hypot(own.x, own.z);
        const double share = around > 0 ? (around - arc_x_) / around : 0;
        return transform_vector(shape_from_own_, {own.x * share, own.y - arc_y_, own.z * share});
    }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override { return transformed(m * shape_from_own_, box_); }

private:
    [[nodiscard]] double side_distance(Vec3d own) const {
        return std::hypot(std::max(std::hypot(own.x, own.z) - arc_x_, 0.0), own.y - arc_y_) - arc_;
    }
    /// Negative inside, convex; the distance from the surface but near the rims.
    [[nodiscard]] double distance(Vec3d own) const {
        return std::max(side_distance(own), std::max(-own.y, own.y - height_));
    }
    [[nodiscard]] std::uint32_t part_of(Vec3d own) const {
        const double side = side_distance(own);
        if (-own.y > side && -own.y > own.y - height_) return kBase;
        return own.y - height_ > side ? kApex : kSide;
    }

    double base_radius_ = 0, apex_radius_ = 0, height_ = 1;
    double arc_ = 1, arc_x_ = 0, arc_y_ = 0;
    bool open_;
    Affine3d shape_from_own_, own_from_shape_;
    Bounds3d box_, roomy_;
};

}  // namespace

ShapePointer make_shape(const scene::Lemon& lemon, const SourceLocation& where) {
    if (!(length(lemon.apex - lemon.base) > 0)) refuse_shape(where, "a lemon's ends must be apart");
    return std::make_shared<Lemon>(lemon);
}

}  // namespace sundog::solids
