// rhi::State as pipeline stages, accesses and image layouts.
#pragma once

#include "volk_private.h"

#include <aureole/rhi/types.h>

namespace aureole::vulkan {

/// What work in a state does to a resource.
struct StateAccess {
    VkPipelineStageFlags stages = VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT;
    VkAccessFlags reads = 0, writes = 0;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    [[nodiscard]] bool operator==(const StateAccess&) const noexcept = default;
};

/// `graphics`: the queue has graphics stages. `read_layout`: the layout in which shaders read the texture, whether its state
/// is called sampled or depth_read; it stands in descriptors too. For State::undefined: nothing has been done yet.
[[nodiscard]] StateAccess access_of(rhi::State state, bool graphics,
                                    VkImageLayout read_layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL) noexcept;

/// Work of which nothing is known: everything before it is waited for.
[[nodiscard]] StateAccess unknown_access() noexcept;

}  // namespace aureole::vulkan
