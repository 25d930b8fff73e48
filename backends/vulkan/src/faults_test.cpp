// Devices that fail or lack something: each failure is an Error of the right kind, and leaves nothing behind.
#include <aureole/rhi/error.h>
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <functional>

#include "aureole_rhi_tests_shaders.h"
#include "rhi/harness.h"
#include "test_loader.h"
#include "test_support.h"

using namespace aureole;
using namespace aureole::rhi;
using namespace aureole::vulkan;
using namespace aureole::vulkan::test;

namespace {

VulkanDeviceDesc lied_to() {
    VulkanDeviceDesc desc;
    desc.loader = lying_loader();
    return desc;
}

Error failure_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& error) {
        return error;
    }
    FAIL("did not throw");
    return Error(ErrorCode::internal, "");
}

bool mentions(const Error& error, const std::string& part) { return std::string(error.what()).find(part) != std::string::npos; }

const TextureDesc half_texture = {
    "half texture", Dimension::d2, Format::rgba16_float, {16, 8, 1}, Usage::sampled | Usage::storage};

bool device_is_lost = false;
VKAPI_ATTR VkResult VKAPI_CALL submit_to_lost(VkQueue queue, uint32_t count, const VkSubmitInfo* submits, VkFence fence) {
    if (device_is_lost) return VK_ERROR_DEVICE_LOST;
    return truth_of<PFN_vkQueueSubmit>("vkQueueSubmit")(queue, count, submits, fence);
}
VKAPI_ATTR VkResult VKAPI_CALL wait_for_lost(VkDevice device, uint32_t count, const VkFence* fences, VkBool32 all,
                                             uint64_t timeout) {
    const VkResult result = truth_of<PFN_vkWaitForFences>("vkWaitForFences")(device, count, fences, all, timeout);
    return device_is_lost ? VK_ERROR_DEVICE_LOST : result;
}

/// A Vulkan function that creates something, failing while `failing` is set.
template <class Info, class Handle, const auto& Name>
struct Failing {
    static inline bool failing = false;
    static VKAPI_ATTR VkResult VKAPI_CALL call(VkDevice device, const Info* info, const VkAllocationCallbacks* allocator,
                                               Handle* handle) {
        if (failing) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
        using Function = VkResult(VKAPI_PTR*)(VkDevice, const Info*, const VkAllocationCallbacks*, Handle*);
        return truth_of<Function>(Name.data())(device, info, allocator, handle);
    }
};

/// Runs `create` with one Vulkan function out of memory after the other.
template <class Info, class Handle, const auto& Name>
void check_out_of_memory(const std::function<void(Device&)>& create, const std::string& object) {
    using Fault = Failing<Info, Handle, Name>;
    CAPTURE(Name.data());
    Lies lies;
    lies.tell(Name.data(), Fault::call);
    TestDevice vulkan(lied_to());  // fails the test if anything leaks
    Fault::failing = true;
    const Error error = failure_of([&] { create(vulkan.device()); });
    Fault::failing = false;
    CAPTURE(error.what());
    CHECK(error.code() == ErrorCode::out_of_memory);
    CHECK(mentions(error, object));
    CHECK(mentions(error, Name.data()));
    CHECK_NOTHROW(create(vulkan.device()));  // and afterwards all is as before
}

constexpr std::array allocate_memory = std::to_array("vkAllocateMemory");
constexpr std::array create_image = std::to_array("vkCreateImage");
constexpr std::array create_image_view = std::to_array("vkCreateImageView");
constexpr std::array create_framebuffer = std::to_array("vkCreateFramebuffer");
constexpr std::array create_buffer = std::to_array("vkCreateBuffer");
constexpr std::array create_sampler = std::to_array("vkCreateSampler");
constexpr std::array create_module = std::to_array("vkCreateShaderModule");
constexpr std::array create_set_layout = std::to_array("vkCreateDescriptorSetLayout");
constexpr std::array create_pipeline_layout = std::to_array("vkCreatePipelineLayout");
constexpr std::array create_pool = std::to_array("vkCreateDescriptorPool");

