// SPDX-License-Identifier: Apache-2.0
#include "scene/deformation.h"

#include <algorithm>

namespace sundog::scene {
namespace {

float within(const Deformation& d, float time_s) { return d.tree ? moment_of(*d.tree, time_s) : time_s; }

void add_weighted(const std::vector<Vec3>& offsets, float weight, std::vector<Vec3>& to) {
    for (std::size_t i = 0; i < offsets.size() && i < to.size(); ++i) to[i] += offsets[i] * weight;
}

void morph(const Deformation& d, float time_s, Mesh& mesh) {
    std::vector<float> weights = d.weights;
    if (d.weight_track) weights = value_at(*d.weight_track, within(d, time_s), false);
    for (std::size_t t = 0; t < d.targets.size() && t < weights.size(); ++t) {
        if (weights[t] == 0) continue;
        add_weighted(d.targets[t].positions, weights[t], mesh.positions);
        add_weighted(d.targets[t].normals, weights[t], mesh.normals);
    }
}

Affine3 sum(const Affine3& a, const Affine3& b, float weight) {
    return {a.x + b.x * weight, a.y + b.y * weight, a.z + b.z * weight, a.t + b.t * weight};
}

/// Linear blend skinning: the weighted mean of the joints' maps (Magnenat-Thalmann, Laperrière and Thalmann 1988).
void skin(const Deformation& d, float time_s, Mesh& mesh) {
    std::vector<Affine3> world_from_mesh;
    world_from_mesh.reserve(d.joints.size());
    for (const Deformation::Joint& joint : d.joints)
        world_from_mesh.push_back(transform_at(*d.tree, joint.node, time_s) * joint.joint_from_mesh);
    const auto map_of = [&](std::size_t vertex) {
        Affine3 map{{}, {}, {}, {}};
        for (const std::vector<Deformation::Influence>& set : d.influences)
            for (std::size_t k = 0; k < 4; ++k)
                if (set[vertex].weight[k] != 0)
                    map = sum(map, world_from_mesh[set[vertex].joint[k]], set[vertex].weight[k]);
        return map;
    };
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        // Cofactors carry normals, whether the map has an inverse or not.
        const Affine3 map = map_of(d.vertex_of_normal[i]);
        const Vec3 n = mesh.normals[i];
        mesh.normals[i] = normalize(cross(map.y, map.z) * n.x + cross(map.z, map.x) * n.y + cross(map.x, map.y) * n.z);
    }
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        mesh.positions[i] = transform_point(map_of(i), mesh.positions[i]);
}

}  // namespace

bool moves(const Deformation& d) {
    const auto turns = [](const AnimatedNode& node) { return node.translations || node.rotations || node.scales; };
    if (d.weight_track) return true;
    return !d.joints.empty() && std::any_of(d.tree->nodes.begin(), d.tree->nodes.end(), turns);
}

bool is_deforming(const Scene& scene) {
    return std::any_of(scene.objects.begin(), scene.objects.end(),
                       [](const Object& object) { return object.deformation && moves(*object.deformation); });
}

void deform(Scene& scene, float time_s) {
    for (Object& object : scene.objects) {
        if (!object.deformation) continue;
        const Deformation& d = *object.deformation;
        Mesh& mesh = *std::get<Boxed<Mesh>>(object.shape);
        mesh.positions = d.positions;
        mesh.normals = d.normals;
        morph(d, time_s, mesh);
        if (!d.joints.empty()) skin(d, time_s, mesh);
    }
}

}  // namespace sundog::scene
