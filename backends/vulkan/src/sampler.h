// Samplers: no mip levels, no comparison, no anisotropy.
#pragma once

#include "context.h"

#include <aureole/rhi/types.h>

namespace aureole::vulkan {

class SamplerObject {
public:
    /// `desc` has passed rhi::check. Throws Error.
    SamplerObject(Context& context, const rhi::SamplerDesc& desc);
    ~SamplerObject();
    SamplerObject(const SamplerObject&) = delete;
    SamplerObject& operator=(const SamplerObject&) = delete;

    [[nodiscard]] const rhi::SamplerDesc& desc() const noexcept { return desc_; }
    [[nodiscard]] VkSampler sampler() const noexcept { return sampler_; }

private:
    Context& context_;
    rhi::SamplerDesc desc_;
    VkSampler sampler_ = VK_NULL_HANDLE;
};

}  // namespace aureole::vulkan
