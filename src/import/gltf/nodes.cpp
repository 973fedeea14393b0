// SPDX-License-Identifier: Apache-2.0
#include "import/gltf/nodes.h"

#include <cmath>
#include <string>

#include "import/gltf/accessor.h"

namespace sundog::import::gltf {
namespace {

constexpr std::size_t kNoParent = SIZE_MAX;

/// glTF's +Y, up, becomes our +Z, and its +Z, the front, -Y: where the orbit camera starts.
constexpr Affine3 kStandUp{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, 0}};

scene::Quaternion quaternion_of(const Json& json) {
    const std::vector<float> q = json.numbers(4);
    const float len = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (!(len > 0) || !std::isfinite(len)) json.fail("a rotation without direction");
    return {q[0] / len, q[1] / len, q[2] / len, q[3] / len};
}

Affine3 matrix_of(const Json& json) {
    const std::vector<float> m = json.numbers(16);
    if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1)
        json.fail("the matrix's last row must be 0, 0, 0, 1", "matrices are written column by column");
    return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
}

scene::AnimatedNode node_of(const Json& json) {
    scene::AnimatedNode node;
    if (const Json matrix = json.member("matrix")) {
        node.matrix = matrix_of(matrix);
        return node;
    }
    node.translation = json.vec3_or("translation", {0, 0, 0});
    node.scale = json.vec3_or("scale", {1, 1, 1});
    if (const Json rotation = json.member("rotation")) node.rotation = quaternion_of(rotation);
    return node;
}

/// The parent of each node of the file.
std::vector<std::size_t> parents_of(const Json& nodes) {
    std::vector<std::size_t> parents(nodes.size(), kNoParent);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Json children = nodes[i].member("children");
        for (std::size_t k = 0; k < children.size(); ++k) {
            const std::size_t child = children[k].index(nodes.size(), "nodes");
            if (parents[child] != kNoParent)
                children[k].fail("nodes[" + std::to_string(child) + "] is a child of nodes[" +
                                 std::to_string(parents[child]) + "] already");
            parents[child] = i;
        }
    }
    return parents;
}

/// Appends a node and all below it, parents before children.
void append_tree(Asset& asset, std::size_t top, NodeGraph& graph) {
    const Json nodes = asset.list("nodes");
    std::vector<std::pair<std::size_t, scene::Index>> open{{top, scene::kNone}};
    while (!open.empty()) {
        const auto [index, parent] = open.back();
        open.pop_back();
        const auto here = static_cast<scene::Index>(graph.tree->nodes.size());
        graph.tree_index[index] = here;
        graph.file_index.push_back(index);
        scene::AnimatedNode node = node_of(nodes[index]);
        node.parent = parent;
        graph.tree->nodes.push_back(std::move(node));
        const Json children = nodes[index].member("children");
        for (std::size_t k = children.size(); k-- > 0;) open.emplace_back(children[k].whole(), here);
    }
}

}  // namespace

NodeGraph read_nodes(Asset& asset) {
    NodeGraph graph;
    graph.tree = std::make_shared<scene::NodeTree>();
    graph.tree->world_from_tree = kStandUp;
    const Json nodes = asset.list("nodes");
    graph.tree_index.assign(nodes.size(), scene::kNone);
    const std::vector<std::size_t> parents = parents_of(nodes);

    const Json scenes = asset.list("scenes");
    const auto shown = asset.root().index_or_none("scene", scenes.size(), "scenes");
    if (shown || scenes.size() > 0) {
        const Json roots = scenes[shown.value_or(0)].member("nodes");
        for (std::size_t i = 0; i < roots.size(); ++i) {
            const std::size_t root = roots[i].index(nodes.size(), "nodes");
            if (parents[root] != kNoParent)
                roots[i].fail("nodes[" + std::to_string(root) + "] is no root: it is a child of nodes[" +
                              std::to_string(parents[root]) + ']');
            if (graph.tree_index[root] != scene::kNone)
                roots[i].fail("nodes[" + std::to_string(root) + "] is named twice");
            append_tree(asset, root, graph);
        }
        graph.shown_count = graph.tree->nodes.size();
    }
    // The other nodes may be joints; without any scene, they are what there is to show.
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (parents[i] == kNoParent && graph.tree_index[i] == scene::kNone) append_tree(asset, i, graph);
    if (scenes.size() == 0) graph.shown_count = graph.tree->nodes.size();
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (graph.tree_index[i] == scene::kNone) nodes[i].fail("the node is above itself in the tree");
    return graph;
}

void finish_nodes(NodeGraph& graph) {
    const std::vector<scene::AnimatedNode>& nodes = graph.tree->nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const scene::AnimatedNode& node = nodes[i];
        const Affine3 local =
            translation(node.translation) * scene::rotation_of(node.rotation) * scaling(node.scale) * node.matrix;
        const bool is_root = node.parent == scene::kNone;
        graph.world_from_node.push_back((is_root ? kStandUp : graph.world_from_node[node.parent]) * local);
        graph.moves.push_back(node.translations || node.rotations || node.scales ||
                              (!is_root && graph.moves[node.parent]));
    }
}

std::vector<Affine3> read_instances(Asset& asset, const Json& node) {
    const Json instancing = node.extension("EXT_mesh_gpu_instancing");
    if (!instancing) return {Affine3{}};
    const Json attributes = instancing.required("attributes");
    std::vector<Affine3> instances;
    std::size_t count = SIZE_MAX;
    const auto read = [&](const char* name, const char* type) {
        const Json attribute = attributes.member(name);
        if (!attribute) return Numbers{};
        Numbers numbers = read_numbers(asset, attribute, {{type}, false});
        if (count != SIZE_MAX && numbers.count != count)
            attribute.fail("has " + std::to_string(numbers.count) + " elements for " + std::to_string(count) +
                           " instances");
        count = numbers.count;
        return numbers;
    };
    const Numbers translations = read("TRANSLATION", "VEC3");
    const Numbers rotations = read("ROTATION", "VEC4");
    const Numbers scales = read("SCALE", "VEC3");
    if (count == SIZE_MAX) attributes.fail("has none of TRANSLATION, ROTATION and SCALE");
    instances.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        Affine3 place;
        if (translations.count > 0) place = translation({translations[i][0], translations[i][1], translations[i][2]});
        if (rotations.count > 0) {
            const auto q = rotations[i];
            const float len = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
            if (!(len > 0)) attributes.member("ROTATION").fail("element " + std::to_string(i) + " is no rotation");
            place = place * scene::rotation_of({q[0] / len, q[1] / len, q[2] / len, q[3] / len});
        }
        if (scales.count > 0) place = place * scaling({scales[i][0], scales[i][1], scales[i][2]});
        instances.push_back(place);
    }
    return instances;
}

}  // namespace sundog::import::gltf
