#include "physical_device.h"

#include <aureole/rhi/error.h>
#include <doctest/doctest.h>

#include <cstdio>

using namespace aureole;
using namespace aureole::vulkan;

namespace {

PhysicalDevice device_of(VkPhysicalDeviceType type, const char* name) {
    PhysicalDevice device;
    device.properties.apiVersion = VK_API_VERSION_1_1;
    device.properties.deviceType = type;
    std::snprintf(device.properties.deviceName, sizeof device.properties.deviceName, "%s", name);
    device.features.shaderStorageImageWriteWithoutFormat = VK_TRUE;
    device.queue_families = {{VK_QUEUE_COMPUTE_BIT | VK_QUEUE_GRAPHICS_BIT, 1, 64, {1, 1, 1}}};
    return device;
}

std::string names_of_choice(const std::vector<PhysicalDevice>& devices, const VulkanDeviceDesc& desc = {}) {
    std::string names;
    for (const PhysicalDevice* device : choose(devices, desc))
        names += std::string(names.empty() ? "" : ", ") + device->properties.deviceName;
    return names;
}

const PhysicalDevice software = device_of(VK_PHYSICAL_DEVICE_TYPE_CPU, "software"),
                     integrated = device_of(VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU, "integrated"),
                     shared = device_of(VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU, "shared"),
                     card = device_of(VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU, "card"),
                     second_card = device_of(VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU, "second card");

}  // namespace

TEST_CASE("the fastest kind of device comes first, equals in the loader's order, and only what can be used") {
    CHECK(names_of_choice({software, shared, integrated, card, second_card}) ==
          "card, second card, integrated, shared, software");
    CHECK(names_of_choice({software}) == "software");
    PhysicalDevice lame = card;
    lame.features = {};
    CHECK(names_of_choice({lame, software}) == "software");
    CHECK_THROWS_AS((void)choose({lame}, {}), Error);
}

TEST_CASE("index and name narrow the choice") {
    VulkanDeviceDesc desc;
    desc.index = 0;
    CHECK(names_of_choice({software, card}, desc) == "software");
    desc = {};
    desc.name = "SECOND";
    CHECK(names_of_choice({card, second_card}, desc) == "second card");
    desc.name = "card";
    CHECK(names_of_choice({software, second_card, card}, desc) == "second card, card");
    desc.index = 0;  // both must fit
    CHECK_THROWS_AS((void)choose({software, card}, desc), Error);
    CHECK_THROWS_AS((void)choose({}, {}), Error);
}

TEST_CASE("the queue is the first that draws and computes, else the first that computes") {
    const VkQueueFamilyProperties transfer = {VK_QUEUE_TRANSFER_BIT, 1, 64, {1, 1, 1}};
    const VkQueueFamilyProperties compute = {VK_QUEUE_COMPUTE_BIT, 1, 64, {1, 1, 1}};
    const VkQueueFamilyProperties draw = {VK_QUEUE_GRAPHICS_BIT, 1, 64, {1, 1, 1}};
    const VkQueueFamilyProperties all = {VK_QUEUE_COMPUTE_BIT | VK_QUEUE_GRAPHICS_BIT, 1, 64, {1, 1, 1}};
    PhysicalDevice device = card;
    device.queue_families = {transfer, compute, all, all};
    CHECK(choose_queue_family(device) == 2);
    device.queue_families = {transfer, draw, compute, compute};
    CHECK(choose_queue_family(device) == 2);
    device.queue_families = {all, compute};
    CHECK(choose_queue_family(device) == 0);
    device.queue_families = {transfer, draw};
    CHECK(problem_of(device, device.features) != "");
}
