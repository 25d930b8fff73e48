// For tests: how often the program has called `new` since counting began.
#pragma once

namespace aureole::cpu {

void begin_counting_allocations() noexcept;
int end_counting_allocations() noexcept;

}  // namespace aureole::cpu
