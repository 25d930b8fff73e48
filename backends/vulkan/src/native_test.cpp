// The native objects behind handles: a host samples the guest's texture and copies the guest's buffer with commands of its own.
#include <aureole/rhi/error.h>
#include <doctest/doctest.h>

#include <cstring>
#include <functional>
#include <numeric>

#include "aureole_rhi_tests_shaders.h"
#include "test_program.h"

using namespace aureole;
using namespace aureole::rhi;
using namespace aureole::vulkan;
using namespace aureole::vulkan::test;

namespace {

constexpr VkExtent2D extent = {7, 5};
constexpr std::size_t floats = std::size_t{4} * 7 * 5;

const std::vector<float>& numbers() {
    static const std::vector<float> values = [] {
        std::vector<float> v(floats);
        std::iota(v.begin(), v.end(), 0.25f);
        return v;
    }();
    return values;
}

bool holds(const std::vector<std::byte>& bytes, const std::vector<float>& expected) {
    return bytes.size() == expected.size() * sizeof(float) && std::memcmp(bytes.data(), expected.data(), bytes.size()) == 0;
}

void move(CommandList& list, Texture texture, State before, State after) {
    const TextureBarrier barrier{texture, before, after};
    list.barrier({&barrier, 1}, {});
}

void refused(const std::function<void()>& call, const char* kind, const char* value) {
    try {
        call();
    } catch (const Error& error) {
        CHECK(error.code() == ErrorCode::invalid_argument);
        CHECK(error.field() == kind);
        CHECK(error.value() == value);
        return;
    }
    FAIL_CHECK("was accepted: " << kind << ", " << value);
}

/// Null, unknown and destroyed handles.
template <class Vulkan>
void check_refusals(Vulkan& vulkan) {
    rhi::Device& device = vulkan.device();
    const Texture texture = device.create_texture({"gone", Dimension::d2, Format::rgba8_unorm, {4, 4, 1}, Usage::sampled});
    const Buffer buffer = device.create_buffer({"gone", 16, Usage::constants});
    CHECK(vulkan.native(texture).image != VK_NULL_HANDLE);
    CHECK(vulkan.native(buffer) != VK_NULL_HANDLE);
    device.destroy(texture, 0);
    device.destroy(buffer, 0);
    refused([&] { (void)vulkan.native(texture); }, "texture", "an unknown or destroyed handle");
    refused([&] { (void)vulkan.native(buffer); }, "buffer", "an unknown or destroyed handle");
    refused([&] { (void)vulkan.native(Texture{1234567}); }, "texture", "an unknown or destroyed handle");
    refused([&] { (void)vulkan.native(Buffer{1234567}); }, "buffer", "an unknown or destroyed handle");
    refused([&] { (void)vulkan.native(Texture{}); }, "texture", "null");
    refused([&] { (void)vulkan.native(Buffer{}); }, "buffer", "null");
}

}  // namespace

TEST_CASE("a host's own shader reads the guest's texture through the native view, in the native layout") {
    AUREOLE_NEEDS_VULKAN;
    Host host;
    HostImage& result = host.make_image_2d(VK_FORMAT_R32G32B32A32_SFLOAT, extent, VK_IMAGE_USAGE_STORAGE_BIT);
    VkImageViewCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    info.image = result.image;
    info.viewType = VK_IMAGE_VIEW_TYPE_2D;
    info.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    VkImageView result_view = VK_NULL_HANDLE;
    REQUIRE(vkCreateImageView(host.device(), &info, nullptr, &result_view) == VK_SUCCESS);
    const VkSampler sampler = make_sampler(host, VK_FILTER_NEAREST);
    {
        const auto guest = borrow_vulkan_device(host.lend());
        Device& device = guest->device();
        device.set_message_callback(Messages::collect, &host.messages);
        const Texture texture = device.create_texture(
            {"table", Dimension::d2, Format::rgba32_float, {7, 5, 1}, Usage::sampled | Usage::copy_destination});
        const Buffer upload = device.create_buffer({"numbers", floats * sizeof(float), Usage::upload});
        device.write_buffer(upload, std::as_bytes(std::span(numbers())));
        const NativeTexture native = guest->native(texture);
        HostProgram program(
            host, shaders::conformance_copy.spirv,
            {{{0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, {sampler, native.sampled_view, native.sampled_layout}, {}},
              {1, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, {VK_NULL_HANDLE, result_view, VK_IMAGE_LAYOUT_GENERAL}, {}}}});

        // Twice in one command buffer, so that the layer sees the guest's second write after the host's first read.
        host.move(result, VK_IMAGE_LAYOUT_GENERAL);
        for (int round = 0; round < 2; ++round) {
            CommandList& list = guest->begin_recording(host.commands());
            move(list, texture, round == 0 ? State::undefined : State::sampled, State::copy_destination);
            list.copy(BufferToTexture{upload, texture});
            move(list, texture, State::copy_destination, State::sampled);
            guest->end_recording();
            if (round == 1) host.move(result, VK_IMAGE_LAYOUT_GENERAL);
            program.record(1, 2);
        }
        CHECK(holds(host.read(result, {extent.width, extent.height, 1}, floats * sizeof(float)), numbers()));
    }
    vkDestroySampler(host.device(), sampler, nullptr);
    vkDestroyImageView(host.device(), result_view, nullptr);
}

TEST_CASE("a host copies from the guest's buffer by its native handle") {
    AUREOLE_NEEDS_VULKAN;
    Host host;
    HostImage& image = host.make_image_2d(VK_FORMAT_R32G32B32A32_SFLOAT, extent, 0);
    const auto guest = borrow_vulkan_device(host.lend());
    const Buffer buffer = guest->device().create_buffer({"numbers", floats * sizeof(float), Usage::upload});
    guest->device().write_buffer(buffer, std::as_bytes(std::span(numbers())));
    host.move(image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    VkBufferImageCopy region = {};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {extent.width, extent.height, 1};
    vkCmdCopyBufferToImage(host.commands(), guest->native(buffer), image.image, image.layout, 1, &region);
    CHECK(holds(host.read(image, region.imageExtent, floats * sizeof(float)), numbers()));
}

TEST_CASE("a lent texture's native objects are the host's own, with the layout in which the guest reads them") {
    AUREOLE_NEEDS_VULKAN;
    Host host;
    const HostImage& depth = host.make_image_2d(VK_FORMAT_D32_SFLOAT, extent,
                                                VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
    const auto guest = borrow_vulkan_device(host.lend());
    ExternalTexture external;
    external.desc = {"host depth", Dimension::d2, Format::d32_float, {7, 5, 1}, Usage::sampled};
    external.native = reinterpret_cast<std::uint64_t>(depth.image);
    external.state = State::depth_read;
    const NativeTexture lent = guest->native(guest->device().wrap_texture(external));
    CHECK(lent.image == depth.image);
    CHECK(lent.sampled_view != VK_NULL_HANDLE);
    CHECK(lent.sampled_layout == VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL);

    const NativeTexture target = guest->native(
        guest->device().create_texture({"target", Dimension::d2, Format::rgba8_unorm, {4, 4, 1}, Usage::color_attachment}));
    CHECK(target.image != VK_NULL_HANDLE);
    CHECK(target.sampled_view == VK_NULL_HANDLE);  // it cannot be sampled
}

TEST_CASE("handles that are null, unknown or destroyed are refused by name") {
    AUREOLE_NEEDS_VULKAN;
    Host host;
    check_refusals(*borrow_vulkan_device(host.lend()));
    TestDevice vulkan;
    check_refusals(vulkan.native());
}
