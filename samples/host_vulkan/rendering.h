// Dynamic rendering with one colour, one depth attachment, or both.
#pragma once

#include "host_vulkan/vulkan.h"

namespace host_vulkan {

enum class Load { clear, keep, discard };

struct Attachment {
    VkImageView view = VK_NULL_HANDLE;  ///< Null: none.
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    Load load = Load::clear;
    float value = 0;  ///< To clear with: depth, or all channels.
};

/// All of the images, in this size. A depth that is kept is read alone.
void begin_rendering(VkCommandBuffer commands, VkExtent2D extent, const Attachment& color, const Attachment& depth);
/// Viewport and scissor. `y_up`: clip space as the camera's projection has it, row 0 where y is 1 (RowOrder::top_first).
void set_viewport(VkCommandBuffer commands, const VkRect2D& area, bool y_up);

}  // namespace host_vulkan
