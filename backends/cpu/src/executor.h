// Executes recorded commands in order; each is split over the device's threads.
#pragma once

#include <cstdint>
#include <vector>

#include "commands.h"
#include "device.h"

namespace aureole::cpu {

class Executor {
public:
    explicit Executor(CpuRhiDevice& device) : device_(device) { touched_.reserve(64); }

    /// Textures of the host's are read before their first use and written back when all commands have run; a command that
    /// throws leaves them as they were.
    void run(const CommandArena& commands);

private:
    void execute(const UpdateCommand& command, std::span<const std::byte> bytes);
    void execute(const DispatchCommand& command, std::span<const std::byte> push_constants);
    void execute(const DrawCommand& command, std::span<const std::byte> push_constants);
    void execute(const rhi::TextureToBuffer& command, std::span<const std::byte>);
    void execute(const rhi::BufferToTexture& command, std::span<const std::byte>);
    void execute(const rhi::TextureToTexture& command, std::span<const std::byte>);
    void execute(const DiscardCommand& command, std::span<const std::byte>);
    void execute(const TimestampCommand& command, std::span<const std::byte>);

    void run_kernel(PipelineObject& pipeline, const BindingsObject* bindings, std::span<const std::byte> push_constants,
                    const std::uint32_t size[3], const rhi::CpuBinding* target);
    void touch(TextureObject& texture, bool written, bool overwritten = false);
    void touch_bindings(const BindingsObject& bindings);
    /// The object, also if it has been destroyed since it was recorded. Throws Error(misuse) if it has been freed.
    template <class Pool, class Handle>
    auto& get(const Pool& pool, Handle handle, const char* kind) const;

    CpuRhiDevice& device_;
    std::uint64_t run_ = 0;                // counts runs, to know textures of the host's that this one has loaded
    std::vector<TextureObject*> touched_;  // textures of the host's used in this run
};

}  // namespace aureole::cpu
