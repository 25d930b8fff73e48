#include "app/trace_run.h"

#include "app/progress.h"
#include "io/file.h"

#include <aureole/rhi/error.h>

#include <unistd.h>
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <optional>

namespace aureole::app {
namespace {

constexpr std::size_t progress_steps = 1000;
constexpr std::chrono::seconds checkpoint_interval{30};

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);
extern "C" void note_interrupt(int) {
    interrupted = true;
    remove_unfinished_on_signals();  // at the second one: a checkpoint may be on its way
}

/// While there is a checkpoint to be written the first signal only ends the work; the second ends the program.
class Interrupts {
public:
    Interrupts() {
        interrupted = false;
        struct sigaction action {};
        action.sa_handler = note_interrupt;
        action.sa_flags = static_cast<int>(SA_RESETHAND);
        for (std::size_t i = 0; i < signals.size(); ++i) {
            ::sigaction(signals[i], &action, &before_[i]);
            if (before_[i].sa_handler == SIG_IGN) ::sigaction(signals[i], &before_[i], nullptr);  // as nohup leaves them
        }
    }
    ~Interrupts() {
        for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals[i], &before_[i], nullptr);
    }
    Interrupts(const Interrupts&) = delete;
    Interrupts& operator=(const Interrupts&) = delete;

private:
    static constexpr std::array<int, 3> signals{SIGHUP, SIGINT, SIGTERM};
    std::array<struct sigaction, 3> before_{};
};

}  // namespace

TraceParameters parameters_of(const AtmosphereParameters& air, const TraceSettings& settings, Backend& backend) {
    TraceParameters parameters = describe(air);
    parameters.emplace_back("spectral", settings.spectral);
    parameters.emplace_back("orders", std::to_string(settings.orders));
    // Left out otherwise: tables and checkpoints from before there was a choice stay what they are.
    if (settings.tracking == models::ReferenceSettings::Tracking::ratio) parameters.emplace_back("tracking", "ratio");
    parameters.emplace_back("seed", std::to_string(settings.seed));
    // Threads of a CPU make no difference; another GPU rounds otherwise.
    parameters.emplace_back("backend", backend.cpu() ? backend.name() : backend.describe());
    return parameters;
}

void trace_all(Tracer& tracer, const TraceParameters& parameters, const std::filesystem::path& checkpoint,
               const std::string& how_to_go_on) {
    std::optional<Interrupts> interrupts;
    if (!checkpoint.empty()) interrupts.emplace();
    Progress progress(progress_steps, stderr, isatty(STDERR_FILENO) == 1);
    const auto reached = [&] {
        return std::min(static_cast<std::size_t>(tracer.share() * progress_steps), progress_steps - 1);
    };
    progress.start_at(reached());
    auto written = std::chrono::steady_clock::now();
    while (tracer.step([] { return interrupted.load(); })) {
        const auto now = std::chrono::steady_clock::now();
        if (!checkpoint.empty() && (interrupted || now - written >= checkpoint_interval)) {
            write_checkpoint(checkpoint, parameters, tracer);
            written = std::chrono::steady_clock::now();
        }
        if (interrupted)
            throw Error(ErrorCode::io, "interrupted with " + std::to_string(tracer.done()) + " of " +
                                           std::to_string(tracer.rows().size()) + " directions done, kept in " +
                                           checkpoint.string() + ": " + how_to_go_on);
        progress.reach(reached());
    }
    if (!checkpoint.empty()) write_checkpoint(checkpoint, parameters, tracer);
    progress.reach(progress_steps);
}

}  // namespace aureole::app
