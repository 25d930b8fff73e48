#include "memory.h"

#include "test_allocations.h"

#include <aureole/rhi/error.h>
#include <doctest/doctest.h>

#include <map>
#include <random>
#include <set>

using namespace aureole;
using namespace aureole::vulkan;

TEST_CASE("ranges given out never overlap, are aligned, and merge again when they return") {
    constexpr VkDeviceSize size = 4096;
    FreeRanges free(size);
    std::map<VkDeviceSize, VkDeviceSize> used;  // offset, size
    std::mt19937 random(7);
    int refused = 0;
    for (int i = 0; i < 5000; ++i) {
        if (random() % 2 == 0) {
            const VkDeviceSize wanted = 1 + random() % 300, alignment = VkDeviceSize{1} << (random() % 8);
            const auto offset = free.take(wanted, alignment);
            if (!offset) {
                ++refused;
                continue;
            }
            REQUIRE(*offset % alignment == 0);
            REQUIRE(*offset + wanted <= size);
            const auto next = used.lower_bound(*offset);
            if (next != used.end()) REQUIRE(*offset + wanted <= next->first);
            if (next != used.begin()) REQUIRE(std::prev(next)->first + std::prev(next)->second <= *offset);
            used[*offset] = wanted;
        } else if (!used.empty()) {
            auto at = used.begin();
            std::advance(at, random() % used.size());
            free.give(at->first, at->second);
            used.erase(at);
        }
    }
    CHECK(refused > 0);  // the block was full at times
    for (const auto& [offset, wanted] : used) free.give(offset, wanted);
    CHECK(free.empty());
    CHECK(free.take(size, 1) == VkDeviceSize{0});
    CHECK(!free.take(1, 1));
}

TEST_CASE("returning a range allocates nothing, in whatever order") {
    constexpr std::size_t count = 257;
    FreeRanges free(count);
    for (std::size_t i = 0; i < count; ++i) REQUIRE(free.take(1, 1));
    test::count_allocations(true);
    for (std::size_t i = 0; i < count; i += 2) free.give(i, 1);  // no neighbours to merge with: the most ranges there can be
    for (std::size_t i = 1; i < count; i += 2) free.give(i, 1);
    test::count_allocations(false);
    CHECK(test::counted_allocations() == 0);
    CHECK(free.empty());
}

namespace {

/// A device that only counts. Type 0: device memory, 1: CPU memory, 2: cached CPU memory.
struct FakeDevice {
    static inline std::map<VkDeviceMemory, VkMemoryAllocateInfo> alive;
    static inline std::set<std::uint32_t> exhausted;
    static inline std::uint64_t next = 1;
    static inline std::byte bytes[64] = {};

    static VKAPI_ATTR VkResult VKAPI_CALL allocate(VkDevice, const VkMemoryAllocateInfo* info, const VkAllocationCallbacks*,
                                                   VkDeviceMemory* memory) {
        if (exhausted.contains(info->memoryTypeIndex)) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
        *memory = reinterpret_cast<VkDeviceMemory>(next++);
        alive[*memory] = *info;
        return VK_SUCCESS;
    }
    static VKAPI_ATTR void VKAPI_CALL free(VkDevice, VkDeviceMemory memory, const VkAllocationCallbacks*) {
        CHECK(alive.erase(memory) == 1);
    }
    static VKAPI_ATTR VkResult VKAPI_CALL map(VkDevice, VkDeviceMemory memory, VkDeviceSize, VkDeviceSize, VkMemoryMapFlags,
                                              void** out) {
        CHECK(alive.at(memory).memoryTypeIndex != 0);
        *out = bytes;
        return VK_SUCCESS;
    }

    FakeDevice() {
        alive.clear();
        exhausted.clear();
        functions.vkAllocateMemory = allocate;
        functions.vkFreeMemory = free;
        functions.vkMapMemory = map;
        const VkMemoryPropertyFlags cpu = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
        types.memoryTypeCount = 3;
        types.memoryTypes[0] = {VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0};
        types.memoryTypes[1] = {cpu, 1};
        types.memoryTypes[2] = {cpu | VK_MEMORY_PROPERTY_HOST_CACHED_BIT, 1};
        types.memoryHeapCount = 2;
        types.memoryHeaps[0].size = types.memoryHeaps[1].size = VkDeviceSize{1} << 30;
    }
    [[nodiscard]] static std::uint32_t type_of(const Memory::Allocation& a) { return alive.at(a.memory).memoryTypeIndex; }

    DeviceFunctions functions;
    VkPhysicalDeviceMemoryProperties types = {};
};

constexpr VkDeviceSize megabyte = 1 << 20;
constexpr VkMemoryRequirements small = {1000, 256, 7};
constexpr auto linear = MemoryLayout::linear;

}  // namespace

