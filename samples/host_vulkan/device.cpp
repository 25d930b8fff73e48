#include "host_vulkan/device.h"

#include "common/surface.h"
#include "host_vulkan/calls.h"

#include <cstdio>
#include <optional>
#include <vector>

namespace host_vulkan {
namespace {

std::vector<VkQueueFamilyProperties> families_of(VkPhysicalDevice physical) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    return families;
}

/// A family that draws, computes and presents to the surface.
std::optional<std::uint32_t> family_of(VkPhysicalDevice physical, VkSurfaceKHR surface) {
    const std::vector<VkQueueFamilyProperties> families = families_of(physical);
    constexpr VkQueueFlags wanted = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (std::uint32_t i = 0; i < families.size(); ++i) {
        VkBool32 presents = VK_FALSE;
        check(vkGetPhysicalDeviceSurfaceSupportKHR(physical, i, surface, &presents), "vkGetPhysicalDeviceSurfaceSupportKHR");
        if (presents && (families[i].queueFlags & wanted) == wanted) return i;
    }
    return {};
}

/// A family that computes and does not draw: what runs there runs beside the graphics, where there is one.
std::optional<std::uint32_t> compute_family_of(VkPhysicalDevice physical) {
    const std::vector<VkQueueFamilyProperties> families = families_of(physical);
    for (std::uint32_t i = 0; i < families.size(); ++i)
        if ((families[i].queueFlags & (VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT)) == VK_QUEUE_COMPUTE_BIT) return i;
    return {};
}

/// Extensions of the instance's and the device's structures that this host uses.
struct Features {
    VkPhysicalDeviceFeatures2 core = info_of<VkPhysicalDeviceFeatures2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2);
    VkPhysicalDeviceVulkan13Features newer =
        info_of<VkPhysicalDeviceVulkan13Features>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES);
    Features() { core.pNext = &newer; }
    Features(const Features&) = delete;
    Features& operator=(const Features&) = delete;
};

bool suits(VkPhysicalDevice physical) {
    VkPhysicalDeviceProperties properties = {};
    vkGetPhysicalDeviceProperties(physical, &properties);
    if (properties.apiVersion < api_version) return false;
    Features has;
    vkGetPhysicalDeviceFeatures2(physical, &has.core);
    return has.newer.dynamicRendering && has.newer.synchronization2 && has.core.features.depthClamp &&
           has.core.features.shaderStorageImageWriteWithoutFormat;
}

}  // namespace

VkBool32 Device::on_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                            const VkDebugUtilsMessengerCallbackDataEXT* data, void* device) {
    ++static_cast<Device*>(device)->messages_;
    std::fprintf(stderr, "validation: %s\n", data->pMessage);
    return VK_FALSE;
}

Device::Device(const Window& window, bool validate) : validated(validate) {
    try {
        make_instance();
        surface = window.make_surface(instance);
        choose();
        make_device();
    } catch (...) {
        destroy();
        throw;
    }
}

Device::~Device() { destroy(); }

void Device::destroy() noexcept {
    if (handle) vkDestroyDevice(handle, nullptr);
    if (!instance) return;
    if (surface) vkDestroySurfaceKHR(instance, surface, nullptr);
    if (messenger_) vkDestroyDebugUtilsMessengerEXT(instance, messenger_, nullptr);
    vkDestroyInstance(instance, nullptr);
}

