// Compute and full-screen raster pipelines, and the layouts that they share with binding sets.
#pragma once

#include "context.h"
#include "render_pass.h"

#include <aureole/rhi/checks.h>
#include <aureole/rhi/device.h>

#include <memory>
#include <vector>

namespace aureole::vulkan {

/// How resources reach a shader. Shaders with equal interfaces share one, so a binding set fits every pipeline of its shader.
struct ShaderLayout {
    VkDescriptorSetLayout set = VK_NULL_HANDLE;
    VkPipelineLayout pipeline = VK_NULL_HANDLE;
    rhi::Stage stage = rhi::Stage::compute;
    std::uint32_t push_constant_bytes = 0;
    std::vector<std::pair<std::uint32_t, rhi::SlotKind>> slots;
};

[[nodiscard]] VkDescriptorType descriptor_type(rhi::SlotKind kind) noexcept;
[[nodiscard]] VkShaderStageFlags stage_flags(rhi::Stage stage) noexcept;

/// Layouts made so far; kept with the device.
class ShaderLayouts {
public:
    explicit ShaderLayouts(const Context& context) : context_(context) {}
    ~ShaderLayouts();
    ShaderLayouts(const ShaderLayouts&) = delete;
    ShaderLayouts& operator=(const ShaderLayouts&) = delete;
    /// Throws Error: unsupported for more slots than the device allows.
    [[nodiscard]] const ShaderLayout& get(const rhi::Shader& shader);

private:
    void check_limits(const rhi::Shader& shader) const;
    void create(ShaderLayout& layout) const;

    const Context& context_;
    std::vector<std::unique_ptr<ShaderLayout>> layouts_;
};

class PipelineObject {
public:
    /// `desc` has passed rhi::check. Throw Error and leave nothing behind.
    PipelineObject(Context& context, ShaderLayouts& layouts, const rhi::ComputePipelineDesc& desc);
    PipelineObject(Context& context, ShaderLayouts& layouts, RenderPasses& passes, const rhi::RasterPipelineDesc& desc);
    ~PipelineObject();
    PipelineObject(const PipelineObject&) = delete;
    PipelineObject& operator=(const PipelineObject&) = delete;

    [[nodiscard]] rhi::PipelineFacts facts() const noexcept { return {name_, shader_, target_format_}; }
    [[nodiscard]] const rhi::Shader& shader() const noexcept { return *shader_; }
    [[nodiscard]] const ShaderLayout& layout() const noexcept { return layout_; }
    [[nodiscard]] VkPipeline pipeline() const noexcept { return pipeline_; }
    [[nodiscard]] VkRenderPass render_pass() const noexcept { return render_pass_; }  ///< Null for compute.

private:
    Context& context_;
    std::string name_;
    const rhi::Shader* shader_;  ///< Lives as long as the program.
    const ShaderLayout& layout_;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
    VkRenderPass render_pass_ = VK_NULL_HANDLE;
    rhi::Format target_format_ = rhi::Format::undefined;
};

}  // namespace aureole::vulkan
