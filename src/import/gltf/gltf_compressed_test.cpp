// SPDX-License-Identifier: Apache-2.0
// Compressed meshes, as the libraries' own encoders write them.
#include <draco/compression/encode.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <string>

#include "import/gltf/gltf_test_file.h"

namespace sundog::import::gltf {
namespace {

const std::vector<float> kPositions{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
const std::vector<std::uint32_t> kCorners{0, 1, 2, 0, 2, 3};

const scene::Mesh& mesh_of(const scene::Scene& scene) {
    return *std::get<Boxed<scene::Mesh>>(scene.objects.at(0).shape);
}

/// Twice the area of all triangles; those of the test are a unit square in the plane y = 0, facing -y.
Vec3 area_of(const scene::Mesh& mesh) {
    Vec3 sum;
    for (const scene::Mesh::Triangle& t : mesh.triangles) {
        const Vec3 a = mesh.positions[t.position[0]];
        sum += cross(mesh.positions[t.position[1]] - a, mesh.positions[t.position[2]] - a);
    }
    return sum;
}

std::string draco_bytes() {
    draco::Mesh mesh;
    mesh.set_num_points(4);
    draco::GeometryAttribute description;
    description.Init(draco::GeometryAttribute::POSITION, nullptr, 3, draco::DT_FLOAT32, false, 12, 0);
    const int id = mesh.AddAttribute(description, true, 4);
    for (std::uint32_t i = 0; i < 4; ++i)
        mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), &kPositions[3 * std::size_t{i}]);
    for (std::size_t i = 0; i < kCorners.size(); i += 3)
        mesh.AddFace(
            {draco::PointIndex(kCorners[i]), draco::PointIndex(kCorners[i + 1]), draco::PointIndex(kCorners[i + 2])});
    draco::Encoder encoder;
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(mesh, &buffer).ok());
    return {buffer.data(), buffer.size()};
}

std::string draco_gltf(const std::string& bytes) {
    return R"({"asset": {"version": "2.0"}, "extensionsRequired": ["KHR_draco_mesh_compression"],
"buffers": [{"byteLength": )" +
           std::to_string(bytes.size()) + R"(, "uri": "data:;base64,)" + base64(bytes) + R"("}],
"bufferViews": [{"buffer": 0, "byteLength": )" +
           std::to_string(bytes.size()) + R"(}],
"accessors": [{"componentType": 5126, "count": 4, "type": "VEC3"}, {"componentType": 5125, "count": 6, "type": "SCALAR"}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1,
  "extensions": {"KHR_draco_mesh_compression": {"bufferView": 0, "attributes": {"POSITION": 0}}}}]}],
"nodes": [{"mesh": 0}]})";
}

// Catches faces or points that get lost on their way through the decoder.
TEST(GltfCompressed, Draco) {
    const scene::Scene scene = import_text(draco_gltf(draco_bytes()));
    const scene::Mesh& mesh = mesh_of(scene);
    EXPECT_EQ(mesh.triangles.size(), 2U);
    EXPECT_NEAR(length(area_of(mesh) - Vec3{0, -2, 0}), 0, 1e-3F);
}

// Catches damaged data that is read all the same, or brings the program down.
TEST(GltfCompressed, DamagedDracoIsRefused) {
    const std::string good = draco_bytes();
    std::size_t refused = 0;
    for (std::size_t i = 0; i < good.size(); ++i) {
        for (const char change : {'\x01', '\x40', '\xff'}) {
            std::string bytes = good;
            bytes[i] = static_cast<char>(bytes[i] ^ change);
            try {
                import_text(draco_gltf(bytes));
            } catch (const InputError& error) {
                EXPECT_TRUE(error.diagnostic().message.starts_with("meshes[0]")) << error.what();
                ++refused;
            }
        }
    }
    EXPECT_GT(refused, good.size() / 4);
    EXPECT_THROW(import_text(draco_gltf(good.substr(0, good.size() / 2))), InputError);
}

std::string meshopt_gltf(const std::string& vertices, const std::string& corners, const std::string& count = "4") {
    const std::string bytes = vertices + corners;
    const auto view = [](std::size_t offset, std::size_t size, const std::string& more) {
        return R"({"buffer": 1, "byteLength": 1, "extensions": {"EXT_meshopt_compression": {"buffer": 0, "byteOffset": )" +
               std::to_string(offset) + R"(, "byteLength": )" + std::to_string(size) + more + "}}}";
    };
    return R"({"asset": {"version": "2.0"}, "extensionsRequired": ["EXT_meshopt_compression"],
"buffers": [{"byteLength": )" +
           std::to_string(bytes.size()) + R"(, "uri": "data:;base64,)" + base64(bytes) + R"("}, {"byteLength": 72}],
"bufferViews": [)" +
           view(0, vertices.size(), R"(, "byteStride": 12, "mode": "ATTRIBUTES", "count": )" + count) + ", " +
           view(vertices.size(), corners.size(), R"(, "byteStride": 4, "mode": "TRIANGLES", "count": 6)") + R"(],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
  {"bufferView": 1, "componentType": 5125, "count": 6, "type": "SCALAR"}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
"nodes": [{"mesh": 0}]})";
}

std::string meshopt_vertices() {
    std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(4, 12));
    bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), kPositions.data(), 4, 12));
    return {bytes.begin(), bytes.end()};
}

std::string meshopt_corners() {
    std::vector<unsigned char> bytes(meshopt_encodeIndexBufferBound(kCorners.size(), 4));
    bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), kCorners.data(), kCorners.size()));
    return {bytes.begin(), bytes.end()};
}

// Catches views that are read as they lie, and buffers without bytes that are asked for them.
TEST(GltfCompressed, Meshopt) {
    const scene::Scene scene = import_text(meshopt_gltf(meshopt_vertices(), meshopt_corners()));
    const scene::Mesh& mesh = mesh_of(scene);
    EXPECT_EQ(mesh.triangles.size(), 2U);
    EXPECT_EQ(area_of(mesh), (Vec3{0, -2, 0}));
}

std::string message_of(const std::string& text) {
    try {
        import_text(text);
    } catch (const InputError& error) {
        return error.diagnostic().message;
    }
    return "no error";
}

// Catches sizes that compressed data can't have, and data that is cut off.
TEST(GltfCompressed, DamagedMeshoptIsRefused) {
    const std::string at = "bufferViews[0].extensions.EXT_meshopt_compression: ";
    const std::string vertices = meshopt_vertices();
    EXPECT_EQ(message_of(meshopt_gltf(vertices.substr(1), meshopt_corners())), at + "the compressed data is damaged");
    EXPECT_EQ(message_of(meshopt_gltf(vertices, meshopt_corners(), "4000000000")),
              at + std::to_string(vertices.size()) + " bytes are too few for 4000000000 elements of 12 bytes");
}

}  // namespace
}  // namespace sundog::import::gltf
