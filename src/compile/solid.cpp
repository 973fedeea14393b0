// SPDX-License-Identifier: Apache-2.0
#include "compile/solid.h"

#include <algorithm>
#include <cmath>

#include "compile/convert.h"
#include "solids/compiled_solid.h"

namespace sundog {
namespace {

/// Unions in each other that are split; deeper ones stay whole.
constexpr int kMaxSplits = 100;

/// Whether a material looks at texture coordinates: the kernel's primitives and POV-Ray's shapes have different ones.
bool uses_uv(const scene::Material& material) {
    if (!material.patterned) {
        const auto mapped = [](const scene::TextureUse& use) { return use.texture != scene::kNone; };
        const scene::MtlSurface& m = *material.mtl;
        return m.checker || mapped(m.map_diffuse) || mapped(m.map_specular) || mapped(m.map_bump) ||
               mapped(m.map_normal) || mapped(m.map_opacity) || mapped(m.map_emission);
    }
    return material.patterned->texture && scene::uses_uv(*material.patterned->texture);
}

/// The factor by which a map scales all lengths alike; 0 if it doesn't.
double similarity_factor(const Affine3d& m) {
    const double s = length(m.x);
    const double slack = 1e-9 * s * s;
    const bool alike = std::abs(dot(m.y, m.y) - s * s) < slack && std::abs(dot(m.z, m.z) - s * s) < slack &&
                       std::abs(dot(m.x, m.y)) < slack && std::abs(dot(m.y, m.z)) < slack &&
                       std::abs(dot(m.z, m.x)) < slack;
    return alike ? s : 0;
}

/// Whether a map carries axes to axes (each column has one entry that isn't rounding).
bool keeps_axes(const Affine3d& m) {
    const auto along_axis = [](Vec3d column) {
        const double most = std::max({std::abs(column.x), std::abs(column.y), std::abs(column.z)});
        int entries = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (std::abs(column[axis]) > 1e-12 * most) ++entries;
        return entries == 1;
    };
    return along_axis(m.x) && along_axis(m.y) && along_axis(m.z);
}

Bounds3 float_bounds(const Bounds3d& b) {
    const double largest = 1e30;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (!(std::abs(b.lower[axis]) < largest && std::abs(b.upper[axis]) < largest)) return {};
    Bounds3 out;
    out.include(to_float(b.lower));
    out.include(to_float(b.upper));
    return out;
}

class SolidWriter {
public:
    SolidWriter(const scene::Scene& scene, const scene::Object& object, MeshAttributes attributes, RenderScene& out,
                const WarningSink& warn, const std::function<void(const SolidPart&)>& add)
        : scene_(scene), object_(object), attributes_(attributes), out_(out), warn_(warn), add_(add) {}

    void write(const scene::Solid& solid, const Affine3d& object_from_parent, std::uint32_t material,
               std::uint32_t interior_material, int depth) {
        const Affine3d object_from_shape = object_from_parent * solid.parent_from_shape;
        if (solid.material != scene::Solid::kInherited) material = solid.material;
        if (solid.interior_material != scene::Solid::kInherited) interior_material = solid.interior_material;
        if (depth < kMaxSplits && solids::can_be_split(solid)) {
            for (const auto& child : std::get<scene::SolidGroup>(solid.shape).children)
                write(*child, object_from_shape, material, interior_material, depth + 1);
            return;
        }
        const bool plain = interior_material == scene::Solid::kInherited && solid.clipped_by.empty();
        if (plain && write_primitive(solid, object_from_shape, material)) return;
        write_exact(solid, object_from_parent, material, interior_material);
    }

private:
    bool write_primitive(const scene::Solid& solid, const Affine3d& m, std::uint32_t material) {
        if (const auto* sphere = std::get_if<scene::SolidSphere>(&solid.shape))
            return !solid.inverted && write_sphere(*sphere, m, material);
        if (const auto* box = std::get_if<scene::SolidBox>(&solid.shape))
            return !solid.inverted && write_box(*box, m, material);
        if (const auto* half_space = std::get_if<scene::HalfSpace>(&solid.shape))
            return write_plane(*half_space, m, material, solid.inverted);
        if (const auto* mesh = std::get_if<std::shared_ptr<const scene::SolidMesh>>(&solid.shape))
            return !solid.inverted && *mesh && write_mesh(**mesh, m, material);
        return false;
    }

