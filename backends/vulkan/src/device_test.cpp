// Finding, choosing and refusing devices.
#include <aureole/rhi/error.h>
#include <doctest/doctest.h>

#include <algorithm>

#include "test_loader.h"
#include "test_support.h"

using namespace aureole;
using namespace aureole::vulkan;
using namespace aureole::vulkan::test;

namespace {

/// The error that creation ends with.
Error refusal(const VulkanDeviceDesc& desc) {
    try {
        (void)create_vulkan_device(desc);
    } catch (const Error& error) {
        return error;
    }
    FAIL("a device was made");
    return Error(ErrorCode::internal, "");
}

bool mentions(const Error& error, const std::string& part) { return std::string(error.what()).find(part) != std::string::npos; }

VulkanDeviceDesc lied_to() {
    VulkanDeviceDesc desc;
    desc.loader = lying_loader();
    return desc;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL empty_loader(VkInstance, const char*) { return nullptr; }

VKAPI_ATTR VkResult VKAPI_CALL no_layers(uint32_t* count, VkLayerProperties*) {
    *count = 0;
    return VK_SUCCESS;
}
VKAPI_ATTR VkResult VKAPI_CALL no_devices(VkInstance, uint32_t* count, VkPhysicalDevice*) {
    *count = 0;
    return VK_SUCCESS;
}
VKAPI_ATTR VkResult VKAPI_CALL version_1_0(uint32_t* version) {
    *version = VK_API_VERSION_1_0;
    return VK_SUCCESS;
}
VKAPI_ATTR void VKAPI_CALL no_features(VkPhysicalDevice, VkPhysicalDeviceFeatures* features) { *features = {}; }
VKAPI_ATTR void VKAPI_CALL old_device(VkPhysicalDevice device, VkPhysicalDeviceProperties* properties) {
    truth_of<PFN_vkGetPhysicalDeviceProperties>("vkGetPhysicalDeviceProperties")(device, properties);
    properties->apiVersion = VK_API_VERSION_1_0;
}
VKAPI_ATTR void VKAPI_CALL transfer_only(VkPhysicalDevice device, uint32_t* count, VkQueueFamilyProperties* families) {
    truth_of<PFN_vkGetPhysicalDeviceQueueFamilyProperties>("vkGetPhysicalDeviceQueueFamilyProperties")(device, count, families);
    for (uint32_t i = 0; families && i < *count; ++i) families[i].queueFlags = VK_QUEUE_TRANSFER_BIT;
}
VKAPI_ATTR VkResult VKAPI_CALL device_out_of_memory(VkPhysicalDevice, const VkDeviceCreateInfo*, const VkAllocationCallbacks*,
                                                    VkDevice*) {
    return VK_ERROR_OUT_OF_HOST_MEMORY;
}

}  // namespace

TEST_CASE("the list names every device and says why one cannot be used") {
    AUREOLE_NEEDS_VULKAN;
    const VulkanDeviceList list = list_vulkan_devices();
    REQUIRE(!list.devices.empty());
    CHECK(list.problem == "");
    for (std::size_t i = 0; i < list.devices.size(); ++i) {
        const VulkanDeviceInfo& info = list.devices[i];
        CHECK(info.index == i);
        CHECK(info.name != "");
        CHECK(info.driver != "");
        CHECK(info.api_version.substr(0, 2) == "1.");
        const std::vector<std::string> types = {"discrete", "integrated", "virtual", "cpu", "other"};
        CHECK(std::count(types.begin(), types.end(), info.type) == 1);
    }
}

TEST_CASE("a device is chosen by index and by part of its name") {
    AUREOLE_NEEDS_VULKAN;
    const VulkanDeviceList list = list_vulkan_devices();
    const auto usable = std::find_if(list.devices.begin(), list.devices.end(), [](const auto& d) { return d.problem.empty(); });
    VulkanDeviceDesc desc;
    desc.index = static_cast<int>(usable->index);
    CHECK(create_vulkan_device(desc)->device().capabilities().device == usable->name);

    desc.index = -1;
    desc.name = usable->name.substr(1, 5);
    std::transform(desc.name.begin(), desc.name.end(), desc.name.begin(), [](unsigned char c) { return std::toupper(c); });
    CHECK(create_vulkan_device(desc)->device().capabilities().device.find(usable->name.substr(1, 5)) != std::string::npos);

    desc.name = "no such device";
    const Error unnamed = refusal(desc);
    CHECK(unnamed.code() == ErrorCode::unsupported);
    CHECK(unnamed.field() == "name");
    CHECK(mentions(unnamed, usable->name));

    desc = {};
    for (const int index : {-2, static_cast<int>(list.devices.size())}) {
        desc.index = index;
        const Error beyond = refusal(desc);
        CHECK(beyond.code() == ErrorCode::invalid_argument);
        CHECK(beyond.field() == "index");
        CHECK(beyond.value() == std::to_string(index));
    }
}

TEST_CASE("capabilities and handles tell about the device that was made") {
    AUREOLE_NEEDS_VULKAN;
    TestDevice vulkan;
    const rhi::Capabilities& c = vulkan.device().capabilities();
    CHECK(c.backend == "vulkan");
    CHECK(c.storage_write_without_format);
    CHECK(c.threads == 0);
    const VulkanHandles handles = vulkan.native().handles();
    CHECK(handles.instance != VK_NULL_HANDLE);
    CHECK(handles.physical_device != VK_NULL_HANDLE);
    CHECK(handles.device != VK_NULL_HANDLE);
    CHECK(handles.queue != VK_NULL_HANDLE);
}

TEST_CASE("several devices live side by side") {
    AUREOLE_NEEDS_VULKAN;
    TestDevice first;
    {
        TestDevice second;
        (void)second.queue().begin();
        (void)second.queue().submit();
        second.queue().wait();
    }
    (void)first.queue().begin();
    CHECK(first.queue().submit() == 1);
    first.queue().wait();
}

TEST_CASE("without a loader, or with an old one, the list and creation say so") {
    VulkanDeviceDesc desc;
    desc.loader = empty_loader;
    CHECK(list_vulkan_devices(empty_loader).devices.empty());
    CHECK(list_vulkan_devices(empty_loader).problem.find("vkCreateInstance") != std::string::npos);
    CHECK(refusal(desc).code() == ErrorCode::unsupported);

    Lies lies;
    lies.tell("vkEnumerateInstanceVersion", version_1_0);
    CHECK(list_vulkan_devices(lying_loader()).problem.find("1.1") != std::string::npos);
    CHECK(mentions(refusal(lied_to()), "1.1"));
}

TEST_CASE("validation without its layer is refused") {
    Lies lies;
    lies.tell("vkEnumerateInstanceLayerProperties", no_layers);
    CHECK(!list_vulkan_devices(lying_loader()).validation_available);
    VulkanDeviceDesc desc = lied_to();
    desc.validation = true;
    const Error error = refusal(desc);
    CHECK(error.code() == ErrorCode::unsupported);
    CHECK(error.field() == "validation");
    CHECK(mentions(error, "VK_LAYER_KHRONOS_validation"));
}

TEST_CASE("without drivers there is no device, and that is said") {
    Lies lies;
    lies.tell("vkEnumeratePhysicalDevices", no_devices);
    CHECK(list_vulkan_devices(lying_loader()).problem.find("no Vulkan driver") != std::string::npos);
    CHECK(refusal(lied_to()).code() == ErrorCode::unsupported);
}

TEST_CASE("devices that lack something are listed with the reason and refused for it") {
    AUREOLE_NEEDS_VULKAN;
    const auto check_reason = [](const std::string& reason) {
        CAPTURE(reason);
        const VulkanDeviceList list = list_vulkan_devices(lying_loader());
        REQUIRE(!list.devices.empty());
        CHECK(list.devices[0].problem.find(reason) != std::string::npos);
        const Error error = refusal(lied_to());
        CHECK(error.code() == ErrorCode::unsupported);
        CHECK(mentions(error, reason));
        CHECK(mentions(error, list.devices[0].name));
    };
    {
        Lies lies;
        lies.tell("vkGetPhysicalDeviceFeatures", no_features);
        check_reason("shaderStorageImageWriteWithoutFormat");
    }
    {
        Lies lies;
        lies.tell("vkGetPhysicalDeviceProperties", old_device);
        check_reason("1.0");
    }
    {
        Lies lies;
        lies.tell("vkGetPhysicalDeviceQueueFamilyProperties", transfer_only);
        check_reason("queue for compute");
    }
}

TEST_CASE("failures while a device is made keep their kind, and a function that is missing is named") {
    AUREOLE_NEEDS_VULKAN;
    {
        Lies lies;
        lies.tell("vkCreateDevice", device_out_of_memory);
        CHECK(refusal(lied_to()).code() == ErrorCode::out_of_memory);
    }
    for (const char* name : {"vkCreateInstance", "vkGetPhysicalDeviceProperties2", "vkCmdDispatch", "vkQueueSubmit"}) {
        Lies lies;
        lies.tell(name, PFN_vkVoidFunction{});
        const Error error = refusal(lied_to());
        CHECK(error.code() == ErrorCode::unsupported);
        CHECK(mentions(error, name));
    }
}
