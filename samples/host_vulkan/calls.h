// The host's way into Vulkan: what makes objects or memory is counted, whoever calls it, Aureole too.
#pragma once

#include "host_vulkan/vulkan.h"

namespace host_vulkan {

/// Loads volk through `counted_proc_addr`. Throws std::runtime_error where there is no Vulkan loader.
void open_vulkan();
/// Looks up functions as the loader does; those that make objects (vkCreate..., vkAllocate...) count themselves first.
[[nodiscard]] VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL counted_proc_addr(VkInstance instance, const char* name);
/// Objects and allocations of memory so far.
[[nodiscard]] std::uint64_t vulkan_objects_made() noexcept;

}  // namespace host_vulkan
