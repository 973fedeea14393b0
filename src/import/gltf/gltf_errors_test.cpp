// SPDX-License-Identifier: Apache-2.0
// What bad files say: a good one, one change each, and the message in full.
#include <gtest/gtest.h>

#include <string>

#include "import/gltf/gltf_test_file.h"

namespace sundog::import::gltf {
namespace {

struct Case {
    std::string_view what, by;  ///< Of triangle_gltf().
    std::string_view message;
    std::uint32_t line;
};

std::string message_of(const std::string& text, SourceLocation* where = nullptr) {
    try {
        import_text(text);
    } catch (const InputError& error) {
        if (where != nullptr) *where = error.diagnostic().where;
        const std::string& hint = error.diagnostic().hint;
        return error.diagnostic().message + (hint.empty() ? "" : "; " + hint);
    }
    return "no error";
}

// Catches bad input that crashes, is read without a word, or is blamed on another value or line.
TEST(GltfErrors, EachNamesTheValueAtFault) {
    const std::vector<Case> cases{
        {"\"2.0\"", "\"1.0\"", "asset.version: glTF of version '1.0'; version 2.0 is read", 2},
        {"{\"version\": \"2.0\"}", "{}", "asset: lacks 'version'", 2},
        {"\"scene\": 0", "\"scene\": 0, \"extensionsRequired\": [\"KHR_xmp\"]",
         "extensionsRequired[0]: the file can't be shown without the extension 'KHR_xmp', which is not read", 11},
        {"\"byteLength\": 42", "\"byteLength\": 43",
         "buffers[0].byteLength: the buffer should have 43 bytes, but has 42", 3},
        {"data:;base64,", "data:;base64,?", "buffers[0].uri: the data URI holds '?', which is no base 64", 3},
        {"data:;base64,", "data:;base64", "buffers[0].uri: the data URI has no ','", 3},
        {"\"uri\": \"data:", "\"uri\": \"lost.bin#", "", 3},
        {"\"byteLength\": 36", "\"byteLength\": 43", "bufferViews[0]: bytes 0 to 43 of buffers[0], which has 42", 4},
        {"\"byteLength\": 36", "\"byteOffset\": 18446744073709551615, \"byteLength\": 36",
         "bufferViews[0].byteOffset: expected a whole number of 0 or more, found 18446744073709551615", 4},
        {"\"byteLength\": 36", "\"byteOffset\": 9007199254740992, \"byteLength\": 36",
         "bufferViews[0]: bytes 9007199254740992 to 9007199254741028 of buffers[0], which has 42", 4},
        {"\"byteLength\": 36", "\"byteStride\": 8, \"byteLength\": 36",
         "bufferViews[0].byteStride: a stride of 8 bytes for elements of 12 (accessors[0])", 4},
        {"\"buffer\": 0, \"byteLength\"", "\"buffer\": 1, \"byteLength\"",
         "bufferViews[0].buffer: there is no buffers[1]; the file has 1, counted from 0", 4},
        {"\"count\": 3, \"type\": \"VEC3\"", "\"count\": 4, \"type\": \"VEC3\"",
         "accessors[0]: 4 elements of 12 bytes, 12 apart, from byte 0 on don't fit bufferViews[0], which has 36 bytes",
         5},
        {"\"count\": 3, \"type\": \"VEC3\"", "\"count\": 4294967294, \"type\": \"VEC3\"",
         "accessors[0]: 4294967294 elements of 12 bytes, 12 apart, from byte 0 on don't fit bufferViews[0], which has "
         "36 "
         "bytes",
         5},
        {"\"bufferView\": 0, \"componentType\": 5126, \"count\": 3", "\"componentType\": 5126, \"count\": 4000000000",
         "accessors[0]: 4000000000 elements without a bufferView", 5},
        {"5126", "5124",
         "accessors[0].componentType: unknown component type 5124; expected one of: 5120 to 5123, 5125, 5126", 5},
        {"\"VEC3\"", "\"VEC9\"",
         "accessors[0].type: unknown type 'VEC9'; expected one of: SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3, MAT4", 5},
        {"\"VEC3\"", "\"VEC2\"",
         "meshes[0].primitives[0].attributes.POSITION: accessors[0] is of type VEC2; expected VEC3", 8},
        {"5123", "5126",
         "meshes[0].primitives[0].indices: accessors[1] doesn't hold unsigned whole numbers; expected a componentType "
         "of "
         "5121, 5123 or 5125",
         8},
        {"5123", "5125",
         "accessors[1]: 3 elements of 4 bytes, 4 apart, from byte 0 on don't fit bufferViews[1], which has 6 bytes", 6},
        {"\"POSITION\": 0", "\"POSITION\": 7",
         "meshes[0].primitives[0].attributes.POSITION: there is no accessors[7]; the file has 2, counted from 0", 8},
        {"\"POSITION\": 0", "\"POSITION\": \"a\"",
         "meshes[0].primitives[0].attributes.POSITION: expected a whole number, found a string", 8},
        {"\"POSITION\": 0", "\"POSITION\": 0, \"NORMAL\": 1",
         "meshes[0].primitives[0].attributes.NORMAL: accessors[1] is of type SCALAR; expected VEC3", 8},
        {"\"attributes\": {\"POSITION\": 0}, ", "", "meshes[0].primitives[0]: lacks 'attributes'", 8},
        {"\"material\": 0", "\"material\": 1",
         "meshes[0].primitives[0].material: there is no materials[1]; the file has 1, counted from 0", 8},
        {"\"material\": 0", "\"mode\": 7", "meshes[0].primitives[0].mode: unknown mode; 0 to 6 are possible", 8},
        {"[1, 0, 0, 1]", "[1, 0, 0]", "materials[0].pbrMetallicRoughness.baseColorFactor: expected 4 numbers, found 3",
         7},
        {"[1, 0, 0, 1]", "[1, null, 0, 1]",
         "materials[0].pbrMetallicRoughness.baseColorFactor[1]: expected a number, found null", 7},
        {"[1, 0, 0, 1]", "[1, 1e39, 0, 1]",
         "materials[0].pbrMetallicRoughness.baseColorFactor[1]: the number is out of range", 7},
        {"{\"name\": \"red\", ", "{\"alphaMode\": \"GLASS\", ",
         "materials[0].alphaMode: unknown mode 'GLASS'; expected one of: OPAQUE, MASK, BLEND", 7},
        {"{\"mesh\": 0}", "{\"mesh\": 0, \"children\": [0]}",
         "scenes[0].nodes[0]: nodes[0] is no root: it is a child of nodes[0]", 10},
        {"{\"mesh\": 0}", "{\"mesh\": 0}, {\"children\": [2]}, {\"children\": [1]}",
         "nodes[1]: the node is above itself in the tree", 9},
        {"{\"mesh\": 0}", "{\"children\": [2]}, {\"children\": [2]}, {}",
         "nodes[1].children[0]: nodes[2] is a child of nodes[0] already", 9},
        {"{\"mesh\": 0}", "{\"mesh\": 0, \"rotation\": [0, 0, 0, 0]}",
         "nodes[0].rotation: a rotation without direction", 9},
        {"{\"mesh\": 0}", "{\"mesh\": 0, \"matrix\": [1, 2]}", "nodes[0].matrix: expected 16 numbers, found 2", 9},
        {"{\"mesh\": 0}", "{\"mesh\": 0, \"matrix\": [1,0,0,0, 0,1,0,0, 0,0,1,1, 0,0,0,1]}",
         "nodes[0].matrix: the matrix's last row must be 0, 0, 0, 1; matrices are written column by column", 9},
        {"{\"mesh\": 0}", "{\"mesh\": 0, \"scale\": [3e38, 1, 1]}, {\"scale\": [9, 1, 1], \"children\": [0]}",
         "scenes[0].nodes[0]: nodes[0] is no root: it is a child of nodes[1]", 10},
        {"\"scene\": 0", "\"scene\": 1", "scene: there is no scenes[1]; the file has 1, counted from 0", 11},
        {"[{\"nodes\": [0]}]", "{\"nodes\": [0]}", "scenes: expected an array, found an object", 10},
        {"\"indices\": 1", "\"indices\": 0",
         "meshes[0].primitives[0].indices: accessors[0] is of type VEC3; expected SCALAR", 8},
    };
    for (const Case& c : cases) {
        SourceLocation where;
        const std::string said = message_of(replaced(triangle_gltf(), c.what, c.by), &where);
        if (!c.message.empty()) {
            EXPECT_EQ(said, c.message) << c.by;
        }
        EXPECT_NE(said, "no error") << c.by;
        EXPECT_EQ(where.line, c.line) << c.by;
    }
}

// Catches numbers that are taken from files unseen: an index beyond the vertices, a position without value.
TEST(GltfErrors, ValuesInBuffersAreChecked) {
    const auto with = [](const std::string& bytes) {
        const std::string good = bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + bytes_of<std::uint16_t>({0, 1, 2});
        return message_of(replaced(triangle_gltf(), base64(good), base64(bytes)));
    };
    EXPECT_EQ(with(bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + bytes_of<std::uint16_t>({0, 1, 3})),
              "meshes[0].primitives[0].indices: index number 2 is 3, but there are 3 vertices");
    EXPECT_EQ(with(bytes_of<float>({0, 0, 0, 1, NAN, 0, 0, 1, 0}) + bytes_of<std::uint16_t>({0, 1, 2})),
              "accessors[0]: element 1 is not finite");
}

// Catches text that is no JSON and is not pointed at.
TEST(GltfErrors, JsonIsPointedAt) {
    SourceLocation where;
    EXPECT_EQ(message_of("{\n  \"asset\": {\"version\" \"2.0\"}\n}\n", &where),
              "not JSON: unexpected string literal; expected ':'");
    EXPECT_EQ(where.line, 2U);
    EXPECT_EQ(message_of("[]", &where), "the file: expected an object");
    EXPECT_EQ(message_of(std::string(300, '[')), "the JSON text has more than 200 levels");
    EXPECT_NE(message_of(""), "no error");
    EXPECT_NE(message_of("{\"asset\": {\"version\": \"\xff\"}}"), "no error");
}

// Catches binary files whose chunks reach beyond their end.
TEST(GltfErrors, BinaryFilesAreChecked) {
    const std::string json = "{\"asset\":{\"version\":\"2.0\"}}  ";
    const auto glb = [&](std::uint32_t version, std::uint32_t length, std::uint32_t chunk, std::uint32_t type) {
        return "glTF" + bytes_of<std::uint32_t>({version, length, chunk, type}) + json;
    };
    const auto size = static_cast<std::uint32_t>(json.size());
    EXPECT_EQ(message_of(glb(2, 20 + size, size, 0x4E4F534A)), "no error");
    EXPECT_EQ(message_of(glb(1, 20 + size, size, 0x4E4F534A)), "binary glTF of version 1; version 2 is read");
    EXPECT_EQ(message_of(glb(2, 99, size, 0x4E4F534A)), "the file is cut off: it has 49 of 99 bytes");
    EXPECT_EQ(message_of(glb(2, 20 + size, 0xffffffff, 0x4E4F534A)),
              "chunk 0 of 4294967295 bytes reaches beyond the file's end");
    EXPECT_EQ(message_of(glb(2, 20 + size, size, 7)), "the first chunk, and no other, must be JSON");
    EXPECT_EQ(message_of("glTF"), "the file ends within its header");
    EXPECT_EQ(message_of(glb(2, 12, size, 0x4E4F534A)), "the file has no JSON chunk");
}

// Catches warnings that are not said, or said again for each primitive.
TEST(GltfErrors, WhatIsNotDrawnIsAWarning) {
    std::string warnings;
    std::string text =
        replaced(triangle_gltf(), "\"primitives\": [", "\"primitives\": [{\"mode\": 1, \"attributes\": {}}, ");
    text = replaced(text, "\"primitives\": [", "\"primitives\": [{\"mode\": 1, \"attributes\": {}}, ");
    text = replaced(text, "\"scene\": 0", "\"scene\": 0, \"extensionsUsed\": [\"KHR_xmp\"]");
    text = replaced(text, "\"pbrMetallicRoughness\"", "\"emissiveTexture\": {\"index\": 0}, \"pbrMetallicRoughness\"");
    text = replaced(text, "\"nodes\": [{",
                    "\"textures\": [{\"source\": 0}], \"images\": [{\"uri\": \"lost.png\"}],\n\"nodes\": [{");
    const scene::Scene scene = import_text(text, &warnings);
    EXPECT_EQ(scene.objects.size(), 1U);
    EXPECT_EQ(warnings,
              "extensionsUsed[0]: the extension 'KHR_xmp' is not read\n"
              "images[0]: missing picture 'lost.png'\n"
              "meshes[0].primitives[0]: lines are not drawn\n");
}

}  // namespace
}  // namespace sundog::import::gltf
