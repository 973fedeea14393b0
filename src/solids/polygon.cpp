// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "solids/shape.h"

namespace sundog::solids {
namespace {

class FlatPolygon final : public Shape {
public:
    FlatPolygon(const scene::FlatPolygon& polygon, Vec3d normal) : normal_(normal) {
        const Vec3d n{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
        const std::size_t dropped = n.x >= n.y && n.x >= n.z ? 0 : n.y >= n.z ? 1 : 2;
        u_axis_ = (dropped + 1) % 3;
        v_axis_ = (dropped + 2) % 3;
        for (const std::vector<Vec3d>& outline : polygon.outlines) {
            for (std::size_t i = 0; i < outline.size(); ++i) {
                const Vec3d a = outline[i];
                const Vec3d b = outline[(i + 1) % outline.size()];
                box_.include(a);
                origin_ = a;
                edges_.push_back({a[u_axis_], a[v_axis_], b[u_axis_], b[v_axis_]});
            }
        }
    }

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        const double speed = dot(normal_, ray.direction);
        if (speed == 0) return false;
        const double t = dot(normal_, origin_ - ray.origin) / speed;
        if (!range.contains(t)) return false;
        const Vec3d p = ray.at(t);
        const double u = p[u_axis_];
        const double v = p[v_axis_];
        // Even-odd, by the edges that a line along +u crosses; an edge holds its lower end, not its upper.
        bool odd = false;
        for (const Edge& e : edges_) {
            if ((e.v0 <= v) == (e.v1 <= v)) continue;
            if (u < e.u0 + (v - e.v0) / (e.v1 - e.v0) * (e.u1 - e.u0)) odd = !odd;
        }
        if (!odd) return false;
        Crossing c{t};
        c.toggles = false;
        out.push_back(c);
        return false;
    }
    [[nodiscard]] bool inside(Vec3d) const override { return false; }
    [[nodiscard]] Vec3d normal(Vec3d, const Crossing&) const override { return normal_; }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override { return transformed(m, box_); }
    [[nodiscard]] Bounds3d inside_bounds(const Affine3d&) const override { return {}; }
    [[nodiscard]] ShapeNumbers numbers() const override {
        ShapeNumbers out{ShapeNumbers::Kind::polygon, {}};
        out.add(normal_).add(origin_).add(static_cast<double>(u_axis_)).add(static_cast<double>(v_axis_));
        out.add(static_cast<double>(edges_.size()));
        for (const Edge& e : edges_) out.add(e.u0).add(e.v0).add(e.u1).add(e.v1);
        return out;
    }

private:
    struct Edge {
        double u0, v0, u1, v1;
    };
    Vec3d normal_, origin_;
    std::size_t u_axis_ = 0, v_axis_ = 1;
    std::vector<Edge> edges_;
    Bounds3d box_;
};

}  // namespace

ShapePointer make_shape(const scene::FlatPolygon& polygon, const SourceLocation& where) {
    // The area's normal, after Newell: good for outlines of any shape.
    Vec3d normal;
    for (const std::vector<Vec3d>& outline : polygon.outlines) {
        Vec3d of_outline;
        for (std::size_t i = 0; i < outline.size(); ++i)
            of_outline += cross(outline[i] - outline[0], outline[(i + 1) % outline.size()] - outline[0]);
        if (dot(of_outline, of_outline) > dot(normal, normal)) normal = of_outline;
    }
    if (!(dot(normal, normal) > 0)) refuse_shape(where, "this polygon has no area", "its points lie on one line");
    return std::make_shared<FlatPolygon>(polygon, normalize(normal));
}

}  // namespace sundog::solids
