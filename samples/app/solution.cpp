#include "app/solution.h"

#include "app/progress.h"

#include <unistd.h>
#include <algorithm>
#include <optional>

namespace aureole::app {
namespace {

/// Steps of the bar: progress is told in shares.
constexpr std::size_t steps = 50;

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
        add_times(part, times, first);
        for (; bar && drawn < static_cast<std::size_t>(air.progress() * steps); ++drawn) bar->step();
    } while (air.progress() < 1);
    if (long_work) air.set_multi_scatter_passes_per_frame(0);
}

std::unique_ptr<Atmosphere> solved(Backend& backend, const AtmosphereParameters& parameters, const ModelPtr& model) {
    auto air = std::make_unique<Atmosphere>(backend.device(), parameters, model);
    std::vector<PassTime> times;
    solve(backend, *air, times);
    return air;
}

}  // namespace aureole::app
