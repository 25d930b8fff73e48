// A command list that the host forgets: nothing of it reaches a device.
#pragma once

#include <aureole/rhi/device.h>

namespace aureole::passes {

class DroppedList final : public rhi::CommandList {
public:
    void update_constants(rhi::Buffer, std::span<const std::byte>) override { ++commands; }
    void barrier(std::span<const rhi::TextureBarrier>, std::span<const rhi::BufferBarrier>) override { ++commands; }
    void dispatch(const rhi::DispatchDesc&) override { ++dispatches, ++commands; }
    void draw_fullscreen(const rhi::DrawDesc&) override { ++commands; }
    void copy(const rhi::CopyDesc&) override { ++commands; }
    void begin_marker(const char*) override { ++commands; }
    void end_marker() override { ++commands; }
    void timestamp(std::uint32_t) override { ++commands; }

    int commands = 0, dispatches = 0;
};

}  // namespace aureole::passes
