// The host's pipelines.
#pragma once

#include "host_vulkan/device.h"

#include <span>

namespace host_vulkan {

struct PipelineDesc {
    std::span<const std::uint32_t> vertex, fragment{};  ///< SPIR-V; without a fragment shader depth alone is drawn.
    VkPipelineLayout layout = VK_NULL_HANDLE;
    VkFormat color = VK_FORMAT_UNDEFINED, depth = VK_FORMAT_UNDEFINED;  ///< Of the attachments; undefined: none.
    std::uint32_t mesh_attributes = 0;  ///< Of terrain_mesh.h's vertices: position, normal, albedo.
    VkCompareOp compare = VK_COMPARE_OP_ALWAYS;
    bool write_depth = false;
    bool clamp_depth = false;                         ///< What lies before the near plane is drawn onto it.
    bool blend = false;                               ///< Over what is there, with premultiplied alpha.
    const VkSpecializationInfo* constants = nullptr;  ///< Of the fragment shader.
};

/// Triangles of any winding; viewport and scissor are dynamic.
[[nodiscard]] VkPipeline make_pipeline(const Device& device, const PipelineDesc& desc);

}  // namespace host_vulkan