VKAPI_ATTR void VKAPI_CALL no_half_storage(VkPhysicalDevice device, VkFormat format, VkFormatProperties* properties) {
    truth_of<PFN_vkGetPhysicalDeviceFormatProperties>("vkGetPhysicalDeviceFormatProperties")(device, format, properties);
    if (format == VK_FORMAT_R16G16B16A16_SFLOAT)
        properties->optimalTilingFeatures &= ~VkFormatFeatureFlags{VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT};
    if (format == VK_FORMAT_R32G32B32A32_SFLOAT)
        properties->optimalTilingFeatures &= ~VkFormatFeatureFlags{VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT};
}
VKAPI_ATTR VkResult VKAPI_CALL small_images(VkPhysicalDevice device, VkFormat format, VkImageType type, VkImageTiling tiling,
                                            VkImageUsageFlags usage, VkImageCreateFlags flags,
                                            VkImageFormatProperties* properties) {
    const auto real = truth_of<PFN_vkGetPhysicalDeviceImageFormatProperties>("vkGetPhysicalDeviceImageFormatProperties");
    const VkResult result = real(device, format, type, tiling, usage, flags, properties);
    properties->maxExtent.width = 500;
    return result;
}
VKAPI_ATTR void VKAPI_CALL bare_queue(VkPhysicalDevice device, uint32_t* count, VkQueueFamilyProperties* families) {
    truth_of<PFN_vkGetPhysicalDeviceQueueFamilyProperties>("vkGetPhysicalDeviceQueueFamilyProperties")(device, count, families);
    for (uint32_t i = 0; families && i < *count; ++i) {
        families[i].queueFlags &= ~VkQueueFlags{VK_QUEUE_GRAPHICS_BIT};
        families[i].timestampValidBits = 0;
    }
}

/// Two devices that are the same one; opening fails for the first `openings_to_fail` of them.
int openings_to_fail = 0, openings = 0;
VKAPI_ATTR VkResult VKAPI_CALL two_devices(VkInstance instance, uint32_t* count, VkPhysicalDevice* devices) {
    uint32_t one = 1;
    VkPhysicalDevice device = VK_NULL_HANDLE;
    const auto real = truth_of<PFN_vkEnumeratePhysicalDevices>("vkEnumeratePhysicalDevices");
    if (const VkResult result = real(instance, &one, &device); result < VK_SUCCESS) return result;
    for (uint32_t i = 0; devices && i < *count; ++i) devices[i] = device;
    *count = 2;
    return VK_SUCCESS;
}
VKAPI_ATTR VkResult VKAPI_CALL fail_to_open(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* device) {
    if (openings++ < openings_to_fail) return openings == 1 ? VK_ERROR_OUT_OF_HOST_MEMORY : VK_ERROR_INITIALIZATION_FAILED;
    return truth_of<PFN_vkCreateDevice>("vkCreateDevice")(physical, info, allocator, device);
}
/// The same for a later step: the device is there, its queue's command pool is not.
VKAPI_ATTR VkResult VKAPI_CALL fail_to_make_pool(VkDevice device, const VkCommandPoolCreateInfo* info,
                                                 const VkAllocationCallbacks* allocator, VkCommandPool* pool) {
    if (openings++ < openings_to_fail) return VK_ERROR_OUT_OF_HOST_MEMORY;
    return truth_of<PFN_vkCreateCommandPool>("vkCreateCommandPool")(device, info, allocator, pool);
}

}  // namespace

