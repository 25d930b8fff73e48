#include "app/solution.h"

#include "app/progress.h"

#include <unistd.h>
#include <algorithm>
#include <optional>

namespace aureole::app {
namespace {

/// Steps of the bar: progress is told in shares.
constexpr std::size_t steps = 50;

void add(const std::vector<PassTime>& part, std::vector<PassTime>& times, std::size_t first) {
    for (const PassTime& time : part) {
        const auto found = std::find_if(times.begin() + static_cast<std::ptrdiff_t>(first), times.end(),
                                        [&](const PassTime& other) { return other.name == time.name; });
        if (found == times.end())
            times.push_back(time);
        else
            found->milliseconds += time.milliseconds;
    }
}

}  // namespace

void solve(Backend& backend, Atmosphere& air, std::vector<PassTime>& times) {
    const TimestampSlots slots = if_supported(backend, air_slots);
    const bool long_work = air.progress() < 1;
    const std::size_t first = times.size();
    if (long_work) air.set_multi_scatter_passes_per_frame(1, true);
    std::optional<Progress> bar;
    if (long_work) bar.emplace(steps, stderr, isatty(STDERR_FILENO) == 1);
    std::size_t drawn = 0;
    do {
        backend.run([&](rhi::CommandList& commands) { air.record(commands, slots); });
        std::vector<PassTime> part;
        collect_times(backend, air.reports(), slots, part);
        add(part, times, first);
        for (; bar && drawn < static_cast<std::size_t>(air.progress() * steps); ++drawn) bar->step();
    } while (air.progress() < 1);
    if (long_work) air.set_multi_scatter_passes_per_frame(0);
}

}  // namespace aureole::app
