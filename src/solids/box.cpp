// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "solids/shape.h"

namespace sundog::solids {
namespace {

// Parts are faces: twice the axis, plus one for the upper side.
class Box final : public Shape {
public:
    explicit Box(const scene::SolidBox& box) {
        box_.include(box.lower);
        box_.include(box.upper);
    }

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        Crossing enter{-kInfinity};
        Crossing leave{kInfinity};
        if (!slabs(ray, enter, leave)) return false;
        if (!(enter.t < leave.t)) return flat_crossing(ray, enter.t, leave.t, range, out);
        return append_interval(enter, leave, range, out);
    }
    bool stretch(const Ray& ray, Range range, Stretch& out) const override {
        Crossing enter{-kInfinity};
        Crossing leave{kInfinity};
        return slabs(ray, enter, leave) && enter.t < leave.t && stretch_between(enter, leave, range, out);
    }
    [[nodiscard]] bool is_quick() const override { return true; }
    [[nodiscard]] bool is_convex() const override {
        return box_.lower.x < box_.upper.x && box_.lower.y < box_.upper.y && box_.lower.z < box_.upper.z;
    }
    [[nodiscard]] bool inside(Vec3d p) const override {
        return p.x > box_.lower.x && p.x < box_.upper.x && p.y > box_.lower.y && p.y < box_.upper.y &&
               p.z > box_.lower.z && p.z < box_.upper.z;
    }
    [[nodiscard]] Vec3d normal(Vec3d, const Crossing& c) const override {
        Vec3d n;
        n[c.part / 2] = (c.part & 1U) != 0 ? 1 : -1;
        return n;
    }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override { return transformed(m, box_); }
    // The picture is cut as a cross of 4 by 3 squares, as the reference's figure of section 3.4.6.7.1 shows.
    [[nodiscard]] std::array<double, 2> uv(Vec3d p, const Crossing& c) const override {
        const Vec3d size = box_.upper - box_.lower;
        Vec3d q = p - box_.lower;
        for (std::size_t axis = 0; axis < 3; ++axis)
            q[axis] = size[axis] > 0 ? std::clamp(q[axis] / size[axis], 0.0, 1.0) : 0;
        double column = 1;
        double row = 1;
        double s = 0;
        double t = 0;
        switch (c.part) {
            case 0:  // left
                column = 0, s = q.z, t = q.y;
                break;
            case 1:  // right
                column = 2, s = 1 - q.z, t = q.y;
                break;
            case 2:  // bottom
                row = 0, s = q.x, t = q.z;
                break;
            case 3:  // top
                row = 2, s = q.x, t = 1 - q.z;
                break;
            case 4:  // front
                column = 3, s = 1 - q.x, t = q.y;
                break;
            default:  // back
                s = q.x, t = q.y;
        }
        return {(column + s) / 4, (row + t) / 3};
    }
    [[nodiscard]] ShapeNumbers numbers() const override {
        return ShapeNumbers{ShapeNumbers::Kind::box, {}}.add(box_.lower).add(box_.upper);
    }

private:
    /// Between which crossings the ray is within all three pairs of faces; false where it runs beside one.
    bool slabs(const Ray& ray, Crossing& enter, Crossing& leave) const {
        for (std::uint32_t axis = 0; axis < 3; ++axis) {
            const double o = ray.origin[axis];
            const double d = ray.direction[axis];
            if (d == 0) {
                if (!(o > box_.lower[axis] && o < box_.upper[axis])) return false;
                continue;
            }
            const double t_lower = (box_.lower[axis] - o) / d;
            const double t_upper = (box_.upper[axis] - o) / d;
            const std::uint32_t first = d > 0 ? 0 : 1;
            const double t_first = d > 0 ? t_lower : t_upper;
            const double t_second = d > 0 ? t_upper : t_lower;
            if (t_first > enter.t) enter.t = t_first, enter.part = 2 * axis + first;
            if (t_second < leave.t) leave.t = t_second, leave.part = 2 * axis + (1 - first);
        }
        return true;
    }
    /// A box without thickness is a surface, as povray shows it.
    bool flat_crossing(const Ray& ray, double enter, double leave, Range range, CrossingList& out) const {
        for (std::uint32_t axis = 0; enter == leave && axis < 3; ++axis) {
            if (box_.lower[axis] != box_.upper[axis] || ray.direction[axis] == 0) continue;
            if ((box_.lower[axis] - ray.origin[axis]) / ray.direction[axis] != enter) continue;
            if (range.contains(enter))
                out.push_back({enter, 0, 0, 2 * axis + (ray.direction[axis] > 0 ? 0U : 1U), false});
            break;
        }
        return false;
    }

    Bounds3d box_;
};

}  // namespace

ShapePointer make_shape(const scene::SolidBox& box, const SourceLocation&) { return std::make_shared<Box>(box); }

}  // namespace sundog::solids
