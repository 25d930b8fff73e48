// A device to test physics on, and the little around it: run, upload, read back.
#pragma once

#include <aureole/cpu/cpu_device.h>
#include <aureole/rhi/device.h>

#include <functional>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace aureole::physics {

class Machine {
public:
    virtual ~Machine() = default;
    [[nodiscard]] virtual rhi::Device& device() = 0;
    [[nodiscard]] virtual rhi::Queue& queue() = 0;
    /// Null if this is no CPU device.
    [[nodiscard]] virtual const cpu::CpuDevice* cpu() const { return nullptr; }

    /// Records, submits and waits. Throws if the device has reported an error.
    void run(const std::function<void(rhi::CommandList&)>& record);
    [[nodiscard]] std::uint64_t frame() const noexcept { return frame_; }

    [[nodiscard]] rhi::Texture texture(const char* name, rhi::Format format, rhi::Extent extent, rhi::Usage usage);
    void destroy(rhi::AnyHandle handle) { device().destroy(handle, frame_); }
    void move(rhi::Texture texture, rhi::State before, rhi::State after);
    void upload(rhi::Texture texture, std::span<const float> texels, rhi::State before, rhi::State after);
    /// All texels of an rgba32_float texture; a double-precision device gives them unrounded. In `state` before and after.
    [[nodiscard]] std::vector<glm::dvec4> read(rhi::Texture texture, std::size_t texels, rhi::State state);

protected:
    void listen();

private:
    std::uint64_t frame_ = 0;
    std::string error_;
};

/// One device of each kind for the whole program.
[[nodiscard]] Machine& cpu_float();
[[nodiscard]] Machine& cpu_double();

}  // namespace aureole::physics
