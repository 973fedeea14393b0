// SPDX-License-Identifier: Apache-2.0
// Triangle meshes, for where they are part of a group; on their own they are the kernel's.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "solids/bounds_tree.h"
#include "solids/shape.h"

namespace sundog::solids {
namespace {

/// A ray in a space where it runs along z and starts at the origin (Woop, Benthin, Wald: Watertight Ray/Triangle
/// Intersection, JCGT 2(1), 2013).
struct ShearedRay {
    explicit ShearedRay(const Ray& ray) : origin(ray.origin) {
        const Vec3d d = ray.direction;
        z = std::abs(d.x) >= std::abs(d.y) && std::abs(d.x) >= std::abs(d.z) ? 0
            : std::abs(d.y) >= std::abs(d.z)                                 ? 1
                                                                             : 2;
        x = (z + 1) % 3;
        y = (z + 2) % 3;
        shear_x = d[x] / d[z];
        shear_y = d[y] / d[z];
        shear_z = 1 / d[z];
    }
    [[nodiscard]] Vec3d carry(Vec3d p) const {
        const Vec3d q = p - origin;
        return {q[x] - shear_x * q[z], q[y] - shear_y * q[z], shear_z * q[z]};
    }
    Vec3d origin;
    std::size_t x, y, z;
    double shear_x, shear_y, shear_z;
};

/// On which side of the line from a to b the z axis passes: never 0, and opposite for the same edge run the other way.
/// A ray that meets the edge itself is decided as if it were moved a little, so neighbours share no ray and miss none.
int side_of(Vec3d a, Vec3d b, double& area) {
    area = a.x * b.y - a.y * b.x;
    if (area != 0) return area > 0 ? 1 : -1;
    if (a.y != b.y) return b.y < a.y ? 1 : -1;
    return b.x > a.x ? 1 : -1;
}

class Mesh final : public Shape {
public:
    explicit Mesh(std::shared_ptr<const scene::SolidMesh> mesh) : mesh_(std::move(mesh)) {
        std::vector<Bounds3d> boxes;
        boxes.reserve(mesh_->triangles.size());
        for (const Triangle& t : mesh_->triangles) {
            Bounds3d box;
            for (const std::uint32_t i : t.position) box.include(to_double(mesh_->positions[i]));
            boxes.push_back(box);
        }
        tree_ = BoundsTree(boxes);
    }

