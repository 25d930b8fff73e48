#include "app/commands.h"

#include "io/test_files.h"

#include <doctest/doctest.h>

using namespace aureole::app;

TEST_CASE("parse_size") {
    CHECK(parse_size("1280x720").width == 1280);
    CHECK(parse_size("1x16384").height == 16384);
    for (const char* bad :
         {"", "1280", "x720", "1280x", "0x10", "10x0", "16385x1", "-1x5", "5x5x5", "1e3x5", "10 x 10", "99999999999x1"}) {
        CAPTURE(bad);
        CHECK(complaint([&] { (void)parse_size(bad); }) ==
              "--size: \"" + std::string(bad) + "\" is not allowed; allowed: WIDTHxHEIGHT in pixels, each in [1, 16384]");
    }
}

TEST_CASE("open_backend: names and reasons") {
    CHECK(open_backend({.name = "cpu"})->name() == "cpu");
    CHECK(open_backend({.name = "cpu-double"})->name() == "cpu-double");
    CHECK(contains(open_backend({.name = "cpu", .threads = 1})->describe(), "1 thread,"));
    CHECK(contains(complaint([] { (void)open_backend({.name = "metal"}); }), "allowed: auto, vulkan, cpu or cpu-double"));
    CHECK(complaint([] { (void)open_backend({.name = "vulkan", .device = "no such device"}); }) != "nothing");
    // Whoever asks for a device by name is not given another backend.
    CHECK(complaint([] { (void)open_backend({.name = "auto", .device = "no such device"}); }) != "nothing");
}

TEST_CASE("open_backend: auto is the CPU whatever keeps Vulkan from opening, and says what") {
    using aureole::Error, aureole::ErrorCode;
    for (const ErrorCode code :
         {ErrorCode::unsupported, ErrorCode::out_of_memory, ErrorCode::device_lost, ErrorCode::internal}) {
        const auto fail = [&](const BackendOptions&) -> std::unique_ptr<Backend> { throw Error(code, "the driver is ill"); };
        const auto backend = open_backend({.name = "auto"}, fail);
        CHECK(backend->name() == "cpu");
        CHECK(contains(backend->describe(), "not vulkan: the driver is ill"));
        CHECK(contains(complaint([&] { (void)open_backend({.name = "vulkan"}, fail); }), "the driver is ill"));
        CHECK(contains(complaint([&] { (void)open_backend({.name = "auto", .device = "x"}, fail); }), "the driver is ill"));
        CHECK(
            contains(complaint([&] { (void)open_backend({.name = "auto", .validation = true}, fail); }), "the driver is ill"));
    }
}

TEST_CASE("open_backend: options that the backend does not have are refused, both named") {
    const auto refused = [](const BackendOptions& options) { return complaint([&] { (void)open_backend(options); }); };
    CHECK(refused({.name = "cpu", .device = "foo"}) == "--device foo: --backend cpu is not allowed; allowed: --backend vulkan");
    CHECK(refused({.name = "cpu-double", .validation = true}) ==
          "--validation: --backend cpu-double is not allowed; allowed: --backend vulkan");
    CHECK(refused({.name = "vulkan", .threads = 3}) ==
          "--threads 3: --backend vulkan is not allowed; allowed: --backend cpu or cpu-double");
    // Where there is no Vulkan the message says so, elsewhere that no device has that name.
    const std::string unknown = refused({.name = "auto", .device = "no such device"});
    CHECK(unknown.starts_with("--device"));
    CHECK(contains(unknown, "no such device"));
}

namespace {

/// A device that has something to report while it goes.
class Leaving final : public Backend {
public:
    Leaving(aureole::rhi::Severity severity, bool strict) : inner_(open_backend({.name = "cpu"})), severity_(severity) {
        keep_warnings_ = strict;
    }
    aureole::rhi::Device& device() override { return inner_->device(); }
    aureole::rhi::Queue& queue() override { return inner_->queue(); }

private:
    void destroy_device() override {
        inner_.reset();
        report(severity_, "a texture was left");
    }
    std::unique_ptr<Backend> inner_;
    aureole::rhi::Severity severity_;
};

std::string said_by(aureole::rhi::Severity severity, bool strict) {
    Leaving backend(severity, strict);
    CHECK_NOTHROW(backend.check());
    return complaint([&] { backend.close(); });
}

}  // namespace

TEST_CASE("Backend: what the device finds while it goes is a failure; warnings are under the validation layer") {
    const std::string fault = "the device reported a fault: a texture was left";
    CHECK(said_by(aureole::rhi::Severity::error, false) == fault);
    CHECK(said_by(aureole::rhi::Severity::warning, true) == fault);
    CHECK(said_by(aureole::rhi::Severity::warning, false) == "nothing");
    CHECK(said_by(aureole::rhi::Severity::info, true) == "nothing");
}

TEST_CASE("DeviceTextures: the device's limit is named") {
    const auto backend = open_backend({.name = "cpu"});
    DeviceTextures textures(*backend);
    const std::uint32_t most = backend->device().capabilities().max_texture_2d;
    CHECK(contains(
        complaint([&] {
            (void)textures.create("picture", aureole::rhi::Format::rgba8_unorm, {most + 1, 1, 1}, aureole::rhi::Usage::storage);
        }),
        "picture: size: " + std::to_string(most + 1) + "x1 is not allowed; allowed: at most " + std::to_string(most)));
}
