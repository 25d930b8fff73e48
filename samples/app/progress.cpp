#include "app/progress.h"

#include <algorithm>
#include <cmath>

namespace aureole::app {

std::string print_duration(double seconds) {
    const long s = std::lround(seconds);
    char text[64];
    if (s < 60)
        std::snprintf(text, sizeof text, "%ld s", s);
    else if (s < 3600)
        std::snprintf(text, sizeof text, "%ld min %02ld s", s / 60, s % 60);
    else
        std::snprintf(text, sizeof text, "%ld h %02ld min", s / 3600, s % 3600 / 60);
    return text;
}

std::string progress_line(std::size_t done, std::size_t steps, double elapsed_s, std::size_t before) {
    constexpr std::size_t width = 30;
    const std::size_t total = std::max<std::size_t>(steps, 1);
    const std::size_t filled = std::min(done, total) * width / total;
    std::string line = "[";
    line.append(filled, '#').append(width - filled, '.').append("]  ");
    line += std::to_string(done) + "/" + std::to_string(steps) + "  " + std::to_string(100 * done / total) + "%  ";
    line += print_duration(elapsed_s);
    if (done > before && done < steps)
        line += ", about " +
                print_duration(elapsed_s / static_cast<double>(done - before) * static_cast<double>(steps - done)) + " left";
    return line;
}

Progress::Progress(std::size_t steps, std::FILE* out, bool terminal) : steps_(steps), out_(out), terminal_(terminal) {}

void Progress::start_at(std::size_t done) {
    done_ = before_ = done;
    tenths_ = done * 10 / std::max<std::size_t>(steps_, 1);
}

void Progress::reach(std::size_t done) {
    if (done == done_) return;
    done_ = done;
    const std::size_t tenths = done * 10 / std::max<std::size_t>(steps_, 1);
    if (terminal_ || done == steps_ || tenths > tenths_) draw();
    tenths_ = std::max(tenths, tenths_);
}

void Progress::draw() const {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    const std::string line = progress_line(done_, steps_, elapsed.count(), before_);
    if (terminal_)
        std::fprintf(out_, "\r%s\x1b[K%s", line.c_str(), done_ == steps_ ? "\n" : "");
    else
        std::fprintf(out_, "%s\n", line.c_str());
    std::fflush(out_);
}

}  // namespace aureole::app
