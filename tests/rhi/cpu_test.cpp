#include <aureole/cpu/cpu_device.h>
#include <aureole/rhi/checks.h>
#include <aureole/rhi/validation.h>
#include <doctest/doctest.h>

#include <cstddef>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "rhi/conformance.h"

using namespace aureole;

namespace {

/// Lends memory of its own, which lives as long as it does.
class Lender {
public:
    rhi::ExternalTexture operator()(const rhi::TextureDesc& desc) const {
        rhi::ExternalTexture external{desc};
        memory_->emplace_back(static_cast<std::size_t>(rhi::packed_size(desc)));
        external.cpu_texels = memory_->back().data();
        external.state = rhi::State::general;
        return external;
    }

private:
    std::shared_ptr<std::deque<std::vector<std::byte>>> memory_ = std::make_shared<std::deque<std::vector<std::byte>>>();
};

}  // namespace

TEST_CASE("the CPU device in float does what every device must") {
    const auto device = cpu::create_cpu_device({});
    conformance::run_all({device->device(), device->queue(), true, Lender()});
}

TEST_CASE("the CPU device in double does what every device must") {
    const auto device = cpu::create_cpu_device({.precision = cpu::Precision::float64});
    conformance::run_all({device->device(), device->queue(), true, Lender()});
}

TEST_CASE("the CPU device with one thread does what every device must") {
    const auto device = cpu::create_cpu_device({.threads = 1});
    conformance::run_all({device->device(), device->queue(), true, Lender()});
}

TEST_CASE("the validation device behaves as the device inside, and has nothing to say about correct use") {
    const auto cpu_device = cpu::create_cpu_device({});
    auto device = rhi::create_validation_device(cpu_device->device());
    auto queue = rhi::create_validation_queue(*device, cpu_device->queue());
    std::vector<std::string> messages;
    const auto listen = [&] {
        messages.clear();
        device->set_message_callback([](void* user, rhi::Severity,
                                        const char* text) { static_cast<std::vector<std::string>*>(user)->emplace_back(text); },
                                     &messages);
    };
    const Lender lender;
    for (const conformance::Check& check : conformance::checks()) {
        INFO("conformance: ", std::string(check.name));
        listen();
        check.run({*device, *queue, true, lender});
        for (const std::string& text : messages) {
            CAPTURE(text);
            CHECK(text.find("\"bad ") != std::string::npos);  // so the check of refusals calls its objects
        }
    }
    listen();
    queue.reset();
    device.reset();
    CHECK(messages.empty());  // no object is left
}
