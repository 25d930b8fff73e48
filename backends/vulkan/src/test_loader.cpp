#include "test_loader.h"

#include <vulkan/vulkan.h>

#include <map>

namespace aureole::vulkan::test {
namespace {

std::map<std::string, PFN_vkVoidFunction> lies, truths;

PFN_vkVoidFunction answer(const char* name, PFN_vkVoidFunction real) {
    if (real) truths[name] = real;
    const auto lie = lies.find(name);
    return lie == lies.end() ? real : lie->second;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL device_function(VkDevice device, const char* name) {
    return answer(name, vkGetDeviceProcAddr(device, name));
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL instance_function(VkInstance instance, const char* name) {
    const PFN_vkVoidFunction found = answer(name, vkGetInstanceProcAddr(instance, name));
    if (found && std::string(name) == "vkGetDeviceProcAddr") return reinterpret_cast<PFN_vkVoidFunction>(device_function);
    return found;
}

}  // namespace

PFN_vkGetInstanceProcAddr lying_loader() { return instance_function; }

Lies::~Lies() { lies.clear(); }

void Lies::tell(const std::string& name, PFN_vkVoidFunction replacement) { lies[name] = replacement; }

PFN_vkVoidFunction truth(const std::string& name) { return truths.at(name); }

}  // namespace aureole::vulkan::test
