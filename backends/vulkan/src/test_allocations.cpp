// Apart from the tests, so that no call is optimized away.
#include "test_allocations.h"

#include <cstdlib>
#include <new>

namespace {
thread_local bool counting = false;
thread_local int allocations = 0;
}  // namespace

void* operator new(std::size_t size) {
    if (counting) ++allocations;
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    if (counting) ++allocations;
    return std::malloc(size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace aureole::vulkan::test {

void count_allocations(bool on) noexcept {
    counting = on;
    if (on) allocations = 0;
}

int counted_allocations() noexcept { return allocations; }

}  // namespace aureole::vulkan::test
