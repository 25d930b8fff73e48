// Records commands for the queue to execute.
#pragma once

#include <aureole/rhi/device.h>

#include "commands.h"

namespace aureole::cpu {

class CpuRhiDevice;

class CpuCommandList final : public rhi::CommandList {
public:
    explicit CpuCommandList(CpuRhiDevice& device) : device_(device) {}

    void update_constants(rhi::Buffer buffer, std::span<const std::byte> bytes) override;
    void barrier(std::span<const rhi::TextureBarrier> textures, std::span<const rhi::BufferBarrier> buffers) override;
    void dispatch(const rhi::DispatchDesc& desc) override;
    void draw_fullscreen(const rhi::DrawDesc& desc) override;
    void copy(const rhi::CopyDesc& desc) override;
    void begin_marker(const char* name) override;
    void end_marker() override;
    void timestamp(std::uint32_t index) override;

    [[nodiscard]] const CommandArena& commands() const noexcept { return commands_; }
    /// True if memory ran out while recording: the list must not be executed.
    [[nodiscard]] bool incomplete() const noexcept { return incomplete_; }
    void clear() noexcept;

private:
    /// Adds the command if there is no complaint, and reports the complaint otherwise.
    template <class Command>
    void record(const std::string& complaint, const Command& command, std::span<const std::byte> payload = {}) noexcept;

    CpuRhiDevice& device_;
    CommandArena commands_;
    bool incomplete_ = false;
};

}  // namespace aureole::cpu
