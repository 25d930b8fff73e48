// How long things live: objects until their last frame is done, memory and descriptors as long as somebody needs them.
#include <doctest/doctest.h>

#include "aureole_rhi_conformance_shaders.h"
#include "test_loader.h"
#include "test_support.h"

using namespace aureole;
using namespace aureole::rhi;
using namespace aureole::vulkan;
using namespace aureole::vulkan::test;

namespace {

int images_alive = 0, memory_alive = 0, refused_sets = 0;
VKAPI_ATTR VkResult VKAPI_CALL count_image(VkDevice device, const VkImageCreateInfo* info,
                                           const VkAllocationCallbacks* allocator, VkImage* image) {
    ++images_alive;
    return truth_of<PFN_vkCreateImage>("vkCreateImage")(device, info, allocator, image);
}
VKAPI_ATTR void VKAPI_CALL uncount_image(VkDevice device, VkImage image, const VkAllocationCallbacks* allocator) {
    if (image) --images_alive;
    truth_of<PFN_vkDestroyImage>("vkDestroyImage")(device, image, allocator);
}

VKAPI_ATTR VkResult VKAPI_CALL count_memory(VkDevice device, const VkMemoryAllocateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDeviceMemory* memory) {
    ++memory_alive;
    return truth_of<PFN_vkAllocateMemory>("vkAllocateMemory")(device, info, allocator, memory);
}
VKAPI_ATTR void VKAPI_CALL uncount_memory(VkDevice device, VkDeviceMemory memory, const VkAllocationCallbacks* allocator) {
    if (memory) --memory_alive;
    truth_of<PFN_vkFreeMemory>("vkFreeMemory")(device, memory, allocator);
}
VKAPI_ATTR VkResult VKAPI_CALL count_refused(VkDevice device, const VkDescriptorSetAllocateInfo* info, VkDescriptorSet* sets) {
    const VkResult result = truth_of<PFN_vkAllocateDescriptorSets>("vkAllocateDescriptorSets")(device, info, sets);
    refused_sets += result != VK_SUCCESS;
    return result;
}

}  // namespace

TEST_CASE("objects go when the frame that used them last is complete, not before and not later") {
    AUREOLE_NEEDS_VULKAN;
    Lies lies;
    lies.tell("vkCreateImage", count_image);
    lies.tell("vkDestroyImage", uncount_image);
    VulkanDeviceDesc desc;
    desc.loader = lying_loader();
    TestDevice vulkan(desc);
    Device& device = vulkan.device();
    images_alive = 0;
    const auto make = [&] {
        return device.create_texture({"short-lived", Dimension::d2, Format::rgba16_float, {4, 4, 1}, Usage::sampled});
    };
    const Texture first = make(), second = make();
    CHECK(images_alive == 2);
    device.destroy(first, 3);
    device.destroy(second, 5);
    CHECK(images_alive == 2);
    device.collect(2);
    CHECK(images_alive == 2);
    device.collect(4);
    CHECK(images_alive == 1);
    device.collect(4);
    CHECK(images_alive == 1);
    device.collect(5);
    CHECK(images_alive == 0);

    // A handle is dead at once, and never comes back.
    Messages complaints;
    device.set_message_callback(Messages::collect, &complaints);
    device.destroy(first, 6);
    CHECK(complaints.mention("destroy"));
    device.set_message_callback(nullptr, nullptr);
    CHECK(make() != first);

    // The queue's wait completes all frames submitted so far.
    const Texture third = make();
    (void)vulkan.queue().begin();
    const std::uint64_t frame = vulkan.queue().submit();
    device.destroy(third, frame);
    vulkan.queue().wait();
    CHECK(images_alive == 1);
}

TEST_CASE("memory goes back to the device when the last object in it goes") {
    AUREOLE_NEEDS_VULKAN;
    Lies lies;
    lies.tell("vkAllocateMemory", count_memory);
    lies.tell("vkFreeMemory", uncount_memory);
    VulkanDeviceDesc desc;
    desc.loader = lying_loader();
    TestDevice vulkan(desc);
    memory_alive = 0;
    for (int round = 0; round < 2; ++round) {
        std::vector<AnyHandle> objects;
        for (int i = 0; i < 20; ++i) {
            objects.push_back(vulkan.device().create_texture(
                {"small", Dimension::d2, Format::rgba16_float, {8, 8, 1}, Usage::sampled | Usage::storage}));
            objects.push_back(vulkan.device().create_buffer({"small", 1000, Usage::upload}));
        }
        CHECK(memory_alive > 0);
        CHECK(memory_alive < 10);  // shared
        for (const AnyHandle object : objects) vulkan.device().destroy(object, 1);
        vulkan.device().collect(1);
        CHECK(memory_alive == 0);
    }
}

TEST_CASE("binding sets find room however many there are, and no pool is asked for more than it has") {
    AUREOLE_NEEDS_VULKAN;
    Lies lies;
    lies.tell("vkAllocateDescriptorSets", count_refused);
    VulkanDeviceDesc desc;
    desc.loader = lying_loader();
    TestDevice vulkan(desc);
    refused_sets = 0;
    Device& device = vulkan.device();
    const Texture texture =
        device.create_texture({"volume", Dimension::d3, Format::rgba16_float, {4, 4, 4}, Usage::storage | Usage::sampled});
    const Pipeline pipeline = device.create_compute_pipeline({"fill", &shaders::conformance_fill_3d, {}});
    const Binding bindings[] = {{0, texture, {}, {}}};
    std::vector<BindingSet> sets;
    for (int round = 0; round < 3; ++round) {
        for (int i = 0; i < 200; ++i) sets.push_back(device.create_binding_set({"set", pipeline, bindings}));
        for (std::size_t i = 0; i < sets.size(); i += 2) device.destroy(sets[i], 1);
        device.collect(1);
        for (std::size_t i = sets.size(); i-- > 0;)
            if (i % 2 == 0) sets.erase(sets.begin() + static_cast<std::ptrdiff_t>(i));
    }
    CHECK(sets.size() > 64);
    CHECK(refused_sets == 0);
}
