// What the device tests share: a device under the validation layer, and every finding of the layer as a failure.
#pragma once

#include <aureole/vulkan/vulkan_device.h>

#include <memory>
#include <string>
#include <vector>

namespace aureole::vulkan::test {

/// Texts of the validation layer (core and synchronization checks), and of misuse reported by the device.
struct Messages {
    std::vector<std::string> texts;

    /// For rhi::Device::set_message_callback; remarks of severity info are dropped.
    static void collect(void* messages, rhi::Severity severity, const char* text);
    [[nodiscard]] bool mention(const std::string& part) const;
    [[nodiscard]] std::string joined() const;
};

/// A messenger of the test's own, whatever callback the device has at the moment.
class Messenger {
public:
    Messenger(VkInstance instance, Messages& messages);
    ~Messenger();
    Messenger(const Messenger&) = delete;
    Messenger& operator=(const Messenger&) = delete;

private:
    VkInstance instance_;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
};

/// True if there is a device and the validation layer; else says that the test is skipped.
[[nodiscard]] bool can_run();

/// A device of our own under validation. When it goes, any message that was not taken away is a failure.
class TestDevice {
public:
    explicit TestDevice(VulkanDeviceDesc desc = {});
    ~TestDevice();
    TestDevice(const TestDevice&) = delete;
    TestDevice& operator=(const TestDevice&) = delete;

    [[nodiscard]] rhi::Device& device() { return device_->device(); }
    [[nodiscard]] rhi::Queue& queue() { return device_->queue(); }
    [[nodiscard]] VulkanDevice& native() { return *device_; }
    Messages messages;

private:
    std::unique_ptr<VulkanDevice> device_;
    std::unique_ptr<Messenger> messenger_;
};

}  // namespace aureole::vulkan::test

/// First line of every test that needs a device.
#define AUREOLE_NEEDS_VULKAN \
    if (!::aureole::vulkan::test::can_run()) return
