#include "buffer.h"

#include <aureole/rhi/checks.h>

#include <cstring>

namespace aureole::cpu {
namespace {

void check_access(const rhi::BufferDesc& desc, rhi::Usage usage, std::size_t bytes) {
    if (!rhi::has(desc.usage, usage))
        throw Error(ErrorCode::misuse, rhi::field_name("buffer", desc.name, "usage"), rhi::to_string(desc.usage),
                    rhi::to_string(usage));
    if (bytes > desc.size)
        throw Error(ErrorCode::invalid_argument, rhi::field_name("buffer", desc.name, "bytes"), std::to_string(bytes),
                    "at most its size, " + std::to_string(desc.size));
}

}  // namespace

BufferObject::BufferObject(const rhi::BufferDesc& desc) : desc_(desc), bytes_(static_cast<std::size_t>(desc.size)) {}

void BufferObject::write(std::span<const std::byte> bytes) {
    check_access(desc_, rhi::Usage::upload, bytes.size());
    std::memcpy(bytes_.data(), bytes.data(), bytes.size());
}

void BufferObject::read(std::span<std::byte> bytes) const {
    check_access(desc_, rhi::Usage::read_back, bytes.size());
    std::memcpy(bytes.data(), bytes_.data(), bytes.size());
}

}  // namespace aureole::cpu
