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

/// A shader and its specialization constants, in the order of their ids: a variant contains only what it needs.
struct Variant {
    std::uint32_t shader = 0;                                           ///< Its number.
    std::uint32_t features = 0;                                         ///< FEATURE_*
    std::uint32_t aovs = 0;                                             ///< AOV_*
    std::uint32_t stack_size = 0;                                       ///< Entries of the traversal's stack.
    std::uint32_t integrator = 0;                                       ///< INTEGRATOR_*
    std::uint32_t solid_kinds = 0;                                      ///< SHAPE_* as bits.
    std::uint32_t solid_depth = 0;                                      ///< Entries of the stack of groups.
    std::uint32_t program_ops = ~0U;                                    ///< OP_* as bits.
    std::uint32_t program_fields = ~0U;                                 ///< FIELD_* as bits.
    friend auto operator<=>(const Variant&, const Variant&) = default;  // NOLINT(modernize-use-nullptr): its own zero
};

/// Compute shaders whose set 0 holds storage buffers 0 to binding_count - 2 and one uniform buffer after them.
class Pipelines {
public:
    /// Shaders are given as SPIR-V, which must outlive this and is loaded once it is used. Errors: DeviceError.
    Pipelines(const Gpu& gpu, std::initializer_list<std::span<const std::uint32_t>> shaders,
              std::uint32_t binding_count, std::uint32_t push_constant_bytes);

    /// Makes binding `binding` read `buffer`. Not while commands run.
    void bind(std::uint32_t binding, const Buffer& buffer);
    /// Makes the variant unless it exists. Errors: DeviceError.
    VkPipeline get(const Variant& variant);

    [[nodiscard]] VkPipelineLayout layout() const { return layout_.get(); }
    [[nodiscard]] VkDescriptorSet set() const { return set_; }

private:
    const Gpu& gpu_;
    std::uint32_t binding_count_;
    VkShaderModule shader(std::uint32_t number);

    std::vector<std::span<const std::uint32_t>> spirv_;
    std::vector<Owned<VkShaderModule>> shaders_;
    Owned<VkDescriptorSetLayout> set_layout_;
    Owned<VkPipelineLayout> layout_;
    Owned<VkDescriptorPool> pool_;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
    Owned<VkPipelineCache> cache_;
    std::map<Variant, Owned<VkPipeline>> variants_;
};

}  // namespace sundog::vulkan
