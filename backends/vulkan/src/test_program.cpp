#include "test_program.h"

#include <doctest/doctest.h>

namespace aureole::vulkan::test {

HostProgram::HostProgram(Host& host, std::span<const std::uint32_t> spirv, const std::vector<ProgramSet>& sets) : host_(host) {
    make_sets(sets);
    make_pipeline(spirv);
}

HostProgram::~HostProgram() {
    vkDestroyPipeline(host_.device(), pipeline_, nullptr);
    vkDestroyPipelineLayout(host_.device(), layout_, nullptr);
    vkDestroyDescriptorPool(host_.device(), pool_, nullptr);
    for (const VkDescriptorSetLayout layout : set_layouts_) vkDestroyDescriptorSetLayout(host_.device(), layout, nullptr);
}

void HostProgram::make_sets(const std::vector<ProgramSet>& sets) {
    std::vector<VkDescriptorPoolSize> sizes;
    for (const ProgramSet& set : sets) {
        std::vector<VkDescriptorSetLayoutBinding> bindings;
        for (const ProgramSlot& slot : set) {
            bindings.push_back({slot.slot, slot.type, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
            sizes.push_back({slot.type, 1});
        }
        VkDescriptorSetLayoutCreateInfo info = {};
        info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
        info.bindingCount = static_cast<std::uint32_t>(bindings.size());
        info.pBindings = bindings.data();
        REQUIRE(vkCreateDescriptorSetLayout(host_.device(), &info, nullptr, &set_layouts_.emplace_back()) == VK_SUCCESS);
    }
    VkDescriptorPoolCreateInfo pool = {};
    pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    pool.maxSets = static_cast<std::uint32_t>(sets.size());
    pool.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
    pool.pPoolSizes = sizes.data();
    REQUIRE(vkCreateDescriptorPool(host_.device(), &pool, nullptr, &pool_) == VK_SUCCESS);
    VkDescriptorSetAllocateInfo allocate = {};
    allocate.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    allocate.descriptorPool = pool_;
    allocate.descriptorSetCount = static_cast<std::uint32_t>(sets.size());
    allocate.pSetLayouts = set_layouts_.data();
    sets_.resize(sets.size());
    REQUIRE(vkAllocateDescriptorSets(host_.device(), &allocate, sets_.data()) == VK_SUCCESS);
    for (std::size_t i = 0; i < sets.size(); ++i) write(sets_[i], sets[i]);
}

void HostProgram::write(VkDescriptorSet set, const ProgramSet& slots) {
    for (const ProgramSlot& slot : slots) {
        VkWriteDescriptorSet info = {};
        info.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        info.dstSet = set;
        info.dstBinding = slot.slot;
        info.descriptorCount = 1;
        info.descriptorType = slot.type;
        info.pImageInfo = &slot.image;
        info.pBufferInfo = &slot.buffer;
        vkUpdateDescriptorSets(host_.device(), 1, &info, 0, nullptr);
    }
}

void HostProgram::make_pipeline(std::span<const std::uint32_t> spirv) {
    VkPipelineLayoutCreateInfo layout = {};
    layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    layout.setLayoutCount = static_cast<std::uint32_t>(set_layouts_.size());
    layout.pSetLayouts = set_layouts_.data();
    REQUIRE(vkCreatePipelineLayout(host_.device(), &layout, nullptr, &layout_) == VK_SUCCESS);

    VkShaderModuleCreateInfo code = {};
    code.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    code.codeSize = spirv.size_bytes();
    code.pCode = spirv.data();
    VkComputePipelineCreateInfo pipeline = {};
    pipeline.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    pipeline.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    pipeline.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    pipeline.stage.pName = "main";
    pipeline.layout = layout_;
    REQUIRE(vkCreateShaderModule(host_.device(), &code, nullptr, &pipeline.stage.module) == VK_SUCCESS);
    const VkResult made = vkCreateComputePipelines(host_.device(), VK_NULL_HANDLE, 1, &pipeline, nullptr, &pipeline_);
    vkDestroyShaderModule(host_.device(), pipeline.stage.module, nullptr);
    REQUIRE(made == VK_SUCCESS);
}

void HostProgram::record(std::uint32_t groups_x, std::uint32_t groups_y) {
    const VkCommandBuffer commands = host_.commands();
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, static_cast<std::uint32_t>(sets_.size()),
                            sets_.data(), 0, nullptr);
    vkCmdDispatch(commands, groups_x, groups_y, 1);
}

VkSampler make_sampler(Host& host, VkFilter filter) {
    VkSamplerCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    info.magFilter = info.minFilter = filter;
    info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    VkSampler sampler = VK_NULL_HANDLE;
    REQUIRE(vkCreateSampler(host.device(), &info, nullptr, &sampler) == VK_SUCCESS);
    return sampler;
}

}  // namespace aureole::vulkan::test
