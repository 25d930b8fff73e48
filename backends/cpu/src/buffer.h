// A buffer on the CPU: bytes.
#pragma once

#include <aureole/rhi/types.h>

#include <cstddef>
#include <span>
#include <vector>

namespace aureole::cpu {

class BufferObject {
public:
    explicit BufferObject(const rhi::BufferDesc& desc);

    [[nodiscard]] const rhi::BufferDesc& desc() const noexcept { return desc_; }
    [[nodiscard]] std::span<std::byte> bytes() noexcept { return bytes_; }

    /// From the start of the buffer. Throw Error for too many bytes or a buffer that lacks the usage `upload` or `read_back`.
    void write(std::span<const std::byte> bytes);
    void read(std::span<std::byte> bytes) const;

private:
    rhi::BufferDesc desc_;
    std::vector<std::byte> bytes_;
};

}  // namespace aureole::cpu
