// Counts allocations: this program's operator new is its own.
#pragma once

namespace aureole::recording {

/// From here on, this thread's calls of operator new are counted.
void begin_counting_allocations() noexcept;
/// How many there were.
[[nodiscard]] int end_counting_allocations() noexcept;

}  // namespace aureole::recording
