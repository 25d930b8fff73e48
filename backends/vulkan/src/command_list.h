// rhi::CommandList on a VkCommandBuffer. Records without allocating; misuse goes to the message callback and is skipped.
#pragma once

#include "device.h"

#include <aureole/rhi/device.h>

namespace aureole::vulkan {

class CommandList final : public rhi::CommandList {
public:
    explicit CommandList(Device& device);

    /// Between begin and end the list records into `commands`, outside of a render pass.
    void begin(VkCommandBuffer commands, std::uint32_t queue_family) noexcept;
    /// Returns lent textures to their state and closes open markers.
    void end() noexcept;
    [[nodiscard]] bool is_recording() const noexcept { return commands_ != VK_NULL_HANDLE; }

    void update_constants(rhi::Buffer buffer, std::span<const std::byte> bytes) override;
    void barrier(std::span<const rhi::TextureBarrier> textures, std::span<const rhi::BufferBarrier> buffers) override;
    void dispatch(const rhi::DispatchDesc& desc) override;
    void draw_fullscreen(const rhi::DrawDesc& desc) override;
    void copy(const rhi::CopyDesc& desc) override;
    void begin_marker(const char* name) override;
    void end_marker() override;
    void timestamp(std::uint32_t index) override;

private:
    [[nodiscard]] bool allowed(const char* verb, const std::string& complaint = {}) const noexcept;
    void bind(VkPipelineBindPoint point, const PipelineObject& pipeline, const BindingSetObject* bindings,
              std::span<const std::byte> push_constants) noexcept;
    void copy_to_buffer(const TextureObject& source, const BufferObject& destination) noexcept;
    void copy_to_texture(const BufferObject& source, const TextureObject& destination) noexcept;
    void copy_between(const TextureObject& source, const TextureObject& destination) noexcept;
    [[nodiscard]] bool queue_copies(const TextureObject& texture) const noexcept;

    Device& device_;
    const Context& context_;
    const DeviceFunctions& fn_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    bool graphics_ = false, timestamps_ = false;  ///< Of the queue that the recording goes to.
    std::uint32_t open_markers_ = 0;
};

}  // namespace aureole::vulkan
