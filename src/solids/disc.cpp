// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "solids/shape.h"

namespace sundog::solids {
namespace {

// Part of a plane is to be seen; inside is all that lies behind the plane, as CSG has it (reference,
// section 3.4.5.2.2).
class Disc final : public Shape {
public:
    explicit Disc(const scene::Disc& d)
        : center_(d.center), normal_(normalize(d.normal)), radius_(d.radius), hole_radius_(d.hole_radius) {}

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        const double speed = dot(normal_, ray.direction);
        if (speed == 0) return inside(ray.at(range.lower));
        const double t = dot(normal_, center_ - ray.origin) / speed;
        if (!range.contains(t)) return (t <= range.lower) == (speed < 0);
        const Vec3d from_center = ray.at(t) - center_;
        const double squared = dot(from_center, from_center);
        Crossing c{t};
        c.visible = squared <= radius_ * radius_ && squared >= hole_radius_ * hole_radius_;
        out.push_back(c);
        return speed > 0;
    }
    [[nodiscard]] bool inside(Vec3d p) const override { return dot(normal_, p - center_) < 0; }
    [[nodiscard]] Vec3d normal(Vec3d, const Crossing&) const override { return normal_; }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override {
        // Along an axis, a circle reaches as far as its radius times the sine between that axis and its normal; in the
        // shape's own space, then carried.
        const Vec3d reach = Vec3d{std::sqrt(std::max(0.0, 1 - normal_.x * normal_.x)),
                                  std::sqrt(std::max(0.0, 1 - normal_.y * normal_.y)),
                                  std::sqrt(std::max(0.0, 1 - normal_.z * normal_.z))} *
                            radius_;
        return transformed(m, {center_ - reach, center_ + reach});
    }
    [[nodiscard]] Bounds3d inside_bounds(const Affine3d&) const override { return everywhere(); }
    [[nodiscard]] ShapeNumbers numbers() const override {
        return ShapeNumbers{ShapeNumbers::Kind::disc, {}}.add(center_).add(normal_).add(radius_).add(hole_radius_);
    }

private:
    Vec3d center_, normal_;
    double radius_, hole_radius_;
};

}  // namespace

ShapePointer make_shape(const scene::Disc& disc, const SourceLocation& where) {
    if (!(dot(disc.normal, disc.normal) > 0)) refuse_shape(where, "a disc's normal must have a direction");
    return std::make_shared<Disc>(disc);
}

}  // namespace sundog::solids
