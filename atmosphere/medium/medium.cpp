// The medium on the host: coefficients and columns by the kernels' own formulas (medium.glsl).
#include "common/check.h"
#include "common/host_air.h"
#include "common/pack_atmosphere.h"
#include "quadrature/gauss_legendre.h"

#include <aureole/parameters.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace aureole {
namespace {

using Air = kernels::AirFormulas<double>;

/// Altitudes in km between which the density of term i is smooth on the scale of the piece.
std::vector<double> smooth_pieces(Air& air, int i) {
    const double shell = air.atm.radii.z;
    const auto profile = air.atm.term_profile[i];
    std::vector<double> cuts{0, shell};
    const auto cut = [&](double h) {
        if (h > 0 && h < shell) cuts.push_back(h);
    };
    switch (air.term_kind(i)) {
        case Air::PROFILE_EXPONENTIAL:  // beyond 80 scale heights there is less than rounding
            for (int k = 1; k <= 40; ++k) cut(2 * k / profile.x);
            break;
        case Air::PROFILE_TENT:
            cut(profile.x - 1 / profile.y);
            cut(profile.x);
            cut(profile.x + 1 / profile.y);
            break;
        default: {
            constexpr double cells = detail::table_width - 1;
            for (int k = 1; k <= detail::table_width - 1; ++k) cut(air.atm.tables.y * (k / cells) * (k / cells));
        }
    }
    std::sort(cuts.begin(), cuts.end());
    return cuts;
}

/// The integral of relative density from the ground to the top, km.
double column_km(Air& air, int i) {
    static const detail::GaussLegendre rule = detail::gauss_legendre(16);
    const std::vector<double> cuts = smooth_pieces(air, i);
    double sum = 0;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
        sum += rule.integrate(cuts[k], cuts[k + 1], [&](double h) { return air.term_density(i, h); });
    return sum;
}

}  // namespace

MediumSample sample_medium(const AtmosphereParameters& parameters, double altitude_m) {
    validate(parameters);
    constexpr double limit = std::numeric_limits<double>::max();
    detail::check("altitude_m", altitude_m, -limit, limit);
    if (altitude_m > parameters.planet.top_radius_m - parameters.planet.bottom_radius_m) return {Rgb(0), Rgb(0)};
    detail::HostAir air(detail::pack_exact(parameters));
    const Air::Medium medium = air.formulas().sample_medium(altitude_m * 1e-3);
    MediumSample sample{Rgb(0), medium.extinction * 1e-3};
    for (const Rgb& scattering : medium.scattering) sample.scattering_per_m += scattering * 1e-3;
    return sample;
}

Rgb vertical_optical_depth(const AtmosphereParameters& parameters) {
    validate(parameters);
    const detail::ExactAtmosphere packed = detail::pack_exact(parameters);
    detail::HostAir air(packed);
    Rgb depth(0);
    for (int i = 0; i < packed.structure.term_count; ++i)
        depth += Rgb(packed.block.term_extinction[i]) * column_km(air.formulas(), i);
    return depth;
}

Rgb vertical_optical_depth(const AtmosphereParameters& parameters, const std::string& term) {
    validate(parameters);
    AtmosphereParameters only = parameters;
    std::erase_if(only.terms, [&](const DensityTerm& t) { return t.name != term; });
    if (only.terms.empty()) {
        std::string names;
        for (const DensityTerm& t : parameters.terms) names += (names.empty() ? "" : ", ") + t.name;
        detail::reject("term", "\"" + term + "\"", names.empty() ? "nothing: there are no terms" : "one of " + names);
    }
    return vertical_optical_depth(only);
}

}  // namespace aureole
