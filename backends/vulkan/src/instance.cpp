#include "instance.h"

#include "result.h"

#include <cstring>
#include <string>
#include <vector>

namespace aureole::vulkan {
namespace {

bool has_extension(const GlobalFunctions& global, const char* layer, std::string_view name) {
    std::uint32_t count = 0;
    if (global.vkEnumerateInstanceExtensionProperties(layer, &count, nullptr) < VK_SUCCESS) return false;
    std::vector<VkExtensionProperties> extensions(count);
    if (global.vkEnumerateInstanceExtensionProperties(layer, &count, extensions.data()) < VK_SUCCESS) return false;
    extensions.resize(count);
    for (const VkExtensionProperties& extension : extensions)
        if (name == extension.extensionName) return true;
    return false;
}

/// Only findings of the validation layer are warnings and errors. The loader's remarks about the machine (a driver that does
/// not load) are of type GENERAL and never stop us.
VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT severity, VkDebugUtilsMessageTypeFlagsEXT type,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    auto level = rhi::Severity::info;
    if (type != VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT)
        level = (severity & VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT) ? rhi::Severity::error : rhi::Severity::warning;
    static_cast<const MessageSink*>(user)->send(level, data->pMessage);
    return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT messenger_info(const MessageSink& sink) {
    VkDebugUtilsMessengerCreateInfoEXT info = {};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    info.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT |
                       VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    info.pfnUserCallback = on_message;
    info.pUserData = const_cast<MessageSink*>(&sink);
    return info;
}

}  // namespace

GlobalFunctions open_vulkan(PFN_vkGetInstanceProcAddr loader) {
    if (!loader) loader = system_loader();
    if (!loader) throw Error(ErrorCode::unsupported, "no Vulkan loader (libvulkan.so.1) is installed; on Debian: libvulkan1");
    const GlobalFunctions global = load_global_functions(loader);
    std::uint32_t version = 0;
    check_result(global.vkEnumerateInstanceVersion(&version), "vkEnumerateInstanceVersion", "Vulkan loader");
    if (version < VK_API_VERSION_1_1) throw Error(ErrorCode::unsupported, "the Vulkan loader is older than version 1.1");
    return global;
}

bool has_layer(const GlobalFunctions& global, std::string_view name) {
    std::uint32_t count = 0;
    if (global.vkEnumerateInstanceLayerProperties(&count, nullptr) < VK_SUCCESS) return false;
    std::vector<VkLayerProperties> layers(count);
    if (global.vkEnumerateInstanceLayerProperties(&count, layers.data()) < VK_SUCCESS) return false;
    layers.resize(count);
    for (const VkLayerProperties& layer : layers)
        if (name == layer.layerName) return true;
    return false;
}

Instance::Instance(const GlobalFunctions& global, bool validation, const MessageSink& sink) {
    if (validation && !has_layer(global, validation_layer))
        throw Error(
            ErrorCode::unsupported, "validation", "true",
            std::string("false: the layer ") + validation_layer + " is not installed (on Debian: vulkan-validationlayers)");
    debug_utils_ = has_extension(global, nullptr, VK_EXT_DEBUG_UTILS_EXTENSION_NAME) ||
                   (validation && has_extension(global, validation_layer, VK_EXT_DEBUG_UTILS_EXTENSION_NAME));
    if (validation && !debug_utils_)
        throw Error(ErrorCode::unsupported, "validation", "true",
                    "false: the instance lacks " VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    if (validation && !has_extension(global, validation_layer, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME))
        throw Error(ErrorCode::unsupported, "validation", "true",
                    "false: the layer lacks " VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME " (synchronization checks)");

    VkApplicationInfo application = {};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.pApplicationName = "Aureole";
    application.pEngineName = "Aureole";
    application.apiVersion = VK_API_VERSION_1_1;

    std::vector<const char*> layers, extensions;
    if (debug_utils_) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    if (validation) {
        layers.push_back(validation_layer);
        extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
    }

    // The chain also catches messages of vkCreateInstance and vkDestroyInstance themselves.
    VkDebugUtilsMessengerCreateInfoEXT messenger = messenger_info(sink);
    const VkValidationFeatureEnableEXT enabled[] = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    VkValidationFeaturesEXT features = {};
    features.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
    features.enabledValidationFeatureCount = 1;
    features.pEnabledValidationFeatures = enabled;
    features.pNext = &messenger;

    VkInstanceCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pNext = validation ? &features : nullptr;
    info.pApplicationInfo = &application;
    info.enabledLayerCount = static_cast<std::uint32_t>(layers.size());
    info.ppEnabledLayerNames = layers.data();
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    const VkResult result = global.vkCreateInstance(&info, nullptr, &instance_);
    const bool no_driver = result == VK_ERROR_INCOMPATIBLE_DRIVER;  // the loader's answer when it finds none
    check_result(result, "vkCreateInstance", no_driver ? "no Vulkan driver is installed that works here" : "Vulkan");

    try {
        functions_ = load_instance_functions(global.get_instance_proc_addr, instance_, Ownership::own, debug_utils_);
        if (validation)
            check_result(functions_.vkCreateDebugUtilsMessengerEXT(instance_, &messenger, nullptr, &messenger_),
                         "vkCreateDebugUtilsMessengerEXT", "Vulkan");
    } catch (...) {
        const auto destroy =
            reinterpret_cast<PFN_vkDestroyInstance>(global.get_instance_proc_addr(instance_, "vkDestroyInstance"));
        if (destroy) destroy(instance_, nullptr);
        throw;
    }
}

Instance::~Instance() {
    if (messenger_) functions_.vkDestroyDebugUtilsMessengerEXT(instance_, messenger_, nullptr);
    functions_.vkDestroyInstance(instance_, nullptr);
}

}  // namespace aureole::vulkan
