// SPDX-License-Identifier: Apache-2.0
// Meshes (glTF 2.0, section 3.7 "Geometry").
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <utility>

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

/// Which of a primitive's TEXCOORD_n its material's maps go by: two at most.
struct UvSets {
    std::size_t first = 0;
    std::optional<std::size_t> second;
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
    std::vector<scene::Mesh::Attributes> attributes;  ///< As many as texcoords, or none.
    std::vector<std::uint32_t> corners;               ///< Indices, three a triangle.
    std::vector<Joints> joints, more_joints;
    std::vector<MorphTarget> targets;
};

/// All meshes of a file, read when first asked for.
class MeshReader {
public:
    /// `uv_sets` are those of the file's materials; `variant` is the number of the one that is shown.
    MeshReader(Asset& asset, std::vector<UvSets> uv_sets, std::optional<std::size_t> variant)
        : asset_(asset), uv_sets_(std::move(uv_sets)), variant_(variant) {}

    /// Mesh number `index`; materials are indices into the scene's. Errors: InputError.
    const MeshData& read(std::size_t index);

private:
    MeshData read_mesh(const Json& json);
    scene::Index material_of(const Json& primitive);

    Asset& asset_;
    std::vector<UvSets> uv_sets_;
    std::optional<std::size_t> variant_;
    std::unordered_map<std::size_t, MeshData> known_;
    scene::Index default_material_ = scene::kNone;
};

/// The triangles of a primitive that has some. `uv_sets` are the texture coordinates that count.
PrimitiveData read_primitive(Asset& asset, const Json& primitive, const UvSets& uv_sets);

/// Gives a primitive's vertices attributes, and texture coordinates where they have none.
void prepare_attributes(std::size_t vertices, PrimitiveData& data);
/// A vertex's colour from three or four numbers, and its tangent from four.
void set_color(std::span<const float> numbers, scene::Mesh::Attributes& out);
void set_tangent(std::span<const float> numbers, scene::Mesh::Attributes& out);

/// The targets of a primitive, whose normals count only where it has some itself.
std::vector<MorphTarget> read_targets(Asset& asset, const Json& targets, std::size_t vertices, bool normals);

/// The triangles of a compressed one.
PrimitiveData read_draco_primitive(Asset& asset, const Json& primitive, const Json& compression, const UvSets& uv_sets);

}  // namespace sundog::import::gltf