TEST_CASE("if a device cannot be opened the next one is, with a warning; if none can, each one's reason is told") {
    AUREOLE_NEEDS_VULKAN;
    for (const bool late : {false, true}) {
        CAPTURE(late);
        Lies lies;
        lies.tell("vkEnumeratePhysicalDevices", two_devices);
        if (late)
            lies.tell("vkCreateCommandPool", fail_to_make_pool);
        else
            lies.tell("vkCreateDevice", fail_to_open);
        openings = 0, openings_to_fail = 1;
        TestDevice vulkan(lied_to());  // fails the test if anything is left of the first
        CHECK(openings == 2);
        CHECK(vulkan.messages.texts.size() == 1);
        CHECK(vulkan.messages.mention("VK_ERROR_OUT_OF_HOST_MEMORY"));
        vulkan.messages.texts.clear();
    }
    Lies lies;
    lies.tell("vkEnumeratePhysicalDevices", two_devices);
    lies.tell("vkCreateDevice", fail_to_open);
    openings = 0, openings_to_fail = 2;
    const Error none = failure_of([&] { (void)create_vulkan_device(lied_to()); });
    CHECK(none.code() == ErrorCode::out_of_memory);  // the better one's
    CHECK(mentions(none, "VK_ERROR_OUT_OF_HOST_MEMORY"));
    CHECK(mentions(none, "VK_ERROR_INITIALIZATION_FAILED"));

    openings = 0, openings_to_fail = 1;
    VulkanDeviceDesc desc = lied_to();
    desc.index = 1;  // whoever names a device gets that one or none
    CHECK(failure_of([&] { (void)create_vulkan_device(desc); }).code() == ErrorCode::out_of_memory);
    CHECK(openings == 1);
}

TEST_CASE("a lost device is an Error of that kind, at submission and at waiting, and can still be destroyed") {
    AUREOLE_NEEDS_VULKAN;
    Lies lies;
    lies.tell("vkQueueSubmit", submit_to_lost);
    lies.tell("vkWaitForFences", wait_for_lost);
    {
        TestDevice vulkan(lied_to());
        (void)vulkan.queue().begin();
        device_is_lost = true;
        CHECK(failure_of([&] { (void)vulkan.queue().submit(); }).code() == ErrorCode::device_lost);
        device_is_lost = false;
    }
    TestDevice vulkan(lied_to());
    (void)vulkan.queue().begin();
    (void)vulkan.queue().submit();
    device_is_lost = true;
    CHECK(failure_of([&] { vulkan.queue().wait(); }).code() == ErrorCode::device_lost);
    CHECK(failure_of([&] { (void)vulkan.queue().begin(); }).code() == ErrorCode::device_lost);
    device_is_lost = false;
    CHECK_NOTHROW(vulkan.queue().wait());
}

TEST_CASE("running out of memory is an Error that names the object, and nothing leaks") {
    AUREOLE_NEEDS_VULKAN;
    const auto texture = [](Device& d) { (void)d.create_texture(half_texture); };
    const auto target = [](Device& d) {
        (void)d.create_texture({"target", Dimension::d2, Format::rgba16_float, {4, 4, 1}, Usage::color_attachment});
    };
    const auto buffer = [](Device& d) { (void)d.create_buffer({"staging", 64, Usage::upload}); };
    const auto sampler = [](Device& d) { (void)d.create_sampler({}); };
    const auto pipeline = [](Device& d) { (void)d.create_compute_pipeline({"fill", &shaders::conformance_fill_3d, {}}); };
    const auto set = [](Device& d) {
        const Pipeline fill = d.create_compute_pipeline({"fill", &shaders::conformance_fill_3d, {}});
        const Texture volume =
            d.create_texture({"volume", Dimension::d3, Format::rgba16_float, {4, 4, 4}, Usage::storage | Usage::sampled});
        const Binding bindings[] = {{0, volume, {}, {}}};
        (void)d.create_binding_set({"fill set", fill, bindings});
    };
    check_out_of_memory<VkMemoryAllocateInfo, VkDeviceMemory, allocate_memory>(texture, "half texture");
    check_out_of_memory<VkImageCreateInfo, VkImage, create_image>(texture, "half texture");
    check_out_of_memory<VkImageViewCreateInfo, VkImageView, create_image_view>(texture, "half texture");
    check_out_of_memory<VkFramebufferCreateInfo, VkFramebuffer, create_framebuffer>(target, "target");
    check_out_of_memory<VkMemoryAllocateInfo, VkDeviceMemory, allocate_memory>(buffer, "staging");
    check_out_of_memory<VkBufferCreateInfo, VkBuffer, create_buffer>(buffer, "staging");
    check_out_of_memory<VkSamplerCreateInfo, VkSampler, create_sampler>(sampler, "sampler");
    check_out_of_memory<VkShaderModuleCreateInfo, VkShaderModule, create_module>(pipeline, "fill");
    check_out_of_memory<VkDescriptorSetLayoutCreateInfo, VkDescriptorSetLayout, create_set_layout>(pipeline, "layout");
    check_out_of_memory<VkPipelineLayoutCreateInfo, VkPipelineLayout, create_pipeline_layout>(pipeline, "layout");
    check_out_of_memory<VkDescriptorPoolCreateInfo, VkDescriptorPool, create_pool>(set, "fill set");
}

