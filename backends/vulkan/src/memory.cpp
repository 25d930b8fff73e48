#include "memory.h"

#include "result.h"

#include <algorithm>
#include <string>

namespace aureole::vulkan {
namespace {

constexpr VkDeviceSize shared_block_size = VkDeviceSize{8} << 20;

/// Memory that needs a use or a feature of its own, which is never asked for or enabled.
constexpr VkMemoryPropertyFlags special_properties =
    VK_MEMORY_PROPERTY_LAZILY_ALLOCATED_BIT | VK_MEMORY_PROPERTY_PROTECTED_BIT | VK_MEMORY_PROPERTY_DEVICE_COHERENT_BIT_AMD |
    VK_MEMORY_PROPERTY_DEVICE_UNCACHED_BIT_AMD;

constexpr VkDeviceSize align_up(VkDeviceSize value, VkDeviceSize alignment) {
    return (value + alignment - 1) / alignment * alignment;
}

}  // namespace

std::optional<VkDeviceSize> FreeRanges::take(VkDeviceSize size, VkDeviceSize alignment) {
    // Between and around n taken ranges lie at most n + 1 free ones; `give` adds one before it merges neighbours.
    const std::size_t most = taken_ + 3;
    if (ranges_.capacity() < most) ranges_.reserve(2 * most);
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
        const Range range = ranges_[i];
        const VkDeviceSize offset = align_up(range.offset, alignment);
        const VkDeviceSize gap = offset - range.offset;
        if (range.size < gap || range.size - gap < size) continue;
        const Range before = {range.offset, gap};
        const Range after = {offset + size, range.size - gap - size};
        ranges_.erase(ranges_.begin() + static_cast<std::ptrdiff_t>(i));
        auto at = ranges_.begin() + static_cast<std::ptrdiff_t>(i);
        if (after.size > 0) at = ranges_.insert(at, after);
        if (before.size > 0) ranges_.insert(at, before);
        ++taken_;
        return offset;
    }
    return std::nullopt;
}

void FreeRanges::give(VkDeviceSize offset, VkDeviceSize size) noexcept {
    --taken_;
    const auto later = [](VkDeviceSize value, const Range& range) { return value < range.offset; };
    auto at = ranges_.insert(std::upper_bound(ranges_.begin(), ranges_.end(), offset, later), Range{offset, size});
    if (const auto next = at + 1; next != ranges_.end() && at->offset + at->size == next->offset) {
        at->size += next->size;
        ranges_.erase(next);
    }
    if (at == ranges_.begin()) return;
    if (const auto previous = at - 1; previous->offset + previous->size == at->offset) {
        previous->size += at->size;
        ranges_.erase(at);
    }
}

struct Memory::Block {
    VkDeviceMemory memory;
    std::uint32_t type;
    MemoryLayout layout;
    std::byte* mapped;
    FreeRanges free;
};

Memory::Memory(const DeviceFunctions& functions, VkDevice device, const VkPhysicalDeviceMemoryProperties& types,
               std::uint32_t max_allocation_count, VkDeviceSize max_allocation_size)
    : functions_(functions),
      device_(device),
      types_(types),
      max_allocation_count_(max_allocation_count),
      max_allocation_size_(max_allocation_size) {}

Memory::~Memory() {
    for (const auto& block : blocks_) functions_.vkFreeMemory(device_, block->memory, nullptr);
}

