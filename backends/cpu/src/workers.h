// The threads that share the work of one command.
#pragma once

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cstddef>

#ifdef __SANITIZE_THREAD__
extern "C" void __tsan_acquire(void* address);
extern "C" void __tsan_release(void* address);
#endif

namespace aureole::cpu {

/// ThreadSanitizer sees no hand-over of work inside of libtbb, which was not compiled for it: it is told that pieces come after
/// what their caller did before, and before what it does next. Of each other they are told nothing. Else both functions are
/// empty.
class HandOver {
public:
    void give() noexcept { release(given_); }
    void take() noexcept { acquire(given_); }
    void give_back() noexcept { release(returned_); }
    void take_back() noexcept { acquire(returned_); }

private:
#ifdef __SANITIZE_THREAD__
    static void acquire(char& mark) noexcept { __tsan_acquire(&mark); }
    static void release(char& mark) noexcept { __tsan_release(&mark); }
#else
    static void acquire(char&) noexcept {}
    static void release(char&) noexcept {}
#endif
    char given_ = 0, returned_ = 0;
};
inline HandOver hand_over;  // one for all: a piece must not look for it in what it has been handed

class Workers {
public:
    /// 0: as many as the process may use, which is also the most.
    explicit Workers(unsigned threads) : arena_(static_cast<int>(threads == 0 ? allowed() : std::min(threads, allowed()))) {
        arena_.initialize();
    }

    [[nodiscard]] unsigned count() const { return static_cast<unsigned>(std::max(arena_.max_concurrency(), 1)); }

    /// Calls body(begin, end) on disjoint pieces of [0, size), each `grain` long or shorter, and waits for all of them.
    template <class Body>
    void for_each(std::size_t size, std::size_t grain, const Body& body) {
        if (size <= grain) {
            if (size > 0) body(std::size_t{0}, size);
            return;
        }
        using Range = oneapi::tbb::blocked_range<std::size_t>;
        hand_over.give();
        arena_.execute([&] {
            oneapi::tbb::parallel_for(
                Range(0, size, grain),
                [&](const Range& r) {
                    hand_over.take();
                    body(r.begin(), r.end());
                    hand_over.give_back();
                },
                oneapi::tbb::simple_partitioner{});
        });
        hand_over.take_back();
    }

private:
    static unsigned allowed() {
        using oneapi::tbb::global_control;
        return static_cast<unsigned>(
            std::max<std::size_t>(global_control::active_value(global_control::max_allowed_parallelism), 1));
    }

    oneapi::tbb::task_arena arena_;
};

}  // namespace aureole::cpu
