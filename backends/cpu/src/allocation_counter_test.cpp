// Replaces the program's `new`; in a file of its own so that the compiler does not mix it with the standard one.
#include "allocation_counter.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<bool> counting = false;
std::atomic<int> allocations = 0;
}  // namespace

void* operator new(std::size_t size) {
    if (counting) ++allocations;
    if (void* memory = std::malloc(size ? size : 1)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace aureole::cpu {

void begin_counting_allocations() noexcept {
    allocations = 0;
    counting = true;
}
int end_counting_allocations() noexcept {
    counting = false;
    return allocations;
}

}  // namespace aureole::cpu
