// The guest on a host's device: works there, leaves everything as found, and refuses what cannot work by name.
#include <aureole/rhi/error.h>
#include <doctest/doctest.h>

#include <cstring>
#include <functional>

#include "aureole_rhi_tests_shaders.h"
#include "test_function_names.h"
#include "test_host.h"
#include "test_loader.h"

using namespace aureole;
using namespace aureole::rhi;
using namespace aureole::vulkan;
using namespace aureole::vulkan::test;

namespace {

constexpr VkExtent2D extent = {7, 5};
constexpr std::size_t texels = 7 * 5;

std::vector<float> floats(const std::vector<std::byte>& bytes) {
    std::vector<float> values(bytes.size() / sizeof(float));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
}

ExternalTexture lend(const HostImage& image, const char* name, Format format, Usage usage, State state) {
    ExternalTexture external;
    external.desc = {name, Dimension::d2, format, {extent.width, extent.height, 1}, usage};
    external.native = reinterpret_cast<std::uint64_t>(image.image);
    external.state = state;
    return external;
}

void move(CommandList& list, Texture texture, State before, State after) {
    const TextureBarrier barrier{texture, before, after};
    list.barrier({&barrier, 1}, {});
}

/// Copies the texels of one texture into another, on the guest.
struct CopyWork {
    CopyWork(rhi::Device& device, Texture source, Texture target) {
        pipeline = device.create_compute_pipeline({"copy", &shaders::conformance_copy, {}});
        const Sampler sampler = device.create_sampler({Filter::nearest});
        const Binding bindings[] = {{0, source, sampler, {}}, {1, target, {}, {}}};
        set = device.create_binding_set({"copy set", pipeline, bindings});
    }
    void record(CommandList& list) const { list.dispatch({pipeline, set, {}, {1, 2, 1}}); }
    Pipeline pipeline;
    BindingSet set;
};

Error refusal(const BorrowedVulkan& host) {
    try {
        (void)borrow_vulkan_device(host);
    } catch (const Error& error) {
        return error;
    }
    FAIL("was accepted");
    return Error(ErrorCode::internal, "");
}

}  // namespace

