// SPDX-License-Identifier: Apache-2.0
#include "import/gltf/objects.h"

#include <utility>

#include "scene/deformation.h"

namespace sundog::import::gltf {
namespace {

/// Carries a mesh from its own space to the world's. Maps that mirror turn triangles round, so that fronts stay fronts.
scene::Mesh placed(const scene::Mesh& mesh, const Affine3& world_from_mesh) {
    scene::Mesh out = mesh;
    for (Vec3& p : out.positions) p = transform_point(world_from_mesh, p);
    const Affine3& m = world_from_mesh;
    const float sign = determinant(m) < 0 ? -1.0F : 1.0F;
    for (scene::Mesh::Attributes& a : out.attributes) {
        a.tangent = normalize(transform_vector(m, a.tangent));
        a.handedness *= sign;
    }
    for (Vec3& n : out.normals)
        n = normalize((cross(m.y, m.z) * n.x + cross(m.z, m.x) * n.y + cross(m.x, m.y) * n.z) * sign);
    if (sign < 0)
        for (scene::Mesh::Triangle& t : out.triangles) {
            std::swap(t.position[1], t.position[2]);
            std::swap(t.normal[1], t.normal[2]);
            std::swap(t.texcoord[1], t.texcoord[2]);
        }
    return out;
}

std::size_t bytes_of(const scene::Mesh& mesh) {
    return mesh.positions.size() * sizeof(Vec3) + mesh.normals.size() * sizeof(Vec3) +
           mesh.texcoords.size() * sizeof(Vec2) + mesh.attributes.size() * sizeof(scene::Mesh::Attributes) +
           mesh.triangles.size() * sizeof(scene::Mesh::Triangle);
}

std::string name_of(const Json& node, const Json& mesh, std::size_t index) {
    const std::string fallback = mesh.string_or("name", "nodes[" + std::to_string(index) + "]");
    return node.string_or("name", fallback);
}

void refuse_far_places(const scene::Mesh& mesh, const Json& node) {
    for (const Vec3 p : mesh.positions)
        if (!is_finite(p)) node.fail("a mesh is placed beyond single precision");
}

/// Tangents of a mesh that bends would bend with it: its texture coordinates say where they are then.
void forget_tangents(scene::Mesh& mesh) {
    for (scene::Mesh::Attributes& a : mesh.attributes) a.tangent = {0, 0, 0};
}

}  // namespace

void read_objects(Asset& asset, const NodeGraph& graph, const WeightTracks& weights, MeshReader& meshes) {
    const std::vector<SourceLocation> places = asset.list("nodes").element_locations();
    for (scene::Index node = 0; node < graph.shown_count; ++node) {
        const Json json = graph.json(asset, node);
        const auto index = json.index_or_none("mesh", asset.list("meshes").size(), "meshes");
        if (!index) continue;
        const MeshData& data = meshes.read(*index);
        if (data.mesh.triangles.empty()) continue;
        const std::size_t file_index = graph.file_index[node];
        scene::Object base;
        base.name = name_of(json, asset.list("meshes")[*index], file_index);
        base.where = places[file_index];
        base.deformation = read_deformation(asset, graph, node, data, weights);
        const bool skinned = base.deformation && !base.deformation->joints.empty();
        const bool stays_in_node = graph.moves[node] || base.deformation;
        for (const Affine3& node_from_mesh : skinned ? std::vector<Affine3>{{}} : read_instances(asset, json)) {
            scene::Object object = base;
            asset.take_memory(bytes_of(data.mesh), json);
            if (skinned) {
                object.shape = data.mesh;  // Its joints carry it.
            } else if (stays_in_node) {
                object.shape = data.mesh;
                object.node_motion = scene::NodeMotion{graph.tree, node, node_from_mesh};
            } else {
                scene::Mesh mesh = placed(data.mesh, graph.world_from_node[node] * node_from_mesh);
                refuse_far_places(mesh, json);
                object.shape = std::move(mesh);
            }
            asset.scene().objects.push_back(std::move(object));
        }
    }
    for (scene::Object& object : asset.scene().objects)
        if (object.deformation) forget_tangents(*std::get<Boxed<scene::Mesh>>(object.shape));
    scene::deform(asset.scene(), 0);
    for (const scene::Object& object : asset.scene().objects)
        if (object.deformation) refuse_far_places(*std::get<Boxed<scene::Mesh>>(object.shape), asset.list("nodes"));
}

}  // namespace sundog::import::gltf
