// What every rhi::Device must do, on Vulkan under core and synchronization validation.
#include <aureole/rhi_tests/conformance.h>
#include <doctest/doctest.h>

#include "test_queue.h"

using namespace aureole;
using namespace aureole::vulkan;
using namespace aureole::vulkan::test;

namespace {

/// An image of the host's, in the layout of State::general.
rhi::ExternalTexture lend(Host& host, const rhi::TextureDesc& desc) {
    REQUIRE(desc.format == rhi::Format::rgba32_float);
    REQUIRE(desc.dimension == rhi::Dimension::d2);
    HostImage& image = host.make_image_2d(VK_FORMAT_R32G32B32A32_SFLOAT, {desc.extent.width, desc.extent.height},
                                          VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT);
    host.move(image, VK_IMAGE_LAYOUT_GENERAL);
    host.submit_and_wait();
    rhi::ExternalTexture external{desc};
    external.native = reinterpret_cast<std::uint64_t>(image.image);
    external.state = rhi::State::general;
    return external;
}

void check_passed(const conformance::Result& result) {
    CAPTURE(result.text());
    CHECK(result.outcome != conformance::Outcome::failed);
}

}  // namespace

TEST_CASE("the Vulkan device does what every device must, and the validation layer is silent") {
    AUREOLE_NEEDS_VULKAN;
    for (const conformance::Check& check : conformance::checks()) {
        CAPTURE(check.name);
        TestDevice vulkan;
        conformance::Target target{vulkan.device(), vulkan.queue()};
        target.pass_tolerance = 1e-4;  // as docs/precision.md has it
        check_passed(check.run(target));
        CHECK(vulkan.messages.joined() == "");
    }
}

TEST_CASE("a guest on a host's Vulkan device does so too") {
    AUREOLE_NEEDS_VULKAN;
    for (const conformance::Check& check : conformance::checks()) {
        // The passes are recorded by the same code as above; tests/recording has them on a host's device.
        if (check.subject == conformance::Subject::passes) continue;
        CAPTURE(check.name);
        Host host;
        const auto guest = borrow_vulkan_device(host.lend());
        HostQueue queue(host, *guest);
        const auto lend_image = [&](const rhi::TextureDesc& desc) { return lend(host, desc); };
        check_passed(check.run({guest->device(), queue, false, lend_image}));
        CHECK(host.messages.joined() == "");
    }
}
