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
};

/// `graphics`: the queue has graphics stages. `depth`: the format is a depth format, whose read-only layout differs.
/// For State::undefined: nothing has been done yet.
[[nodiscard]] StateAccess access_of(rhi::State state, bool graphics, bool depth) noexcept;

/// Work of which nothing is known: everything before it is waited for.
[[nodiscard]] StateAccess unknown_access() noexcept;

/// The layout in which a texture stands in a sampled slot.
[[nodiscard]] VkImageLayout sampled_layout(bool depth) noexcept;

}  // namespace aureole::vulkan
