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
        listen();
    }
    rhi::Device& device() override { return device_->device(); }
    rhi::Queue& queue() override { return device_->queue(); }

private:
    std::unique_ptr<vulkan::VulkanDevice> device_;
};
#endif

std::unique_ptr<Backend> open_vulkan([[maybe_unused]] const BackendOptions& options) {
#ifdef AUREOLE_HAS_VULKAN
    return std::make_unique<VulkanBackend>(options);
#else
    throw Error(ErrorCode::unsupported, "this program was built without the Vulkan backend (AUREOLE_BUILD_VULKAN)");
#endif
}

}  // namespace

std::unique_ptr<Backend> open_backend(const BackendOptions& options) { return open_backend(options, open_vulkan); }

std::unique_ptr<Backend> open_backend(const BackendOptions& options, const VulkanOpener& open_vulkan) {
    if (options.name == "vulkan") return open_vulkan(options);
    if (options.name == "cpu") return std::make_unique<CpuBackend>(cpu::Precision::float32, options, "");
    if (options.name == "cpu-double") return std::make_unique<CpuBackend>(cpu::Precision::float64, options, "");
    if (options.name != "auto")
        throw Error(ErrorCode::invalid_argument, "backend", "\"" + options.name + "\"", "auto, vulkan, cpu or cpu-double");
    try {
        return open_vulkan(options);
    } catch (const std::exception& reason) {
        // Whoever named a device or asked for the validation layer does not want another backend instead.
        if (!options.device.empty() || options.validation) throw;
        return std::make_unique<CpuBackend>(cpu::Precision::float32, options, reason.what());
    }
}

void Backend::listen() { device().set_message_callback(on_message, this); }

void Backend::on_message(void* user, rhi::Severity severity, const char* text) {
    if (severity == rhi::Severity::error) static_cast<Backend*>(user)->errors_.emplace_back(text);
    const auto level = severity == rhi::Severity::error     ? spdlog::level::err
                       : severity == rhi::Severity::warning ? spdlog::level::warn
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
    if (errors_.empty()) return;
    throw Error(ErrorCode::internal,
                "the device reported " + std::to_string(errors_.size()) + " errors, first: " + errors_.front());
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

std::vector<std::uint8_t> DeviceTextures::read_bytes(rhi::Texture texture, std::size_t count, rhi::State state) {
    std::vector<std::uint8_t> values(count);
    read(texture, std::as_writable_bytes(std::span(values)), state);
    return values;
}

}  // namespace aureole::app
