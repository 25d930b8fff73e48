#include "app/backend.h"

#ifdef AUREOLE_HAS_VULKAN
#include <aureole/vulkan/vulkan_device.h>
#endif

#include <spdlog/spdlog.h>

#include <exception>

namespace aureole::app {
namespace {

class CpuBackend final : public Backend {
public:
    CpuBackend(cpu::Precision precision, const BackendOptions& options, std::string note)
        : device_(cpu::create_cpu_device({precision, options.threads, options.count_work})) {
        name_ = precision == cpu::Precision::float64 ? "cpu-double" : "cpu";
        note_ = std::move(note);
        listen();
    }
    rhi::Device& device() override { return device_->device(); }
    rhi::Queue& queue() override { return device_->queue(); }
    cpu::CpuDevice* cpu() override { return device_.get(); }

private:
    void destroy_device() override { device_.reset(); }
    std::unique_ptr<cpu::CpuDevice> device_;
};

#ifdef AUREOLE_HAS_VULKAN
class VulkanBackend final : public Backend {
public:
    explicit VulkanBackend(const BackendOptions& options) {
        vulkan::VulkanDeviceDesc desc;
        desc.name = options.device;
        desc.validation = options.validation;
        device_ = vulkan::create_vulkan_device(desc);
        name_ = "vulkan";
        keep_warnings_ = options.validation;
        listen();
    }
    rhi::Device& device() override { return device_->device(); }
    rhi::Queue& queue() override { return device_->queue(); }

private:
    void destroy_device() override { device_.reset(); }
    std::unique_ptr<vulkan::VulkanDevice> device_;
};
#endif

std::unique_ptr<Backend> open_vulkan([[maybe_unused]] const BackendOptions& options) {
#ifdef AUREOLE_HAS_VULKAN
    try {
        return std::make_unique<VulkanBackend>(options);
    } catch (const Error& reason) {
        if (reason.field() != "name") throw;  // of VulkanDeviceDesc; here it came from --device
        throw Error(reason.code(), "--device", reason.value(), reason.allowed());
    }
#else
    throw Error(ErrorCode::unsupported, "this program was built without the Vulkan backend (AUREOLE_BUILD_VULKAN)");
#endif
}

/// The first option given that the Vulkan backend alone has; empty if there is none.
std::string vulkan_option(const BackendOptions& options) {
    if (!options.device.empty()) return "--device " + options.device;
    return options.validation ? "--validation" : "";
}

std::unique_ptr<Backend> open_cpu(cpu::Precision precision, const BackendOptions& options) {
    if (const std::string given = vulkan_option(options); !given.empty())
        throw Error(ErrorCode::invalid_argument, given, "--backend " + options.name, "--backend vulkan");
    return std::make_unique<CpuBackend>(precision, options, "");
}

void refuse_threads(const BackendOptions& options, const std::string& chosen) {
    if (options.threads != 0)
        throw Error(ErrorCode::invalid_argument, "--threads " + std::to_string(options.threads), chosen,
                    "--backend cpu or cpu-double");
}

/// Vulkan, or the CPU whatever keeps it from opening; but whoever asked for what Vulkan alone has does not want another
/// backend.
std::unique_ptr<Backend> open_any(const BackendOptions& options, const VulkanOpener& open_vulkan) {
    std::unique_ptr<Backend> vulkan;
    try {
        vulkan = open_vulkan(options);
    } catch (const std::exception& reason) {
        const auto* error = dynamic_cast<const Error*>(&reason);
        if (error != nullptr && error->field() == "--device") throw;
        if (const std::string given = vulkan_option(options); !given.empty())
            throw Error(ErrorCode::unsupported,
                        given + " needs Vulkan, and --backend auto finds none here: " + std::string(reason.what()));
        return std::make_unique<CpuBackend>(cpu::Precision::float32, options, reason.what());
    }
    refuse_threads(options, "--backend auto, which is vulkan here");
    return vulkan;
}

}  // namespace

std::unique_ptr<Backend> open_backend(const BackendOptions& options) { return open_backend(options, open_vulkan); }

std::unique_ptr<Backend> open_backend(const BackendOptions& options, const VulkanOpener& open_vulkan) {
    if (options.name == "cpu") return open_cpu(cpu::Precision::float32, options);
    if (options.name == "cpu-double") return open_cpu(cpu::Precision::float64, options);
    if (options.name == "auto") return open_any(options, open_vulkan);
    if (options.name != "vulkan")
        throw Error(ErrorCode::invalid_argument, "backend", "\"" + options.name + "\"", "auto, vulkan, cpu or cpu-double");
    refuse_threads(options, "--backend vulkan");
    return open_vulkan(options);
}

void Backend::listen() { device().set_message_callback(on_message, this); }

void Backend::on_message(void* user, rhi::Severity severity, const char* text) {
    static_cast<Backend*>(user)->report(severity, text);
}

void Backend::report(rhi::Severity severity, const char* text) {
    const bool warning = severity == rhi::Severity::warning;
    if (severity == rhi::Severity::error || (warning && keep_warnings_)) findings_.emplace_back(text);
    const auto level = severity == rhi::Severity::error ? spdlog::level::err
                       : warning                        ? spdlog::level::warn
                                                        : spdlog::level::debug;
    spdlog::log(level, "{}", text);
}

std::string Backend::describe() {
    const rhi::Capabilities& c = device().capabilities();
    std::string text = name_ + " on " + c.device;
    if (c.threads > 0) text += ", " + std::to_string(c.threads) + (c.threads == 1 ? " thread" : " threads");
    if (!c.driver.empty()) text += ", driver " + c.driver;
    if (!note_.empty()) text += " (not vulkan: " + note_ + ")";
    return text;
}

void Backend::run(const std::function<void(rhi::CommandList&)>& record) {
    record(queue().begin());
    frame_ = queue().submit();
    queue().wait();
}

void Backend::check() const {
    if (findings_.empty()) return;
    const std::string what = findings_.size() == 1 ? "a fault: " : std::to_string(findings_.size()) + " faults, first: ";
    throw Error(ErrorCode::internal, "the device reported " + what + findings_.front());
}

void Backend::close() {
    destroy_device();
    check();
}

DeviceTextures::~DeviceTextures() {
    for (const rhi::Texture texture : textures_) backend_.device().destroy(texture, backend_.frame());
}

rhi::Texture DeviceTextures::create(const char* name, rhi::Format format, rhi::Extent extent, rhi::Usage usage) {
    const std::uint32_t most = backend_.device().capabilities().max_texture_2d;
    if (extent.width > most || extent.height > most)
        throw Error(ErrorCode::unsupported, std::string(name) + ": size",
                    std::to_string(extent.width) + "x" + std::to_string(extent.height),
                    "at most " + std::to_string(most) + " a side on this device");
    textures_.push_back(backend_.device().create_texture({name, rhi::Dimension::d2, format, extent, usage}));
    return textures_.back();
}

void DeviceTextures::make_ready(rhi::Texture texture, rhi::State state) {
    backend_.run([&](rhi::CommandList& commands) {
        const rhi::TextureBarrier barrier{texture, rhi::State::undefined, state};
        commands.barrier({&barrier, 1}, {});
    });
}

void DeviceTextures::upload(rhi::Texture texture, std::span<const std::byte> texels, rhi::State before, rhi::State state) {
    rhi::Device& device = backend_.device();
    const rhi::Buffer buffer = device.create_buffer({"upload", texels.size(), rhi::Usage::upload | rhi::Usage::copy_source});
    device.write_buffer(buffer, texels);
    backend_.run([&](rhi::CommandList& commands) {
        const rhi::TextureBarrier writable{texture, before, rhi::State::copy_destination};
        const rhi::BufferBarrier readable{buffer, rhi::State::undefined, rhi::State::copy_source};
        commands.barrier({&writable, 1}, {&readable, 1});
        commands.copy(rhi::BufferToTexture{buffer, texture});
        const rhi::TextureBarrier done{texture, rhi::State::copy_destination, state};
        commands.barrier({&done, 1}, {});
    });
    device.destroy(buffer, backend_.frame());
}

void DeviceTextures::read(rhi::Texture texture, std::span<std::byte> bytes, rhi::State state) {
    rhi::Device& device = backend_.device();
    const rhi::Buffer buffer =
        device.create_buffer({"read back", bytes.size(), rhi::Usage::read_back | rhi::Usage::copy_destination});
    backend_.run([&](rhi::CommandList& commands) {
        const rhi::TextureBarrier readable{texture, state, rhi::State::copy_source};
        const rhi::BufferBarrier writable{buffer, rhi::State::undefined, rhi::State::copy_destination};
        commands.barrier({&readable, 1}, {&writable, 1});
        commands.copy(rhi::TextureToBuffer{texture, buffer});
        const rhi::TextureBarrier done{texture, rhi::State::copy_source, state};
        commands.barrier({&done, 1}, {});
    });
    device.read_buffer(buffer, bytes);
    device.destroy(buffer, backend_.frame());
}

std::vector<float> DeviceTextures::read_floats(rhi::Texture texture, std::size_t count, rhi::State state) {
    std::vector<float> values(count);
    read(texture, std::as_writable_bytes(std::span(values)), state);
    return values;
}

std::vector<double> DeviceTextures::read_doubles(rhi::Texture texture, std::size_t count, rhi::State state) {
    if (const cpu::CpuDevice* cpu = backend_.cpu()) return cpu->read_texels_double(texture);
    const std::vector<float> values = read_floats(texture, count, state);
    return {values.begin(), values.end()};
}

LightTable DeviceTextures::read_light(const View& view, std::size_t max_suns) {
    return LightTable(read_floats(view.light_table(), LightTable::floats_per_sun * max_suns, rhi::State::sampled));
}

std::vector<std::uint8_t> DeviceTextures::read_bytes(rhi::Texture texture, std::size_t count, rhi::State state) {
    std::vector<std::uint8_t> values(count);
    read(texture, std::as_writable_bytes(std::span(values)), state);
    return values;
}

}  // namespace aureole::app
