// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_host_camera.h"

#include <array>

#include "import/pov/build_function.h"

namespace sundog::pov {
namespace {

/// A mesh's triangles where the camera has them; null for other shapes.
std::shared_ptr<const scene::SolidMesh> placed_mesh(const Node& node) {
    const auto* mesh = std::get_if<std::shared_ptr<const NodeMesh>>(&node.shape);
    if (mesh == nullptr || !*mesh) return nullptr;
    auto placed = std::make_shared<scene::SolidMesh>((*mesh)->triangles);
    const Affine3d& m = node.parent_from_shape;
    const Affine3d back = inverse(m);
    for (Vec3& p : placed->positions) p = to_float(transform_point(m, to_double(p)));
    for (Vec3& n : placed->normals) {
        const Vec3d old = to_double(n);
        n = to_float(Vec3d{dot(back.x, old), dot(back.y, old), dot(back.z, old)});
    }
    return placed;
}

}  // namespace

scene::MeshCamera read_mesh_camera(ObjectReader& objects, const Block& block) {
    ItemReader items(objects.context(), block);
    scene::MeshCamera camera;
    constexpr int kMostRays = 100'000;
    camera.rays_per_pixel = items.integer("a number of rays per pixel", 1, kMostRays);
    camera.distribution = items.integer("a distribution of rays", 0, 3);
    camera.max_distance = items.maybe_number().value_or(0);
    while (!items.at_end()) {
        if (items.take(Keyword::smooth)) {
            camera.smooth = items.flag();
        } else if (const auto mesh = items.take_block()) {
            auto placed = is_object(mesh->keyword) ? placed_mesh(*objects.read(mesh)) : nullptr;
            if (!placed) items.fail("not a mesh", "a mesh_camera's rays start on mesh { } or mesh2 { }");
            camera.meshes.push_back(std::move(placed));
        } else {
            items.unexpected("mesh { } or smooth");
        }
    }
    if (camera.meshes.empty()) items.fail("a mesh_camera without a mesh");
    if (camera.distribution == 0 && static_cast<std::size_t>(camera.rays_per_pixel) > camera.meshes.size())
        items.fail("more rays per pixel than meshes", "distribution 0 takes one mesh for each ray of a pixel");
    return camera;
}

std::shared_ptr<const scene::Function> read_camera_functions(BuildContext& context, const Block& block) {
    ItemReader items(context, block);
    std::array<std::shared_ptr<const FunctionExpression>, 3> functions;
    for (auto& function : functions) {
        function = items.take_function();
        if (!function) items.unexpected("three functions of x and y");
    }
    if (!items.at_end()) items.unexpected("'}'");
    return read_functions(context, functions, 3);
}

}  // namespace sundog::pov
