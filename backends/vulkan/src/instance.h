// A VkInstance of our own, with the validation layer if asked for.
#pragma once

#include "functions.h"
#include "messages.h"

#include <string_view>

namespace aureole::vulkan {

inline constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

/// The loader to use: `loader` if given, else the system's. Throws Error(unsupported) if there is none or it is too old.
[[nodiscard]] GlobalFunctions open_vulkan(PFN_vkGetInstanceProcAddr loader);

[[nodiscard]] bool has_layer(const GlobalFunctions& global, std::string_view name);

class Instance {
public:
    /// Messages of instance and validation layer go to `sink`, which outlives the instance.
    Instance(const GlobalFunctions& global, bool validation, const MessageSink& sink);
    ~Instance();
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    [[nodiscard]] VkInstance handle() const noexcept { return instance_; }
    [[nodiscard]] const InstanceFunctions& functions() const noexcept { return functions_; }
    [[nodiscard]] bool debug_utils() const noexcept { return debug_utils_; }

private:
    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    InstanceFunctions functions_;
    bool debug_utils_ = false;
};

}  // namespace aureole::vulkan