TEST_CASE("the guest reads and writes the host's images inside the host's command buffer, and gives them back as lent") {
    AUREOLE_NEEDS_VULKAN;
    Host host;
    HostImage& color = host.make_image_2d(VK_FORMAT_R32G32B32A32_SFLOAT, extent,
                                          VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
    HostImage& result = host.make_image_2d(VK_FORMAT_R32G32B32A32_SFLOAT, extent, VK_IMAGE_USAGE_STORAGE_BIT);
    const auto guest = borrow_vulkan_device(host.lend());
    Device& device = guest->device();
    device.set_message_callback(Messages::collect, &host.messages);

    const Texture source = device.wrap_texture(
        lend(color, "host colour", Format::rgba32_float, Usage::sampled | Usage::color_attachment, State::color_attachment));
    const Texture target = device.wrap_texture(
        lend(result, "host result", Format::rgba32_float, Usage::storage | Usage::copy_source, State::copy_source));
    const CopyWork work(device, source, target);

    for (int frame = 0; frame < 3; ++frame) {
        host.clear_color(color, 0.25f + static_cast<float>(frame), -2, 3, 4);
        host.move(color, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
        host.move(result, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
        CommandList& list = guest->begin_recording(host.commands());
        list.begin_marker("guest");  // left open: end_recording closes it
        move(list, source, State::color_attachment, State::sampled);
        move(list, target, State::undefined, State::storage_write);
        work.record(list);
        guest->end_recording();
        // The host goes on with its images in the layouts it lent them in. The validation layer knows the real ones.
        const auto got = floats(host.read(result, {extent.width, extent.height, 1}, texels * 16));
        for (std::size_t i = 0; i < texels; ++i) CHECK(got[4 * i] == 0.25f + static_cast<float>(frame));
        CHECK(got[1] == -2);
        const auto kept = floats(host.read(color, {extent.width, extent.height, 1}, texels * 16));
        CHECK(kept[2] == 3);
        CHECK(kept[4 * texels - 1] == 4);
        CHECK(host.messages.joined() == "");
    }
}

TEST_CASE("a host's depth is read in either of its read-only states and kept") {
    AUREOLE_NEEDS_VULKAN;
    struct {
        State state;
        VkImageLayout layout;
    } cases[] = {{State::depth_read, VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL},
                 {State::sampled, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL},
                 {State::general, VK_IMAGE_LAYOUT_GENERAL}};
    for (const auto& c : cases) {
        const State state = c.state;
        CAPTURE(to_string(state));
        Host host;
        HostImage& depth = host.make_image_2d(VK_FORMAT_D32_SFLOAT, extent,
                                              VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
        HostImage& result = host.make_image_2d(VK_FORMAT_R32G32B32A32_SFLOAT, extent, VK_IMAGE_USAGE_STORAGE_BIT);
        const auto guest = borrow_vulkan_device(host.lend());
        const Texture source =
            guest->device().wrap_texture(lend(depth, "host depth", Format::d32_float, Usage::sampled, state));
        const Texture target =
            guest->device().wrap_texture(lend(result, "host result", Format::rgba32_float, Usage::storage, State::general));
        const CopyWork work(guest->device(), source, target);
        host.clear_depth(depth, 0.625f);
        host.move(depth, c.layout);
        host.move(result, VK_IMAGE_LAYOUT_GENERAL);
        CommandList& list = guest->begin_recording(host.commands());
        move(list, source, state, State::depth_read);
        move(list, target, State::general, State::storage_write);
        work.record(list);
        guest->end_recording();
        CHECK(floats(host.read(result, {extent.width, extent.height, 1}, texels * 16))[4] == 0.625f);
        CHECK(floats(host.read(depth, {extent.width, extent.height, 1}, texels * 4))[3] == 0.625f);
        CHECK(host.messages.joined() == "");
    }
}

TEST_CASE("the guest draws into a host's target, through a view of its own or the host's") {
    AUREOLE_NEEDS_VULKAN;
    for (const bool own_view : {false, true}) {
        Host host;
        HostImage& image = host.make_image_2d(VK_FORMAT_R32G32B32A32_SFLOAT, extent, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
        VkImageViewCreateInfo info = {};
        info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
        info.image = image.image;
        info.viewType = VK_IMAGE_VIEW_TYPE_2D;
        info.format = VK_FORMAT_R32G32B32A32_SFLOAT;
        info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        VkImageView view = VK_NULL_HANDLE;
        REQUIRE(vkCreateImageView(host.device(), &info, nullptr, &view) == VK_SUCCESS);
        {
            const auto guest = borrow_vulkan_device(host.lend());
            Device& device = guest->device();
            ExternalTexture external =
                lend(image, "host target", Format::rgba32_float, Usage::color_attachment, State::color_attachment);
            if (!own_view) external.native_view = reinterpret_cast<std::uint64_t>(view);
            const Texture target = device.wrap_texture(external);
            const Texture canvas = device.create_texture(
                {"canvas", Dimension::d2, Format::rgba32_float, {7, 5, 1}, Usage::sampled | Usage::color_attachment});
            const Pipeline pipeline =
                device.create_raster_pipeline({"draw", &shaders::conformance_draw, {}, Format::rgba32_float});
            const Binding binding[] = {{0, canvas, device.create_sampler({Filter::nearest}), {}}};
            const BindingSet set = device.create_binding_set({"draw set", pipeline, binding});
            const Texture empty = device.create_texture(
                {"empty", Dimension::d2, Format::rgba32_float, {7, 5, 1}, Usage::sampled | Usage::copy_destination});
            const Buffer zeros = device.create_buffer({"zeros", texels * 16, Usage::upload});
            device.write_buffer(zeros, std::vector<std::byte>(texels * 16));
            const Binding from_empty[] = {{0, empty, device.create_sampler({Filter::nearest}), {}}};
            const BindingSet start = device.create_binding_set({"start set", pipeline, from_empty});

            host.move(image, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
            CommandList& list = guest->begin_recording(host.commands());
            move(list, empty, State::undefined, State::copy_destination);
            list.copy(BufferToTexture{zeros, empty});
            move(list, empty, State::copy_destination, State::sampled);
            move(list, canvas, State::undefined, State::color_attachment);
            const float first[8] = {1, 10, 0, 0, 0.5f, 0, 0, 0}, second[8] = {0, 0, 0, 0, 0, 0, 0, 2};
            list.draw_fullscreen({pipeline, start, std::as_bytes(std::span(first)), canvas});
            move(list, canvas, State::color_attachment, State::sampled);
            list.draw_fullscreen({pipeline, set, std::as_bytes(std::span(second)), target});
            guest->end_recording();
            const auto got = floats(host.read(image, {extent.width, extent.height, 1}, texels * 16));
            for (std::size_t i = 0; i < texels; ++i) {
                const std::size_t row = i / 7;
                CHECK(got[4 * i] == 0.5f + static_cast<float>(i % 7));
                CHECK(got[4 * i + 1] == 10 * static_cast<float>(row));
                CHECK(got[4 * i + 3] == 2);
            }
        }
        vkDestroyImageView(host.device(), view, nullptr);  // the host's view is still there
    }
}

TEST_CASE("a texture lent in an undefined state is taken over, and forgetting it leaves the host's image") {
    AUREOLE_NEEDS_VULKAN;
    Host host;
    HostImage& image = host.make_image_2d(VK_FORMAT_R16G16B16A16_SFLOAT, extent, VK_IMAGE_USAGE_STORAGE_BIT);
    const auto guest = borrow_vulkan_device(host.lend());
    const Texture lent = guest->device().wrap_texture(
        lend(image, "discarded", Format::rgba16_float, Usage::storage | Usage::copy_source, State::undefined));
    for (int recording = 0; recording < 2; ++recording) {
        host.clear_color(image, 1, 1, 1, 1);  // work of the host on it that the guest has to wait for
        CommandList& list = guest->begin_recording(host.commands());
        move(list, lent, State::undefined, State::storage_write);
        move(list, lent, State::storage_write, State::copy_source);
        guest->end_recording();
        image.layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;  // where the guest left it
    }
    host.submit_and_wait();
    guest->device().destroy(lent, 1);
    guest->device().collect(1);
    CHECK(host.read(image, {extent.width, extent.height, 1}, 8).size() == 8);
}

TEST_CASE("a texture that is forgotten while it is away from the state it was lent in is returned to it all the same") {
    AUREOLE_NEEDS_VULKAN;
    Host host;
    HostImage& image =
        host.make_image_2d(VK_FORMAT_R16G16B16A16_SFLOAT, extent, VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT);
    const auto guest = borrow_vulkan_device(host.lend());
    std::uint64_t frame = 0;
    const auto lend_again = [&] {
        return guest->device().wrap_texture(
            lend(image, "forgotten", Format::rgba16_float, Usage::storage | Usage::sampled, State::sampled));
    };
    for (int round = 0; round < 2; ++round) {
        host.move(image, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        const Texture lent = lend_again();
        CommandList& list = guest->begin_recording(host.commands());
        move(list, lent, State::sampled, State::storage_write);
        guest->device().destroy(lent, ++frame);
        guest->end_recording();
        // A recording that comes before the frame is complete has nothing to return any more.
        (void)guest->begin_recording(host.commands());
        guest->end_recording();
        CHECK(host.read(image, {extent.width, extent.height, 1}, 8).size() == 8);  // from the layout it was lent in
        guest->device().collect(frame);
    }
}

TEST_CASE("outside of a recording the guest's list records nothing and says so") {
    AUREOLE_NEEDS_VULKAN;
    Host host;
    const auto guest = borrow_vulkan_device(host.lend());
    Messages complaints;
    guest->device().set_message_callback(Messages::collect, &complaints);
    CHECK_THROWS_AS((void)guest->begin_recording(VK_NULL_HANDLE), Error);
    CommandList& list = guest->begin_recording(host.commands());
    guest->end_recording();
    guest->end_recording();
    CHECK(complaints.joined() == "");
    list.begin_marker("late");
    list.timestamp(0);
    list.barrier({}, {});
    CHECK(complaints.texts.size() == 3);
    CHECK(complaints.mention("not recording"));
    complaints.texts.clear();

    (void)guest->begin_recording(host.commands());
    (void)guest->begin_recording(host.commands());
    CHECK(complaints.mention("was not ended"));
    guest->end_recording();
    guest->device().set_message_callback(nullptr, nullptr);
    host.submit_and_wait();
}

namespace {
VkPipelineCache cache_in_use = VK_NULL_HANDLE;
VKAPI_ATTR VkResult VKAPI_CALL note_cache(VkDevice device, VkPipelineCache cache, uint32_t count,
                                          const VkComputePipelineCreateInfo* infos, const VkAllocationCallbacks* allocator,
                                          VkPipeline* pipelines) {
    cache_in_use = cache;
    return truth_of<PFN_vkCreateComputePipelines>("vkCreateComputePipelines")(device, cache, count, infos, allocator,
                                                                              pipelines);
}
}  // namespace

TEST_CASE("a host's pipeline cache is used and stays the host's; without one the guest has its own") {
    AUREOLE_NEEDS_VULKAN;
    Host host;
    BorrowedVulkan lent = host.lend();
    lent.get_instance_proc_addr = lying_loader();
    Lies lies;
    lies.tell("vkCreateComputePipelines", note_cache);
    (void)borrow_vulkan_device(lent)->device().create_compute_pipeline({"copy", &shaders::conformance_copy, {}});
    CHECK(cache_in_use != VK_NULL_HANDLE);

    lent.pipeline_cache = host.make_pipeline_cache();
    CHECK(cache_in_use != lent.pipeline_cache);
    (void)borrow_vulkan_device(lent)->device().create_compute_pipeline({"copy", &shaders::conformance_copy, {}});
    CHECK(cache_in_use == lent.pipeline_cache);
    std::size_t size = 0;
    CHECK(vkGetPipelineCacheData(host.device(), lent.pipeline_cache, &size, nullptr) == VK_SUCCESS);  // alive
}

TEST_CASE("what a host forgot or lacks is refused by name, and nothing is left behind") {
    AUREOLE_NEEDS_VULKAN;
    Host host;
    const auto check = [&](const char* part, ErrorCode code, const std::function<void(BorrowedVulkan&)>& spoil) {
        BorrowedVulkan lent = host.lend();
        spoil(lent);
        const Error error = refusal(lent);
        CAPTURE(error.what());
        CHECK(error.code() == code);
        CHECK(std::string(error.what()).find(part) != std::string::npos);
    };
    const auto invalid = ErrorCode::invalid_argument, unsupported = ErrorCode::unsupported;
    check("instance", invalid, [](auto& h) { h.instance = VK_NULL_HANDLE; });
    check("physical_device", invalid, [](auto& h) { h.physical_device = VK_NULL_HANDLE; });
    check("device", invalid, [](auto& h) { h.device = VK_NULL_HANDLE; });
    check("get_instance_proc_addr", invalid, [](auto& h) { h.get_instance_proc_addr = nullptr; });
    check("queue_family", invalid, [](auto& h) { h.queue_family = 1000; });
    check("api_version", unsupported, [](auto& h) { h.api_version = 0; });
    check("1.0.0", unsupported, [](auto& h) { h.api_version = VK_API_VERSION_1_0; });
    check("shaderStorageImageWriteWithoutFormat", unsupported, [](auto& h) { h.enabled_features = {}; });
}

TEST_CASE("every entry point that a guest needs is missed by name, and no other is needed") {
    AUREOLE_NEEDS_VULKAN;
    Host host;
    BorrowedVulkan lent = host.lend();
    lent.get_instance_proc_addr = lying_loader();
    for (const std::string& name : functions_of_guests()) {
        Lies lies;
        lies.tell(name, PFN_vkVoidFunction{});
        const Error error = refusal(lent);
        CAPTURE(name);
        CHECK(error.code() == ErrorCode::unsupported);
        CHECK(std::string(error.what()).find(name) != std::string::npos);
    }
    // What only an owner calls: a guest does without, so it cannot submit, wait, or destroy the host's device.
    Lies lies;
    for (const std::string& name : functions_of_owners()) lies.tell(name, PFN_vkVoidFunction{});
    CHECK_NOTHROW((void)borrow_vulkan_device(lent));
}
