// What every rhi::Device must do, on Vulkan under core and synchronization validation.
#include <aureole/rhi_tests/conformance.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

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

/// A check that a device may skip, and the reason that it then has.
struct Skip {
    std::string check, reason;
    [[nodiscard]] bool operator==(const Skip&) const = default;
};

/// All pass but those that are named here; whoever reads the log sees which.
class Skips {
public:
    explicit Skips(std::vector<Skip> of_the_target) : allowed_(std::move(of_the_target)) {}

    void check(const rhi::Device& device, const conformance::Result& result) {
        CAPTURE(result.text());
        CHECK(result.outcome != conformance::Outcome::failed);
        if (result.outcome != conformance::Outcome::skipped) return;
        const Skip skip{result.name, result.reason};
        const std::vector<Skip> allowed = allowed_of(device);
        MESSAGE("skipped by ", device.capabilities().device, ": ", skip.check, ": ", skip.reason);
        CHECK_MESSAGE(std::ranges::find(allowed, skip) != allowed.end(), skip.check, " is not to be skipped here");
        skipped_.push_back(skip);
    }
    /// What the target lacks was skipped indeed: else the list is out of date.
    void check_all_met() const {
        for (const Skip& skip : allowed_) {
            CAPTURE(skip.check);
            CHECK(std::ranges::find(skipped_, skip) != skipped_.end());
        }
    }

private:
    /// Mesa's llvmpipe has all that the kit asks for. Elsewhere a queue may be without a clock.
    [[nodiscard]] std::vector<Skip> allowed_of(const rhi::Device& device) const {
        std::vector<Skip> all = allowed_;
        if (!device.capabilities().device.starts_with("llvmpipe"))
            all.push_back({"timestamps", "Capabilities::timestamp_slots is below 3"});
        return all;
    }

    std::vector<Skip> allowed_, skipped_;
};

}  // namespace

TEST_CASE("the Vulkan device does what every device must, and the validation layer is silent") {
    AUREOLE_NEEDS_VULKAN;
    Skips skips(std::vector<Skip>{{"lent textures", "Target::lend is empty"}});  // a guest lends them, below
    for (const conformance::Check& check : conformance::checks()) {
        CAPTURE(check.name);
        TestDevice vulkan;
        conformance::Target target{vulkan.device(), vulkan.queue()};
        target.pass_tolerance = 1e-4;  // as docs/precision.md has it
        skips.check(vulkan.device(), check.run(target));
        CHECK(vulkan.messages.joined() == "");
    }
    skips.check_all_met();
}

TEST_CASE("a guest on a host's Vulkan device does so too") {
    AUREOLE_NEEDS_VULKAN;
    Skips skips(std::vector<Skip>{});
    for (const conformance::Check& check : conformance::checks()) {
        // The passes are recorded by the same code as above; tests/recording has them on a host's device.
        if (check.subject == conformance::Subject::passes) continue;
        CAPTURE(check.name);
        Host host;
        const auto guest = borrow_vulkan_device(host.lend());
        HostQueue queue(host, *guest);
        const auto lend_image = [&](const rhi::TextureDesc& desc) { return lend(host, desc); };
        skips.check(guest->device(), check.run({guest->device(), queue, false, lend_image}));
        CHECK(host.messages.joined() == "");
    }
}
