// Issues commands to the context as they are recorded.
#pragma once

#include "device.h"
#include "host_state.h"

namespace aureole::gl {

class CommandList final : public rhi::CommandList {
public:
    explicit CommandList(Device& device) : device_(device) {}

    /// Puts the host's state back, and makes what was stored visible to whatever the host does next.
    void finish() noexcept;

    void update_constants(rhi::Buffer buffer, std::span<const std::byte> bytes) override;
    void barrier(std::span<const rhi::TextureBarrier> textures, std::span<const rhi::BufferBarrier> buffers) override;
    void dispatch(const rhi::DispatchDesc& desc) override;
    void draw_fullscreen(const rhi::DrawDesc& desc) override;
    void copy(const rhi::CopyDesc& desc) override;
    void begin_marker(const char* name) override;
    void end_marker() override;
    void timestamp(std::uint32_t index) override;

private:
    [[nodiscard]] bool refuse(const std::string& complaint) noexcept;
    void use(const PipelineObject& pipeline, const BindingsObject* bindings,
             std::span<const std::byte> push_constants) noexcept;
    void bind(const BindingsObject::Slot& slot) noexcept;
    void push(std::span<const std::byte> bytes) noexcept;
    void write(GLuint buffer, std::span<const std::byte> bytes) noexcept;

    Device& device_;
    HostState host_;
    std::uint32_t open_markers_ = 0;
    bool stored_ = false;
};

}  // namespace aureole::gl