    bool crossings(const Ray& ray, Range range, CrossingList& out) const override {
        const ShearedRay sheared(ray);
        const bool solid = mesh_->has_inside;
        // Whether a solid mesh is entered or left is told by all that lies ahead.
        Range ahead{range.lower, solid ? kInfinity : range.upper};
        const std::size_t first = out.size();
        bool odd = false;
        tree_.along(ray, ahead, [&](std::uint32_t triangle) {
            Crossing c;
            if (!crosses(sheared, triangle, c) || !ahead.contains(c.t)) return;
            if (solid) odd = !odd;
            c.toggles = solid;
            if (c.t < range.upper) out.push_back(c);
        });
        std::sort(out.begin() + first, out.end(), [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
        return odd;
    }
    [[nodiscard]] bool inside(Vec3d p) const override {
        if (!mesh_->has_inside) return false;
        const Ray ray{p, mesh_->inside_vector};
        const ShearedRay sheared(ray);
        Range ahead;
        bool odd = false;
        tree_.along(ray, ahead, [&](std::uint32_t triangle) {
            Crossing c;
            if (crosses(sheared, triangle, c) && c.t > 0) odd = !odd;
        });
        return odd;
    }
    [[nodiscard]] Vec3d normal(Vec3d, const Crossing& c) const override {
        const Triangle& t = mesh_->triangles[c.part];
        const Vec3d flat = flat_normal(t);
        if (t.normal[0] == scene::SolidMesh::kNoIndex) return flat;
        const auto at = [&](std::size_t i) { return to_double(mesh_->normals[t.normal[i]]); };
        const Vec3d smooth = at(0) * (1 - c.u - c.v) + at(1) * c.u + at(2) * c.v;
        return dot(smooth, smooth) > 0 ? smooth : flat;
    }
    [[nodiscard]] std::optional<Vec3d> face_normal(Vec3d, const Crossing& c) const override {
        const Triangle& t = mesh_->triangles[c.part];
        if (t.normal[0] == scene::SolidMesh::kNoIndex) return std::nullopt;
        return flat_normal(t);
    }
    [[nodiscard]] Bounds3d bounds(const Affine3d& m) const override {
        Bounds3d box;
        for (const Vec3 p : mesh_->positions) box.include(transform_point(m, to_double(p)));
        return box;
    }
    [[nodiscard]] Bounds3d inside_bounds(const Affine3d& m) const override {
        return mesh_->has_inside ? bounds(m) : Bounds3d{};
    }
    [[nodiscard]] std::array<double, 2> uv(Vec3d, const Crossing& c) const override {
        const Triangle& t = mesh_->triangles[c.part];
        if (t.uv[0] == scene::SolidMesh::kNoIndex) return {c.u, c.v};
        const Vec2 a = mesh_->uvs[t.uv[0]];
        const Vec2 b = mesh_->uvs[t.uv[1]];
        const Vec2 d = mesh_->uvs[t.uv[2]];
        const double w = 1 - c.u - c.v;
        return {w * a.x + c.u * b.x + c.v * d.x, w * a.y + c.u * b.y + c.v * d.y};
    }
    [[nodiscard]] std::uint32_t material(Vec3d, const Crossing& c) const override {
        return mesh_->triangles[c.part].material;
    }
    [[nodiscard]] std::vector<std::uint32_t> materials() const override {
        std::vector<std::uint32_t> found;
        for (const Triangle& t : mesh_->triangles)
            if (t.material != scene::SolidMesh::kNoIndex && (found.empty() || found.back() != t.material))
                found.push_back(t.material);
        return found;
    }

private:
    using Triangle = scene::SolidMesh::Triangle;
    static_assert(scene::SolidMesh::kNoIndex == scene::Solid::kInherited, "a triangle without a material inherits");

    [[nodiscard]] Vec3d position(const Triangle& t, std::size_t i) const {
        return to_double(mesh_->positions[t.position[i]]);
    }
    [[nodiscard]] Vec3d flat_normal(const Triangle& t) const {
        const Vec3d a = position(t, 0);
        return cross(position(t, 1) - a, position(t, 2) - a);
    }
    bool crosses(const ShearedRay& ray, std::uint32_t index, Crossing& out) const {
        const Triangle& t = mesh_->triangles[index];
        const Vec3d a = ray.carry(position(t, 0));
        const Vec3d b = ray.carry(position(t, 1));
        const Vec3d c = ray.carry(position(t, 2));
        double area_a = 0;
        double area_b = 0;
        double area_c = 0;
        const int side_a = side_of(b, c, area_a);
        if (side_of(c, a, area_b) != side_a || side_of(a, b, area_c) != side_a) return false;
        const double all = area_a + area_b + area_c;
        if (all == 0) return false;
        out.t = (area_a * a.z + area_b * b.z + area_c * c.z) / all;
        out.u = area_b / all;
        out.v = area_c / all;
        out.part = index;
        return true;
    }

    std::shared_ptr<const scene::SolidMesh> mesh_;
    BoundsTree tree_;
};

}  // namespace

ShapePointer make_shape(const std::shared_ptr<const scene::SolidMesh>& mesh, const SourceLocation& where) {
    if (!mesh) refuse_shape(where, "a mesh without triangles");
    if (mesh->has_inside && !(dot(mesh->inside_vector, mesh->inside_vector) > 0))
        refuse_shape(where, "a mesh's inside_vector must have a direction");
    return std::make_shared<Mesh>(mesh);
}

}  // namespace sundog::solids
