// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "solids/shape.h"

namespace sundog::solids {
namespace {

/// The box around all p with dot(normal, p) < distance: half of everywhere where the normal lies along an axis.
Bounds3d half_bounds(Vec3d normal, double distance) {
    Bounds3d box = everywhere();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (normal[(axis + 1) % 3] != 0 || normal[(axis + 2) % 3] != 0 || normal[axis] == 0) continue;
        (normal[axis] > 0 ? box.upper : box.lower)[axis] = distance / normal[axis];
    }
    return box;
}

/// Parts of a normal that are rounding beside its largest become 0, so that turned axes are axes again.
Vec3d cleaned(Vec3d n) {
    const double most = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (std::abs(n[axis]) < 1e-15 * most) n[axis] = 0;
    return n;
}

class HalfSpace final : public Shape {
public:
    explicit HalfSpace(const scene::HalfSpace& h) : normal_(h.normal), distance_(h.distance) {}

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        const double speed = dot(normal_, ray.direction);
        const double height = dot(normal_, ray.at(range.lower)) - distance_;
        if (speed == 0) return height < 0;
        const double t = (distance_ - dot(normal_, ray.origin)) / speed;
        if (range.contains(t)) {
            out.push_back({t});
            return speed > 0;
        }
        return (t <= range.lower) == (speed < 0);
    }
    bool stretch(const Ray& ray, Range range, Stretch& out) const override {
        const double speed = dot(normal_, ray.direction);
        out.begins = out.ends = false;
        if (speed == 0) return dot(normal_, ray.at(range.lower)) < distance_;
        const double t = (distance_ - dot(normal_, ray.origin)) / speed;
        if (!range.contains(t)) return (t <= range.lower) == (speed < 0);
        (speed < 0 ? out.begins : out.ends) = true;
        (speed < 0 ? out.lower : out.upper) = {t};
        return true;
    }
    [[nodiscard]] bool is_quick() const override { return true; }
    [[nodiscard]] bool is_convex() const override { return true; }
    [[nodiscard]] bool inside(Vec3d p) const override { return dot(normal_, p) < distance_; }
    [[nodiscard]] Vec3d normal(Vec3d, const Crossing&) const override { return normal_; }
    [[nodiscard]] Bounds3d bounds(const Affine3d&) const override { return everywhere(); }
    [[nodiscard]] Bounds3d inside_bounds(const Affine3d& m) const override {
        const auto [n, d] = carried(m);
        return half_bounds(n, d);
    }
    [[nodiscard]] Bounds3d outside_bounds(const Affine3d& m) const override {
        const auto [n, d] = carried(m);
        return half_bounds(-n, -d);
    }
    [[nodiscard]] ShapeNumbers numbers() const override {
        return ShapeNumbers{ShapeNumbers::Kind::half_space, {}}.add(normal_).add(distance_);
    }

private:
    struct Equation {
        Vec3d normal;
        double distance;
    };
    [[nodiscard]] Equation carried(const Affine3d& m) const {
        const Vec3d n = cleaned(transform_normal(inverse(m), normal_));
        return {n, dot(n, transform_point(m, normal_ * (distance_ / dot(normal_, normal_))))};
    }

    Vec3d normal_;
    double distance_;
};

}  // namespace

ShapePointer make_shape(const scene::HalfSpace& half_space, const SourceLocation& where) {
    if (!(dot(half_space.normal, half_space.normal) > 0)) refuse_shape(where, "a plane's normal must have a direction");
    return std::make_shared<HalfSpace>(half_space);
}

}  // namespace sundog::solids
