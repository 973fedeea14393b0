// SPDX-License-Identifier: Apache-2.0
#include "device/vulkan/scene_buffers.h"

#include <algorithm>
#include <cstring>

#include "base/diagnostics.h"

namespace sundog::vulkan {
namespace {

template <class T>
std::span<const std::byte> bytes_of(const std::vector<T>& values) {
    return std::as_bytes(std::span(values));
}

/// "3.5 MiB"
std::string mebibytes(std::uint64_t bytes) {
    const std::uint64_t tenths = (bytes * 10 + (std::uint64_t{1} << 19U)) >> 20U;
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " MiB";
}

std::string too_large(const std::string& name, std::uint64_t bytes, const Adapter& adapter) {
    const std::uint64_t limit = std::min(adapter.max_storage_buffer_bytes, adapter.max_allocation_bytes);
    if (bytes <= limit) return {};
    return "the array '" + name + "' takes " + mebibytes(bytes) + ", this GPU's shaders read arrays of at most " +
           mebibytes(limit) + "; use the CPU";
}

}  // namespace

std::vector<std::string> arrays_too_large(const RenderScene& scene, const Adapter& adapter) {
    std::vector<std::string> sentences;
    const auto add = [&](const std::string& name, std::uint64_t bytes) {
        if (auto sentence = too_large(name, bytes, adapter); !sentence.empty())
            sentences.push_back(std::move(sentence));
    };
#define KERNEL_ARRAYS_SCENE_ONLY
#define KERNEL_ARRAY(type, name, binding) add(#name, scene.name.size() * sizeof(scene.name[0]));
#include "kernel/arrays.h"
#undef KERNEL_ARRAY
#undef KERNEL_ARRAYS_SCENE_ONLY
    std::uint64_t primitives = 0;
    for (const kernel::Geometry& geometry : scene.geometries) {
        if (geometry.kind != kernel::GEOMETRY_PLANE) primitives += geometry.primitive_count;
    }
    add("leaves of the hierarchy", primitives * sizeof(kernel::Leaf));
    return sentences;
}

std::vector<std::string> not_drawn_by_shaders(const RenderScene& scene, const Adapter& adapter) {
    constexpr std::size_t kMost = 5;
    std::vector<std::string> sentences;
    std::size_t more = 0;
    const auto add = [&](std::uint32_t geometry, const SourceLocation* where, const std::string& what) {
        if (sentences.size() >= kMost) {
            ++more;
            return;
        }
        const std::string name = geometry < scene.geometry_names.size() ? scene.geometry_names[geometry] : "";
        std::string place;
        if (where != nullptr && where->file) place = *where->file + ":" + std::to_string(where->line) + ": ";
        sentences.push_back(place + "object '" + name + "' " + what + "; use --device cpu");
    };
    for (const PlacedSolid& solid : scene.solids) {
        if (!adapter.computes_doubles)
            add(solid.geometry, &solid.where, "is an exact solid, and this GPU doesn't compute with doubles");
        else if (const std::string what = not_drawn_of(*solid.solid); !what.empty())
            add(solid.geometry, &solid.where, what);
    }
    const auto add_feature = [&](const SourceLocation& where, const std::string& what) {
        const std::string place = where.file ? *where.file + ":" + std::to_string(where.line) + ": " : "";
        sentences.push_back(place + what + "; use --device cpu");
    };
    if (scene.radiosity) add_feature(*scene.radiosity, "radiosity is what only the CPU computes");
    if (scene.photons) add_feature(*scene.photons, "photons are what only the CPU computes");
    if (!scene.camera_feature.empty())
        add_feature(scene.camera_where, "the camera has " + scene.camera_feature + ", which only the CPU draws");
    if (scene.first_host_field) add_feature(*scene.first_host_field, "a pattern or a warp that only the CPU draws");
    if (!scene.only_on_cpu.empty()) add_feature(scene.only_on_cpu.front().where, scene.only_on_cpu.front().sentence);
    if (more > 0) sentences.push_back("and " + std::to_string(more) + " more");
    return sentences;
}

SceneBuffers::SceneBuffers(Gpu& gpu, Pipelines& pipelines, const RenderScene& scene)
    : instances_move_((scene.features & kernel::FEATURE_INSTANCES) != 0),
      solids_(solid_slots(scene)),
      hierarchy_(build_hierarchy(scene, solids_)) {
    const auto upload = [&](std::uint32_t binding, std::span<const std::byte> content, const std::string& name) {
        if (const auto sentence = too_large(name, content.size(), gpu.adapter()); !sentence.empty()) {
            throw DeviceError(sentence);
        }
        Buffer buffer = make_storage(gpu, content, name);
        pipelines.bind(binding, buffer);
        return buffer;
    };
#define KERNEL_ARRAYS_SCENE_ONLY
#define KERNEL_ARRAY(type, name, binding) arrays_.push_back(upload(binding, bytes_of(scene.name), #name));
#include "kernel/arrays.h"
#undef KERNEL_ARRAY
#undef KERNEL_ARRAYS_SCENE_ONLY
    nodes_ = upload(kernel::BINDING_NODES, bytes_of(hierarchy_.nodes), "nodes of the hierarchy");
    leaves_ = upload(kernel::BINDING_LEAVES, bytes_of(hierarchy_.leaves), "leaves of the hierarchy");
    solid_slots_ = upload(kernel::BINDING_SOLIDS, bytes_of(solids_.slots), "exact solids");
    hierarchy_.nodes = {};
    hierarchy_.leaves = {};
    solids_.slots = {};
}

void SceneBuffers::write_or_grow(Gpu& gpu, Pipelines& pipelines, Buffer& buffer, std::uint32_t binding,
                                 std::span<const std::byte> content, VkBufferUsageFlags usage,
                                 const std::string& name) {
    if (!buffer.get() || buffer.bytes() < content.size()) {
        buffer = Buffer(gpu, content.size(), usage, Memory::upload, name);
        pipelines.bind(binding, buffer);
    }
    if (!content.empty()) std::memcpy(buffer.mapped().data(), content.data(), content.size());
}

std::uint32_t SceneBuffers::set_frame(Gpu& gpu, Pipelines& pipelines, const Frame& frame) {
    constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    std::uint32_t depth = hierarchy_.depth;
    std::vector<kernel::TopRef> top_refs;
    if (instances_move_) {
        TopLevel top = build_top_level(hierarchy_, frame);
        write(gpu, nodes_, bytes_of(top.nodes));
        top_refs = std::move(top.refs);
        // A level leaves one group waiting at most; where the top level meets hierarchies, one more.
        depth += top.depth + 1;
    }
    write_or_grow(gpu, pipelines, params_, kernel::BINDING_FRAME, std::as_bytes(std::span(&frame.params, 1)),
                  VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, "frame");
    write_or_grow(gpu, pipelines, lights_, kernel::BINDING_LIGHTS, bytes_of(frame.lights), storage, "lights");
    write_or_grow(gpu, pipelines, emitters_, kernel::BINDING_EMITTERS, bytes_of(frame.emitters), storage, "emitters");
    write_or_grow(gpu, pipelines, instances_, kernel::BINDING_INSTANCES, bytes_of(frame.instances), storage,
                  "instances");
    write_or_grow(gpu, pipelines, top_refs_, kernel::BINDING_TOP_REFS, bytes_of(top_refs), storage,
                  "references of the top level");
    // Few different sizes, so that few variants of the shader are compiled.
    return (std::max(depth, 1U) + 3) / 4 * 4;
}

std::size_t SceneBuffers::memory_bytes() const {
    std::size_t bytes = nodes_.bytes() + leaves_.bytes() + solid_slots_.bytes() + params_.bytes() + lights_.bytes() +
                        instances_.bytes() + emitters_.bytes() + top_refs_.bytes();
    for (const Buffer& buffer : arrays_) bytes += buffer.bytes();
    return bytes;
}

}  // namespace sundog::vulkan
