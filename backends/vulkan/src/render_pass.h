// The render passes of draw_fullscreen.
#pragma once

#include "context.h"

#include <aureole/rhi/types.h>

#include <utility>
#include <vector>

namespace aureole::vulkan {

/// One render pass for each target format: everything is overwritten and kept. Made on first use, kept with the device.
class RenderPasses {
public:
    explicit RenderPasses(const Context& context) : context_(context) {}
    ~RenderPasses();
    RenderPasses(const RenderPasses&) = delete;
    RenderPasses& operator=(const RenderPasses&) = delete;
    [[nodiscard]] VkRenderPass get(rhi::Format format);

private:
    const Context& context_;
    std::vector<std::pair<rhi::Format, VkRenderPass>> passes_;
};

}  // namespace aureole::vulkan