    bool write_sphere(const scene::SolidSphere& sphere, const Affine3d& m, std::uint32_t material) {
        const double radius = similarity_factor(m) * std::abs(sphere.radius);
        if (!(radius > 0) || needs_uv(material)) return false;
        const Vec3d center = transform_point(m, sphere.center);
        const Vec3d reach{radius, radius, radius};
        out_.spheres.push_back({to_kernel(to_float(center)), static_cast<float>(radius), material});
        add_({{kernel::GEOMETRY_SPHERE, last(out_.spheres), 1, kernel::NONE, 0, 0, 0},
              nullptr,
              float_bounds({center - reach, center + reach})});
        return true;
    }
    bool write_box(const scene::SolidBox& box, const Affine3d& m, std::uint32_t material) {
        if (!keeps_axes(m) || needs_uv(material)) return false;
        Bounds3d bounds;
        bounds.include(transform_point(m, box.lower));
        bounds.include(transform_point(m, box.upper));
        out_.boxes.push_back({to_kernel(to_float(bounds.lower)), to_kernel(to_float(bounds.upper)), material});
        add_({{kernel::GEOMETRY_BOX, last(out_.boxes), 1, kernel::NONE, 0, 0, 0}, nullptr, float_bounds(bounds)});
        return true;
    }
    /// Planes are asked one by one, by all rays: what some rays don't see can't be among them.
    bool write_plane(const scene::HalfSpace& half_space, const Affine3d& m, std::uint32_t material, bool inverted) {
        if (needs_uv(material) || scene::moves(object_) || !object_.casts_shadow || !object_.seen_by_camera ||
            !object_.seen_in_reflections || !object_.seen_by_radiosity || !(std::abs(determinant(m)) > 0))
            return false;
        const Vec3d normal = normalize(transform_normal(inverse(m), half_space.normal));
        const double square = dot(half_space.normal, half_space.normal);
        const Vec3d point = transform_point(m, half_space.normal * (half_space.distance / square));
        const double side = inverted ? -1 : 1;
        const auto geometry = static_cast<std::uint32_t>(out_.geometries.size());
        out_.planes.push_back(
            {to_kernel(to_float(normal * side)), static_cast<float>(dot(normal, point) * side), material, geometry});
        add_({{kernel::GEOMETRY_PLANE, last(out_.planes), 1, kernel::NONE, 0, 0, 0}, nullptr, {}});
        return true;
    }
    bool write_mesh(const scene::SolidMesh& mesh, const Affine3d& m, std::uint32_t material) {
        const scene::Mesh placed = placed_mesh(mesh, m, material);
        const auto first = static_cast<std::uint32_t>(out_.triangles.size());
        const std::uint32_t count = append_mesh(object_, placed, attributes_, out_, warn_);
        Bounds3 bounds;
        for (const Vec3 p : placed.positions) bounds.include(p);
        if (count > 0) add_({{kernel::GEOMETRY_TRIANGLES, first, count, kernel::NONE, 0, 0, 0}, nullptr, bounds});
        return true;
    }
    static scene::Mesh placed_mesh(const scene::SolidMesh& mesh, const Affine3d& m, std::uint32_t material) {
        scene::Mesh placed;
        placed.positions.reserve(mesh.positions.size());
        for (const Vec3 p : mesh.positions) placed.positions.push_back(to_float(transform_point(m, to_double(p))));
        const Affine3d shape_from_object = inverse(m);
        placed.normals.reserve(mesh.normals.size());
        for (const Vec3 n : mesh.normals)
            placed.normals.push_back(to_float(normalize(transform_normal(shape_from_object, to_double(n)))));
        placed.texcoords = mesh.uvs;
        placed.triangles.reserve(mesh.triangles.size());
        for (const scene::SolidMesh::Triangle& t : mesh.triangles)
            placed.triangles.push_back({{t.position[0], t.position[1], t.position[2]},
                                        {t.normal[0], t.normal[1], t.normal[2]},
                                        {t.uv[0], t.uv[1], t.uv[2]},
                                        t.material == scene::SolidMesh::kNoIndex ? material : t.material});
        return placed;
    }

    void write_exact(const scene::Solid& solid, const Affine3d& object_from_parent, std::uint32_t material,
                     std::uint32_t interior_material) {
        scene::Solid placed = solid;
        placed.parent_from_shape = object_from_parent * solid.parent_from_shape;
        placed.interior_material = interior_material;
        const auto needs = [this](std::uint32_t m) { return needs_uv(m); };
        std::shared_ptr<const solids::CompiledSolid> compiled;
        if (object_from_parent == Affine3d{} || solid.clipped_by.empty()) {
            compiled = solids::compile_solid(placed, material, scene_.textures, needs);
        } else {
            // Clips lie in the parent's space: a group of one carries them there.
            placed.parent_from_shape = solid.parent_from_shape;
            scene::Solid parent;
            parent.where = solid.where;
            parent.shape = scene::SolidGroup{{}, {std::make_shared<const scene::Solid>(std::move(placed))}};
            parent.parent_from_shape = object_from_parent;
            compiled = solids::compile_solid(parent, material, scene_.textures, needs);
        }
        add_({{kernel::GEOMETRY_SOLID, 0, 1, kernel::NONE, 0, 0, 0}, compiled, float_bounds(compiled->bounds())});
    }

    [[nodiscard]] bool needs_uv(std::uint32_t material) const {
        return material < scene_.materials.size() && uses_uv(scene_.materials[material]);
    }
    template <class T>
    static std::uint32_t last(const std::vector<T>& array) {
        return static_cast<std::uint32_t>(array.size() - 1);
    }

    const scene::Scene& scene_;
    const scene::Object& object_;
    MeshAttributes attributes_;
    RenderScene& out_;
    const WarningSink& warn_;
    const std::function<void(const SolidPart&)>& add_;
};

}  // namespace

MeshAttributes solid_attributes(const scene::Solid& solid) {
    MeshAttributes found;
    if (const auto* group = std::get_if<scene::SolidGroup>(&solid.shape)) {
        for (const std::shared_ptr<const scene::Solid>& child : group->children) {
            const MeshAttributes of_child = solid_attributes(*child);
            found.normals = found.normals || of_child.normals;
            found.uvs = found.uvs || of_child.uvs;
        }
    } else if (const auto* mesh = std::get_if<std::shared_ptr<const scene::SolidMesh>>(&solid.shape); mesh && *mesh) {
        found.normals = !(*mesh)->normals.empty();
        found.uvs = !(*mesh)->uvs.empty();
    }
    return found;
}

void append_solid(const scene::Scene& scene, const scene::Object& object, const scene::Solid& solid,
                  MeshAttributes attributes, RenderScene& out, const WarningSink& warn,
                  const std::function<void(const SolidPart&)>& add) {
    SolidWriter(scene, object, attributes, out, warn, add)
        .write(solid, {}, object.material, scene::Solid::kInherited, 0);
}

}  // namespace sundog
