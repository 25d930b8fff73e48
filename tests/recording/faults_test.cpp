// The whole module on a Vulkan device that fails: one Error, nothing left behind, and a host that goes on.
#include <aureole/models/fog.h>
#include <aureole/vulkan/vulkan_device.h>
#include <doctest/doctest.h>

#include "passes/rig.h"
#include "test_loader.h"
#include "test_support.h"

using namespace aureole;
using namespace aureole::passes;
using namespace aureole::vulkan::test;

namespace {

struct OpenLiar final : OpenDevice {
    OpenLiar() {
        vulkan::VulkanDeviceDesc desc;
        desc.validation = true;
        desc.loader = lying_loader();
        made = vulkan::create_vulkan_device(desc);
    }
    [[nodiscard]] rhi::Device& device() override { return made->device(); }
    [[nodiscard]] rhi::Queue& queue() override { return made->queue(); }
    std::unique_ptr<vulkan::VulkanDevice> made;
};
/// When it goes, whatever is left, and whatever the validation layer found, fails the test.
std::unique_ptr<Backend> open_liar() { return std::make_unique<Backend>("Vulkan, lying", std::make_unique<OpenLiar>()); }

Setup foggy() {
    Setup setup;
    setup.model = models::fog({});
    setup.composite.target_format = rhi::Format::rgba32_float;
    return setup;
}

Image picture(Rig& rig) {
    rig.record_air();
    rig.record_view(camera_at(rig.setup.air.planet, 100), sun_at(15));
    return rig.show({9, 5, 1});
}

Error failure_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error;
    }
    return Error(ErrorCode::internal, "nothing");
}

bool mentions(const Error& error, const std::string& part) { return std::string(error.what()).find(part) != std::string::npos; }

int pipelines_until_refused = -1;
VKAPI_ATTR VkResult VKAPI_CALL refuse_pipeline(VkDevice device, VkPipelineCache cache, std::uint32_t count,
                                               const VkComputePipelineCreateInfo* infos, const VkAllocationCallbacks* allocator,
                                               VkPipeline* pipelines) {
    if (pipelines_until_refused >= 0 && pipelines_until_refused-- == 0) return VK_ERROR_INVALID_SHADER_NV;
    const auto real = truth_of<PFN_vkCreateComputePipelines>("vkCreateComputePipelines");
    return real(device, cache, count, infos, allocator, pipelines);
}

bool lost = false;
VKAPI_ATTR VkResult VKAPI_CALL lose_device(VkQueue queue, std::uint32_t count, const VkSubmitInfo* submits, VkFence fence) {
    if (lost) return VK_ERROR_DEVICE_LOST;
    return truth_of<PFN_vkQueueSubmit>("vkQueueSubmit")(queue, count, submits, fence);
}

VKAPI_ATTR void VKAPI_CALL no_half_storage(VkPhysicalDevice device, VkFormat format, VkFormatProperties* properties) {
    truth_of<PFN_vkGetPhysicalDeviceFormatProperties>("vkGetPhysicalDeviceFormatProperties")(device, format, properties);
    if (format == VK_FORMAT_R16G16B16A16_SFLOAT)
        properties->optimalTilingFeatures &= ~VkFormatFeatureFlags{VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT};
}

}  // namespace

TEST_CASE("a driver that refuses a shader: the pipeline is named, nothing is left, and the next try shows the same") {
    AUREOLE_NEEDS_VULKAN;
    Lies lies;
    lies.tell("vkCreateComputePipelines", refuse_pipeline);
    pipelines_until_refused = -1;
    const auto vulkan = open_liar();
    Rig whole(*vulkan, foggy());
    const Image expected = picture(whole);
    const std::uint64_t live = vulkan->device().live();
    int refusals = 0;
    for (bool made = false; !made; ++refusals) {
        pipelines_until_refused = refusals;
        const Error error = failure_of([&] {
            Rig rig(*vulkan, foggy());
            made = true;
        });
        CHECK(vulkan->device().live() == live);
        if (made) break;
        CHECK(mentions(error, "pipeline \""));
        CHECK(mentions(error, "vkCreateComputePipelines returned VK_ERROR_INVALID_SHADER_NV"));
        CHECK(vulkan->take_messages() == error.what() + std::string("\n"));  // once
    }
    pipelines_until_refused = -1;
    CHECK(refusals >= 2);               // light and composite
    CHECK(picture(whole) == expected);  // what is there already is as it was
    Rig again(*vulkan, foggy());
    CHECK(picture(again) == expected);
}

TEST_CASE("a device that is lost in a frame: one Error, all of it can be destroyed, and another device goes on") {
    AUREOLE_NEEDS_VULKAN;
    Lies lies;
    lies.tell("vkQueueSubmit", lose_device);
    const auto other = open_liar();
    Rig beside(*other, foggy());
    const Image expected = picture(beside);
    {
        const auto vulkan = open_liar();
        Rig rig(*vulkan, foggy());
        rig.air.set_frame(1);  // the host's number of the frame that does not come
        lost = true;
        const Error error = failure_of([&] { (void)picture(rig); });
        lost = false;
        CHECK(error.code() == ErrorCode::device_lost);
        CHECK(mentions(error, "vkQueueSubmit returned VK_ERROR_DEVICE_LOST"));
    }
    CHECK(picture(beside) == expected);
    const auto fresh = open_liar();
    Rig rig(*fresh, foggy());
    CHECK(picture(rig) == expected);
}

TEST_CASE("a device without a format that is needed: it is named, nothing is left, and models that do without it work") {
    AUREOLE_NEEDS_VULKAN;
    Lies lies;
    lies.tell("vkGetPhysicalDeviceFormatProperties", no_half_storage);
    const auto vulkan = open_liar();
    const Error error = failure_of([&] { Atmosphere air(vulkan->device(), presets::earth(), models::aureole({})); });
    CHECK(error.code() == ErrorCode::unsupported);
    CHECK(mentions(error, "rgba16_float"));
    CHECK(mentions(error, "no storage"));
    CHECK(vulkan->device().live() == 0);
    Rig fog(*vulkan, foggy());
    (void)picture(fog);
}