TEST_CASE("small objects share memory, large ones have their own, and nothing stays") {
    FakeDevice fake;
    {
        Memory memory(fake.functions, VK_NULL_HANDLE, fake.types, 100, VkDeviceSize{1} << 31);
        std::vector<Memory::Allocation> allocations;
        allocations.reserve(50);
        for (int i = 0; i < 50; ++i) allocations.push_back(memory.allocate(small, MemoryUse::device, linear, "small"));
        CHECK(FakeDevice::alive.size() == 1);
        for (int i = 1; i < 50; ++i) CHECK(allocations[1].offset % 256 == 0);
        // Images do not share with buffers.
        allocations.push_back(memory.allocate(small, MemoryUse::device, MemoryLayout::image, "image"));
        CHECK(FakeDevice::alive.size() == 2);
        const VkMemoryRequirements large = {100 * megabyte, 4096, 7};
        allocations.push_back(memory.allocate(large, MemoryUse::device, linear, "large"));
        CHECK(FakeDevice::alive.size() == 3);
        CHECK(FakeDevice::alive.at(allocations.back().memory).allocationSize == large.size);
        for (const auto& allocation : allocations) memory.free(allocation);
        CHECK(memory.block_count() == 0);
    }
    CHECK(FakeDevice::alive.empty());
}

TEST_CASE("memory suits its use, and other types are tried when one is exhausted") {
    FakeDevice fake;
    Memory memory(fake.functions, VK_NULL_HANDLE, fake.types, 100, VkDeviceSize{1} << 31);
    const auto device = memory.allocate(small, MemoryUse::device, linear, "a");
    const auto upload = memory.allocate(small, MemoryUse::upload, linear, "b");
    const auto read_back = memory.allocate(small, MemoryUse::read_back, linear, "c");
    CHECK(FakeDevice::type_of(device) == 0);
    CHECK(device.mapped == nullptr);
    CHECK(FakeDevice::type_of(upload) == 1);
    CHECK(upload.mapped != nullptr);
    CHECK(FakeDevice::type_of(read_back) == 2);
    CHECK(read_back.mapped != nullptr);

    FakeDevice::exhausted = {0};
    const VkMemoryRequirements large = {50 * megabyte, 16, 7};
    const auto elsewhere = memory.allocate(large, MemoryUse::device, linear, "d");
    CHECK(FakeDevice::type_of(elsewhere) != 0);
    for (const auto& allocation : {device, upload, read_back, elsewhere}) memory.free(allocation);
}

TEST_CASE("memory types that need a use or a feature of their own are left alone, even where nothing else is left") {
    for (const VkMemoryPropertyFlags special :
         {VK_MEMORY_PROPERTY_LAZILY_ALLOCATED_BIT, VK_MEMORY_PROPERTY_PROTECTED_BIT, VK_MEMORY_PROPERTY_DEVICE_COHERENT_BIT_AMD,
          VK_MEMORY_PROPERTY_DEVICE_UNCACHED_BIT_AMD}) {
        CAPTURE(special);
        FakeDevice fake;
        fake.types.memoryTypes[0].propertyFlags |= special;
        fake.types.memoryTypes[1].propertyFlags |= special;
        Memory memory(fake.functions, VK_NULL_HANDLE, fake.types, 100, VkDeviceSize{1} << 31);
        for (const MemoryUse use : {MemoryUse::device, MemoryUse::upload, MemoryUse::read_back}) {
            const auto allocation = memory.allocate(small, use, linear, "a");
            CHECK(FakeDevice::type_of(allocation) == 2);
            memory.free(allocation);
        }
        FakeDevice::exhausted = {2};
        CHECK_THROWS_AS((void)memory.allocate(small, MemoryUse::device, linear, "b"), Error);
    }
}

TEST_CASE("lack of memory is an error that says what for, and how much") {
    FakeDevice fake;
    Memory memory(fake.functions, VK_NULL_HANDLE, fake.types, 2, 200 * megabyte);
    const auto check_refused = [&](const VkMemoryRequirements& need, const std::string& part) {
        try {
            (void)memory.allocate(need, MemoryUse::device, linear, "texture \"huge\"");
            FAIL("was given");
        } catch (const Error& error) {
            CAPTURE(error.what());
            CHECK(error.code() == ErrorCode::out_of_memory);
            CHECK(std::string(error.what()).find("texture \"huge\"") != std::string::npos);
            CHECK(std::string(error.what()).find(std::to_string(need.size)) != std::string::npos);
            CHECK(std::string(error.what()).find(part) != std::string::npos);
        }
    };
    check_refused({201 * megabyte, 16, 7}, "209715200");  // more than the device gives at a time

    FakeDevice::exhausted = {0, 1, 2};
    check_refused({100 * megabyte, 16, 7}, "VK_ERROR_OUT_OF_DEVICE_MEMORY");
    FakeDevice::exhausted.clear();

    // Two allocations are allowed: the third is refused before the device is asked.
    const VkMemoryRequirements own = {100 * megabyte, 16, 7};
    const auto first = memory.allocate(own, MemoryUse::device, linear, "first");
    const auto second = memory.allocate(own, MemoryUse::device, linear, "second");
    check_refused(own, "2 allocations");
    memory.free(second);
    const auto third = memory.allocate(own, MemoryUse::device, linear, "third");
    memory.free(first);
    memory.free(third);
    CHECK(FakeDevice::alive.empty());
}
