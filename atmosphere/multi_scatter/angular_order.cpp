#include "multi_scatter/angular_order.h"

#include "phase/distinct.h"

#include <algorithm>
#include <cmath>

namespace aureole::detail {
namespace {

constexpr int degrees = 11;

}  // namespace

std::vector<double> scattered_moments(const AtmosphereParameters& parameters) {
    std::vector<Rgb> sums(degrees, Rgb(0));
    for (const PhaseFunction& phase : distinct_phases(parameters.terms)) {
        AtmosphereParameters scattering = parameters;
        std::erase_if(scattering.terms, [&](const DensityTerm& term) { return !scatters(term) || !(term.phase == phase); });
        for (DensityTerm& term : scattering.terms) term.absorption_per_m = Rgb(0);
        const Rgb depth = vertical_optical_depth(scattering);
        const std::vector<double> moments = legendre_moments(phase, degrees);
        for (std::size_t l = 0; l < sums.size(); ++l) sums[l] += depth * std::abs(moments[l]);
    }
    std::vector<double> result;
    result.reserve(sums.size());
    for (const Rgb& sum : sums) result.push_back(std::max({sum.r, sum.g, sum.b}));
    return result;
}

int angular_order_for(const AtmosphereParameters& parameters, int most) {
    const std::vector<double> moments = scattered_moments(parameters);
    int order = 0;
    for (const int next : {2, 4, 6, 8}) {
        const auto first = static_cast<std::size_t>(order) + 1;
        if (next > most || std::max(moments[first], moments[first + 1]) < negligible_moment(most)) break;
        order = next;
    }
    return order;
}

}  // namespace aureole::detail