void Device::make_instance() {
    open_vulkan();
    auto application = info_of<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
    application.pApplicationName = "host_vulkan";
    application.apiVersion = api_version;
    const auto needed = Window::instance_extensions();
    std::vector<const char*> extensions(needed.begin(), needed.end());
    auto info = info_of<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
    info.pApplicationInfo = &application;

    const char* const layer = "VK_LAYER_KHRONOS_validation";
    const VkValidationFeatureEnableEXT checks[] = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    auto validation = info_of<VkValidationFeaturesEXT>(VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT);
    validation.enabledValidationFeatureCount = 1;
    validation.pEnabledValidationFeatures = checks;
    // Of the instance's own making and end, too.
    VkDebugUtilsMessengerCreateInfoEXT messages = aureole::app::messenger_info(on_message, this);
    if (validated) {
        extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
        extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
        validation.pNext = &messages;
        info.pNext = &validation;
        info.enabledLayerCount = 1;
        info.ppEnabledLayerNames = &layer;
    }
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    const VkResult made = vkCreateInstance(&info, nullptr, &instance);
    if (made == VK_ERROR_LAYER_NOT_PRESENT)
        throw std::runtime_error("--validate: the layer VK_LAYER_KHRONOS_validation is not installed");
    check(made, "vkCreateInstance");
    volkLoadInstance(instance);
    if (validated)
        check(vkCreateDebugUtilsMessengerEXT(instance, &messages, nullptr, &messenger_), "vkCreateDebugUtilsMessengerEXT");
}

void Device::choose() {
    std::uint32_t count = 0;
    check(vkEnumeratePhysicalDevices(instance, &count, nullptr), "vkEnumeratePhysicalDevices");
    std::vector<VkPhysicalDevice> all(count);
    check(vkEnumeratePhysicalDevices(instance, &count, all.data()), "vkEnumeratePhysicalDevices");
    int best = -1;
    for (VkPhysicalDevice candidate : all) {
        const auto found = suits(candidate) ? family_of(candidate, surface) : std::nullopt;
        if (!found) continue;
        VkPhysicalDeviceProperties properties = {};
        vkGetPhysicalDeviceProperties(candidate, &properties);
        const int score = properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU ? 2
                          : properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU        ? 0
                                                                                        : 1;
        if (score <= best) continue;
        best = score;
        name = properties.deviceName;
        physical = candidate;
        family = *found;
        compute_family = compute_family_of(candidate).value_or(family);
        queues_ = compute_family == family && families_of(candidate)[family].queueCount > 1 ? 2 : 1;
    }
    if (!physical)
        throw std::runtime_error(
            "no Vulkan 1.3 device here presents to the window and has dynamicRendering, synchronization2, depthClamp and "
            "shaderStorageImageWriteWithoutFormat");
}

void Device::make_device() {
    const float priorities[] = {1, 1};
    VkDeviceQueueCreateInfo queues[2] = {};
    for (VkDeviceQueueCreateInfo& info : queues) {
        info = info_of<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
        info.queueFamilyIndex = &info == queues ? family : compute_family;
        info.queueCount = &info == queues ? queues_ : 1;
        info.pQueuePriorities = priorities;
    }
    Features enabled;
    enabled.core.features.depthClamp = VK_TRUE;
    enabled.core.features.shaderStorageImageWriteWithoutFormat = VK_TRUE;  // Aureole's one wish
    enabled.newer.dynamicRendering = VK_TRUE;
    enabled.newer.synchronization2 = VK_TRUE;
    const char* const extensions[] = {VK_KHR_SWAPCHAIN_EXTENSION_NAME};
    auto info = info_of<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
    info.pNext = &enabled.core;
    info.queueCreateInfoCount = compute_family == family ? 1 : 2;
    info.pQueueCreateInfos = queues;
    info.enabledExtensionCount = 1;
    info.ppEnabledExtensionNames = extensions;
    check(vkCreateDevice(physical, &info, nullptr, &handle), "vkCreateDevice");
    features = enabled.core.features;
    vkGetDeviceQueue(handle, family, 0, &queue);
    vkGetDeviceQueue(handle, compute_family, queues_ - 1, &compute_queue);
}

const char* Device::describe_compute_queue() const {
    if (compute_family != family) return "a queue of a family that computes alone";
    return queues_ > 1 ? "a second queue of the family" : "the one queue that there is, between semaphores";
}

std::uint32_t Device::memory_type(std::uint32_t allowed, VkMemoryPropertyFlags wanted) const {
    if (const auto found = aureole::app::memory_type(physical, allowed, wanted)) return *found;
    throw std::runtime_error("the device has no memory of the kind " + std::to_string(wanted));
}

}  // namespace host_vulkan