TEST_CASE("what the device cannot do with a format is refused by name") {
    AUREOLE_NEEDS_VULKAN;
    Lies lies;
    lies.tell("vkGetPhysicalDeviceFormatProperties", no_half_storage);
    TestDevice vulkan(lied_to());
    CHECK(!vulkan.device().format_support(Format::rgba16_float, Dimension::d2).storage);
    const Error storage = failure_of([&] { (void)vulkan.device().create_texture(half_texture); });
    CHECK(storage.code() == ErrorCode::unsupported);
    CHECK(mentions(storage, "half texture"));
    CHECK(mentions(storage, "rgba16_float"));

    conformance::Harness h({vulkan.device(), vulkan.queue()});
    const auto source = h.texture("float texture", Format::rgba32_float, {4, 4, 1}, Usage::sampled);
    const auto image = h.texture("image", Format::rgba32_float, {4, 4, 1}, Usage::storage);
    const auto pipeline = h.compute(shaders::conformance_copy);
    const Error filter = failure_of([&] {
        h.bind(pipeline, {{0, source, h.sampler(Filter::linear), {}}, {1, image, {}, {}}});
    });
    CHECK(filter.code() == ErrorCode::unsupported);
    CHECK(mentions(filter, "float texture"));
}

TEST_CASE("sizes beyond the device are refused before the driver sees them") {
    AUREOLE_NEEDS_VULKAN;
    TestDevice vulkan;
    Device& device = vulkan.device();
    const std::uint32_t most = device.capabilities().max_texture_2d;
    TextureDesc desc = half_texture;
    desc.extent = {most + 1, 1, 1};
    const Error wide = failure_of([&] { (void)device.create_texture(desc); });
    CHECK(wide.code() == ErrorCode::unsupported);
    CHECK(mentions(wide, "width"));
    CHECK(mentions(wide, std::to_string(most)));

    desc.format = Format::rgba32_float;
    desc.dimension = Dimension::d3;
    desc.extent.width = desc.extent.height = desc.extent.depth = device.capabilities().max_texture_3d;
    const Error huge = failure_of([&] { (void)device.create_texture(desc); });
    CHECK((huge.code() == ErrorCode::unsupported || huge.code() == ErrorCode::out_of_memory));
    CHECK(mentions(huge, "half texture"));
    const Error long_buffer = failure_of([&] { (void)device.create_buffer({"long", std::uint64_t{1} << 60, Usage::upload}); });
    CHECK(long_buffer.code() == ErrorCode::unsupported);
    CHECK(mentions(long_buffer, "long"));
}

TEST_CASE("limits are those of images that can really be made") {
    AUREOLE_NEEDS_VULKAN;
    Lies lies;
    lies.tell("vkGetPhysicalDeviceImageFormatProperties", small_images);
    TestDevice vulkan(lied_to());
    CHECK(vulkan.device().capabilities().max_texture_2d == 500);
    CHECK(vulkan.device().capabilities().max_texture_3d == 500);
    CHECK(vulkan.device().capabilities().max_texture_cube == 500);
}

TEST_CASE("the CPU reads and writes only what is for it and not more than there is") {
    AUREOLE_NEEDS_VULKAN;
    TestDevice vulkan;
    Device& device = vulkan.device();
    const Buffer up = device.create_buffer({"up", 16, Usage::upload}),
                 down = device.create_buffer({"down", 16, Usage::read_back});
    std::vector<std::byte> bytes(17);
    const Error long_write = failure_of([&] { device.write_buffer(up, bytes); });
    CHECK(long_write.code() == ErrorCode::invalid_argument);
    CHECK(mentions(long_write, "up"));
    CHECK(mentions(long_write, "17"));
    CHECK(failure_of([&] { device.read_buffer(down, bytes); }).code() == ErrorCode::invalid_argument);
    bytes.resize(16);
    CHECK_NOTHROW(device.write_buffer(up, bytes));
    CHECK_NOTHROW(device.read_buffer(down, bytes));
    CHECK(failure_of([&] { device.write_buffer(down, bytes); }).code() == ErrorCode::misuse);
    CHECK(failure_of([&] { device.read_buffer(up, bytes); }).code() == ErrorCode::misuse);
    CHECK(failure_of([&] { device.read_buffer({}, bytes); }).code() == ErrorCode::misuse);
    CHECK(failure_of([&] { device.write_buffer(Buffer{12345}, bytes); }).code() == ErrorCode::misuse);
}

