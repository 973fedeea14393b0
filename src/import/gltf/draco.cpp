// SPDX-License-Identifier: Apache-2.0
// KHR_draco_mesh_compression.
#include <draco/compression/decode.h>

#include <cmath>
#include <new>
#include <string>

#include "import/gltf/mesh.h"

namespace sundog::import::gltf {
namespace {

std::unique_ptr<draco::Mesh> decode(const Json& compression, Bytes bytes) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    try {
        draco::Decoder decoder;
        auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
        if (decoded.ok()) return std::move(decoded).value();
        compression.fail("the compressed mesh is damaged (" + decoded.status().error_msg_string() + ')');
    } catch (const std::bad_alloc&) {
        compression.fail("the compressed mesh is damaged, or too large");
    }
}

/// Reads attributes of a decoded mesh by their names in glTF.
class DracoAttributes {
public:
    DracoAttributes(const draco::Mesh& mesh, const Json& compression)
        : mesh_(mesh), names_(compression.required("attributes")) {}

    [[nodiscard]] std::size_t vertex_count() const { return mesh_.num_points(); }
    [[nodiscard]] bool has(const std::string& name) const { return static_cast<bool>(names_.member(name.c_str())); }

    /// How many numbers a vertex has.
    [[nodiscard]] std::size_t width(const std::string& name) const { return attribute(name).num_components(); }

    /// Calls put(vertex, its `width` numbers) for all vertices.
    template <class T, std::size_t width, class Put>
    void read(const std::string& name, const Put& put) const {
        const Json id = names_.required(name.c_str());
        const draco::PointAttribute& attribute = this->attribute(name);
        for (std::uint32_t i = 0; i < mesh_.num_points(); ++i) {
            std::array<T, width> numbers{};
            if (!attribute.ConvertValue<T>(attribute.mapped_index(draco::PointIndex(i)), width, numbers.data()))
                id.fail("the attribute can't be read");
            for (const T number : numbers)
                if (!std::isfinite(static_cast<float>(number)))
                    id.fail("vertex " + std::to_string(i) + " has a number that is not finite");
            put(i, numbers);
        }
    }

private:
    [[nodiscard]] const draco::PointAttribute& attribute(const std::string& name) const {
        const Json id = names_.required(name.c_str());
        const draco::PointAttribute* found =
            mesh_.GetAttributeByUniqueId(static_cast<std::uint32_t>(id.whole(UINT32_MAX)));
        if (found == nullptr) id.fail("the compressed mesh has no such attribute");
        return *found;
    }

    const draco::Mesh& mesh_;
    Json names_;
};

std::vector<Vec3> read_vectors(const DracoAttributes& attributes, const std::string& name) {
    std::vector<Vec3> all(attributes.vertex_count());
    attributes.read<float, 3>(name, [&](std::size_t i, const auto& v) { all[i] = {v[0], v[1], v[2]}; });
    return all;
}

/// Colours, tangents and second texture coordinates.
void read_further_attributes(const DracoAttributes& attributes, const UvSets& uv_sets, PrimitiveData& data) {
    const std::string uvs = "TEXCOORD_" + std::to_string(uv_sets.second.value_or(0));
    const bool second = uv_sets.second && attributes.has(uvs);
    if (!second && !attributes.has("COLOR_0") && !attributes.has("TANGENT")) return;
    prepare_attributes(attributes.vertex_count(), data);
    std::vector<scene::Mesh::Attributes>& all = data.attributes;
    if (second)
        attributes.read<float, 2>(uvs, [&](std::size_t i, const auto& v) {
            all[i].second_texcoord = {v[0], 1 - v[1]};
        });
    if (attributes.has("COLOR_0")) {
        const auto color = [&](std::size_t i, const auto& v) { set_color(v, all[i]); };
        if (attributes.width("COLOR_0") < 4) attributes.read<float, 3>("COLOR_0", color);
        else attributes.read<float, 4>("COLOR_0", color);
    }
    if (attributes.has("TANGENT"))
        attributes.read<float, 4>("TANGENT", [&](std::size_t i, const auto& v) { set_tangent(v, all[i]); });
}

std::vector<Joints> read_joints(const DracoAttributes& attributes, const std::string& set) {
    std::vector<Joints> all;
    if (!attributes.has("JOINTS_" + set) || !attributes.has("WEIGHTS_" + set)) return all;
    all.resize(attributes.vertex_count());
    attributes.read<std::uint32_t, 4>("JOINTS_" + set, [&](std::size_t i, const auto& v) { all[i].joint = v; });
    attributes.read<float, 4>("WEIGHTS_" + set, [&](std::size_t i, const auto& v) { all[i].weight = v; });
    return all;
}

}  // namespace

PrimitiveData read_draco_primitive(Asset& asset, const Json& primitive, const Json& compression,
                                   const UvSets& uv_sets) {
    const std::size_t view = compression.required_index("bufferView", asset.list("bufferViews").size(), "bufferViews");
    const std::unique_ptr<draco::Mesh> mesh = decode(compression, asset.view(view));
    const DracoAttributes attributes(*mesh, compression);
    asset.take_memory(attributes.vertex_count() * (2 * sizeof(Vec3) + sizeof(Vec2)), compression);
    PrimitiveData data;
    data.positions = read_vectors(attributes, "POSITION");
    if (attributes.has("NORMAL")) data.normals = read_vectors(attributes, "NORMAL");
    if (const std::string uvs = "TEXCOORD_" + std::to_string(uv_sets.first); attributes.has(uvs)) {
        data.texcoords.resize(attributes.vertex_count());
        attributes.read<float, 2>(uvs, [&](std::size_t i, const auto& v) { data.texcoords[i] = {v[0], 1 - v[1]}; });
    }
    read_further_attributes(attributes, uv_sets, data);
    data.joints = read_joints(attributes, "0");
    data.more_joints = read_joints(attributes, "1");
    data.targets = read_targets(asset, primitive.member("targets"), data.positions.size(), !data.normals.empty());
    data.corners.reserve(std::size_t{mesh->num_faces()} * 3);
    for (std::uint32_t f = 0; f < mesh->num_faces(); ++f)
        for (const draco::PointIndex& corner : mesh->face(draco::FaceIndex(f))) {
            if (corner.value() >= attributes.vertex_count()) compression.fail("the compressed mesh is damaged");
            data.corners.push_back(corner.value());
        }
    return data;
}

}  // namespace sundog::import::gltf
