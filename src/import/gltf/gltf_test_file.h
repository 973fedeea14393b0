// SPDX-License-Identifier: Apache-2.0
// Small glTF files for tests.
#pragma once

#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "base/test_folder.h"
#include "import/gltf/gltf_import.h"

namespace sundog::import::gltf {

inline std::string base64(const std::string& bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63U];
    }
    return text;
}

template <class T>
std::string bytes_of(const std::vector<T>& values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

inline std::string replaced(std::string text, std::string_view what, std::string_view by) {
    const std::size_t at = text.find(what);
    if (at == std::string::npos) throw std::logic_error("not in the file: " + std::string(what));
    return text.replace(at, what.size(), by);
}

/// One triangle, (0, 0, 0), (1, 0, 0), (0, 1, 0), of positions (36 bytes) and 16-bit indices (6 bytes).
inline std::string triangle_gltf() {
    const std::string data = bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + bytes_of<std::uint16_t>({0, 1, 2});
    return R"({
"asset": {"version": "2.0"},
"buffers": [{"byteLength": 42, "uri": "data:;base64,)" +
           base64(data) + R"("}],
"bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
              {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
"materials": [{"name": "red", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
"nodes": [{"mesh": 0}],
"scenes": [{"nodes": [0]}],
"scene": 0
})";
}

/// The scene of a file with this text, and all warnings in front of one another.
inline scene::Scene import_text(const std::string& text, std::string* warnings = nullptr) {
    const TestFolder folder;
    const std::filesystem::path file = folder.write("test.gltf", text);
    return import_gltf(file, [&](const Diagnostic& d) {
        if (warnings != nullptr) *warnings += d.message + '\n';
    });
}

}  // namespace sundog::import::gltf
