#include "viewer/ui/gpu.h"

#include "common/surface.h"

#include <aureole/rhi/error.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <spdlog/spdlog.h>
#include <cstring>
#include <string>
#include <vector>

namespace aureole::viewer {
namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

bool has_layer(const char* name) {
    std::uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    for (const VkLayerProperties& layer : layers)
        if (std::strcmp(layer.layerName, name) == 0) return true;
    return false;
}

template <class Function>
Function function(VkInstance instance, const char* name) {
    return reinterpret_cast<Function>(vkGetInstanceProcAddr(instance, name));
}

}  // namespace

void check(VkResult result, const char* call) {
    if (result >= 0) return;
    const ErrorCode code = result == VK_ERROR_DEVICE_LOST ? ErrorCode::device_lost
                           : result == VK_ERROR_OUT_OF_HOST_MEMORY || result == VK_ERROR_OUT_OF_DEVICE_MEMORY
                               ? ErrorCode::out_of_memory
                               : ErrorCode::internal;
    throw Error(code, std::string(call) + " failed: VkResult " + std::to_string(result));
}

VkBool32 Gpu::on_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    ++static_cast<Gpu*>(user)->findings_;
    spdlog::error("{}", data->pMessage);
    return VK_FALSE;
}

Gpu::Gpu(GLFWwindow* window, const GpuOptions& options) {
    try {
        make_instance(options.validation);
        check(glfwCreateWindowSurface(instance, window, nullptr, &surface), "glfwCreateWindowSurface");
        choose_device();
        choose_format(options.srgb_surface);
        make_device();
    } catch (...) {
        destroy();
        throw;
    }
}

Gpu::~Gpu() { destroy(); }

void Gpu::make_instance(bool validation) {
    if (validation && !has_layer(validation_layer))
        throw Error(ErrorCode::unsupported, "--validation: the Vulkan validation layer is not installed");
    std::uint32_t count = 0;
    const char** needed = glfwGetRequiredInstanceExtensions(&count);
    if (!needed) throw Error(ErrorCode::unsupported, "GLFW finds no Vulkan that can show a window here");
    std::vector<const char*> extensions(needed, needed + count);
    if (validation) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);

    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.pApplicationName = "aureole-viewer";
    application.apiVersion = VK_API_VERSION_1_1;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    info.enabledLayerCount = validation ? 1 : 0;
    info.ppEnabledLayerNames = &validation_layer;
    const VkDebugUtilsMessengerCreateInfoEXT messages = app::messenger_info(on_message, this);
    info.pNext = validation ? &messages : nullptr;
    check(vkCreateInstance(&info, nullptr, &instance), "vkCreateInstance");
    if (!validation) return;
    const auto create = function<PFN_vkCreateDebugUtilsMessengerEXT>(instance, "vkCreateDebugUtilsMessengerEXT");
    check(create(instance, &messages, nullptr, &messenger_), "vkCreateDebugUtilsMessengerEXT");
}

/// A queue that draws and presents; a discrete device before others.
void Gpu::choose_device() {
    std::uint32_t count = 0;
    check(vkEnumeratePhysicalDevices(instance, &count, nullptr), "vkEnumeratePhysicalDevices");
    std::vector<VkPhysicalDevice> devices(count);
    check(vkEnumeratePhysicalDevices(instance, &count, devices.data()), "vkEnumeratePhysicalDevices");
    bool discrete = false;
    for (const VkPhysicalDevice candidate : devices) {
        VkPhysicalDeviceProperties properties;
        vkGetPhysicalDeviceProperties(candidate, &properties);
        std::uint32_t families = 0;
        vkGetPhysicalDeviceQueueFamilyProperties(candidate, &families, nullptr);
        std::vector<VkQueueFamilyProperties> all(families);
        vkGetPhysicalDeviceQueueFamilyProperties(candidate, &families, all.data());
        for (std::uint32_t i = 0; i < families; ++i) {
            VkBool32 presents = VK_FALSE;
            vkGetPhysicalDeviceSurfaceSupportKHR(candidate, i, surface, &presents);
            if (!presents || !(all[i].queueFlags & VK_QUEUE_GRAPHICS_BIT) || (physical_device && discrete)) continue;
            if (physical_device && properties.deviceType != VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU) continue;
            physical_device = candidate;
            family = i;
            discrete = properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU;
        }
    }
    if (!physical_device) throw Error(ErrorCode::unsupported, "no Vulkan device can draw to this window");
}

void Gpu::choose_format(bool srgb) {
    const auto found = app::surface_format(physical_device, surface, srgb);
    if (!found) throw Error(ErrorCode::unsupported, "the window's surface takes no sRGB of 8 bits");
    surface_format = *found;
    const bool encodes = app::encodes_srgb(surface_format.format);
    if (srgb && !encodes)
        throw Error(ErrorCode::unsupported, "--srgb-surface: the window's surface has no format that encodes");
    image_format = encodes ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R8G8B8A8_UNORM;
}

void Gpu::make_device() {
    const float priority = 1;
    VkDeviceQueueCreateInfo queues{};
    queues.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queues.queueFamilyIndex = family;
    queues.queueCount = 1;
    queues.pQueuePriorities = &priority;
    const char* extension = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queues;
    info.enabledExtensionCount = 1;
    info.ppEnabledExtensionNames = &extension;
    check(vkCreateDevice(physical_device, &info, nullptr, &device), "vkCreateDevice");
    vkGetDeviceQueue(device, family, 0, &queue);
    VkCommandPoolCreateInfo pool_info{};
    pool_info.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    pool_info.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
    pool_info.queueFamilyIndex = family;
    check(vkCreateCommandPool(device, &pool_info, nullptr, &pool), "vkCreateCommandPool");
}

void Gpu::destroy() noexcept {
    if (device) vkDestroyCommandPool(device, pool, nullptr);
    if (device) vkDestroyDevice(device, nullptr);
    if (surface) vkDestroySurfaceKHR(instance, surface, nullptr);
    if (messenger_)
        function<PFN_vkDestroyDebugUtilsMessengerEXT>(instance, "vkDestroyDebugUtilsMessengerEXT")(instance, messenger_,
                                                                                                   nullptr);
    if (instance) vkDestroyInstance(instance, nullptr);
}

void Gpu::run(const std::function<void(VkCommandBuffer)>& record) const {
    VkCommandBufferAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    allocate.commandPool = pool;
    allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocate.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    check(vkAllocateCommandBuffers(device, &allocate, &commands), "vkAllocateCommandBuffers");
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
    record(commands);
    check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
    VkSubmitInfo submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    check(vkQueueSubmit(queue, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit");
    check(vkQueueWaitIdle(queue), "vkQueueWaitIdle");
    vkFreeCommandBuffers(device, pool, 1, &commands);
}

std::uint32_t Gpu::memory_type(std::uint32_t bits, VkMemoryPropertyFlags properties) const {
    if (const auto found = app::memory_type(physical_device, bits, properties)) return *found;
    throw Error(ErrorCode::out_of_memory, "the device has no memory of the kind that the window needs");
}

}  // namespace aureole::viewer
