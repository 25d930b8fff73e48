#include "measure/cost.h"

#include <algorithm>

namespace aureole::app {
namespace {

/// The composite is counted with so many times fewer pixels each way.
constexpr std::uint32_t coarser = 8;

rhi::CpuCounts times(rhi::CpuCounts counts, std::uint64_t factor) {
    for (std::uint64_t* count : {&counts.evaluations, &counts.samples, &counts.fetches, &counts.stores, &counts.bytes})
        *count *= factor;
    return counts;
}

Cost cost_of(const PassCosts& passes) {
    const auto time_of = [&](std::string_view name) {
        const auto pass = std::ranges::find(passes.passes, name, &PassCost::name);
        return pass == passes.passes.end() ? Spread() : pass->milliseconds;
    };
    Cost cost{passes.frame,
              passes.rebuild,
              time_of("composite"),
              time_of("composite_geometry"),
              time_of("aerial_perspective"),
              time_of("light"),
              time_of("composite_two_suns"),
              time_of("composite_bare"),
              time_of("shadows"),
              time_of("composite_shadows"),
              {},
              {},
              passes.table_bytes,
              passes.air_bytes,
              passes.aerial_perspective_bytes,
              passes.shadow_bytes};
    cost.per_frame = times(passes.pass("composite").counts, std::uint64_t{coarser} * coarser);
    for (std::size_t i = 0; i < passes.air_passes + passes.view_passes; ++i) {
        cost.rebuild += passes.passes[i].counts;
        if (i >= passes.air_passes) cost.per_frame += passes.passes[i].counts;
    }
    return cost;
}

}  // namespace

std::vector<Cost> costs(Backend& backend, std::span<const CostSubject> subjects, const CostOptions& options,
                        const std::function<void()>& after_round) {
    if (options.rounds == 0) throw Error(ErrorCode::invalid_argument, "rounds", "0", "at least 1");
    PassCostOptions measured;
    measured.width = options.width;
    measured.height = options.height;
    measured.frames = options.rounds;
    measured.warm_up = options.warm_up;
    measured.features = options.features;
    measured.known = options.known;
    measured.after_measured = options.after_measured;
    measured.known_counts = options.known_counts;
    measured.after_counted = options.after_counted;
    measured.counted_width = std::max(options.width / coarser, 1U);
    measured.counted_height = std::max(options.height / coarser, 1U);
    std::vector<Cost> found;
    for (const PassCosts& passes : pass_costs(
             backend, subjects, measured, after_round ? after_round : [] {}))
        found.push_back(cost_of(passes));
    return found;
}

}  // namespace aureole::app
