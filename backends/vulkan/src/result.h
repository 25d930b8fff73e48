// VkResult as aureole::Error.
#pragma once

#include "volk_private.h"

#include <aureole/rhi/error.h>

#include <string_view>

namespace aureole::vulkan {

/// Name of a result, e.g. "VK_ERROR_DEVICE_LOST"; "VkResult" for those that nobody expects.
[[nodiscard]] const char* to_string(VkResult result) noexcept;

/// Device loss, memory, missing things; everything else is `internal`.
[[nodiscard]] ErrorCode error_code(VkResult result) noexcept;

/// Throws Error("<what>: <call> returned <result>") for results below VK_SUCCESS.
void check_result(VkResult result, const char* call, std::string_view what);

}  // namespace aureole::vulkan
