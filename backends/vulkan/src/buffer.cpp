#include "buffer.h"

#include "result.h"

#include <aureole/rhi/checks.h>

#include <cstring>
#include <string>

namespace aureole::vulkan {
namespace {

VkBufferUsageFlags buffer_usage(rhi::Usage usage) {
    VkBufferUsageFlags flags = 0;
    // A copy is how bytes get into constants (update_constants) and read_back buffers, and out of upload buffers.
    if (has(usage, rhi::Usage::constants)) flags |= VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    if (has(usage, rhi::Usage::read_back)) flags |= VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    if (has(usage, rhi::Usage::upload)) flags |= VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
    if (has(usage, rhi::Usage::copy_source)) flags |= VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
    if (has(usage, rhi::Usage::copy_destination)) flags |= VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    return flags;
}

MemoryUse memory_use(rhi::Usage usage) {
    if (has(usage, rhi::Usage::read_back)) return MemoryUse::read_back;
    return has(usage, rhi::Usage::upload) ? MemoryUse::upload : MemoryUse::device;
}

}  // namespace

BufferObject::BufferObject(Context& context, const rhi::BufferDesc& desc) : context_(context), desc_(desc) {
    const std::string what = rhi::field_name("buffer", desc_.name, "");
    if (has(desc_.usage, rhi::Usage::constants) && desc_.size > context_.limits().maxUniformBufferRange)
        throw Error(ErrorCode::unsupported, rhi::field_name("buffer", desc_.name, "size"), std::to_string(desc_.size),
                    "at most " + std::to_string(context_.limits().maxUniformBufferRange) + " for constants on this device");
    // Asked before the buffer is made: Vulkan 1.1 has no limit of its own on a buffer's size.
    if (desc_.size > context_.physical.max_allocation_size)
        throw Error(ErrorCode::unsupported, rhi::field_name("buffer", desc_.name, "size"), std::to_string(desc_.size),
                    "at most " + std::to_string(context_.physical.max_allocation_size) + " on this device");
    try {
        VkBufferCreateInfo info = {};
        info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
        info.size = desc_.size;
        info.usage = buffer_usage(desc_.usage);
        context_.share(info);
        check_result(context_.fn.vkCreateBuffer(context_.device, &info, nullptr, &buffer_), "vkCreateBuffer", what);
        VkMemoryRequirements need = {};
        context_.fn.vkGetBufferMemoryRequirements(context_.device, buffer_, &need);
        allocation_ = context_.memory.allocate(need, memory_use(desc_.usage), MemoryLayout::linear, what);
        check_result(context_.fn.vkBindBufferMemory(context_.device, buffer_, allocation_.memory, allocation_.offset),
                     "vkBindBufferMemory", what);
    } catch (...) {
        release();
        throw;
    }
    context_.set_name(VK_OBJECT_TYPE_BUFFER, buffer_, desc_.name);
    // Submitting makes the CPU's bytes visible: the first copy needs no barrier, but what comes after it may have to wait for
    // it.
    if (has(desc_.usage, rhi::Usage::upload)) last_access = access_of(rhi::State::copy_source, context_.graphics);
}

BufferObject::~BufferObject() { release(); }

void BufferObject::release() noexcept {
    context_.fn.vkDestroyBuffer(context_.device, buffer_, nullptr);
    context_.memory.free(allocation_);
}

void BufferObject::check_cpu_access(rhi::Usage usage, std::size_t bytes) const {
    if (!has(desc_.usage, usage))
        throw Error(ErrorCode::misuse, rhi::field_name("buffer", desc_.name, "usage"), rhi::to_string(desc_.usage),
                    "with " + rhi::to_string(usage));
    if (bytes > desc_.size)
        throw Error(ErrorCode::invalid_argument, rhi::field_name("buffer", desc_.name, "bytes"), std::to_string(bytes),
                    "at most its size, " + std::to_string(desc_.size));
}

void BufferObject::write(std::span<const std::byte> bytes) {
    check_cpu_access(rhi::Usage::upload, bytes.size());
    if (!bytes.empty()) std::memcpy(allocation_.mapped, bytes.data(), bytes.size());
}

void BufferObject::read(std::span<std::byte> bytes) const {
    check_cpu_access(rhi::Usage::read_back, bytes.size());
    if (!bytes.empty()) std::memcpy(bytes.data(), allocation_.mapped, bytes.size());
}

}  // namespace aureole::vulkan
