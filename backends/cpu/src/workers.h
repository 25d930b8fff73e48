// The threads that share the work of one command.
#pragma once

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cstddef>

namespace aureole::cpu {

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
        arena_.execute([&] {
            oneapi::tbb::parallel_for(
                Range(0, size, grain), [&](const Range& r) { body(r.begin(), r.end()); }, oneapi::tbb::simple_partitioner{});
        });
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
