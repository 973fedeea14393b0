// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>

#include "import/gltf/accessor.h"
#include "import/gltf/mesh.h"

namespace sundog::import::gltf {
namespace {

constexpr std::size_t kTriangles = 4;
constexpr std::size_t kTriangleStrip = 5;

/// Y up to Z up comes with the nodes: meshes stay as written.
std::vector<Vec3> vectors_of(const Numbers& numbers) {
    std::vector<Vec3> all;
    all.reserve(numbers.count);
    for (std::size_t i = 0; i < numbers.count; ++i) {
        const auto v = numbers[i];
        all.push_back({v[0], v[1], v[2]});
    }
    return all;
}

/// An attribute that every vertex must have, if any has.
Numbers read_attribute(Asset& asset, const Json& attribute, const AccessorKind& kind, std::size_t vertices) {
    const std::size_t count = accessor_count(asset, attribute);
    if (count != vertices)
        attribute.fail("has " + std::to_string(count) + " elements for " + std::to_string(vertices) + " vertices");
    return read_numbers(asset, attribute, kind);
}

std::vector<Vec2> read_texcoords(Asset& asset, const Json& attributes, std::size_t set, std::size_t vertices) {
    std::vector<Vec2> all;
    const Json uvs = attributes.member(("TEXCOORD_" + std::to_string(set)).c_str());
    if (!uvs) return all;
    const Numbers numbers = read_attribute(asset, uvs, {{"VEC2"}, true}, vertices);
    all.reserve(vertices);
    for (std::size_t i = 0; i < vertices; ++i) all.push_back({numbers[i][0], 1 - numbers[i][1]});
    return all;
}

/// Colours, tangents and second texture coordinates.
void read_further_attributes(Asset& asset, const Json& attributes, const UvSets& uv_sets, PrimitiveData& data) {
    const std::size_t vertices = data.positions.size();
    const auto all = [&]() -> std::vector<scene::Mesh::Attributes>& {
        prepare_attributes(vertices, data);
        return data.attributes;
    };
    if (uv_sets.second) {
        const std::vector<Vec2> second = read_texcoords(asset, attributes, *uv_sets.second, vertices);
        for (std::size_t i = 0; i < second.size(); ++i) all()[i].second_texcoord = second[i];
    }
    if (const Json colors = attributes.member("COLOR_0")) {
        const Numbers numbers = read_attribute(asset, colors, {{"VEC3", "VEC4"}, false}, vertices);
        for (std::size_t i = 0; i < vertices; ++i) set_color(numbers[i], all()[i]);
    }
    if (const Json tangents = attributes.member("TANGENT")) {
        const Numbers numbers = read_attribute(asset, tangents, {{"VEC4"}, true}, vertices);
        for (std::size_t i = 0; i < vertices; ++i) set_tangent(numbers[i], all()[i]);
    }
}

std::vector<Joints> read_joints(Asset& asset, const Json& joints, const Json& weights, std::size_t vertices) {
    std::vector<Joints> all;
    if (!joints || !weights) return all;
    const std::vector<std::uint32_t> numbers = read_whole_numbers(asset, joints, "VEC4");
    const Numbers shares = read_attribute(asset, weights, {{"VEC4"}, false}, vertices);
    if (numbers.size() != 4 * vertices)
        joints.fail("has " + std::to_string(numbers.size() / 4) + " elements for " + std::to_string(vertices) +
                    " vertices");
    all.resize(vertices);
    for (std::size_t i = 0; i < vertices; ++i)
        for (std::size_t k = 0; k < 4; ++k) all[i].joint[k] = numbers[4 * i + k], all[i].weight[k] = shares[i][k];
    return all;
}

std::vector<std::uint32_t> read_indices(Asset& asset, const Json& primitive, std::size_t vertices) {
    std::vector<std::uint32_t> indices;
    const Json json = primitive.member("indices");
    if (!json) {
        indices.resize(vertices);
        for (std::size_t i = 0; i < vertices; ++i) indices[i] = static_cast<std::uint32_t>(i);
        return indices;
    }
    indices = read_whole_numbers(asset, json, "SCALAR");
    const auto bad = std::find_if(indices.begin(), indices.end(), [&](std::uint32_t i) { return i >= vertices; });
    if (bad != indices.end())
        json.fail("index number " + std::to_string(bad - indices.begin()) + " is " + std::to_string(*bad) +
                  ", but there are " + std::to_string(vertices) + " vertices");
    return indices;
}

/// Section 3.7.2.1: of a strip every other triangle is turned round; a fan goes around its first vertex.
std::vector<std::uint32_t> triangles_of(Asset& asset, const Json& primitive, std::vector<std::uint32_t> indices) {
    const std::size_t mode = primitive.whole_or("mode", kTriangles);
    if (mode == kTriangles) {
        if (indices.size() % 3 == 0) return indices;
        asset.warn_once("odd corners", primitive, "the number of corners is no multiple of 3; the last are left off");
        indices.resize(indices.size() / 3 * 3);
        return indices;
    }
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
        if (mode == kTriangleStrip) {
            const std::size_t odd = i % 2;
            corners.insert(corners.end(), {indices[i], indices[i + 1 + odd], indices[i + 2 - odd]});
        } else {
            corners.insert(corners.end(), {indices[i + 1], indices[i + 2], indices[0]});
        }
    }
    return corners;
}

}  // namespace

