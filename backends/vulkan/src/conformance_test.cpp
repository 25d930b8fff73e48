// What every rhi::Device must do, on Vulkan under core and synchronization validation.
#include <doctest/doctest.h>

#include "rhi/conformance.h"
#include "test_host.h"

using namespace aureole;
using namespace aureole::vulkan;
using namespace aureole::vulkan::test;

namespace {

/// A host that lends its command buffer for each list and submits it to its own queue.
class HostQueue final : public rhi::Queue {
public:
    HostQueue(Host& host, BorrowedVulkanDevice& guest) : host_(host), guest_(guest) {}
    [[nodiscard]] rhi::CommandList& begin() override { return guest_.begin_recording(host_.commands()); }
    [[nodiscard]] std::uint64_t submit() override {
        guest_.end_recording();
        host_.submit_and_wait();
        return ++frame_;
    }
    void wait() override { guest_.device().collect(frame_); }

private:
    Host& host_;
    BorrowedVulkanDevice& guest_;
    std::uint64_t frame_ = 0;
};

}  // namespace

TEST_CASE("the Vulkan device does what every device must, and the validation layer is silent") {
    AUREOLE_NEEDS_VULKAN;
    for (const conformance::Check& check : conformance::checks()) {
        CAPTURE(check.name);
        TestDevice vulkan;
        CHECK_NOTHROW(check.run({vulkan.device(), vulkan.queue(), false}));
        CHECK(vulkan.messages.joined() == "");
    }
}

TEST_CASE("a guest on a host's Vulkan device does so too") {
    AUREOLE_NEEDS_VULKAN;
    for (const conformance::Check& check : conformance::checks()) {
        CAPTURE(check.name);
        Host host;
        const auto guest = borrow_vulkan_device(host.lend());
        HostQueue queue(host, *guest);
        CHECK_NOTHROW(check.run({guest->device(), queue, false}));
        CHECK(host.messages.joined() == "");
    }
}
