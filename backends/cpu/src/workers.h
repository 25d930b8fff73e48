// The threads that share the work of one command.
#pragma once

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cstddef>

namespace aureole::cpu {

class Workers {
public:
    /// 0: as many as the process may use.
    explicit Workers(unsigned threads) : arena_(threads == 0 ? oneapi::tbb::task_arena::automatic : static_cast<int>(threads)) {
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
    oneapi::tbb::task_arena arena_;
};

}  // namespace aureole::cpu
