// Fewer terms for the same air: what the kernels evaluate at every sample of every ray.
#pragma once

#include <aureole/parameters.h>

#include <cstddef>
#include <vector>

namespace aureole::detail {

/// The most terms that kernels evaluate one by one.
inline constexpr std::size_t max_kernel_terms = 16;

/// Terms to the same effect as the parameters', at most `max_kernel_terms` of them. Those without any coefficient are left out.
/// Where more than that remain,
/// - terms of equal profiles are added up, unless they scatter by different phase functions: nothing is lost;
/// - if that is not enough, all become tables: for each phase function and channel one profile of the scattering by all its
///   terms, and for each channel one of the absorption by all terms, on the fine grid of the profile table.
/// `parameters` must be valid.
[[nodiscard]] std::vector<DensityTerm> merged_terms(const AtmosphereParameters& parameters);

}  // namespace aureole::detail
