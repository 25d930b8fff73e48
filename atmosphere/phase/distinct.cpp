#include "phase/distinct.h"

#include <algorithm>

namespace aureole::detail {

bool scatters(const DensityTerm& term) { return term.scattering_per_m * term.scattering_scale != Rgb(0); }

std::vector<PhaseFunction> distinct_phases(const std::vector<DensityTerm>& terms) {
    std::vector<PhaseFunction> phases;
    for (const DensityTerm& term : terms)
        if (scatters(term) && std::find(phases.begin(), phases.end(), term.phase) == phases.end()) phases.push_back(term.phase);
    std::stable_partition(phases.begin(), phases.end(),
                          [](const PhaseFunction& phase) { return std::holds_alternative<RayleighPhase>(phase); });
    return phases;
}

int phase_index(const std::vector<PhaseFunction>& phases, const PhaseFunction& phase) {
    return static_cast<int>(std::find(phases.begin(), phases.end(), phase) - phases.begin());
}

}  // namespace aureole::detail
