// Recording in steady state allocates nothing, on the CPU or on the device, and leaves nothing open.
#include <doctest/doctest.h>

#include <new>

#include "aureole_rhi_tests_shaders.h"
#include "rhi/harness.h"
#include "test_allocations.h"
#include "test_host.h"
#include "test_loader.h"

using namespace aureole;
using namespace aureole::rhi;
using namespace aureole::vulkan;
using namespace aureole::vulkan::test;

namespace {

int objects_made = 0, labels_open = 0, host_barriers = 0;
VKAPI_ATTR void VKAPI_CALL open_label(VkCommandBuffer commands, const VkDebugUtilsLabelEXT* label) {
    ++labels_open;
    truth_of<PFN_vkCmdBeginDebugUtilsLabelEXT>("vkCmdBeginDebugUtilsLabelEXT")(commands, label);
}
VKAPI_ATTR void VKAPI_CALL close_label(VkCommandBuffer commands) {
    --labels_open;
    truth_of<PFN_vkCmdEndDebugUtilsLabelEXT>("vkCmdEndDebugUtilsLabelEXT")(commands);
}
VKAPI_ATTR void VKAPI_CALL note_host_barrier(VkCommandBuffer commands, VkPipelineStageFlags source, VkPipelineStageFlags target,
                                             VkDependencyFlags flags, uint32_t memory_count, const VkMemoryBarrier* memory,
                                             uint32_t buffer_count, const VkBufferMemoryBarrier* buffers, uint32_t image_count,
                                             const VkImageMemoryBarrier* images) {
    for (uint32_t i = 0; i < buffer_count; ++i)
        host_barriers += source == VK_PIPELINE_STAGE_TRANSFER_BIT && target == VK_PIPELINE_STAGE_HOST_BIT &&
                         buffers[i].srcAccessMask == VK_ACCESS_TRANSFER_WRITE_BIT &&
                         buffers[i].dstAccessMask == VK_ACCESS_HOST_READ_BIT;
    truth_of<PFN_vkCmdPipelineBarrier>("vkCmdPipelineBarrier")(commands, source, target, flags, memory_count, memory,
                                                               buffer_count, buffers, image_count, images);
}

/// Counts the calls of a creating function.
template <class Function, int Tag>
struct Counted;
template <class... Arguments, int Tag>
struct Counted<VkResult(VKAPI_PTR*)(Arguments...), Tag> {
    static inline const char* name = nullptr;
    static VKAPI_ATTR VkResult VKAPI_CALL call(Arguments... arguments) {
        ++objects_made;
        return truth_of<VkResult(VKAPI_PTR*)(Arguments...)>(name)(arguments...);
    }
    static void tell(Lies& lies, const char* function) {
        name = function;
        lies.tell(function, call);
    }
};

/// A frame with every kind of command.
class Frame {
public:
    explicit Frame(rhi::Device& device) {
        const Extent extent{8, 8, 1};
        const Usage usage = Usage::sampled | Usage::storage | Usage::copy_source | Usage::copy_destination;
        first_ = device.create_texture({"a rather long name of a texture", Dimension::d2, Format::rgba32_float, extent, usage});
        second_ = device.create_texture({"second", Dimension::d2, Format::rgba32_float, extent, usage});
        target_ = device.create_texture(
            {"target", Dimension::d2, Format::rgba16_float, extent, Usage::color_attachment | Usage::copy_source});
        result_ = device.create_buffer({"result", 8 * 8 * 8, Usage::read_back});
        constants_ = device.create_buffer({"constants", 96, Usage::constants});
        table_ = device.create_texture({"table", Dimension::d2, Format::rgba32_float, {6, 1, 1}, Usage::storage});
        const Sampler sampler = device.create_sampler({Filter::nearest});
        const auto set = [&](Pipeline pipeline, std::initializer_list<Binding> bindings) {
            return device.create_binding_set({"set", pipeline, {bindings.begin(), bindings.size()}});
        };
        step_ = device.create_compute_pipeline({"step", &shaders::conformance_increment, {}});
        step_set_ = set(step_, {{0, first_, sampler, {}}, {1, second_, {}, {}}});
        fill_ = device.create_compute_pipeline({"fill", &shaders::conformance_constants, {}});
        fill_set_ = set(fill_, {{0, {}, {}, constants_}, {1, table_, {}, {}}});
        draw_ = device.create_raster_pipeline({"draw", &shaders::conformance_draw, {}, Format::rgba16_float});
        draw_set_ = set(draw_, {{0, second_, sampler, {}}});
    }

    void record(CommandList& list) const {
        const std::byte bytes[96] = {};
        list.begin_marker("frame");
        list.timestamp(0);
        move(list, constants_, State::undefined, State::copy_destination);
        list.update_constants(constants_, bytes);
        move(list, constants_, State::copy_destination, State::constants);
        move(list, table_, State::undefined, State::storage_write);
        list.dispatch({fill_, fill_set_, std::span(bytes).first(32), {1, 1, 1}});
        TextureBarrier many[40];  // more than any one batch holds
        for (TextureBarrier& barrier : many) barrier = {table_, State::storage_write, State::storage_write};
        list.barrier(many, {});
        move(list, second_, State::undefined, State::copy_destination);
        move(list, first_, State::undefined, State::copy_source);
        list.copy(TextureToTexture{first_, second_});
        move(list, first_, State::copy_source, State::sampled);
        move(list, second_, State::copy_destination, State::storage_write);
        list.dispatch({step_, step_set_, std::span(bytes).first(16), {1, 1, 1}});
        move(list, second_, State::storage_write, State::sampled);
        move(list, target_, State::undefined, State::color_attachment);
        list.draw_fullscreen({draw_, draw_set_, std::span(bytes).first(32), target_});
        move(list, target_, State::color_attachment, State::copy_source);
        move(list, result_, State::undefined, State::copy_destination);
        list.copy(TextureToBuffer{target_, result_});
        list.timestamp(1);
        list.end_marker();
    }

private:
    static void move(CommandList& list, Texture texture, State before, State after) {
        const TextureBarrier barrier{texture, before, after};
        list.barrier({&barrier, 1}, {});
    }
    static void move(CommandList& list, Buffer buffer, State before, State after) {
        const BufferBarrier barrier{buffer, before, after};
        list.barrier({}, {&barrier, 1});
    }
    Texture first_, second_, target_, table_;
    Buffer result_, constants_;
    Pipeline step_, fill_, draw_;
    BindingSet step_set_, fill_set_, draw_set_;
};

}  // namespace

