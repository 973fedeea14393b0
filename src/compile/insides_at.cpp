// SPDX-License-Identifier: Apache-2.0
#include "compile/insides_at.h"

#include <algorithm>
#include <vector>

#include "solids/compiled_solid.h"

namespace sundog {
namespace {

Vec3d to_vec3d(const kernel::vec3& v) { return {v.x, v.y, v.z}; }

/// What only lights that are projected through it meet.
bool is_projector(const kernel::Geometry& g) { return (g.hidden_from | kernel::RAY_ANY_PROJECTION) == kernel::RAY_ALL; }

class InsideFinder {
public:
    /// What of a material is listed, `none` standing for nothing.
    InsideFinder(const RenderScene& scene, Vec3d point, std::uint32_t kernel::PatternedMaterial::*listed,
                 std::uint32_t none)
        : scene_(scene), point_(point), listed_(listed), none_(none) {}

    std::vector<std::uint32_t> find() {
        for (const kernel::Geometry& g : scene_.geometries) {
            if (g.instance != kernel::NONE || is_projector(g)) continue;
            for (std::uint32_t i = g.first_primitive; i < g.first_primitive + g.primitive_count; ++i)
                add_primitive(g, i);
        }
        for (const PlacedSolid& placed : scene_.solids) {
            const std::vector<std::uint32_t>& materials = placed.solid->materials();
            if (is_projector(scene_.geometries[placed.geometry])) continue;
            if (!materials.empty() && placed.solid->inside(point_))
                add(scene_.geometries[placed.geometry], materials.front());
        }
        return found_;
    }

private:
    void add_primitive(const kernel::Geometry& g, std::uint32_t i) {
        if (g.kind == kernel::GEOMETRY_SPHERE) {
            const kernel::Sphere& sphere = scene_.spheres[i];
            if (length(point_ - to_vec3d(sphere.center)) < sphere.radius) add(g, sphere.material);
        } else if (g.kind == kernel::GEOMETRY_BOX) {
            const kernel::Box& box = scene_.boxes[i];
            const Vec3d lower = to_vec3d(box.lower), upper = to_vec3d(box.upper);
            if (point_.x > lower.x && point_.y > lower.y && point_.z > lower.z && point_.x < upper.x &&
                point_.y < upper.y && point_.z < upper.z)
                add(g, box.material);
        } else if (g.kind == kernel::GEOMETRY_PLANE) {
            const kernel::Plane& plane = scene_.planes[i];
            if (dot(to_vec3d(plane.normal), point_) < plane.offset) add(g, plane.material);
        }
    }

    void add(const kernel::Geometry& g, std::uint32_t material) {
        const kernel::Material& m = scene_.materials[material];
        if ((m.flags & kernel::MATERIAL_PATTERNED) == 0) return;
        std::uint32_t entry = scene_.patterned[m.patterned].*listed_;
        if (entry == none_) return;
        const bool interiors = listed_ == &kernel::PatternedMaterial::interior;
        if (interiors && entry > kernel::INTERIOR_PLAIN) entry += g.interior_copy;
        // What is around the point for good, and not what rays go in and out of: one for all objects that have no
        // interior of their own.
        if (interiors && entry == kernel::INTERIOR_PLAIN) {
            if (std::find(found_.begin(), found_.end(), kInteriorAround) == found_.end())
                found_.push_back(kInteriorAround);
            return;
        }
        // Two parts that share one interior: see media_beyond() in kernel/atmosphere/media_insides.h.
        const auto known = std::find(found_.begin(), found_.end(), entry);
        if (known == found_.end() || entry == kernel::MEDIUM_SOLID) found_.push_back(entry);
        else found_.erase(known);
    }

    const RenderScene& scene_;
    Vec3d point_;
    std::uint32_t kernel::PatternedMaterial::*listed_;
    std::uint32_t none_;
    std::vector<std::uint32_t> found_;
};

}  // namespace

void set_media_insides(const RenderScene& scene, Vec3d point, std::span<std::uint32_t> out) {
    std::vector<std::uint32_t> found =
        InsideFinder(scene, point, &kernel::PatternedMaterial::medium, kernel::NONE).find();
    // In a solid there are no media, whatever else holds the point.
    std::stable_partition(found.begin(), found.end(), [](std::uint32_t m) { return m == kernel::MEDIUM_SOLID; });
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = i < found.size() ? found[i] : kernel::NONE;
}

std::array<std::uint32_t, 4> interiors_around(const RenderScene& scene, Vec3d point) {
    const std::vector<std::uint32_t> found = InsideFinder(scene, point, &kernel::PatternedMaterial::interior, 0).find();
    std::array<std::uint32_t, 4> interiors{};
    std::copy_n(found.begin(), std::min(found.size(), interiors.size()), interiors.begin());
    return interiors;
}

}  // namespace sundog
