#include "test_support.h"

#include <doctest/doctest.h>
#include <vulkan/vulkan.h>

#include <algorithm>

namespace aureole::vulkan::test {
namespace {

VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    static_cast<Messages*>(user)->texts.emplace_back(data->pMessage);
    return VK_FALSE;
}

template <class Function>
Function function_of(VkInstance instance, const char* name) {
    return reinterpret_cast<Function>(vkGetInstanceProcAddr(instance, name));
}

}  // namespace

void Messages::collect(void* messages, rhi::Severity severity, const char* text) {
    if (severity != rhi::Severity::info) static_cast<Messages*>(messages)->texts.emplace_back(text);
}

bool Messages::mention(const std::string& part) const {
    return std::any_of(texts.begin(), texts.end(), [&](const auto& text) { return text.find(part) != std::string::npos; });
}

std::string Messages::joined() const {
    std::string all;
    for (const std::string& text : texts) all += text + "\n";
    return all;
}

Messenger::Messenger(VkInstance instance, Messages& messages) : instance_(instance) {
    VkDebugUtilsMessengerCreateInfoEXT info = {};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    info.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    info.pfnUserCallback = on_message;
    info.pUserData = &messages;
    const auto create = function_of<PFN_vkCreateDebugUtilsMessengerEXT>(instance, "vkCreateDebugUtilsMessengerEXT");
    REQUIRE(create(instance, &info, nullptr, &messenger_) == VK_SUCCESS);
}

Messenger::~Messenger() {
    function_of<PFN_vkDestroyDebugUtilsMessengerEXT>(instance_, "vkDestroyDebugUtilsMessengerEXT")(instance_, messenger_,
                                                                                                   nullptr);
}

bool can_run() {
    static const VulkanDeviceList list = list_vulkan_devices();
    const bool usable =
        std::any_of(list.devices.begin(), list.devices.end(), [](const auto& device) { return device.problem.empty(); });
    if (!usable) MESSAGE("skipped: no usable Vulkan device. " << list.problem);
    if (usable && !list.validation_available) MESSAGE("skipped: the Vulkan validation layer is not installed");
    return usable && list.validation_available;
}

TestDevice::TestDevice(VulkanDeviceDesc desc) {
    desc.validation = true;
    desc.message_callback = Messages::collect;
    desc.message_user = &messages;
    device_ = create_vulkan_device(desc);
    device_->device().set_message_callback(nullptr, nullptr);
    messenger_ = std::make_unique<Messenger>(device_->handles().instance, messages);
}

TestDevice::~TestDevice() {
    // The last calls, in which leaks are found, outlive the messenger.
    device_->device().set_message_callback(Messages::collect, &messages);
    messenger_.reset();
    device_.reset();
    CHECK(messages.joined() == "");
}

}  // namespace aureole::vulkan::test
