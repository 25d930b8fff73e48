#include "context.h"

#include "result.h"

namespace aureole::vulkan {
namespace {

VkPhysicalDeviceMemoryProperties memory_properties(const ContextDesc& desc) {
    VkPhysicalDeviceMemoryProperties properties = {};
    desc.functions.vkGetPhysicalDeviceMemoryProperties(desc.physical.handle, &properties);
    return properties;
}

}  // namespace

Context::Context(const ContextDesc& desc)
    : instance_functions(desc.functions),
      fn(load_device_functions(desc.functions, desc.device, desc.ownership)),
      instance(desc.instance),
      physical(desc.physical),
      device(desc.device),
      queue_family(desc.queue_family),
      families{desc.queue_family, desc.second_queue_family},
      graphics(desc.physical.has_graphics(desc.queue_family)),
      debug_utils(desc.debug_utils),
      memory(fn, desc.device, memory_properties(desc), desc.physical.properties.limits.maxMemoryAllocationCount,
             desc.physical.max_allocation_size),
      pipeline_cache(desc.pipeline_cache),
      own_pipeline_cache_(desc.pipeline_cache == VK_NULL_HANDLE) {
    if (!own_pipeline_cache_) return;
    VkPipelineCacheCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
    check_result(fn.vkCreatePipelineCache(device, &info, nullptr, &pipeline_cache), "vkCreatePipelineCache", "pipeline cache");
}

Context::~Context() {
    if (own_pipeline_cache_) fn.vkDestroyPipelineCache(device, pipeline_cache, nullptr);
}

void Context::set_name(VkObjectType type, std::uint64_t handle, const std::string& name) const noexcept {
    if (!debug_utils || name.empty()) return;
    VkDebugUtilsObjectNameInfoEXT info = {};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT;
    info.objectType = type;
    info.objectHandle = handle;
    info.pObjectName = name.c_str();
    instance_functions.vkSetDebugUtilsObjectNameEXT(device, &info);
}

}  // namespace aureole::vulkan
