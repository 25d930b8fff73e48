// Commands to callbacks: checked by the rules that all devices share, dropped and told where they break them.
#pragma once

#include "adapter_device.h"

namespace aureole::c_api {

class AdapterDevice::List final : public rhi::CommandList {
public:
    explicit List(const AdapterDevice& device) : d_(device) {}
    void begin(void* host_list) noexcept { host_ = host_list; }

    void update_constants(rhi::Buffer buffer, std::span<const std::byte> bytes) override;
    void barrier(std::span<const rhi::TextureBarrier> textures, std::span<const rhi::BufferBarrier> buffers) override;
    void dispatch(const rhi::DispatchDesc& desc) override;
    void draw_fullscreen(const rhi::DrawDesc& desc) override;
    void copy(const rhi::CopyDesc& desc) override;
    void begin_marker(const char* name) override;
    void end_marker() override;
    void timestamp(std::uint32_t index) override;

private:
    /// Tells a complaint; true where there is none.
    [[nodiscard]] bool good(const char* function, const std::string& complaint) const noexcept;

    const AdapterDevice& d_;
    void* host_ = nullptr;
};

}  // namespace aureole::c_api
