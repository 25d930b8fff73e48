#include "pipeline.h"

#include "result.h"

#include <string>

namespace aureole::vulkan {
namespace {

#include "fullscreen_triangle.h"

/// Lives until the pipeline is made.
class ShaderModule {
public:
    ShaderModule(const Context& context, std::span<const std::uint32_t> spirv, const std::string& what) : context_(context) {
        VkShaderModuleCreateInfo info = {};
        info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
        info.codeSize = spirv.size_bytes();
        info.pCode = spirv.data();
        check_result(context_.fn.vkCreateShaderModule(context_.device, &info, nullptr, &module_), "vkCreateShaderModule", what);
    }
    ~ShaderModule() { context_.fn.vkDestroyShaderModule(context_.device, module_, nullptr); }
    ShaderModule(const ShaderModule&) = delete;
    ShaderModule& operator=(const ShaderModule&) = delete;
    [[nodiscard]] VkShaderModule get() const noexcept { return module_; }

private:
    const Context& context_;
    VkShaderModule module_ = VK_NULL_HANDLE;
};

/// Specialization values as Vulkan wants them: 32 bits each, one after the other.
class SpecializationInfo {
public:
    explicit SpecializationInfo(std::span<const rhi::Specialization> values) {
        for (const rhi::Specialization& value : values) {
            entries_.push_back({value.id, static_cast<std::uint32_t>(bits_.size() * sizeof(std::uint32_t)), sizeof value.bits});
            bits_.push_back(value.bits);
        }
        info_.mapEntryCount = static_cast<std::uint32_t>(entries_.size());
        info_.pMapEntries = entries_.data();
        info_.dataSize = bits_.size() * sizeof(std::uint32_t);
        info_.pData = bits_.data();
    }
    SpecializationInfo(const SpecializationInfo&) = delete;
    SpecializationInfo& operator=(const SpecializationInfo&) = delete;
    [[nodiscard]] const VkSpecializationInfo* get() const noexcept { return &info_; }

private:
    std::vector<VkSpecializationMapEntry> entries_;
    std::vector<std::uint32_t> bits_;
    VkSpecializationInfo info_ = {};
};

VkPipelineShaderStageCreateInfo stage_info(VkShaderStageFlagBits stage, const ShaderModule& module,
                                           const VkSpecializationInfo* specialization) {
    VkPipelineShaderStageCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage = stage;
    info.module = module.get();
    info.pName = "main";
    info.pSpecializationInfo = specialization;
    return info;
}

void check_spirv(const std::string& pipeline, const rhi::Shader& shader) {
    constexpr std::uint32_t magic = 0x07230203;
    if (shader.spirv.size() < 5 || shader.spirv[0] != magic)
        throw Error(ErrorCode::invalid_argument, rhi::field_name("pipeline", pipeline, "shader.spirv"),
                    std::to_string(shader.spirv.size()) + " words of " + std::string(shader.name), "a SPIR-V module");
}

void check_local_size(const Context& context, const std::string& pipeline, const rhi::Shader& shader) {
    const VkPhysicalDeviceLimits& limits = context.limits();
    std::uint64_t invocations = 1;
    bool fits = true;
    for (int i = 0; i < 3; ++i) {
        invocations *= shader.local_size[i];
        fits = fits && shader.local_size[i] >= 1 && shader.local_size[i] <= limits.maxComputeWorkGroupSize[i];
    }
    if (fits && invocations <= limits.maxComputeWorkGroupInvocations) return;
    const auto sizes = [](const std::uint32_t* s) {
        return std::to_string(s[0]) + "x" + std::to_string(s[1]) + "x" + std::to_string(s[2]);
    };
    throw Error(ErrorCode::unsupported, rhi::field_name("pipeline", pipeline, "shader.local_size"), sizes(shader.local_size),
                "at most " + sizes(limits.maxComputeWorkGroupSize) + " and " +
                    std::to_string(limits.maxComputeWorkGroupInvocations) + " in all");
}

void check_raster_slots(const rhi::RasterPipelineDesc& desc) {
    for (const rhi::SlotDesc& slot : desc.shader->slots)
        if (slot.kind == rhi::SlotKind::storage_texture)
            throw Error(ErrorCode::invalid_argument, rhi::field_name("pipeline", desc.name, "shader.slots"),
                        "storage texture " + std::string(slot.name), "sampled textures and constants in fragment shaders");
}

}  // namespace

PipelineObject::PipelineObject(Context& context, ShaderLayouts& layouts, const rhi::ComputePipelineDesc& desc)
    : context_(context), name_(desc.name), shader_(desc.shader), layout_(layouts.get(*desc.shader)) {
    const std::string what = rhi::field_name("pipeline", name_, "");
    check_spirv(name_, *shader_);
    check_local_size(context_, name_, *shader_);
    const ShaderModule module(context_, shader_->spirv, what);
    const SpecializationInfo specialization(desc.specialization);
    VkComputePipelineCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage = stage_info(VK_SHADER_STAGE_COMPUTE_BIT, module, specialization.get());
    info.layout = layout_.pipeline;
    check_result(context_.fn.vkCreateComputePipelines(context_.device, context_.pipeline_cache, 1, &info, nullptr, &pipeline_),
                 "vkCreateComputePipelines", what);
    context_.set_name(VK_OBJECT_TYPE_PIPELINE, pipeline_, name_);
}

PipelineObject::PipelineObject(Context& context, ShaderLayouts& layouts, RenderPasses& passes,
                               const rhi::RasterPipelineDesc& desc)
    : context_(context),
      name_(desc.name),
      shader_(desc.shader),
      layout_(layouts.get(*desc.shader)),
      target_format_(desc.target_format) {
    const std::string what = rhi::field_name("pipeline", name_, "");
    check_spirv(name_, *shader_);
    check_raster_slots(desc);
    render_pass_ = passes.get(target_format_);
    const ShaderModule vertex(context_, fullscreen_triangle_spirv, what), fragment(context_, shader_->spirv, what);
    const SpecializationInfo specialization(desc.specialization);
    const VkPipelineShaderStageCreateInfo stages[] = {stage_info(VK_SHADER_STAGE_VERTEX_BIT, vertex, nullptr),
                                                      stage_info(VK_SHADER_STAGE_FRAGMENT_BIT, fragment, specialization.get())};

    VkPipelineVertexInputStateCreateInfo vertices = {};
    vertices.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
    VkPipelineInputAssemblyStateCreateInfo assembly = {};
    assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkPipelineViewportStateCreateInfo viewport = {};
    viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
    viewport.viewportCount = 1;
    viewport.scissorCount = 1;
    VkPipelineRasterizationStateCreateInfo raster = {};
    raster.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
    raster.polygonMode = VK_POLYGON_MODE_FILL;
    raster.cullMode = VK_CULL_MODE_NONE;
    raster.lineWidth = 1.0f;
    VkPipelineMultisampleStateCreateInfo samples = {};
    samples.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
    samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    VkPipelineColorBlendAttachmentState overwrite = {};
    overwrite.colorWriteMask =
        VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
    VkPipelineColorBlendStateCreateInfo blend = {};
    blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    blend.attachmentCount = 1;
    blend.pAttachments = &overwrite;
    const VkDynamicState dynamic_states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    VkPipelineDynamicStateCreateInfo dynamic = {};
    dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
    dynamic.dynamicStateCount = 2;
    dynamic.pDynamicStates = dynamic_states;

    VkGraphicsPipelineCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
    info.stageCount = 2;
    info.pStages = stages;
    info.pVertexInputState = &vertices;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &samples;
    info.pColorBlendState = &blend;
    info.pDynamicState = &dynamic;
    info.layout = layout_.pipeline;
    info.renderPass = render_pass_;
    check_result(context_.fn.vkCreateGraphicsPipelines(context_.device, context_.pipeline_cache, 1, &info, nullptr, &pipeline_),
                 "vkCreateGraphicsPipelines", what);
    context_.set_name(VK_OBJECT_TYPE_PIPELINE, pipeline_, name_);
}

PipelineObject::~PipelineObject() { context_.fn.vkDestroyPipeline(context_.device, pipeline_, nullptr); }

}  // namespace aureole::vulkan
