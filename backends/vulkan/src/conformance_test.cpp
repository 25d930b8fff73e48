// What every rhi::Device must do, on Vulkan under core and synchronization validation.
#include <doctest/doctest.h>

#include "rhi/conformance.h"
#include "test_queue.h"

using namespace aureole;
using namespace aureole::vulkan;
using namespace aureole::vulkan::test;

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
