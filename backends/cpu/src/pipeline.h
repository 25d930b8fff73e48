// A compute or raster pipeline on the CPU: the kernel's entry in the device's precision and its specialization.
#pragma once

#include <aureole/cpu/cpu_device.h>
#include <aureole/rhi/checks.h>
#include <aureole/rhi/shader.h>

#include <string>
#include <vector>

namespace aureole::cpu {

class PipelineObject {
public:
    /// Throws Error(unsupported) if the shader has no kernel for this precision.
    PipelineObject(const rhi::ComputePipelineDesc& desc, Precision precision);
    PipelineObject(const rhi::RasterPipelineDesc& desc, Precision precision);

    [[nodiscard]] const std::string& name() const noexcept { return name_; }
    [[nodiscard]] const rhi::Shader& shader() const noexcept { return *shader_; }
    [[nodiscard]] rhi::CpuRun run() const noexcept { return run_; }
    [[nodiscard]] std::span<const rhi::Specialization> specialization() const noexcept { return specialization_; }
    [[nodiscard]] rhi::PipelineFacts facts() const noexcept { return {name_, shader_, target_format_}; }

    PipelineWork* work = nullptr;  ///< Where its work is counted; null if it is not.

private:
    std::string name_;
    const rhi::Shader* shader_;
    rhi::CpuRun run_;
    std::vector<rhi::Specialization> specialization_;
    rhi::Format target_format_ = rhi::Format::undefined;
};

}  // namespace aureole::cpu
