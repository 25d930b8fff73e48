// Counts allocations: this program's operator new is its own.
#pragma once

namespace aureole::vulkan::test {

/// Calls of operator new by this thread since the last `count_allocations(true)`.
void count_allocations(bool on) noexcept;
[[nodiscard]] int counted_allocations() noexcept;

}  // namespace aureole::vulkan::test
