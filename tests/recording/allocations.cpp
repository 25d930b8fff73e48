// In a file of its own, so that no call is optimized away.
#include "allocations.h"

#include <cstdlib>
#include <new>

namespace {
thread_local bool counting = false;
thread_local int allocations = 0;

void* allocate(std::size_t size) noexcept {
    if (counting) ++allocations;
    return std::malloc(size > 0 ? size : 1);
}
}  // namespace

void* operator new(std::size_t size) {
    if (void* memory = allocate(size)) return memory;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace aureole::recording {

void begin_counting_allocations() noexcept {
    allocations = 0;
    counting = true;
}
int end_counting_allocations() noexcept {
    counting = false;
    return allocations;
}

}  // namespace aureole::recording
