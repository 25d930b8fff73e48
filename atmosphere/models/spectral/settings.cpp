// Which wavelengths, and the air at each of them.
#include "common/check.h"
#include "models/spectral/sum.h"

#include <aureole/models/spectral.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace aureole::models {
namespace {

/// What red, green and blue of an atmosphere stand for, from the shortest: those of the presets (Bruneton 2017).
constexpr std::array<double, 3> known_nm{440, 550, 680};
constexpr std::array<int, 3> channel{2, 1, 0};
constexpr double greatest_exponent = 5;

double power_between(double nm, double nm_a, double a, double nm_b, double b) {
    double exponent = std::log(b / a) / std::log(nm_b / nm_a);
    if (nm < nm_a || nm > nm_b) exponent = std::clamp(exponent, -greatest_exponent, greatest_exponent);
    const bool from_b = nm > nm_b;
    return (from_b ? b : a) * std::pow(nm / (from_b ? nm_b : nm_a), exponent);
}

double linear_between(double nm, double nm_a, double a, double nm_b, double b) {
    return std::lerp(a, b, std::clamp((nm - nm_a) / (nm_b - nm_a), 0.0, 1.0));
}

/// One of three values at the known wavelengths, between or beyond them.
template <class Between>
double interpolate(const Rgb& value, double nm, Between&& between) {
    const std::size_t i = nm < known_nm[1] ? 0 : 1;
    return between(nm, known_nm[i], value[channel[i]], known_nm[i + 1], value[channel[i + 1]]);
}

double coefficient(const Rgb& value, double nm) {
    for (std::size_t i = 0; i < known_nm.size(); ++i)
        if (nm == known_nm[i]) return value[channel[i]];
    const bool powers = std::min({value.r, value.g, value.b}) > 0;
    return powers ? interpolate(value, nm, power_between) : interpolate(value, nm, linear_between);
}

/// Molecules' scattering that fits the three best; 0: none does.
double rayleigh_amplitude(const Rgb& scattering) {
    constexpr double farthest = 0.2;
    if (!(std::min({scattering.r, scattering.g, scattering.b}) > 0)) return 0;
    std::array<double, 3> ratio{};
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        ratio[i] = std::log(scattering[channel[i]] / spectrum::rayleigh_scattering(known_nm[i]));
        sum += ratio[i] / 3;
    }
    const bool alike = std::ranges::all_of(ratio, [&](double r) { return std::abs(r - sum) < std::log1p(farthest); });
    return alike ? std::exp(sum) : 0;
}

double ozone_amplitude(const Rgb& absorption) {
    double sum = 0;
    for (const double nm : known_nm) sum += spectrum::ozone_cross_section(nm);
    return (absorption.r + absorption.g + absorption.b) / sum;
}

template <class F>
Rgb of_each(const std::array<double, 3>& nm, F&& f) {
    return {f(nm[0]), f(nm[1]), f(nm[2])};
}

void use_wavelengths(DensityTerm& term, const std::array<double, 3>& nm) {
    const Rgb scattering = term.scattering_per_m, absorption = term.absorption_per_m;
    const double molecules = term.name == "rayleigh" ? rayleigh_amplitude(scattering) : 0;
    term.scattering_per_m = of_each(nm, [&](double l) {
        return molecules > 0 ? molecules * spectrum::rayleigh_scattering(l) : coefficient(scattering, l);
    });
    const double ozone = term.name == "ozone" ? ozone_amplitude(absorption) : 0;
    term.absorption_per_m = of_each(
        nm, [&](double l) { return ozone > 0 ? ozone * spectrum::ozone_cross_section(l) : coefficient(absorption, l); });
    // What scatters anywhere does so a little everywhere: the phase functions of the air are the same at all wavelengths.
    const double most = std::max({scattering.r, scattering.g, scattering.b});
    for (int c = 0; c < 3; ++c) term.scattering_per_m[c] = std::clamp(term.scattering_per_m[c], 1e-12 * most, 1e6);
    for (int c = 0; c < 3; ++c) term.absorption_per_m[c] = std::min(term.absorption_per_m[c], 1e6);
}

}  // namespace

AtmosphereParameters at_wavelengths(const AtmosphereParameters& rgb, const std::array<double, 3>& nm) {
    aureole::validate(rgb);
    for (std::size_t i = 0; i < nm.size(); ++i)
        detail::check(detail::element("nm", i), nm[i], spectrum::first_nm, spectrum::last_nm);
    AtmosphereParameters result = rgb;
    for (DensityTerm& term : result.terms) use_wavelengths(term, nm);
    result.planet.ground_albedo =
        of_each(nm, [&](double l) { return interpolate(rgb.planet.ground_albedo, l, linear_between); });
    return result;
}

Rgb solar_rec709(const spectrum::Wavelengths& wavelengths) {
    Rgb sum(0);
    for (const Rgb& weight : wavelengths.to_rec709) sum += weight;
    return sum;
}

void validate(const SpectralSettings& settings) {
    const spectrum::Wavelengths& set = settings.wavelengths;
    detail::check_count("spectral.wavelengths.nm", set.nm.size(), 1, 3 * detail::max_triplets);
    detail::check_count("spectral.wavelengths.to_rec709", set.to_rec709.size(), set.nm.size(), set.nm.size());
    for (std::size_t i = 0; i < set.nm.size(); ++i) {
        detail::check(detail::element("spectral.wavelengths.nm", i), set.nm[i], spectrum::first_nm, spectrum::last_nm);
        for (int c = 0; c < 3; ++c)
            detail::check(detail::element("spectral.wavelengths.to_rec709", i), set.to_rec709[i][c], -1e30, 1e30);
    }
    const Rgb sun = solar_rec709(set);
    for (int c = 0; c < 3; ++c) detail::check("sum of spectral.wavelengths.to_rec709", sun[c], 1e-30, 1e32);
}

spectrum::Wavelengths wavelengths_by_name(std::string_view name) {
    int count = 0;
    const auto read = std::from_chars(name.data(), name.data() + name.size(), count);
    const bool whole = read.ec == std::errc() && read.ptr == name.data() + name.size();
    if (!whole || count < 3 || count > static_cast<int>(3 * detail::max_triplets))
        detail::reject("spectral", std::string("\"").append(name).append("\""), "rgb, or a number of wavelengths in [3, 42]");
    return count == 3 || count == 4 || count == 6 ? spectrum::fitted(count) : spectrum::equal_bins(count);
}

}  // namespace aureole::models
