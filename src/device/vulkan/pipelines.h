// SPDX-License-Identifier: Apache-2.0
// The compute pipeline in the variants that scenes need, and the descriptors that it reads.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <span>

#include "device/vulkan/buffer.h"
#include "device/vulkan/gpu.h"

namespace sundog::vulkan {

/// The shader's specialization constants, in the order of their ids: a variant contains only what it needs.
struct Variant {
    std::uint32_t features = 0;                                         ///< FEATURE_*
    std::uint32_t aovs = 0;                                             ///< AOV_*
    std::uint32_t stack_size = 0;                                       ///< Entries of the traversal's stack.
    friend auto operator<=>(const Variant&, const Variant&) = default;  // NOLINT(modernize-use-nullptr): its own zero
};

/// A compute shader whose set 0 holds storage buffers 0 to binding_count - 2 and one uniform buffer after them.
class Pipelines {
public:
    Pipelines(const Gpu& gpu, std::span<const std::uint32_t> spirv, std::uint32_t binding_count,
              std::uint32_t push_constant_bytes);

    /// Makes binding `binding` read `buffer`. Not while commands run.
    void bind(std::uint32_t binding, const Buffer& buffer);
    /// Makes the variant unless it exists. Errors: DeviceError.
    VkPipeline get(const Variant& variant);

    [[nodiscard]] VkPipelineLayout layout() const { return layout_.get(); }
    [[nodiscard]] VkDescriptorSet set() const { return set_; }

private:
    const Gpu& gpu_;
    std::uint32_t binding_count_;
    Owned<VkShaderModule> shader_;
    Owned<VkDescriptorSetLayout> set_layout_;
    Owned<VkPipelineLayout> layout_;
    Owned<VkDescriptorPool> pool_;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
    Owned<VkPipelineCache> cache_;
    std::map<Variant, Owned<VkPipeline>> variants_;
};

}  // namespace sundog::vulkan
