// SPDX-License-Identifier: Apache-2.0
#include "import/gltf/asset.h"

#include <algorithm>
#include <array>

#include "output/file.h"
#include "scene/files.h"

namespace sundog::import::gltf {
namespace {

/// What is read, or can be drawn in full without being read.
constexpr std::array<std::string_view, 19> kExtensions = {
    "EXT_mesh_gpu_instancing",
    "EXT_meshopt_compression",
    "KHR_draco_mesh_compression",
    "KHR_lights_punctual",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_dispersion",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_iridescence",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_variants",
    "KHR_materials_volume",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
};

bool is_known(std::string_view name) {
    return std::find(kExtensions.begin(), kExtensions.end(), name) != kExtensions.end();
}

}  // namespace

Asset::Asset(const std::filesystem::path& file, scene::Scene& scene, const WarningSink& warn)
    : Asset(file, read_container(file), scene, warn) {}

Asset::Asset(const std::filesystem::path& file, Container container, scene::Scene& scene, const WarningSink& warn)
    : file_(file),
      document_(std::move(container.json)),
      binary_(std::move(container.binary)),
      has_binary_(container.has_binary),
      scene_(scene),
      warn_(warn),
      memory_left_(physical_memory_bytes() / 2) {
    scene::add_file(scene_, file_);
    if (!root().is_object()) root().fail("expected an object");
    check_version();
    check_extensions();
}

void Asset::check_version() const {
    const Json asset = root().required("asset");
    const Json version = asset.required("version");
    if (!version.string().starts_with("2."))
        version.fail("glTF of version " + in_quotes(version.string()), "version 2.0 is read");
    const Json least = asset.member("minVersion");
    if (least && least.string() != "2.0")
        least.fail("the file needs glTF " + in_quotes(least.string()), "version 2.0 is read");
}

void Asset::check_extensions() {
    const Json required = list("extensionsRequired");
    for (std::size_t i = 0; i < required.size(); ++i) {
        if (is_known(required[i].string())) continue;
        required[i].fail("the file can't be shown without the extension " + in_quotes(required[i].string()) +
                         ", which is not read");
    }
    const Json used = list("extensionsUsed");
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (is_known(used[i].string())) continue;
        warn_once(std::string(used[i].string()), used[i],
                  "the extension " + in_quotes(used[i].string()) + " is not read");
    }
}

void Asset::take_memory(std::size_t bytes, const Json& at) {
    if (bytes > memory_left_) at.fail("the scene would take more than half of this machine's memory");
    memory_left_ -= bytes;
}

Bytes Asset::buffer(std::size_t index) {
    const Json json = list("buffers")[index];
    const Json length = json.required("byteLength");
    const std::size_t size = length.whole();
    const auto enough = [&](Bytes bytes) {
        if (bytes.size() < size)
            length.fail("the buffer should have " + std::to_string(size) + " bytes, but has " +
                        std::to_string(bytes.size()));
        return bytes.first(size);
    };
    const Json uri = json.member("uri");
    if (!uri) {
        if (index != 0 || !has_binary_) json.fail("the buffer has no 'uri', and the file no binary chunk for it");
        return enough(binary_);
    }
    const auto known = buffers_.find(index);
    if (known != buffers_.end()) return enough(known->second);
    std::optional<std::vector<unsigned char>> bytes = decode_data_uri(uri);
    if (!bytes) {
        const std::filesystem::path file = file_of_uri(file_, uri.string());
        if (file.empty()) uri.fail("missing buffer " + in_quotes(uri.string()));
        try {
            bytes = output::read_file(file);
        } catch (const InputError& error) {
            uri.fail("unreadable buffer " + in_quotes(uri.string()) + " (" + error.diagnostic().message + ')');
        }
        scene::add_file(scene_, file);
    }
    return enough(buffers_.emplace(index, std::move(*bytes)).first->second);
}

Bytes Asset::slice(const Json& view, const Json& from) {
    const std::size_t index = from.required_index("buffer", list("buffers").size(), "buffers");
    const std::size_t offset = from.whole_or("byteOffset", 0);
    const std::size_t size = from.required("byteLength").whole();
    const Bytes bytes = buffer(index);
    if (offset > bytes.size() || size > bytes.size() - offset)
        view.fail("bytes " + std::to_string(offset) + " to " + std::to_string(offset + size) + " of buffers[" +
                  std::to_string(index) + "], which has " + std::to_string(bytes.size()));
    return bytes.subspan(offset, size);
}

Bytes Asset::view(std::size_t index) {
    const Json json = list("bufferViews")[index];
    const Json compression = json.extension("EXT_meshopt_compression");
    if (!compression) return slice(json, json);
    const auto known = decompressed_.find(index);
    if (known != decompressed_.end()) return known->second;
    std::vector<unsigned char> bytes = decompress_meshopt(compression, slice(compression, compression), *this);
    return decompressed_.emplace(index, std::move(bytes)).first->second;
}

}  // namespace sundog::import::gltf
