#include "physical_device.h"

#include "result.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace aureole::vulkan {
namespace {

bool has_extension(const InstanceFunctions& f, VkPhysicalDevice device, std::string_view name) {
    std::uint32_t count = 0;
    if (f.vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr) < VK_SUCCESS) return false;
    std::vector<VkExtensionProperties> extensions(count);
    if (f.vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data()) < VK_SUCCESS) return false;
    extensions.resize(count);
    return std::any_of(extensions.begin(), extensions.end(), [&](const auto& e) { return name == e.extensionName; });
}

const char* type_text(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return "discrete";
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return "integrated";
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return "virtual";
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return "cpu";
        default:
            return "other";
    }
}

/// Smaller is better.
int rank(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return 0;
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return 1;
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return 2;
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return 3;
        default:
            return 4;
    }
}

bool contains_ignoring_case(std::string_view text, std::string_view part) {
    const auto equal = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    return std::search(text.begin(), text.end(), part.begin(), part.end(), equal) != text.end();
}

std::string names_of(const std::vector<PhysicalDevice>& devices) {
    std::string names;
    for (const PhysicalDevice& device : devices) {
        if (!names.empty()) names += ", ";
        names += device.properties.deviceName;
    }
    return names;
}

}  // namespace

std::string version_text(std::uint32_t version) {
    return std::to_string(VK_API_VERSION_MAJOR(version)) + "." + std::to_string(VK_API_VERSION_MINOR(version)) + "." +
           std::to_string(VK_API_VERSION_PATCH(version));
}

PhysicalDevice describe(const InstanceFunctions& f, VkPhysicalDevice handle) {
    PhysicalDevice device;
    device.handle = handle;
    f.vkGetPhysicalDeviceProperties(handle, &device.properties);
    f.vkGetPhysicalDeviceFeatures(handle, &device.features);
    std::uint32_t count = 0;
    f.vkGetPhysicalDeviceQueueFamilyProperties(handle, &count, nullptr);
    device.queue_families.resize(count);
    f.vkGetPhysicalDeviceQueueFamilyProperties(handle, &count, device.queue_families.data());
    device.queue_families.resize(count);

    device.driver = "version " + std::to_string(device.properties.driverVersion);
    if (device.properties.apiVersion < VK_API_VERSION_1_1) return device;

    VkPhysicalDeviceDriverPropertiesKHR driver = {};
    driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES_KHR;
    VkPhysicalDeviceMaintenance3Properties limits = {};
    limits.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES;
    VkPhysicalDeviceProperties2 properties = {};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &limits;
    const bool names_driver = has_extension(f, handle, VK_KHR_DRIVER_PROPERTIES_EXTENSION_NAME);
    if (names_driver) limits.pNext = &driver;
    f.vkGetPhysicalDeviceProperties2(handle, &properties);
    device.max_allocation_size = limits.maxMemoryAllocationSize;
    if (names_driver) device.driver = std::string(driver.driverName) + " " + driver.driverInfo;
    return device;
}

std::vector<PhysicalDevice> enumerate(const InstanceFunctions& f, VkInstance instance) {
    std::uint32_t count = 0;
    check_result(f.vkEnumeratePhysicalDevices(instance, &count, nullptr), "vkEnumeratePhysicalDevices", "Vulkan");
    std::vector<VkPhysicalDevice> handles(count);
    check_result(f.vkEnumeratePhysicalDevices(instance, &count, handles.data()), "vkEnumeratePhysicalDevices", "Vulkan");
    handles.resize(count);
    std::vector<PhysicalDevice> devices;
    devices.reserve(handles.size());
    for (VkPhysicalDevice handle : handles) devices.push_back(describe(f, handle));
    return devices;
}

std::string problem_of(const PhysicalDevice& device, const VkPhysicalDeviceFeatures& features) {
    if (device.properties.apiVersion < VK_API_VERSION_1_1)
        return "supports only Vulkan " + version_text(device.properties.apiVersion) + "; 1.1 is needed";
    const auto computes = [](const VkQueueFamilyProperties& q) { return (q.queueFlags & VK_QUEUE_COMPUTE_BIT) != 0; };
    if (std::none_of(device.queue_families.begin(), device.queue_families.end(), computes))
        return "has no queue for compute work";
    if (!features.shaderStorageImageWriteWithoutFormat) return "lacks the feature shaderStorageImageWriteWithoutFormat";
    return {};
}

std::uint32_t choose_queue_family(const PhysicalDevice& device) {
    const auto first_with = [&](VkQueueFlags flags) {
        std::uint32_t i = 0;
        while (i < device.queue_families.size() && (device.queue_families[i].queueFlags & flags) != flags) ++i;
        return i;
    };
    const std::uint32_t draws = first_with(VK_QUEUE_COMPUTE_BIT | VK_QUEUE_GRAPHICS_BIT);
    return draws < device.queue_families.size() ? draws : first_with(VK_QUEUE_COMPUTE_BIT);
}

std::vector<const PhysicalDevice*> choose(const std::vector<PhysicalDevice>& devices, const VulkanDeviceDesc& desc) {
    if (devices.empty()) throw Error(ErrorCode::unsupported, "no Vulkan device: no driver is installed that works here");
    const int count = static_cast<int>(devices.size());
    if (desc.index < -1 || desc.index >= count)
        throw Error(ErrorCode::invalid_argument, "index", std::to_string(desc.index),
                    "-1 (any) to " + std::to_string(count - 1));

    std::vector<const PhysicalDevice*> usable;
    std::string problems;
    bool named = false;
    for (int i = 0; i < count; ++i) {
        const PhysicalDevice& device = devices[static_cast<std::size_t>(i)];
        if (desc.index >= 0 && i != desc.index) continue;
        if (!contains_ignoring_case(device.properties.deviceName, desc.name)) continue;
        named = true;
        if (const std::string problem = problem_of(device, device.features); !problem.empty())
            problems += std::string(problems.empty() ? "" : "; ") + device.properties.deviceName + " " + problem;
        else
            usable.push_back(&device);
    }
    if (!named) throw Error(ErrorCode::unsupported, "name", desc.name, "part of a device's name: " + names_of(devices));
    if (usable.empty()) throw Error(ErrorCode::unsupported, "no usable Vulkan device: " + problems);
    const auto better = [](const PhysicalDevice* a, const PhysicalDevice* b) {
        return rank(a->properties.deviceType) < rank(b->properties.deviceType);
    };
    std::stable_sort(usable.begin(), usable.end(), better);
    return usable;
}

VulkanDeviceInfo info_of(const PhysicalDevice& device, std::uint32_t index) {
    VulkanDeviceInfo info;
    info.index = index;
    info.name = device.properties.deviceName;
    info.type = type_text(device.properties.deviceType);
    info.driver = device.driver;
    info.api_version = version_text(device.properties.apiVersion);
    info.problem = problem_of(device, device.features);
    return info;
}

}  // namespace aureole::vulkan
