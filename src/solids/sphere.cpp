// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "solids/shape.h"

namespace sundog::solids {
namespace {

class Sphere final : public Shape {
public:
    explicit Sphere(const scene::SolidSphere& s) : center_(s.center), radius_(std::abs(s.radius)) {}

    // The discriminant is taken from the ray's closest point to the centre (Haines, Günther, Akenine-Möller: Precision
    // Improvements for Ray/Sphere Intersection, Ray Tracing Gems 2019, chapter 7).
    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        double lower, upper;
        return ends(ray, lower, upper) && append_interval({lower}, {upper}, range, out);
    }
    bool stretch(const Ray& ray, Range range, Stretch& out) const override {
        double lower, upper;
        return ends(ray, lower, upper) && stretch_between({lower}, {upper}, range, out);
    }
    [[nodiscard]] bool is_quick() const override { return true; }
    [[nodiscard]] bool is_convex() const override { return true; }
    [[nodiscard]] bool inside(Vec3d p) const override { return dot(p - center_, p - center_) < radius_ * radius_; }
    [[nodiscard]] Vec3d normal(Vec3d p, const Crossing&) const override { return p - center_; }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override {
        // An ellipsoid reaches as far along an axis as that row of the matrix is long.
        const Vec3d reach = Vec3d{std::sqrt(m.x.x * m.x.x + m.y.x * m.y.x + m.z.x * m.z.x),
                                  std::sqrt(m.x.y * m.x.y + m.y.y * m.y.y + m.z.y * m.z.y),
                                  std::sqrt(m.x.z * m.x.z + m.y.z * m.y.z + m.z.z * m.z.z)} *
                            radius_;
        const Vec3d center = transform_point(m, center_);
        return {center - reach, center + reach};
    }
    // u runs once around the y axis, v from the south to the north pole.
    [[nodiscard]] std::array<double, 2> uv(Vec3d p, const Crossing&) const override {
        const Vec3d n = normalize(p - center_);
        double u = std::atan2(n.z, n.x) / (2 * std::numbers::pi);
        if (u < 0) u += 1;
        return {u, std::asin(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi + 0.5};
    }
    [[nodiscard]] ShapeNumbers numbers() const override {
        return ShapeNumbers{ShapeNumbers::Kind::sphere, {}}.add(center_).add(radius_);
    }

private:
    /// Where the ray goes in and out; false where it misses the sphere.
    bool ends(const Ray& ray, double& lower, double& upper) const {
        const double a = dot(ray.direction, ray.direction);
        const double middle = dot(center_ - ray.origin, ray.direction) / a;
        const Vec3d offset = ray.at(middle) - center_;
        const double discriminant = radius_ * radius_ - dot(offset, offset);
        if (!(discriminant > 0)) return false;
        const double half = std::sqrt(discriminant / a);
        lower = middle - half, upper = middle + half;
        return true;
    }

    Vec3d center_;
    double radius_;
};

}  // namespace

ShapePointer make_shape(const scene::SolidSphere& sphere, const SourceLocation&) {
    return std::make_shared<Sphere>(sphere);
}

}  // namespace sundog::solids
