#include "medium/merge.h"

#include "common/host_air.h"
#include "common/pack_atmosphere.h"
#include "phase/distinct.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace aureole::detail {
namespace {

bool absorbs(const DensityTerm& term) { return term.absorption_per_m != Rgb(0); }

bool can_add(const DensityTerm& a, const DensityTerm& b) {
    return a.profile == b.profile && (!scatters(a) || !scatters(b) || a.phase == b.phase);
}

/// Lossless: one term a profile and phase function.
std::vector<DensityTerm> added_up(const std::vector<DensityTerm>& terms) {
    std::vector<DensityTerm> result;
    for (const DensityTerm& term : terms) {
        const auto like = std::find_if(result.begin(), result.end(), [&](const DensityTerm& r) { return can_add(r, term); });
        if (like == result.end()) {
            result.push_back(term);
            continue;
        }
        if (!scatters(*like)) like->phase = term.phase;
        like->scattering_per_m += term.scattering_per_m;
        like->absorption_per_m += term.absorption_per_m;
    }
    return result;
}

/// Altitudes in m at which merged profiles are sampled: the nodes of the profile table, and the corners of tents.
std::vector<double> altitudes_of(const std::vector<DensityTerm>& terms, double shell_m) {
    std::vector<double> altitudes;
    for (int k = 0; k < table_width; ++k) {
        const double s = k / (table_width - 1.0);
        altitudes.push_back(shell_m * s * s);
    }
    for (const DensityTerm& term : terms)
        if (const auto* tent = std::get_if<TentProfile>(&term.profile))
            for (const double h : {tent->center_m - tent->half_width_m, tent->center_m, tent->center_m + tent->half_width_m})
                if (h > 0 && h < shell_m) altitudes.push_back(h);
    std::sort(altitudes.begin(), altitudes.end());
    // Neighbours closer than rounding make no table.
    altitudes.erase(
        std::unique(altitudes.begin(), altitudes.end(), [&](double a, double b) { return b - a < 1e-12 * shell_m; }),
        altitudes.end());
    return altitudes;
}

/// Sums over terms, one value an altitude, of one channel.
struct Sums {
    std::vector<std::array<std::vector<double>, 3>> scattering;  ///< By phase function.
    std::array<std::vector<double>, 3> absorption;
};

/// Densities come from the kernels' own formulas, as many terms at a time as those take.
void add_batch(const Planet& planet, std::span<const DensityTerm> batch, const std::vector<PhaseFunction>& phases,
               const std::vector<double>& altitudes, Sums& sums) {
    AtmosphereParameters some;
    some.planet = planet;
    some.terms.assign(batch.begin(), batch.end());
    HostAir air(pack_exact(some));
    for (std::size_t i = 0; i < batch.size(); ++i) {
        const DensityTerm& term = batch[i];
        auto* scattering =
            scatters(term) ? &sums.scattering[static_cast<std::size_t>(phase_index(phases, term.phase))] : nullptr;
        for (std::size_t k = 0; k < altitudes.size(); ++k) {
            const double density = air.formulas().term_density(static_cast<int>(i), altitudes[k] * 1e-3);
            for (std::size_t c = 0; c < 3; ++c) {
                const auto channel = static_cast<glm::length_t>(c);
                if (scattering) (*scattering)[c][k] += density * term.scattering_per_m[channel];
                sums.absorption[c][k] += density * term.absorption_per_m[channel];
            }
        }
    }
}

/// A term whose coefficient stands in one channel alone; nothing if that is 0 everywhere.
void push_channel(std::vector<DensityTerm>& terms, const std::vector<double>& altitudes, std::vector<double> values,
                  std::size_t channel, const PhaseFunction* phase) {
    const double greatest = *std::max_element(values.begin(), values.end());
    if (!(greatest > 0)) return;
    for (double& v : values) v /= greatest;
    DensityTerm term;
    term.name = "merged";
    term.profile = TabulatedProfile{altitudes, std::move(values)};
    Rgb& coefficient = phase ? term.scattering_per_m : term.absorption_per_m;
    coefficient[static_cast<glm::length_t>(channel)] = greatest;
    if (phase) term.phase = *phase;
    terms.push_back(std::move(term));
}

std::vector<DensityTerm> tabulated(const AtmosphereParameters& parameters, const std::vector<DensityTerm>& terms) {
    const std::vector<PhaseFunction> phases = distinct_phases(terms);
    const std::vector<double> altitudes =
        altitudes_of(terms, parameters.planet.top_radius_m - parameters.planet.bottom_radius_m);
    const std::vector<double> zero(altitudes.size(), 0.0);
    Sums sums{{phases.size(), {zero, zero, zero}}, {zero, zero, zero}};
    const std::span<const DensityTerm> all(terms);
    for (std::size_t begin = 0; begin < all.size(); begin += max_kernel_terms)
        add_batch(parameters.planet, all.subspan(begin, std::min<std::size_t>(max_kernel_terms, all.size() - begin)), phases,
                  altitudes, sums);

    std::vector<DensityTerm> result;
    for (std::size_t p = 0; p < phases.size(); ++p)
        for (std::size_t c = 0; c < 3; ++c) push_channel(result, altitudes, std::move(sums.scattering[p][c]), c, &phases[p]);
    for (std::size_t c = 0; c < 3; ++c) push_channel(result, altitudes, std::move(sums.absorption[c]), c, nullptr);
    return result;
}

}  // namespace

std::vector<DensityTerm> merged_terms(const AtmosphereParameters& parameters) {
    std::vector<DensityTerm> terms = parameters.terms;
    for (DensityTerm& term : terms) {  // from here on coefficients are what acts
        term.scattering_per_m *= std::exchange(term.scattering_scale, 1.0);
        term.absorption_per_m *= std::exchange(term.absorption_scale, 1.0);
    }
    std::erase_if(terms, [](const DensityTerm& term) { return !scatters(term) && !absorbs(term); });
    if (terms.size() > max_kernel_terms) terms = added_up(terms);
    // Each phase function's scattering and the absorption, in three channels.
    static_assert(max_kernel_terms == Blocks<float>::MAX_TERMS);
    static_assert(3 * (AtmosphereParameters::max_phase_functions + 1) <= max_kernel_terms);
    return terms.size() <= max_kernel_terms ? terms : tabulated(parameters, terms);
}

}  // namespace aureole::detail
