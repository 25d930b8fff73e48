#include "host_vulkan/pipelines.h"

#include "host_vulkan/terrain_mesh.h"

#include <array>
#include <cstddef>

namespace host_vulkan {
namespace {

VkShaderModule make_module(const Device& device, std::span<const std::uint32_t> words) {
    auto info = info_of<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
    info.codeSize = words.size_bytes();
    info.pCode = words.data();
    VkShaderModule made = VK_NULL_HANDLE;
    check(vkCreateShaderModule(device.handle, &info, nullptr, &made), "vkCreateShaderModule");
    return made;
}

VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits which, VkShaderModule shader,
                                      const VkSpecializationInfo* constants) {
    auto info = info_of<VkPipelineShaderStageCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO);
    info.stage = which;
    info.module = shader;
    info.pName = "main";
    info.pSpecializationInfo = constants;
    return info;
}

constexpr VkVertexInputBindingDescription vertices = {0, sizeof(Vertex), VK_VERTEX_INPUT_RATE_VERTEX};
constexpr VkVertexInputAttributeDescription attributes[] = {
    {0, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, position)},
    {1, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, normal)},
    {2, 0, VK_FORMAT_R32G32B32A32_SFLOAT, offsetof(Vertex, albedo)},
};

VkPipelineVertexInputStateCreateInfo vertex_input(std::uint32_t mesh_attributes) {
    auto info = info_of<VkPipelineVertexInputStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO);
    if (mesh_attributes == 0) return info;
    info.vertexBindingDescriptionCount = 1;
    info.pVertexBindingDescriptions = &vertices;
    info.vertexAttributeDescriptionCount = mesh_attributes;
    info.pVertexAttributeDescriptions = attributes;
    return info;
}

VkPipelineColorBlendAttachmentState blending(bool blend) {
    VkPipelineColorBlendAttachmentState state = {};
    state.colorWriteMask =
        VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
    state.blendEnable = blend;
    state.srcColorBlendFactor = state.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
    state.dstColorBlendFactor = state.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
    return state;
}

}  // namespace

VkPipeline make_pipeline(const Device& device, const PipelineDesc& desc) {
    const VkShaderModule vertex = make_module(device, desc.vertex);
    const VkShaderModule fragment = desc.fragment.empty() ? VK_NULL_HANDLE : make_module(device, desc.fragment);
    std::array<VkPipelineShaderStageCreateInfo, 2> stages = {stage(VK_SHADER_STAGE_VERTEX_BIT, vertex, nullptr)};
    if (fragment) stages[1] = stage(VK_SHADER_STAGE_FRAGMENT_BIT, fragment, desc.constants);
    const VkPipelineVertexInputStateCreateInfo input = vertex_input(desc.mesh_attributes);
    auto triangles =
        info_of<VkPipelineInputAssemblyStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO);
    triangles.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    auto viewport = info_of<VkPipelineViewportStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO);
    viewport.viewportCount = viewport.scissorCount = 1;
    auto raster = info_of<VkPipelineRasterizationStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO);
    raster.depthClampEnable = desc.clamp_depth;
    raster.lineWidth = 1;
    auto samples = info_of<VkPipelineMultisampleStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO);
    samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    auto depth = info_of<VkPipelineDepthStencilStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO);
    depth.depthTestEnable = desc.depth != VK_FORMAT_UNDEFINED;
    depth.depthWriteEnable = desc.write_depth;
    depth.depthCompareOp = desc.compare;
    const VkPipelineColorBlendAttachmentState attachment = blending(desc.blend);
    const std::uint32_t colors = desc.color != VK_FORMAT_UNDEFINED ? 1 : 0;
    auto blend = info_of<VkPipelineColorBlendStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO);
    blend.attachmentCount = colors;
    blend.pAttachments = &attachment;
    constexpr VkDynamicState dynamic_states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    auto dynamic = info_of<VkPipelineDynamicStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO);
    dynamic.dynamicStateCount = 2;
    dynamic.pDynamicStates = dynamic_states;
    auto rendering = info_of<VkPipelineRenderingCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO);
    rendering.colorAttachmentCount = colors;
    rendering.pColorAttachmentFormats = &desc.color;
    rendering.depthAttachmentFormat = desc.depth;

    auto info = info_of<VkGraphicsPipelineCreateInfo>(VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO);
    info.pNext = &rendering;
    info.stageCount = fragment ? 2 : 1;
    info.pStages = stages.data();
    info.pVertexInputState = &input;
    info.pInputAssemblyState = &triangles;
    info.pViewportState = &viewport;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &samples;
    info.pDepthStencilState = &depth;
    info.pColorBlendState = &blend;
    info.pDynamicState = &dynamic;
    info.layout = desc.layout;
    VkPipeline made = VK_NULL_HANDLE;
    const VkResult result = vkCreateGraphicsPipelines(device.handle, VK_NULL_HANDLE, 1, &info, nullptr, &made);
    vkDestroyShaderModule(device.handle, vertex, nullptr);
    vkDestroyShaderModule(device.handle, fragment, nullptr);
    check(result, "vkCreateGraphicsPipelines");
    return made;
}

}  // namespace host_vulkan
