// A device to run on, whichever it is, and the little that a program without a frame loop needs around it.
#pragma once

#include <aureole/atmosphere.h>
#include <aureole/cpu/cpu_device.h>
#include <aureole/light.h>
#include <aureole/rhi/device.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace aureole::app {

struct BackendOptions {
    std::string name = "auto";  ///< "auto", "vulkan", "cpu" or "cpu-double".
    std::string device{};       ///< Vulkan alone: part of a device's name; empty: the best one.
    bool validation = false;    ///< Vulkan alone: under the validation layer; its findings become errors of `Backend::check`.
    unsigned threads = 0;       ///< CPU alone: 0 for all.
    bool count_work = false;    ///< CPU: count evaluations, look-ups and bytes (cpu::CpuDevice::work).
};

/// Owns a device and its queue.
class Backend {
public:
    virtual ~Backend() = default;
    [[nodiscard]] virtual rhi::Device& device() = 0;
    [[nodiscard]] virtual rhi::Queue& queue() = 0;
    /// The device of a CPU backend, else null.
    [[nodiscard]] virtual cpu::CpuDevice* cpu() { return nullptr; }

    [[nodiscard]] const std::string& name() const noexcept { return name_; }  ///< "vulkan", "cpu" or "cpu-double".
    /// "vulkan on llvmpipe (...), driver ...", with the reason if another backend was hoped for.
    [[nodiscard]] std::string describe();
    /// Records with `record`, runs it, and waits.
    void run(const std::function<void(rhi::CommandList&)>& record);
    /// Frame number of the latest run.
    [[nodiscard]] std::uint64_t frame() const noexcept { return frame_; }
    /// Throws Error(internal) if the device has reported errors (under the validation layer: or warnings).
    void check() const;
    /// Destroys the device, which may have more to report while it goes, and checks. Nothing of it may be in use any more, and
    /// nothing but the name may be asked for afterwards.
    void close();

protected:
    void listen();  ///< To the device's messages: they go to the log, findings are kept.
    void report(rhi::Severity severity, const char* text);
    virtual void destroy_device() = 0;
    std::string name_, note_;
    bool keep_warnings_ = false;

private:
    static void on_message(void* user, rhi::Severity severity, const char* text);
    std::uint64_t frame_ = 0;
    std::vector<std::string> findings_;
};

/// "auto" is Vulkan if that can be opened, else the CPU in float, with the reason in `describe`; but whoever named a device or
/// asked for the validation layer gets the reason as the error.
/// Throws Error: invalid_argument (name; an option that this backend does not have), unsupported (no such device; says why).
[[nodiscard]] std::unique_ptr<Backend> open_backend(const BackendOptions& options);
/// The same with another way to open Vulkan.
using VulkanOpener = std::function<std::unique_ptr<Backend>(const BackendOptions&)>;
[[nodiscard]] std::unique_ptr<Backend> open_backend(const BackendOptions& options, const VulkanOpener& open_vulkan);

/// Textures that die with it, and the ways into and out of them.
class DeviceTextures {
public:
    explicit DeviceTextures(Backend& backend) : backend_(backend) {}
    ~DeviceTextures();
    DeviceTextures(const DeviceTextures&) = delete;
    DeviceTextures& operator=(const DeviceTextures&) = delete;

    /// Throws Error(unsupported) naming the device's limit if the extent is too large for it.
    [[nodiscard]] rhi::Texture create(const char* name, rhi::Format format, rhi::Extent extent, rhi::Usage usage);
    /// From whatever state to `state`.
    void make_ready(rhi::Texture texture, rhi::State state);
    /// Replaces all texels; the texture was in `before` (or is new) and ends in `state`.
    void upload(rhi::Texture texture, std::span<const std::byte> texels, rhi::State before, rhi::State state);
    /// All texels; the texture is in `state` before and after.
    [[nodiscard]] std::vector<float> read_floats(rhi::Texture texture, std::size_t count, rhi::State state);
    /// The same, unrounded where the device is in double precision.
    [[nodiscard]] std::vector<double> read_doubles(rhi::Texture texture, std::size_t count, rhi::State state);
    /// A view's light table, recorded with so many suns at most (ViewSettings::max_suns).
    [[nodiscard]] LightTable read_light(const View& view, std::size_t max_suns);
    [[nodiscard]] std::vector<std::uint8_t> read_bytes(rhi::Texture texture, std::size_t count, rhi::State state);

private:
    void read(rhi::Texture texture, std::span<std::byte> bytes, rhi::State state);
    Backend& backend_;
    std::vector<rhi::Texture> textures_;
};

}  // namespace aureole::app
