#include "pipeline.h"

namespace aureole::cpu {
namespace {

rhi::CpuRun entry(const std::string& name, const rhi::Shader& shader, Precision precision) {
    const rhi::CpuRun run = precision == Precision::float32 ? shader.cpu.run_float : shader.cpu.run_double;
    if (!run)
        throw Error(ErrorCode::unsupported, rhi::field_name("pipeline", name, "shader"), shader.name,
                    std::string("shaders with a CPU kernel in ") + (precision == Precision::float32 ? "float" : "double"));
    return run;
}

}  // namespace

PipelineObject::PipelineObject(const rhi::ComputePipelineDesc& desc, Precision precision)
    : name_(desc.name),
      shader_(desc.shader),
      run_(entry(desc.name, *desc.shader, precision)),
      specialization_(desc.specialization.begin(), desc.specialization.end()) {}

PipelineObject::PipelineObject(const rhi::RasterPipelineDesc& desc, Precision precision)
    : name_(desc.name),
      shader_(desc.shader),
      run_(entry(desc.name, *desc.shader, precision)),
      specialization_(desc.specialization.begin(), desc.specialization.end()),
      target_format_(desc.target_format) {}

}  // namespace aureole::cpu