void prepare_attributes(std::size_t vertices, PrimitiveData& data) {
    data.texcoords.resize(vertices);
    if (!data.attributes.empty()) return;
    data.attributes.resize(vertices);
    // Where a second set is named but isn't there, maps go by the first.
    for (std::size_t i = 0; i < vertices; ++i) data.attributes[i].second_texcoord = data.texcoords[i];
}

void set_color(std::span<const float> numbers, scene::Mesh::Attributes& out) {
    out.color = max(Vec3{numbers[0], numbers[1], numbers[2]}, {0, 0, 0});
    out.alpha = numbers.size() > 3 ? std::clamp(numbers[3], 0.0F, 1.0F) : 1;
}

void set_tangent(std::span<const float> numbers, scene::Mesh::Attributes& out) {
    out.tangent = {numbers[0], numbers[1], numbers[2]};
    out.handedness = numbers[3] < 0 ? -1.0F : 1.0F;
}

std::vector<MorphTarget> read_targets(Asset& asset, const Json& targets, std::size_t vertices, bool normals) {
    std::vector<MorphTarget> all(targets.size());
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (const Json positions = targets[i].member("POSITION"))
            all[i].positions = vectors_of(read_attribute(asset, positions, {{"VEC3"}, true}, vertices));
        const Json bent = targets[i].member("NORMAL");
        if (bent && normals) all[i].normals = vectors_of(read_attribute(asset, bent, {{"VEC3"}, true}, vertices));
    }
    return all;
}

PrimitiveData read_primitive(Asset& asset, const Json& primitive, const UvSets& uv_sets) {
    PrimitiveData data;
    const Json attributes = primitive.required("attributes");
    const Json positions = attributes.member("POSITION");
    if (!positions) {
        asset.warn_once("no POSITION", attributes, "has no 'POSITION', and is not drawn");
        return data;
    }
    // Quantized positions (KHR_mesh_quantization) may be whole numbers.
    data.positions = vectors_of(read_numbers(asset, positions, {{"VEC3"}, true}));
    const std::size_t vertices = data.positions.size();
    if (const Json normals = attributes.member("NORMAL"))
        data.normals = vectors_of(read_attribute(asset, normals, {{"VEC3"}, true}, vertices));
    data.texcoords = read_texcoords(asset, attributes, uv_sets.first, vertices);
    read_further_attributes(asset, attributes, uv_sets, data);
    data.joints = read_joints(asset, attributes.member("JOINTS_0"), attributes.member("WEIGHTS_0"), vertices);
    data.more_joints = read_joints(asset, attributes.member("JOINTS_1"), attributes.member("WEIGHTS_1"), vertices);
    data.targets = read_targets(asset, primitive.member("targets"), vertices, !data.normals.empty());
    data.corners = triangles_of(asset, primitive, read_indices(asset, primitive, vertices));
    return data;
}

}  // namespace sundog::import::gltf