/// Every allowed type with the properties that `use` cannot do without; those with the properties it likes come first.
std::vector<std::uint32_t> Memory::candidate_types(std::uint32_t allowed, MemoryUse use) const {
    const VkMemoryPropertyFlags cpu = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    const VkMemoryPropertyFlags needed = use == MemoryUse::device ? 0 : cpu;
    const VkMemoryPropertyFlags liked = use == MemoryUse::device      ? VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT
                                        : use == MemoryUse::read_back ? VK_MEMORY_PROPERTY_HOST_CACHED_BIT
                                                                      : 0;
    std::vector<std::uint32_t> first, second;
    for (std::uint32_t i = 0; i < types_.memoryTypeCount; ++i) {
        const VkMemoryPropertyFlags flags = types_.memoryTypes[i].propertyFlags;
        if (!(allowed & (1u << i)) || (flags & needed) != needed) continue;
        if (flags & special_properties) continue;
        ((flags & liked) == liked ? first : second).push_back(i);
    }
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

std::optional<Memory::Allocation> Memory::take_from_blocks(std::uint32_t type, const VkMemoryRequirements& need,
                                                           MemoryLayout layout) {
    for (const auto& block : blocks_) {
        if (block->type != type || block->layout != layout) continue;
        if (const auto offset = block->free.take(need.size, need.alignment)) {
            std::byte* mapped = block->mapped ? block->mapped + *offset : nullptr;
            return Allocation{block.get(), block->memory, *offset, need.size, mapped};
        }
    }
    return std::nullopt;
}

/// Blocks are shared, but never more than an eighth of a heap; what would fill most of one gets its own.
VkDeviceSize Memory::block_size(std::uint32_t type, VkDeviceSize need) const {
    const VkDeviceSize heap = types_.memoryHeaps[types_.memoryTypes[type].heapIndex].size;
    const VkDeviceSize shared = std::min({shared_block_size, heap / 8, max_allocation_size_});
    return need > shared / 2 ? need : shared;
}

Memory::Answer Memory::add_block(std::uint32_t type, VkDeviceSize size, MemoryLayout layout) {
    blocks_.reserve(blocks_.size() + 1);
    VkMemoryAllocateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = size;
    info.memoryTypeIndex = type;
    auto block = std::make_unique<Block>(Block{VK_NULL_HANDLE, type, layout, nullptr, FreeRanges(size)});
    VkResult result = functions_.vkAllocateMemory(device_, &info, nullptr, &block->memory);
    if (result < VK_SUCCESS) return {result, "vkAllocateMemory"};
    const VkMemoryPropertyFlags flags = types_.memoryTypes[type].propertyFlags;
    const VkMemoryPropertyFlags cpu = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    if (layout == MemoryLayout::linear && (flags & cpu) == cpu) {
        void* mapped = nullptr;
        result = functions_.vkMapMemory(device_, block->memory, 0, VK_WHOLE_SIZE, 0, &mapped);
        if (result < VK_SUCCESS) {
            functions_.vkFreeMemory(device_, block->memory, nullptr);
            return {result, "vkMapMemory"};
        }
        block->mapped = static_cast<std::byte*>(mapped);
    }
    blocks_.push_back(std::move(block));
    return {};
}

Memory::Allocation Memory::allocate(const VkMemoryRequirements& need, MemoryUse use, MemoryLayout layout,
                                    std::string_view what) {
    const std::string wanted = std::string(what) + ": " + std::to_string(need.size) + " bytes of device memory";
    if (need.size > max_allocation_size_)
        throw Error(ErrorCode::out_of_memory, wanted + " are more than the " + std::to_string(max_allocation_size_) +
                                                  " bytes that the device gives at a time");
    Answer answer{VK_ERROR_OUT_OF_DEVICE_MEMORY, "vkAllocateMemory"};
    for (std::uint32_t type : candidate_types(need.memoryTypeBits, use)) {
        if (auto allocation = take_from_blocks(type, need, layout)) return *allocation;
        if (blocks_.size() >= max_allocation_count_)
            throw Error(ErrorCode::out_of_memory, wanted + " would be one more than the " +
                                                      std::to_string(max_allocation_count_) + " allocations the device allows");
        answer = add_block(type, block_size(type, need.size), layout);
        if (answer.result == VK_SUCCESS) return *take_from_blocks(type, need, layout);
        if (error_code(answer.result) != ErrorCode::out_of_memory) break;
    }
    check_result(answer.result, answer.call, wanted);
    return {};
}

void Memory::free(const Allocation& allocation) noexcept {
    if (!allocation.block) return;
    allocation.block->free.give(allocation.offset, allocation.size);
    if (!allocation.block->free.empty()) return;
    const auto is_it = [&](const auto& block) { return block.get() == allocation.block; };
    const auto at = std::find_if(blocks_.begin(), blocks_.end(), is_it);
    functions_.vkFreeMemory(device_, (*at)->memory, nullptr);
    blocks_.erase(at);
}

}  // namespace aureole::vulkan
