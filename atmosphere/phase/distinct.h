// Which phase functions an atmosphere's scattering terms have, each counted once.
#pragma once

#include <aureole/parameters.h>

#include <vector>

namespace aureole::detail {

/// True if the term scatters at all: only then does its phase function matter.
[[nodiscard]] bool scatters(const DensityTerm& term);
/// The different phase functions of the terms that scatter: Rayleigh's first, the others in the terms' order.
[[nodiscard]] std::vector<PhaseFunction> distinct_phases(const std::vector<DensityTerm>& terms);
/// Where `phase` stands among `phases`, which must hold it.
[[nodiscard]] int phase_index(const std::vector<PhaseFunction>& phases, const PhaseFunction& phase);

}  // namespace aureole::detail
