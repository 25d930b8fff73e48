// Timestamp slots in a query pool.
#pragma once

#include "context.h"

#include <bitset>
#include <span>

namespace aureole::vulkan {

class Timestamps {
public:
    static constexpr std::uint32_t max_slots = 256;

    /// Throws Error. A queue without timestamps has 0 slots.
    explicit Timestamps(const Context& context);
    ~Timestamps();
    Timestamps(const Timestamps&) = delete;
    Timestamps& operator=(const Timestamps&) = delete;

    [[nodiscard]] std::uint32_t slots() const noexcept { return pool_ ? max_slots : 0; }
    /// `index` < slots().
    void record(VkCommandBuffer commands, std::uint32_t index) noexcept;
    /// Slots that were never recorded read as NaN. Throws Error(invalid_argument) for more slots than there are.
    void read(std::span<double> out_nanoseconds) const;

private:
    const Context& context_;
    VkQueryPool pool_ = VK_NULL_HANDLE;
    std::uint64_t valid_bits_ = 0;
    std::bitset<max_slots> recorded_;
};

}  // namespace aureole::vulkan
