// Recordings for queues of two families. No driver that every machine has offers two: here one pretends to, with a second
// family that computes and cannot draw. The truth makes all objects for its one family, and what they were to be shared by is
// kept.
#include <aureole/rhi/error.h>
#include <doctest/doctest.h>

#include <cstring>
#include <set>
#include <vector>

#include "aureole_rhi_tests_shaders.h"
#include "test_host.h"
#include "test_loader.h"

using namespace aureole;
using namespace aureole::rhi;
using namespace aureole::vulkan;
using namespace aureole::vulkan::test;

namespace {

constexpr VkPipelineStageFlags without_graphics =
    VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT | VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT;

VkPipelineStageFlags stages = 0;  ///< Of all barriers.
std::vector<std::pair<VkSharingMode, std::uint32_t>>
    made;  ///< Images and buffers: how, and by how many families they are shared.

void two_families(VkPhysicalDevice physical, std::uint32_t* count, VkQueueFamilyProperties* families) {
    std::uint32_t one = 1;
    VkQueueFamilyProperties truly = {};
    truth_of<PFN_vkGetPhysicalDeviceQueueFamilyProperties>("vkGetPhysicalDeviceQueueFamilyProperties")(physical, &one, &truly);
    *count = 2;
    if (!families) return;
    families[0] = families[1] = truly;
    families[1].queueFlags = VK_QUEUE_COMPUTE_BIT | VK_QUEUE_TRANSFER_BIT;
    families[1].timestampValidBits = 0;
}

template <class Info>
Info as_one_family_has_it(const Info& info) {
    made.emplace_back(info.sharingMode, info.queueFamilyIndexCount);
    if (info.queueFamilyIndexCount == 2) CHECK(info.pQueueFamilyIndices[0] + 1 == info.pQueueFamilyIndices[1]);
    Info exclusive = info;
    exclusive.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
    exclusive.queueFamilyIndexCount = 0;
    return exclusive;
}
VkResult create_image(VkDevice device, const VkImageCreateInfo* info, const VkAllocationCallbacks* callbacks, VkImage* image) {
    const VkImageCreateInfo exclusive = as_one_family_has_it(*info);
    return truth_of<PFN_vkCreateImage>("vkCreateImage")(device, &exclusive, callbacks, image);
}
VkResult create_buffer(VkDevice device, const VkBufferCreateInfo* info, const VkAllocationCallbacks* callbacks,
                       VkBuffer* buffer) {
    const VkBufferCreateInfo exclusive = as_one_family_has_it(*info);
    return truth_of<PFN_vkCreateBuffer>("vkCreateBuffer")(device, &exclusive, callbacks, buffer);
}
void barrier(VkCommandBuffer commands, VkPipelineStageFlags before, VkPipelineStageFlags after, VkDependencyFlags flags,
             std::uint32_t memory_count, const VkMemoryBarrier* memory, std::uint32_t buffer_count,
             const VkBufferMemoryBarrier* buffers, std::uint32_t image_count, const VkImageMemoryBarrier* images) {
    stages |= before | after;
    truth_of<PFN_vkCmdPipelineBarrier>("vkCmdPipelineBarrier")(commands, before, after, flags, memory_count, memory,
                                                               buffer_count, buffers, image_count, images);
}

/// A host that pretends, from here to the end of a test.
struct Pretender {
    Pretender() {
        made.clear();
        lies.tell("vkGetPhysicalDeviceQueueFamilyProperties", two_families);
        lies.tell("vkCreateImage", create_image);
        lies.tell("vkCreateBuffer", create_buffer);
        lies.tell("vkCmdPipelineBarrier", barrier);
    }
    [[nodiscard]] BorrowedVulkan lend() const {
        BorrowedVulkan lent = host.lend();
        lent.get_instance_proc_addr = lying_loader();
        lent.second_queue_family = 1;
        return lent;
    }
    Host host;
    Lies lies;
};

}  // namespace

