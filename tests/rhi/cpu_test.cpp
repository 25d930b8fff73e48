// The CPU backend does what every device must: in float, in double, with one thread, and under the validation device.
#include <aureole/cpu/cpu_device.h>
#include <aureole/rhi/checks.h>
#include <aureole/rhi/validation.h>
#include <aureole/rhi_tests/conformance.h>
#include <doctest/doctest.h>

#include <cstddef>
#include <deque>
#include <memory>
#include <string>
#include <vector>

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

conformance::Target target_of(cpu::CpuDevice& device, double pass_tolerance = 1e-2) {
    return {device.device(), device.queue(), true, Lender(), pass_tolerance};
}

}  // namespace

TEST_CASE("the CPU device in float does what every device must, and makes the very tables of the CPU device") {
    const auto device = cpu::create_cpu_device({.threads = 2});
    const conformance::Report report = conformance::run_all(target_of(*device, 1e-300));
    CAPTURE(report.text());
    CHECK(report.passed());
    CHECK(report.count(conformance::Outcome::skipped) == 0);
    CHECK(report.results.size() == conformance::checks().size());
}

TEST_CASE("the CPU device in double does what every device must") {
    const auto device = cpu::create_cpu_device({.precision = cpu::Precision::float64});
    const conformance::Report report = conformance::run_all(target_of(*device), conformance::Subject::device);
    CAPTURE(report.text());
    CHECK(report.passed());
}

TEST_CASE("the CPU device with one thread does what every device must") {
    const auto device = cpu::create_cpu_device({.threads = 1});
    const conformance::Report report = conformance::run_all(target_of(*device), conformance::Subject::device);
    CAPTURE(report.text());
    CHECK(report.passed());
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
        if (check.subject == conformance::Subject::passes) continue;  // tests/passes has them under this device
        listen();
        const conformance::Result result = check.run({*device, *queue, true, lender});
        CAPTURE(result.text());
        CHECK(result.outcome == conformance::Outcome::passed);
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

TEST_CASE("the test program runs what is named, and says how it went by what it returns") {
    const auto device = cpu::create_cpu_device({});
    const conformance::Target target = target_of(*device);
    const auto run = [&](std::vector<const char*> arguments) {
        arguments.insert(arguments.begin(), "program");
        return conformance::run_main(target, static_cast<int>(arguments.size()), arguments.data());
    };
    CHECK(run({"--list"}) == 0);
    CHECK(run({"frames", "cube"}) == 0);
    CHECK(run({"there is no such check"}) == 1);  // nothing ran
    CHECK(run({"--lost"}) == 2);
    CHECK_THROWS_AS((void)conformance::check_by_name("none"), Error);
    CHECK(conformance::run_all(target, "cube").results.size() == 3);
}
