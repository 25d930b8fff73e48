#define VOLK_IMPLEMENTATION
#include "host_vulkan/calls.h"

#include <atomic>
#include <string_view>

namespace host_vulkan {
namespace {

std::atomic<std::uint64_t> made = 0;
PFN_vkGetInstanceProcAddr loader = nullptr;
PFN_vkGetDeviceProcAddr device_loader = nullptr;

/// A function with the signature of one of Vulkan's that counts and goes on to it. No two below have the same signature.
template <class Function>
struct Counted;
template <class Result, class... Arguments>
struct Counted<Result(VKAPI_PTR*)(Arguments...)> {
    static inline PFN_vkVoidFunction real = nullptr;
    static VKAPI_ATTR Result VKAPI_CALL call(Arguments... arguments) {
        ++made;
        return reinterpret_cast<Result(VKAPI_PTR*)(Arguments...)>(real)(arguments...);
    }
};

struct Entry {
    std::string_view name;
    PFN_vkVoidFunction call;
    PFN_vkVoidFunction* real;
};
template <class Function>
Entry entry(std::string_view name) {
    using Call = Counted<Function>;
    return {name, reinterpret_cast<PFN_vkVoidFunction>(&Call::call), &Call::real};
}
#define ENTRY(function) entry<PFN_##function>(#function)
const Entry entries[] = {
    ENTRY(vkAllocateMemory),
    ENTRY(vkCreateBuffer),
    ENTRY(vkCreateImage),
    ENTRY(vkCreateImageView),
    ENTRY(vkCreateSampler),
    ENTRY(vkCreateDescriptorPool),
    ENTRY(vkAllocateDescriptorSets),
    ENTRY(vkCreateDescriptorSetLayout),
    ENTRY(vkCreatePipelineLayout),
    ENTRY(vkCreateGraphicsPipelines),
    ENTRY(vkCreateComputePipelines),
    ENTRY(vkCreateShaderModule),
    ENTRY(vkCreateRenderPass),
    ENTRY(vkCreateFramebuffer),
    ENTRY(vkCreateCommandPool),
    ENTRY(vkAllocateCommandBuffers),
    ENTRY(vkCreateFence),
    ENTRY(vkCreateSemaphore),
    ENTRY(vkCreateQueryPool),
    ENTRY(vkCreateSwapchainKHR),
};
#undef ENTRY

PFN_vkVoidFunction counted(PFN_vkVoidFunction found, std::string_view name) {
    if (!found) return nullptr;
    for (const Entry& known : entries)
        if (known.name == name) {
            *known.real = found;
            return known.call;
        }
    return found;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL counted_device_proc_addr(VkDevice device, const char* name) {
    return counted(device_loader(device, name), name);
}

}  // namespace

PFN_vkVoidFunction counted_proc_addr(VkInstance instance, const char* name) {
    const PFN_vkVoidFunction found = loader(instance, name);
    if (std::string_view(name) == "vkGetInstanceProcAddr") return reinterpret_cast<PFN_vkVoidFunction>(&counted_proc_addr);
    if (std::string_view(name) == "vkGetDeviceProcAddr" && found) {
        device_loader = reinterpret_cast<PFN_vkGetDeviceProcAddr>(found);
        return reinterpret_cast<PFN_vkVoidFunction>(&counted_device_proc_addr);
    }
    return counted(found, name);
}

void open_vulkan() {
    check(volkInitialize(), "volkInitialize (is libvulkan.so.1 there?)");
    loader = vkGetInstanceProcAddr;
    volkInitializeCustom(counted_proc_addr);
}

std::uint64_t vulkan_objects_made() noexcept { return made; }

}  // namespace host_vulkan
