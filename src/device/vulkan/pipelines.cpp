// SPDX-License-Identifier: Apache-2.0
#include "device/vulkan/pipelines.h"

#include <array>
#include <cstddef>
#include <vector>

namespace sundog::vulkan {
namespace {

VkDescriptorType type_of(std::uint32_t binding, std::uint32_t binding_count) {
    return binding + 1 == binding_count ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
}

}  // namespace

Pipelines::Pipelines(const Gpu& gpu, std::initializer_list<std::span<const std::uint32_t>> shaders,
                     std::uint32_t binding_count, std::uint32_t push_constant_bytes)
    : gpu_(gpu), binding_count_(binding_count), spirv_(shaders), shaders_(shaders.size()) {
    const DeviceFunctions& f = gpu.functions();
    std::vector<VkDescriptorSetLayoutBinding> bindings(binding_count);
    for (std::uint32_t i = 0; i < binding_count; ++i) {
        bindings[i].binding = i;
        bindings[i].descriptorType = type_of(i, binding_count);
        bindings[i].descriptorCount = 1;
        bindings[i].stageFlags = VK_SHADER_STAGE_COMPUTE_BIT;
    }
    VkDescriptorSetLayoutCreateInfo set_layout{};
    set_layout.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    set_layout.bindingCount = binding_count;
    set_layout.pBindings = bindings.data();
    VkDescriptorSetLayout set_layout_handle = VK_NULL_HANDLE;
    check(f.vkCreateDescriptorSetLayout(gpu.device(), &set_layout, nullptr, &set_layout_handle),
          "describing the shader's buffers");
    set_layout_ = gpu.own(set_layout_handle, f.vkDestroyDescriptorSetLayout);

    const VkPushConstantRange push{VK_SHADER_STAGE_COMPUTE_BIT, 0, push_constant_bytes};
    VkPipelineLayoutCreateInfo layout{};
    layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    layout.setLayoutCount = 1;
    layout.pSetLayouts = &set_layout_handle;
    layout.pushConstantRangeCount = 1;
    layout.pPushConstantRanges = &push;
    VkPipelineLayout layout_handle = VK_NULL_HANDLE;
    check(f.vkCreatePipelineLayout(gpu.device(), &layout, nullptr, &layout_handle), "describing the shader's inputs");
    layout_ = gpu.own(layout_handle, f.vkDestroyPipelineLayout);

    const std::array sizes{VkDescriptorPoolSize{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, binding_count - 1},
                           VkDescriptorPoolSize{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1}};
    VkDescriptorPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    pool.maxSets = 1;
    pool.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
    pool.pPoolSizes = sizes.data();
    VkDescriptorPool pool_handle = VK_NULL_HANDLE;
    check(f.vkCreateDescriptorPool(gpu.device(), &pool, nullptr, &pool_handle), "making a descriptor pool");
    pool_ = gpu.own(pool_handle, f.vkDestroyDescriptorPool);
    VkDescriptorSetAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    allocate.descriptorPool = pool_handle;
    allocate.descriptorSetCount = 1;
    allocate.pSetLayouts = &set_layout_handle;
    check(f.vkAllocateDescriptorSets(gpu.device(), &allocate, &set_), "making a descriptor set");

    VkPipelineCacheCreateInfo cache{};
    cache.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
    VkPipelineCache cache_handle = VK_NULL_HANDLE;
    check(f.vkCreatePipelineCache(gpu.device(), &cache, nullptr, &cache_handle), "making a pipeline cache");
    cache_ = gpu.own(cache_handle, f.vkDestroyPipelineCache);
}

VkShaderModule Pipelines::shader(std::uint32_t number) {
    Owned<VkShaderModule>& loaded = shaders_.at(number);
    if (!loaded) {
        const DeviceFunctions& f = gpu_.functions();
        VkShaderModuleCreateInfo module{};
        module.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
        module.codeSize = spirv_[number].size_bytes();
        module.pCode = spirv_[number].data();
        VkShaderModule handle = VK_NULL_HANDLE;
        check(f.vkCreateShaderModule(gpu_.device(), &module, nullptr, &handle), "loading the shader");
        loaded = gpu_.own(handle, f.vkDestroyShaderModule);
    }
    return loaded.get();
}

void Pipelines::bind(std::uint32_t binding, const Buffer& buffer) {
    const VkDescriptorBufferInfo info{buffer.get(), 0, VK_WHOLE_SIZE};
    VkWriteDescriptorSet write{};
    write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    write.dstSet = set_;
    write.dstBinding = binding;
    write.descriptorCount = 1;
    write.descriptorType = type_of(binding, binding_count_);
    write.pBufferInfo = &info;
    gpu_.functions().vkUpdateDescriptorSets(gpu_.device(), 1, &write, 0, nullptr);
}

VkPipeline Pipelines::get(const Variant& variant) {
    if (const auto found = variants_.find(variant); found != variants_.end()) return found->second.get();
    constexpr std::uint32_t word = sizeof(std::uint32_t);
    const std::array entries{VkSpecializationMapEntry{0, offsetof(Variant, features), word},
                             VkSpecializationMapEntry{1, offsetof(Variant, aovs), word},
                             VkSpecializationMapEntry{2, offsetof(Variant, stack_size), word},
                             VkSpecializationMapEntry{3, offsetof(Variant, integrator), word},
                             VkSpecializationMapEntry{4, offsetof(Variant, solid_kinds), word},
                             VkSpecializationMapEntry{5, offsetof(Variant, solid_depth), word},
                             VkSpecializationMapEntry{6, offsetof(Variant, program_ops), word},
                             VkSpecializationMapEntry{7, offsetof(Variant, program_fields), word}};
    const VkSpecializationInfo specialization{static_cast<std::uint32_t>(entries.size()), entries.data(),
                                              sizeof(Variant), &variant};
    VkComputePipelineCreateInfo create{};
    create.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    create.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    create.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    create.stage.module = shader(variant.shader);
    create.stage.pName = "main";
    create.stage.pSpecializationInfo = &specialization;
    create.layout = layout_.get();
    VkPipeline pipeline = VK_NULL_HANDLE;
    const DeviceFunctions& f = gpu_.functions();
    check(f.vkCreateComputePipelines(gpu_.device(), cache_.get(), 1, &create, nullptr, &pipeline),
          "compiling the shader");
    return variants_.emplace(variant, gpu_.own(pipeline, f.vkDestroyPipeline)).first->second.get();
}

}  // namespace sundog::vulkan
