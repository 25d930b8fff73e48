// How long things live: objects until their last frame is done, memory and descriptors as long as somebody needs them.
#include <doctest/doctest.h>

#include "aureole_rhi_tests_shaders.h"
#include "test_loader.h"
#include "test_support.h"

using namespace aureole;
using namespace aureole::rhi;
using namespace aureole::vulkan;
using namespace aureole::vulkan::test;

namespace {

int images_alive = 0, memory_alive = 0, passes_made = 0, layouts_made = 0;
std::vector<std::uint32_t> pool_sizes;

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
VKAPI_ATTR VkResult VKAPI_CALL count_pool(VkDevice device, const VkDescriptorPoolCreateInfo* info,
                                          const VkAllocationCallbacks* allocator, VkDescriptorPool* pool) {
    pool_sizes.push_back(info->maxSets);
    return truth_of<PFN_vkCreateDescriptorPool>("vkCreateDescriptorPool")(device, info, allocator, pool);
}
VKAPI_ATTR VkResult VKAPI_CALL count_layout(VkDevice device, const VkPipelineLayoutCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkPipelineLayout* layout) {
    ++layouts_made;
    return truth_of<PFN_vkCreatePipelineLayout>("vkCreatePipelineLayout")(device, info, allocator, layout);
}
VKAPI_ATTR VkResult VKAPI_CALL count_pass(VkDevice device, const VkRenderPassCreateInfo* info,
                                          const VkAllocationCallbacks* allocator, VkRenderPass* pass) {
    ++passes_made;
    return truth_of<PFN_vkCreateRenderPass>("vkCreateRenderPass")(device, info, allocator, pass);
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

TEST_CASE("binding sets find room however many there are: pools are filled before new ones are made, and refilled") {
    AUREOLE_NEEDS_VULKAN;
    Lies lies;
    lies.tell("vkCreateDescriptorPool", count_pool);
    VulkanDeviceDesc desc;
    desc.loader = lying_loader();
    TestDevice vulkan(desc);
    pool_sizes.clear();
    Device& device = vulkan.device();
    const Texture texture =
        device.create_texture({"volume", Dimension::d3, Format::rgba16_float, {4, 4, 4}, Usage::storage | Usage::sampled});
    const Pipeline pipeline = device.create_compute_pipeline({"fill", &shaders::conformance_fill_3d, {}});
    const Binding bindings[] = {{0, texture, {}, {}}};
    for (int round = 0; round < 3; ++round) {
        std::vector<BindingSet> sets;
        sets.reserve(200);
        for (int i = 0; i < 200; ++i) sets.push_back(device.create_binding_set({"set", pipeline, bindings}));
        std::uint32_t room = 0;
        for (const std::uint32_t size : pool_sizes) room += size;
        CHECK(room >= 200);
        CHECK(room - pool_sizes.back() < 200);  // the last one was needed
        for (const BindingSet set : sets) device.destroy(set, 1);
        device.collect(1);
    }
}

TEST_CASE("pipelines of one shader share their layout") {
    AUREOLE_NEEDS_VULKAN;
    Lies lies;
    lies.tell("vkCreatePipelineLayout", count_layout);
    VulkanDeviceDesc desc;
    desc.loader = lying_loader();
    TestDevice vulkan(desc);
    layouts_made = 0;
    const Specialization values[] = {{0, 3}};
    (void)vulkan.device().create_compute_pipeline({"one", &shaders::conformance_constants, {}});
    (void)vulkan.device().create_compute_pipeline({"two", &shaders::conformance_constants, values});
    CHECK(layouts_made == 1);
    (void)vulkan.device().create_compute_pipeline({"other", &shaders::conformance_increment, {}});
    CHECK(layouts_made == 2);
}

TEST_CASE("targets and pipelines of one format share a render pass") {
    AUREOLE_NEEDS_VULKAN;
    Lies lies;
    lies.tell("vkCreateRenderPass", count_pass);
    VulkanDeviceDesc desc;
    desc.loader = lying_loader();
    TestDevice vulkan(desc);
    passes_made = 0;
    for (const Format format : {Format::rgba8_unorm, Format::rgba16_float})
        for (int i = 0; i < 3; ++i) {
            (void)vulkan.device().create_texture({"target", Dimension::d2, format, {4, 4, 1}, Usage::color_attachment});
            (void)vulkan.device().create_raster_pipeline({"draw", &shaders::conformance_draw, {}, format});
        }
    CHECK(passes_made == 2);
}
