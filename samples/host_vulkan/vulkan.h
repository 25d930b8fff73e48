// Vulkan's functions, as volk loads them, and what becomes of their failures.
#pragma once

#include <volk.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace host_vulkan {

/// Throws std::runtime_error naming the function. Successes that are no failure (VK_SUBOPTIMAL_KHR) pass.
inline void check(VkResult result, const char* function) {
    if (result < 0) throw std::runtime_error(std::string(function) + " failed: VkResult " + std::to_string(result));
}

/// One of Vulkan's structures, empty but for its type.
template <class Info>
Info info_of(VkStructureType type) {
    Info info = {};
    info.sType = type;
    return info;
}

constexpr std::uint32_t api_version = VK_API_VERSION_1_3;  // for dynamic rendering and vkCmdPipelineBarrier2

}  // namespace host_vulkan
