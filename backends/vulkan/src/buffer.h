// Buffers; those that the CPU touches stay mapped.
#pragma once

#include "context.h"
#include "states.h"

#include <aureole/rhi/types.h>

#include <cstddef>
#include <span>

namespace aureole::vulkan {

class BufferObject {
public:
    /// `desc` has passed rhi::check. Throws Error and leaves nothing behind.
    BufferObject(Context& context, const rhi::BufferDesc& desc);
    ~BufferObject();
    BufferObject(const BufferObject&) = delete;
    BufferObject& operator=(const BufferObject&) = delete;

    [[nodiscard]] const rhi::BufferDesc& desc() const noexcept { return desc_; }
    [[nodiscard]] VkBuffer buffer() const noexcept { return buffer_; }
    /// Throw Error: misuse without the usage, invalid_argument for more bytes than the buffer has.
    void write(std::span<const std::byte> bytes);
    void read(std::span<std::byte> bytes) const;

    /// As of textures.
    StateAccess last_access;

private:
    void check_cpu_access(rhi::Usage usage, std::size_t bytes) const;
    void release() noexcept;

    Context& context_;
    rhi::BufferDesc desc_;
    VkBuffer buffer_ = VK_NULL_HANDLE;
    Memory::Allocation allocation_;
};

}  // namespace aureole::vulkan