TEST_CASE("the frame of the next test is right in the eyes of the validation layer") {
    AUREOLE_NEEDS_VULKAN;
    Host host;
    const auto guest = borrow_vulkan_device(host.lend());
    guest->device().set_message_callback(Messages::collect, &host.messages);
    const Frame frame(guest->device());
    for (int i = 0; i < 3; ++i) {
        frame.record(guest->begin_recording(host.commands()));
        guest->end_recording();
        host.submit_and_wait();
    }
}

TEST_CASE("after the first frame recording allocates nothing and makes no Vulkan object") {
    AUREOLE_NEEDS_VULKAN;
    Host host(false);  // the layer allocates for itself
    Lies lies;
    Counted<PFN_vkAllocateMemory, 0>::tell(lies, "vkAllocateMemory");
    Counted<PFN_vkAllocateDescriptorSets, 1>::tell(lies, "vkAllocateDescriptorSets");
    Counted<PFN_vkCreateFramebuffer, 2>::tell(lies, "vkCreateFramebuffer");
    Counted<PFN_vkCreateImageView, 3>::tell(lies, "vkCreateImageView");
    Counted<PFN_vkCreateRenderPass, 4>::tell(lies, "vkCreateRenderPass");
    Counted<PFN_vkCreateGraphicsPipelines, 5>::tell(lies, "vkCreateGraphicsPipelines");
    Counted<PFN_vkCreateComputePipelines, 6>::tell(lies, "vkCreateComputePipelines");
    BorrowedVulkan lent = host.lend();
    lent.get_instance_proc_addr = lying_loader();
    const auto guest = borrow_vulkan_device(lent);
    const Frame frame(guest->device());
    CHECK(objects_made > 5);
    for (int i = 0; i < 3; ++i) {
        const VkCommandBuffer commands = host.commands();
        objects_made = 0;
        count_allocations(true);
        frame.record(guest->begin_recording(commands));
        guest->end_recording();
        count_allocations(false);
        CHECK(objects_made == 0);
        if (i > 0) CHECK(counted_allocations() == 0);
        host.submit_and_wait();
    }
    // The counter does count.
    count_allocations(true);
    ::operator delete(::operator new(4));
    count_allocations(false);
    CHECK(counted_allocations() == 1);
}

TEST_CASE("what the CPU reads back is made visible to it") {
    // No check of the layer and no coherent device shows this one missing: the command itself is looked for.
    AUREOLE_NEEDS_VULKAN;
    Host host;
    Lies lies;
    lies.tell("vkCmdPipelineBarrier", note_host_barrier);
    BorrowedVulkan lent = host.lend();
    lent.get_instance_proc_addr = lying_loader();
    const auto guest = borrow_vulkan_device(lent);
    const Frame frame(guest->device());
    host_barriers = 0;
    frame.record(guest->begin_recording(host.commands()));  // copies into one read_back buffer
    guest->end_recording();
    CHECK(host_barriers == 1);
    host.submit_and_wait();
}

TEST_CASE("markers that are left open end with the recording") {
    AUREOLE_NEEDS_VULKAN;
    Host host;
    Lies lies;
    lies.tell("vkCmdBeginDebugUtilsLabelEXT", open_label);
    lies.tell("vkCmdEndDebugUtilsLabelEXT", close_label);
    BorrowedVulkan lent = host.lend();
    lent.get_instance_proc_addr = lying_loader();
    const auto guest = borrow_vulkan_device(lent);
    labels_open = 0;
    CommandList& list = guest->begin_recording(host.commands());
    list.begin_marker("one");
    list.begin_marker("two");
    list.begin_marker(nullptr);
    CHECK(labels_open == 3);
    list.end_marker();
    CHECK(labels_open == 2);
    guest->end_recording();
    CHECK(labels_open == 0);
    host.submit_and_wait();
}

TEST_CASE("the queue is used in order: begin, submit, wait") {
    AUREOLE_NEEDS_VULKAN;
    TestDevice vulkan;
    CHECK_NOTHROW(vulkan.queue().wait());  // nothing to wait for
    CHECK_THROWS_AS((void)vulkan.queue().submit(), Error);
    CommandList& list = vulkan.queue().begin();
    CHECK_THROWS_AS((void)vulkan.queue().begin(), Error);
    CHECK(vulkan.queue().submit() == 1);
    Messages complaints;
    vulkan.device().set_message_callback(Messages::collect, &complaints);
    list.end_marker();  // after submission
    CHECK(complaints.mention("not recording"));
    complaints.texts.clear();
    vulkan.queue().begin().end_marker();  // none is open
    CHECK(complaints.mention("no marker"));
    vulkan.device().set_message_callback(nullptr, nullptr);
    CHECK(vulkan.queue().submit() == 2);
}