TEST_CASE("timestamps that were never written are no numbers, and slots end where the capabilities say") {
    AUREOLE_NEEDS_VULKAN;
    TestDevice vulkan;
    const std::uint32_t slots = vulkan.device().capabilities().timestamp_slots;
    if (slots == 0) return;
    std::vector<double> times(slots);
    vulkan.queue().begin().timestamp(1);
    (void)vulkan.queue().submit();
    vulkan.queue().wait();
    vulkan.device().read_timestamps(times);
    CHECK(std::isnan(times[0]));
    CHECK(!std::isnan(times[1]));
    CHECK(std::isnan(times[slots - 1]));
    times.push_back(0);
    CHECK(failure_of([&] { vulkan.device().read_timestamps(times); }).code() == ErrorCode::invalid_argument);
}

TEST_CASE("a queue for compute alone has no raster and no timestamps, and works") {
    AUREOLE_NEEDS_VULKAN;
    Lies lies;
    lies.tell("vkGetPhysicalDeviceQueueFamilyProperties", bare_queue);
    TestDevice vulkan(lied_to());
    Device& device = vulkan.device();
    CHECK(!device.capabilities().raster);
    CHECK(device.capabilities().timestamp_slots == 0);
    CHECK(!device.format_support(Format::rgba8_unorm, Dimension::d2).color_attachment);
    const Error error = failure_of([&] {
        (void)device.create_raster_pipeline({"draw", &shaders::conformance_draw, {}, Format::rgba8_unorm});
    });
    CHECK(error.code() == ErrorCode::unsupported);
    double time = 0;
    CHECK_THROWS_AS(device.read_timestamps({&time, 1}), Error);
    for (const char* name : {"barriers", "3d textures", "constants"}) {
        const conformance::Result result = conformance::check_by_name(name).run({device, vulkan.queue()});
        CAPTURE(result.text());
        CHECK(result.outcome == conformance::Outcome::passed);
    }
    CHECK(conformance::check_by_name("raster").run({device, vulkan.queue()}).outcome == conformance::Outcome::skipped);

    // Depth cannot be copied there: said, and not recorded.
    Messages complaints;
    conformance::Harness h({device, vulkan.queue()});
    const auto depth = h.texture("depth", Format::d32_float, {4, 4, 1}, Usage::sampled | Usage::copy_destination);
    device.set_message_callback(Messages::collect, &complaints);
    h.upload(depth, std::vector<std::byte>(64));
    h.list().timestamp(0);
    device.set_message_callback(nullptr, nullptr);
    h.run();
    CHECK(complaints.texts.size() == 2);
    CHECK(complaints.mention("depth"));
    CHECK(complaints.mention("timestamp"));
}

TEST_CASE("a shader that is no SPIR-V or asks too much is refused before the driver sees it") {
    AUREOLE_NEEDS_VULKAN;
    TestDevice vulkan;
    const auto refused = [&](const Shader& shader, ErrorCode code, const std::string& part) {
        const Error error = failure_of([&] { (void)vulkan.device().create_compute_pipeline({"odd", &shader, {}}); });
        CAPTURE(error.what());
        CHECK(error.code() == code);
        CHECK(mentions(error, "odd"));
        CHECK(mentions(error, part));
    };
    Shader shader = shaders::conformance_copy;
    shader.spirv = {};
    refused(shader, ErrorCode::invalid_argument, "spirv");
    shader = shaders::conformance_copy;
    shader.local_size[0] = 1u << 20;
    refused(shader, ErrorCode::unsupported, "local_size");
}
