// SPDX-License-Identifier: Apache-2.0
#include "import/gltf/mesh.h"

#include <algorithm>
#include <string>

#include "import/gltf/materials.h"

namespace sundog::import::gltf {
namespace {

constexpr std::size_t kTriangles = 4;
constexpr std::size_t kTriangleFan = 6;

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from, std::size_t vertices_before, std::size_t vertices) {
    if (from.empty() && to.empty()) return;
    to.resize(vertices_before);
    to.insert(to.end(), from.begin(), from.end());
    to.resize(vertices_before + vertices);
}

/// Puts a primitive behind those before it.
void append_primitive(const PrimitiveData& p, scene::Index material, MeshData& out) {
    scene::Mesh& mesh = out.mesh;
    const std::size_t first = mesh.positions.size();
    const std::size_t count = p.positions.size();
    const auto normals_first = static_cast<std::uint32_t>(mesh.normals.size());
    const auto texcoords_first = static_cast<std::uint32_t>(mesh.texcoords.size());
    append(out.joints, p.joints, first, count);
    append(out.more_joints, p.more_joints, first, count);
    for (std::size_t t = 0; t < out.targets.size(); ++t) {
        const MorphTarget none;
        const MorphTarget& target = t < p.targets.size() ? p.targets[t] : none;
        append(out.targets[t].positions, target.positions, first, count);
        // Normals are kept for vertices that have some, in their own order.
        append(out.targets[t].normals, target.normals, normals_first, p.normals.size());
    }
    mesh.positions.insert(mesh.positions.end(), p.positions.begin(), p.positions.end());
    mesh.normals.insert(mesh.normals.end(), p.normals.begin(), p.normals.end());
    const std::size_t attributes_before = mesh.attributes.size();
    append(mesh.attributes, p.attributes, texcoords_first, p.texcoords.size());
    mesh.texcoords.insert(mesh.texcoords.end(), p.texcoords.begin(), p.texcoords.end());
    // Primitives without attributes, before this one and this one itself, have one set of texture coordinates for both.
    const std::size_t own = p.attributes.empty() ? mesh.attributes.size() : texcoords_first;
    for (std::size_t i = attributes_before; i < own && i < mesh.attributes.size(); ++i)
        mesh.attributes[i].second_texcoord = mesh.texcoords[i];
    for (std::size_t i = 0; i + 2 < p.corners.size(); i += 3) {
        scene::Mesh::Triangle triangle{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = p.corners[i + k];
            triangle.position[k] = static_cast<std::uint32_t>(first) + vertex;
            triangle.normal[k] = p.normals.empty() ? scene::kNone : normals_first + vertex;
            triangle.texcoord[k] = p.texcoords.empty() ? scene::kNone : texcoords_first + vertex;
        }
        triangle.material = material;
        mesh.triangles.push_back(triangle);
    }
}

const char* kind_of(std::size_t mode) { return mode == 0 ? "points" : "lines"; }

}  // namespace

const MeshData& MeshReader::read(std::size_t index) {
    const auto known = known_.find(index);
    if (known != known_.end()) return known->second;
    return known_.emplace(index, read_mesh(asset_.list("meshes")[index])).first->second;
}

scene::Index MeshReader::material_of(const Json& primitive) {
    const std::size_t count = asset_.list("materials").size();
    auto index = primitive.index_or_none("material", count, "materials");
    if (const auto other = variant_ ? material_of_variant(primitive, *variant_, count) : std::nullopt) index = other;
    if (index) return static_cast<scene::Index>(*index);
    if (default_material_ == scene::kNone) {
        default_material_ = static_cast<scene::Index>(asset_.scene().materials.size());
        scene::Material material;
        material.name = "default";
        material.where = {asset_.name(), 0, 0};
        material.principled.emplace();
        asset_.scene().materials.push_back(std::move(material));
    }
    return default_material_;
}

MeshData MeshReader::read_mesh(const Json& json) {
    MeshData data;
    const Json primitives = json.required("primitives");
    if (primitives.size() == 0) primitives.fail("a mesh must have a primitive");
    std::size_t target_count = 0;
    for (std::size_t i = 0; i < primitives.size(); ++i)
        target_count = std::max(target_count, primitives[i].member("targets").size());
    if (const Json weights = json.member("weights")) data.weights = weights.numbers(target_count);
    data.weights.resize(target_count);
    data.targets.resize(target_count);
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        const Json primitive = primitives[i];
        const std::size_t mode = primitive.whole_or("mode", kTriangles);
        if (mode > kTriangleFan) primitive.required("mode").fail("unknown mode", "0 to 6 are possible");
        if (mode < kTriangles) {
            asset_.warn_once(kind_of(mode), primitive, std::string(kind_of(mode)) + " are not drawn");
            continue;
        }
        const scene::Index material = material_of(primitive);
        const UvSets uv_sets = material < uv_sets_.size() ? uv_sets_[material] : UvSets{};
        const Json compression = primitive.extension("KHR_draco_mesh_compression");
        const PrimitiveData p = compression ? read_draco_primitive(asset_, primitive, compression, uv_sets)
                                            : read_primitive(asset_, primitive, uv_sets);
        if (data.mesh.positions.size() + p.positions.size() >= scene::kNone)
            json.fail("the mesh has more vertices than 32-bit indices can count");
        asset_.take_memory(p.corners.size() / 3 * sizeof(scene::Mesh::Triangle), primitive);
        append_primitive(p, material, data);
    }
    for (const std::vector<Joints>* joints : {&data.joints, &data.more_joints})
        for (const Joints& j : *joints)
            for (std::size_t k = 0; k < 4; ++k)
                if (j.weight[k] > 0) data.joint_count = std::max(data.joint_count, std::size_t{j.joint[k]} + 1);
    return data;
}

}  // namespace sundog::import::gltf
