// SPDX-License-Identifier: Apache-2.0
// Meshes (glTF 2.0, section 3.7 "Geometry").
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "import/gltf/asset.h"

namespace sundog::import::gltf {

/// A target of morphing: what its whole weight adds.
struct MorphTarget {
    std::vector<Vec3> positions, normals;  ///< Of each vertex, or empty.
};

/// A vertex's joints (of its node's skin) and their weights.
struct Joints {
    std::array<std::uint32_t, 4> joint{};
    std::array<float, 4> weight{};
};

/// A mesh as written, all its primitives together. Vertices have all of their numbers under one index.
struct MeshData {
    scene::Mesh mesh;
    std::vector<Joints> joints;        ///< Of each vertex, or empty.
    std::vector<Joints> more_joints;   ///< Four more of each, or empty.
    std::vector<MorphTarget> targets;  ///< As many as the mesh has.
    std::vector<float> weights;        ///< Of the targets, at rest.
    std::size_t joint_count = 0;       ///< One more than the largest joint that is named.
};

/// Reads a primitive's triangles, uncompressed or (KHR_draco_mesh_compression) compressed.
struct PrimitiveData {
    std::vector<Vec3> positions, normals;
    std::vector<Vec2> texcoords;
    std::vector<std::uint32_t> corners;  ///< Indices, three a triangle.
    std::vector<Joints> joints, more_joints;
    std::vector<MorphTarget> targets;
};

/// All meshes of a file, read when first asked for.
class MeshReader {
public:
    explicit MeshReader(Asset& asset) : asset_(asset) {}

    /// Mesh number `index`; materials are indices into the scene's. Errors: InputError.
    const MeshData& read(std::size_t index);

private:
    MeshData read_mesh(const Json& json);
    scene::Index material_of(const Json& primitive);

    Asset& asset_;
    std::unordered_map<std::size_t, MeshData> known_;
    scene::Index default_material_ = scene::kNone;
};

/// The triangles of a primitive that has some. `uv_set` is which texture coordinates count.
PrimitiveData read_primitive(Asset& asset, const Json& primitive, std::size_t uv_set);

/// The targets of a primitive, whose normals count only where it has some itself.
std::vector<MorphTarget> read_targets(Asset& asset, const Json& targets, std::size_t vertices, bool normals);

/// The triangles of a compressed one.
PrimitiveData read_draco_primitive(Asset& asset, const Json& primitive, const Json& compression, std::size_t uv_set);

}  // namespace sundog::import::gltf
