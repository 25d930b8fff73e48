#include "functions.h"

#include <aureole/rhi/error.h>

#include <mutex>
#include <string>

namespace aureole::vulkan {
namespace {

[[noreturn]] void missing(const char* function, const char* where) {
    throw Error(ErrorCode::unsupported, std::string("Vulkan function ") + function + " is missing from " + where);
}

template <class Function>
Function look_up(PFN_vkGetInstanceProcAddr loader, VkInstance instance, const char* name) {
    return reinterpret_cast<Function>(loader(instance, name));
}

/// volk finds vkGetDeviceProcAddr through a pointer of its own, one for the program: set it for the time of the call.
void load_table(VolkDeviceTable& table, PFN_vkGetDeviceProcAddr get_device_proc_addr, VkDevice device) {
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    vkGetDeviceProcAddr = get_device_proc_addr;
    volkLoadDeviceTable(&table, device);
    vkGetDeviceProcAddr = nullptr;
}

}  // namespace

PFN_vkGetInstanceProcAddr system_loader() {
    static std::mutex mutex;
    static PFN_vkGetInstanceProcAddr loader = nullptr;
    const std::lock_guard lock(mutex);
    if (!loader && volkInitialize() == VK_SUCCESS) loader = vkGetInstanceProcAddr;
    return loader;
}

GlobalFunctions load_global_functions(PFN_vkGetInstanceProcAddr loader) {
    GlobalFunctions f;
    f.get_instance_proc_addr = loader;
#define AUREOLE_LOAD(name)                                       \
    f.name = look_up<PFN_##name>(loader, VK_NULL_HANDLE, #name); \
    if (!f.name) missing(#name, "the loader (Vulkan 1.1 is needed)");
    AUREOLE_GLOBAL_FUNCTIONS(AUREOLE_LOAD)
#undef AUREOLE_LOAD
    return f;
}

InstanceFunctions load_instance_functions(PFN_vkGetInstanceProcAddr loader, VkInstance instance, Ownership ownership,
                                          bool debug_utils) {
    InstanceFunctions f;
    f.get_instance_proc_addr = loader;
#define AUREOLE_LOAD(name)                                 \
    f.name = look_up<PFN_##name>(loader, instance, #name); \
    if (!f.name) missing(#name, "the instance");
    AUREOLE_INSTANCE_FUNCTIONS(AUREOLE_LOAD)
    if (ownership == Ownership::own) {
        AUREOLE_OWN_INSTANCE_FUNCTIONS(AUREOLE_LOAD)
    }
    if (debug_utils) {
        AUREOLE_DEBUG_FUNCTIONS(AUREOLE_LOAD)
    }
#undef AUREOLE_LOAD
    return f;
}

DeviceFunctions load_device_functions(const InstanceFunctions& instance, VkDevice device, Ownership ownership) {
    VolkDeviceTable table = {};
    load_table(table, instance.vkGetDeviceProcAddr, device);
    DeviceFunctions f;
#define AUREOLE_LOAD(name) \
    f.name = table.name;   \
    if (!f.name) missing(#name, "the device");
    AUREOLE_DEVICE_FUNCTIONS(AUREOLE_LOAD)
    if (ownership == Ownership::own) {
        AUREOLE_OWN_DEVICE_FUNCTIONS(AUREOLE_LOAD)
    }
#undef AUREOLE_LOAD
    return f;
}

}  // namespace aureole::vulkan
