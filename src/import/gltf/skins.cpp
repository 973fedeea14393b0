// SPDX-License-Identifier: Apache-2.0
// Skins and morph targets of nodes.
#include <algorithm>
#include <string>

#include "import/gltf/accessor.h"
#include "import/gltf/objects.h"
#include "scene/deformation.h"

namespace sundog::import::gltf {
namespace {

std::vector<scene::Deformation::Joint> read_skin(Asset& asset, const NodeGraph& graph, const Json& skin) {
    const Json list = skin.required("joints");
    std::vector<scene::Deformation::Joint> joints;
    for (std::size_t i = 0; i < list.size(); ++i)
        joints.push_back({graph.tree_index[list[i].index(asset.list("nodes").size(), "nodes")], {}});
    const Json inverse = skin.member("inverseBindMatrices");
    if (!inverse) return joints;
    const Numbers matrices = read_numbers(asset, inverse, {{"MAT4"}, false});
    if (matrices.count < joints.size())
        inverse.fail("has " + std::to_string(matrices.count) + " matrices for " + std::to_string(joints.size()) +
                     " joints");
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const auto m = matrices[i];
        joints[i].joint_from_mesh = {
            {m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
    }
    return joints;
}

/// The sets of joints with weights whose sum over all sets is 1.
std::vector<std::vector<scene::Deformation::Influence>> influences_of(const MeshData& data) {
    std::vector<std::vector<scene::Deformation::Influence>> sets;
    for (const std::vector<Joints>* joints : {&data.joints, &data.more_joints}) {
        if (joints->empty()) continue;
        std::vector<scene::Deformation::Influence>& set = sets.emplace_back();
        for (const Joints& j : *joints) set.push_back({j.joint, j.weight});
    }
    for (std::size_t vertex = 0; vertex < data.mesh.positions.size(); ++vertex) {
        float sum = 0;
        for (const auto& set : sets)
            for (const float w : set[vertex].weight) sum += w;
        for (auto& set : sets)
            for (std::size_t k = 0; k < 4; ++k) {
                if (sum != 0) set[vertex].weight[k] /= sum;
                // A vertex that nothing carries goes with the first joint.
                else set[vertex] = {{}, {&set == &sets.front() ? 1.0F : 0.0F, 0, 0, 0}};
                if (set[vertex].weight[k] == 0) set[vertex].joint[k] = 0;
            }
    }
    return sets;
}

/// The position that each normal belongs to: a triangle's corners have both.
std::vector<std::uint32_t> vertices_of_normals(const scene::Mesh& mesh) {
    std::vector<std::uint32_t> vertices(mesh.normals.size());
    for (const scene::Mesh::Triangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            if (t.normal[k] != scene::kNone) vertices[t.normal[k]] = t.position[k];
    return vertices;
}

}  // namespace

std::shared_ptr<const scene::Deformation> read_deformation(Asset& asset, const NodeGraph& graph, scene::Index node,
                                                           const MeshData& data, const WeightTracks& weights) {
    const Json json = graph.json(asset, node);
    const auto skin_index = json.index_or_none("skin", asset.list("skins").size(), "skins");
    const bool skinned = skin_index && !data.joints.empty();
    if (!skinned && data.targets.empty()) return nullptr;
    auto out = std::make_shared<scene::Deformation>();
    out->tree = graph.tree;
    out->positions = data.mesh.positions;
    out->normals = data.mesh.normals;
    out->vertex_of_normal = vertices_of_normals(data.mesh);
    for (const MorphTarget& target : data.targets) out->targets.push_back({target.positions, target.normals});
    out->weights = data.weights;
    if (const Json own = json.member("weights"); own && !data.targets.empty())
        out->weights = own.numbers(data.targets.size());
    if (const auto track = weights.find(node); track != weights.end()) out->weight_track = track->second;
    if (skinned) {
        const Json skin = asset.list("skins")[*skin_index];
        out->joints = read_skin(asset, graph, skin);
        if (data.joint_count > out->joints.size() || out->joints.empty())
            skin.fail("has " + std::to_string(out->joints.size()) + " joints, but meshes[" +
                      std::to_string(json.required("mesh").whole()) + "] names joint " +
                      std::to_string(data.joint_count > 0 ? data.joint_count - 1 : 0));
        out->influences = influences_of(data);
    }
    return out;
}

}  // namespace sundog::import::gltf
