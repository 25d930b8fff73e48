// The backends as the tests of the passes see them: a device under the RHI's validation wrapper (and Vulkan's validation layer
// with synchronization checks), with every message a failure, and tables read and written as doubles.
#pragma once

#include <aureole/cpu/cpu_device.h>
#include <aureole/rhi/validation.h>

#include <functional>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <string>
#include <vector>

#include "passes/counting_device.h"
#include "rhi/image.h"

namespace aureole::passes {

/// A device and its queue, however they were made.
struct OpenDevice {
    virtual ~OpenDevice() = default;
    [[nodiscard]] virtual rhi::Device& device() = 0;
    [[nodiscard]] virtual rhi::Queue& queue() = 0;
    [[nodiscard]] virtual const cpu::CpuDevice* cpu() const { return nullptr; }
};

class Backend {
public:
    Backend(std::string name, std::unique_ptr<OpenDevice> inner);
    /// Objects that are left and messages that nobody took are failures.
    ~Backend();
    Backend(const Backend&) = delete;
    Backend& operator=(const Backend&) = delete;

    [[nodiscard]] const std::string& name() const noexcept { return name_; }
    [[nodiscard]] CountingDevice& device() noexcept { return *counting_; }
    /// Records, runs and waits. Returns what was recorded.
    CommandCounts run(const std::function<void(rhi::CommandList&)>& record);
    /// Messages so far, one a line; forgets them.
    [[nodiscard]] std::string take_messages();

    /// Texels of a texture in State::sampled (or `state`) that lives on this device.
    [[nodiscard]] Image read(rhi::Texture texture, rhi::State state = rhi::State::sampled);
    /// Replaces them: rounded to the format, and to float on every backend.
    void write(rhi::Texture texture, const Image& image, rhi::State state = rhi::State::sampled);
    /// A sampled texture with these texels, destroyed with the backend.
    [[nodiscard]] rhi::Texture make(const std::string& name, rhi::Format format, const Image& image);
    /// A target for composites, in `state`, destroyed with the backend.
    [[nodiscard]] rhi::Texture make_target(rhi::Format format, rhi::Extent extent, rhi::State state);

private:
    static void collect(void* backend, rhi::Severity severity, const char* text);

    std::string name_;
    std::unique_ptr<OpenDevice> inner_;
    std::unique_ptr<rhi::ValidationDevice> validation_;
    std::unique_ptr<rhi::Queue> queue_;
    std::unique_ptr<CountingDevice> counting_;
    std::vector<rhi::AnyHandle> made_;
    std::vector<std::string> messages_;
};

[[nodiscard]] std::unique_ptr<Backend> open_cpu_float(unsigned threads = 0);
[[nodiscard]] std::unique_ptr<Backend> open_cpu_double();
/// Null, and says that the test is skipped, where there is no device, no validation layer, or no Vulkan backend in this build.
[[nodiscard]] std::unique_ptr<Backend> open_vulkan();

}  // namespace aureole::passes
