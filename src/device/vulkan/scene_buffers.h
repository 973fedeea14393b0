// SPDX-License-Identifier: Apache-2.0
// A scene in GPU memory: its arrays and its hierarchies.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "device/render_scene.h"
#include "device/vulkan/buffer.h"
#include "device/vulkan/hierarchy.h"
#include "device/vulkan/pipelines.h"

namespace sundog::vulkan {

/// One sentence for each array of the scene that is larger than the adapter's shaders can read.
std::vector<std::string> arrays_too_large(const RenderScene& scene, const Adapter& adapter);

/// One sentence for each thing that the shaders can't draw (at most a few, then how many more there are): some exact
/// solids, and what only the CPU computes.
std::vector<std::string> not_drawn_by_shaders(const RenderScene& scene, const Adapter& adapter);

/// The loaded scene. What a frame brings (lights, placements, the top level) is kept here too.
class SceneBuffers {
public:
    /// Uploads everything and binds it. Errors: DeviceError.
    SceneBuffers(Gpu& gpu, Pipelines& pipelines, const RenderScene& scene);

    /// Uploads and binds what the frame brings. Returns the stack that its traversal needs, in entries.
    std::uint32_t set_frame(Gpu& gpu, Pipelines& pipelines, const Frame& frame);

    /// Which kinds of shapes the scene's solids consist of (SHAPE_*, as bits), and how deep their groups lie in each
    /// other.
    [[nodiscard]] std::uint32_t solid_kinds() const { return solids_.kinds; }
    [[nodiscard]] std::uint32_t solid_depth() const { return solids_.depth; }
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    void write_or_grow(Gpu& gpu, Pipelines& pipelines, Buffer& buffer, std::uint32_t binding,
                       std::span<const std::byte> content, VkBufferUsageFlags usage, const std::string& name);

    bool instances_move_;
    SolidSlots solids_;    // once all is uploaded, without its slots
    Hierarchy hierarchy_;  // of it, only what the top level needs stays once all is uploaded
    std::vector<Buffer> arrays_;
    Buffer nodes_, leaves_, solid_slots_;
    Buffer params_, lights_, emitters_, instances_, top_refs_;
};

}  // namespace sundog::vulkan
