// SPDX-License-Identifier: Apache-2.0
#include "compile/materials_of.h"

namespace sundog {
namespace {

using Visit = std::function<void(std::uint32_t)>;

void visit_solid(const scene::Solid& solid, std::uint32_t inherited, const Visit& visit) {
    const std::uint32_t own = solid.material == scene::Solid::kInherited ? inherited : solid.material;
    if (solid.interior_material != scene::Solid::kInherited) visit(solid.interior_material);
    if (const auto* group = std::get_if<scene::SolidGroup>(&solid.shape)) {
        for (const std::shared_ptr<const scene::Solid>& child : group->children) visit_solid(*child, own, visit);
        return;
    }
    visit(own);
    if (const auto* blob = std::get_if<scene::Blob>(&solid.shape)) {
        for (const scene::BlobComponent& component : blob->components)
            if (component.material != scene::Solid::kInherited) visit(component.material);
    } else if (const auto* mesh = std::get_if<std::shared_ptr<const scene::SolidMesh>>(&solid.shape); mesh && *mesh) {
        for (const scene::SolidMesh::Triangle& t : (*mesh)->triangles)
            if (t.material != scene::SolidMesh::kNoIndex) visit(t.material);
    }
}

}  // namespace

void for_each_material(const scene::Object& object, const Visit& visit) {
    if (const auto* mesh = std::get_if<Boxed<scene::Mesh>>(&object.shape)) {
        for (const scene::Mesh::Triangle& t : (*mesh)->triangles) visit(t.material);
    } else if (const auto* solid = std::get_if<std::shared_ptr<const scene::Solid>>(&object.shape)) {
        visit_solid(**solid, object.material, visit);
    } else {
        visit(object.material);
    }
}

}  // namespace sundog
