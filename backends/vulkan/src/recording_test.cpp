// Recording in steady state allocates nothing, on the CPU or on the device; what is destroyed goes when its frame is done.
#include <doctest/doctest.h>

#include <new>

#include "aureole_rhi_conformance_shaders.h"
#include "rhi/harness.h"
#include "test_allocations.h"
#include "test_host.h"
#include "test_loader.h"

using namespace aureole;
using namespace aureole::rhi;
using namespace aureole::vulkan;
using namespace aureole::vulkan::test;

namespace {

int images_alive = 0, objects_made = 0;
VKAPI_ATTR VkResult VKAPI_CALL count_image(VkDevice device, const VkImageCreateInfo* info,
                                           const VkAllocationCallbacks* allocator, VkImage* image) {
    ++images_alive;
    return truth_of<PFN_vkCreateImage>("vkCreateImage")(device, info, allocator, image);
}
VKAPI_ATTR void VKAPI_CALL uncount_image(VkDevice device, VkImage image, const VkAllocationCallbacks* allocator) {
    if (image) --images_alive;
    truth_of<PFN_vkDestroyImage>("vkDestroyImage")(device, image, allocator);
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

TEST_CASE("binding sets find room however many there are") {
    AUREOLE_NEEDS_VULKAN;
    TestDevice vulkan;
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
}
