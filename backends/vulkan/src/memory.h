// Device memory: small objects share blocks, large ones get an allocation of their own, so that the number of allocations
// stays far below the device's limit (maxMemoryAllocationCount, which a host needs for itself).
#pragma once

#include "functions.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace aureole::vulkan {

/// Free parts of a block, in order, neighbours merged. First fit.
class FreeRanges {
public:
    explicit FreeRanges(VkDeviceSize size) : size_(size), ranges_{{0, size}} {}

    /// Offset of `size` > 0 bytes at a multiple of `alignment` > 0, now in use; nothing if there is no room.
    [[nodiscard]] std::optional<VkDeviceSize> take(VkDeviceSize size, VkDeviceSize alignment);
    /// Returns what `take` gave.
    void give(VkDeviceSize offset, VkDeviceSize size) noexcept;
    /// Nothing is in use.
    [[nodiscard]] bool empty() const noexcept { return ranges_.size() == 1 && ranges_[0].size == size_; }

private:
    struct Range {
        VkDeviceSize offset, size;
    };
    VkDeviceSize size_;
    std::size_t taken_ = 0;      ///< Takes without their give.
    std::vector<Range> ranges_;  ///< With room for what `give` adds: it must not allocate.
};

enum class MemoryUse {
    device,     ///< Touched by the device alone.
    upload,     ///< Written by the CPU.
    read_back,  ///< Read by the CPU.
};

/// Linear resources (buffers) and images do not share blocks: no bufferImageGranularity to care for.
enum class MemoryLayout { linear, image };

class Memory {
    struct Block;

public:
    struct Allocation {
        Block* block = nullptr;
        VkDeviceMemory memory = VK_NULL_HANDLE;
        VkDeviceSize offset = 0, size = 0;
        std::byte* mapped = nullptr;  ///< Of CPU-visible memory, which is always coherent.
    };

    Memory(const DeviceFunctions& functions, VkDevice device, const VkPhysicalDeviceMemoryProperties& types,
           std::uint32_t max_allocation_count, VkDeviceSize max_allocation_size);
    ~Memory();  ///< Everything has been freed.
    Memory(const Memory&) = delete;
    Memory& operator=(const Memory&) = delete;

    /// Throws Error(out_of_memory) that says what for and how many bytes.
    [[nodiscard]] Allocation allocate(const VkMemoryRequirements& need, MemoryUse use, MemoryLayout layout,
                                      std::string_view what);
    void free(const Allocation& allocation) noexcept;

    [[nodiscard]] std::size_t block_count() const noexcept { return blocks_.size(); }

private:
    [[nodiscard]] std::vector<std::uint32_t> candidate_types(std::uint32_t allowed, MemoryUse use) const;
    [[nodiscard]] std::optional<Allocation> take_from_blocks(std::uint32_t type, const VkMemoryRequirements& need,
                                                             MemoryLayout layout);
    /// What the last call returned, and which it was.
    struct Answer {
        VkResult result = VK_SUCCESS;
        const char* call = "";
    };
    [[nodiscard]] Answer add_block(std::uint32_t type, VkDeviceSize size, MemoryLayout layout);
    [[nodiscard]] VkDeviceSize block_size(std::uint32_t type, VkDeviceSize need) const;

    const DeviceFunctions& functions_;
    VkDevice device_;
    VkPhysicalDeviceMemoryProperties types_;
    std::uint32_t max_allocation_count_;
    VkDeviceSize max_allocation_size_;
    std::vector<std::unique_ptr<Block>> blocks_;
};

}  // namespace aureole::vulkan
