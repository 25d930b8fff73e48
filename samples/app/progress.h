// A bar with an estimate for work of many steps.
#pragma once

#include <chrono>
#include <cstdio>
#include <string>

namespace aureole::app {

/// On a terminal one line that is drawn over; elsewhere a line at every tenth of the way.
class Progress {
public:
    Progress(std::size_t steps, std::FILE* out, bool terminal);
    /// Another step is done.
    void step() { reach(done_ + 1); }
    /// So many steps are done, be they more or fewer than before.
    void reach(std::size_t done);
    /// So many had been done when the clock started: the estimate leaves them out. Before the first step.
    void start_at(std::size_t done);

private:
    void draw() const;
    std::size_t steps_, done_ = 0, before_ = 0;
    std::size_t tenths_ = 0;  // of the way, shown already
    std::FILE* out_;
    bool terminal_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// "[#####.....]  12/24  50%  8 s, 8 s left"; the estimate assumes that steps to come take as long as those before, of which
/// the first `before` took no part of the time.
[[nodiscard]] std::string progress_line(std::size_t done, std::size_t steps, double elapsed_s, std::size_t before = 0);
/// "8 s", "2 min 05 s", "1 h 02 min"
[[nodiscard]] std::string print_duration(double seconds);

}  // namespace aureole::app
