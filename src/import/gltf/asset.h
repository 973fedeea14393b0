// SPDX-License-Identifier: Apache-2.0
// A glTF file (Khronos Group 2021, "glTF 2.0 Specification") with what it names: JSON, buffers, warnings.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "import/gltf/json.h"
#include "scene/scene.h"

namespace sundog::import::gltf {

using Bytes = std::span<const unsigned char>;

/// A text or binary file in its two parts.
struct Container {
    SourceText json;
    std::vector<unsigned char> binary;  ///< A .glb file's BIN chunk.
    bool has_binary = false;
};

/// Reads a .gltf or .glb file; which of them is told by its content. Errors: InputError.
Container read_container(const std::filesystem::path& file);

/// The bytes of a `data:` URI, or nothing if it is none. Errors: InputError at `uri`.
std::optional<std::vector<unsigned char>> decode_data_uri(const Json& uri);

/// The file that a relative URI names ("%20" resolved); empty if there is none.
std::filesystem::path file_of_uri(const std::filesystem::path& named_in, std::string_view uri);

/// One file while it is imported.
class Asset {
public:
    /// Errors: InputError for what is no glTF 2.0, or requires an extension that isn't read here.
    Asset(const std::filesystem::path& file, scene::Scene& scene, const WarningSink& warn);

    [[nodiscard]] Json root() const { return document_.root(); }
    /// An array of the root; nothing where the file has none.
    [[nodiscard]] Json list(const char* name) const { return root().member(name); }
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    [[nodiscard]] const std::shared_ptr<const std::string>& name() const { return document_.source().name; }
    [[nodiscard]] scene::Scene& scene() const { return scene_; }

    void warn(const Diagnostic& diagnostic) const {
        if (warn_) warn_(diagnostic);
    }
    /// Warns of a value, once for each key, and of a hundred at most: finding a value's place takes as long as the
    /// file.
    void warn_once(const std::string& key, const Json& at, const std::string& message, std::string hint = {}) {
        constexpr std::size_t kMost = 100;
        if (said_.size() < kMost && said_.insert(key).second) warn(at.warning(message, std::move(hint)));
    }

    /// The bytes of a buffer, as many as it says, read when first asked for.
    Bytes buffer(std::size_t index);
    /// The bytes of a buffer view, decompressed where it is (EXT_meshopt_compression).
    Bytes view(std::size_t index);

    /// Counts what the scene takes. Errors: InputError at `at` where that goes beyond half of the machine's memory.
    void take_memory(std::size_t bytes, const Json& at);

private:
    Asset(const std::filesystem::path& file, Container container, scene::Scene& scene, const WarningSink& warn);
    void check_version() const;
    void check_extensions();
    Bytes slice(const Json& view, const Json& from);

    std::filesystem::path file_;
    JsonDocument document_;
    std::vector<unsigned char> binary_;
    bool has_binary_;
    scene::Scene& scene_;
    const WarningSink& warn_;
    std::unordered_set<std::string> said_;
    std::unordered_map<std::size_t, std::vector<unsigned char>> buffers_;
    std::unordered_map<std::size_t, std::vector<unsigned char>> decompressed_;
    std::size_t memory_left_;
};

/// The bytes that EXT_meshopt_compression's object (of a buffer view) says. Errors: InputError.
std::vector<unsigned char> decompress_meshopt(const Json& compression, Bytes compressed, Asset& asset);

}  // namespace sundog::import::gltf
