// SPDX-License-Identifier: Apache-2.0
// Cones, their frustums, and cylinders.
#include <algorithm>
#include <array>
#include <cmath>

#include "solids/shape.h"

namespace sundog::solids {
namespace {

constexpr std::uint32_t kBase = 1, kCap = 2;  // the side is 0

class Cone final : public Shape {
public:
    explicit Cone(const scene::SolidCone& c)
        : base_(c.base),
          height_(length(c.cap - c.base)),
          axis_((c.cap - c.base) / height_),
          base_radius_(std::abs(c.base_radius)),
          cap_radius_(std::abs(c.cap_radius)),
          slope_((cap_radius_ - base_radius_) / height_),
          open_(c.open) {}

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        std::array<Piece, 2> inside;
        const int count = pieces(ray, inside);
        bool starts_inside = false;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
            if (append_interval(inside[i].lower, inside[i].upper, range, out)) starts_inside = true;
        return starts_inside;
    }
    bool stretch(const Ray& ray, Range range, Stretch& out) const override {
        std::array<Piece, 2> inside;
        const int count = pieces(ray, inside);
        return count > 0 &&
               stretch_between(inside[0].lower, inside[static_cast<std::size_t>(count - 1)].upper, range, out);
    }
    [[nodiscard]] bool is_quick() const override { return true; }
    [[nodiscard]] bool is_convex() const override { return !open_; }
    [[nodiscard]] bool inside(Vec3d p) const override {
        const double z = dot(p - base_, axis_);
        if (!(z > 0 && z < height_)) return false;
        const Vec3d off_axis = p - base_ - axis_ * z;
        const double radius = base_radius_ + slope_ * z;
        return dot(off_axis, off_axis) < radius * radius;
    }
    [[nodiscard]] Vec3d normal(Vec3d p, const Crossing& c) const override {
        if (c.part == kBase) return -axis_;
        if (c.part == kCap) return axis_;
        const Vec3d from_base = p - base_;
        const Vec3d off_axis = from_base - axis_ * dot(from_base, axis_);
        const double off = length(off_axis);
        return off > 0 ? off_axis - axis_ * (slope_ * off) : axis_ * (slope_ < 0 ? 1 : -1);
    }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override {
        // The hull of its two end circles; a carried circle reaches along a world axis as far as the part of that row
        // of the matrix that is perpendicular to the cone's axis.
        Bounds3d out;
        const Vec3d rows[3] = {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
        Vec3d reach;
        for (std::size_t i = 0; i < 3; ++i) reach[i] = length(rows[i] - axis_ * dot(rows[i], axis_));
        const Vec3d base = transform_point(m, base_);
        const Vec3d cap = transform_point(m, base_ + axis_ * height_);
        out.include(base - reach * base_radius_);
        out.include(base + reach * base_radius_);
        out.include(cap - reach * cap_radius_);
        out.include(cap + reach * cap_radius_);
        return out;
    }
    [[nodiscard]] ShapeNumbers numbers() const override {
        ShapeNumbers out{ShapeNumbers::Kind::cone, {}};
        return out.add(base_).add(height_).add(axis_).add(base_radius_).add(slope_).add(open_ ? 1 : 0);
    }

private:
    struct Piece {
        Crossing lower, upper;
    };

    // Inside: between the two end planes, and nearer to the axis than a radius that is linear along it. The slab never
    // reaches beyond the apex, so what is inside along a ray is one interval (two that touch where it meets the apex).
    int pieces(const Ray& ray, std::array<Piece, 2>& out) const {
        Crossing enter;
        Crossing leave;
        if (!slab(ray, enter, leave)) return 0;
        // Seen from the ray's point nearest to the frustum's middle, rounding is least.
        const double t_near = std::clamp(
            dot(base_ + axis_ * (height_ / 2) - ray.origin, ray.direction) / dot(ray.direction, ray.direction), enter.t,
            leave.t);
        const Vec3d from_base = ray.at(t_near) - base_;
        const double z = dot(from_base, axis_);
        const double dz = dot(ray.direction, axis_);
        const Vec3d off_axis = from_base - axis_ * z;
        const Vec3d d_off_axis = ray.direction - axis_ * dz;
        const double radius = base_radius_ + slope_ * z;
        const double d_radius = slope_ * dz;
        // a*s^2 + 2*b*s + c < 0 is inside, t = t_near + s.
        const double a = dot(d_off_axis, d_off_axis) - d_radius * d_radius;
        const double b = dot(off_axis, d_off_axis) - radius * d_radius;
        const double c = dot(off_axis, off_axis) - radius * radius;
        const double discriminant = b * b - a * c;
        const auto one = [&](const Crossing& lower, const Crossing& upper) {
            out[0] = {lower, upper};
            return lower.t < upper.t ? 1 : 0;
        };
        if (a == 0 && b == 0) return c < 0 ? one(enter, leave) : 0;
        if (a == 0) {
            const Crossing root{t_near - c / (2 * b)};
            return b > 0 ? one(enter, earlier(root, leave)) : one(later(enter, root), leave);
        }
        if (!(discriminant > 0)) return a < 0 ? one(enter, leave) : 0;
        const double q = -(b + std::copysign(std::sqrt(discriminant), b));
        const double s0 = q / a;
        const double s1 = q != 0 ? c / q : -s0;
        const Crossing first{t_near + std::min(s0, s1)};
        const Crossing second{t_near + std::max(s0, s1)};
        if (a > 0) return one(later(enter, first), earlier(second, leave));
        const int before = one(enter, earlier(first, leave));
        const Piece behind{later(enter, second), leave};
        if (!(behind.lower.t < behind.upper.t)) return before;
        out[static_cast<std::size_t>(before)] = behind;
        return before + 1;
    }

    /// Where the ray is between the end planes; false where nowhere.
    bool slab(const Ray& ray, Crossing& enter, Crossing& leave) const {
        const double z = dot(ray.origin - base_, axis_);
        const double dz = dot(ray.direction, axis_);
        enter.visible = leave.visible = !open_;
        if (dz == 0) {
            enter.t = -kInfinity, leave.t = kInfinity;
            return z > 0 && z < height_;
        }
        enter.t = ((dz > 0 ? 0 : height_) - z) / dz;
        leave.t = ((dz > 0 ? height_ : 0) - z) / dz;
        enter.part = dz > 0 ? kBase : kCap;
        leave.part = dz > 0 ? kCap : kBase;
        return true;
    }
    static Crossing later(const Crossing& a, const Crossing& b) { return a.t >= b.t ? a : b; }
    static Crossing earlier(const Crossing& a, const Crossing& b) { return b.t <= a.t ? b : a; }

    Vec3d base_;
    double height_;
    Vec3d axis_;
    double base_radius_, cap_radius_, slope_;
    bool open_;
};

}  // namespace

ShapePointer make_shape(const scene::SolidCone& cone, const SourceLocation& where) {
    if (!(length(cone.cap - cone.base) > 0))
        refuse_shape(where, "a cone or cylinder must have a length", "its two end points are the same");
    return std::make_shared<Cone>(cone);
}

}  // namespace sundog::solids