TEST_CASE("two families: what the guest makes is shared by both, and a recording for the one without graphics keeps off it") {
    AUREOLE_NEEDS_VULKAN;
    Pretender pretender;
    Messages said;
    const auto guest = borrow_vulkan_device(pretender.lend());
    Device& device = guest->device();
    device.set_message_callback(Messages::collect, &said);
    constexpr Extent extent{7, 5, 1};
    const Texture source = device.create_texture(
        {"source", Dimension::d2, Format::rgba32_float, extent, Usage::sampled | Usage::storage | Usage::copy_destination});
    const Texture target = device.create_texture(
        {"target", Dimension::d2, Format::rgba32_float, extent, Usage::sampled | Usage::storage | Usage::copy_source});
    const Buffer upload = device.create_buffer({"upload", 7 * 5 * 16, Usage::upload});
    const Buffer result = device.create_buffer({"result", 7 * 5 * 16, Usage::read_back | Usage::copy_destination});
    const std::vector<float> texels(7 * 5 * 4, 0.75F);
    device.write_buffer(upload, std::as_bytes(std::span(texels)));
    REQUIRE(made.size() >= 4);
    for (const auto& [mode, families] : made) {
        CHECK(mode == VK_SHARING_MODE_CONCURRENT);
        CHECK(families == 2);
    }
    const Pipeline pipeline = device.create_compute_pipeline({"copy", &shaders::conformance_copy, {}});
    const Sampler sampler = device.create_sampler({Filter::nearest});
    const Binding bindings[] = {{0, source, sampler, {}}, {1, target, {}, {}}};
    const BindingSet set = device.create_binding_set({"copy set", pipeline, bindings});
    const auto move = [](CommandList& list, Texture texture, State before, State after) {
        const TextureBarrier one{texture, before, after};
        list.barrier({&one, 1}, {});
    };

    // A recording for each in turn. The texture that the first one leaves behind for fragment shaders is taken over by the
    // second.
    for (const std::uint32_t family : {VK_QUEUE_FAMILY_IGNORED, 1U, 0U, 1U}) {
        CAPTURE(family);
        stages = 0;
        CommandList& list = guest->begin_recording(pretender.host.commands(), family);
        move(list, source, State::undefined, State::copy_destination);
        list.copy(BufferToTexture{upload, source});
        move(list, source, State::copy_destination, State::sampled);
        move(list, target, State::undefined, State::storage_write);
        list.dispatch({pipeline, set, {}, {1, 2, 1}});
        move(list, target, State::storage_write, State::sampled);
        guest->end_recording();
        CHECK(((stages & VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT) == 0) == (family == 1));
        if (family == 1) CHECK((stages & ~without_graphics) == 0);
    }
    CommandList& list = guest->begin_recording(pretender.host.commands(), 1);
    move(list, target, State::sampled, State::copy_source);
    list.copy(TextureToBuffer{target, result});
    CHECK(said.joined() == "");
    list.timestamp(0);
    CHECK(said.mention("timestamp: the queue of this recording has none"));
    guest->end_recording();
    pretender.host.submit_and_wait();
    std::vector<float> got(texels.size());
    device.read_buffer(result, std::as_writable_bytes(std::span(got)));
    CHECK(got == texels);
}

TEST_CASE("a second family that is none, does not compute, or was not named is refused") {
    AUREOLE_NEEDS_VULKAN;
    Pretender pretender;
    BorrowedVulkan lent = pretender.lend();
    lent.second_queue_family = 2;
    CHECK_THROWS_WITH_AS((void)borrow_vulkan_device(lent), doctest::Contains("second_queue_family"), Error);
    lent.second_queue_family = lent.queue_family;  // none, said otherwise
    made.clear();
    const auto guest = borrow_vulkan_device(lent);
    (void)guest->device().create_buffer({"constants", 64, Usage::constants | Usage::copy_destination});
    REQUIRE(!made.empty());
    CHECK(made.back().first == VK_SHARING_MODE_EXCLUSIVE);
    CHECK_THROWS_WITH_AS((void)guest->begin_recording(pretender.host.commands(), 1), doctest::Contains("queue_family"), Error);
}
