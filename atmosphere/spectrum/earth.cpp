// The Earth's air at given wavelengths.
#include <aureole/presets.h>
#include <aureole/spectrum.h>

#include "common/check.h"

#include <cmath>

namespace aureole::spectrum {
namespace {

using aureole::detail::check;

constexpr double molecules_per_dobson = 2.6867e20;  // of a column of 1 m^2

/// U.S. Standard Atmosphere 1976, table 4: from each geopotential altitude on, temperature changes by `lapse` K/km.
struct Layer {
    double from_km, lapse;
};
constexpr std::array<Layer, 8> layers{{{0, -6.5}, {11, 0}, {20, 1}, {32, 2.8}, {47, 0}, {51, -2.8}, {71, -2}, {84.852, 0}}};
constexpr double sea_level_k = 288.15;
/// g0 M / R in K/km: how fast pressure falls (its equations 33a, 33b).
constexpr double hydrostatic = 9.80665 * 28.9644 / 8.31432;
constexpr double geopotential_radius_km = 6356.766;

/// Pressure over temperature, relative to sea level.
double standard_density(double altitude_km) {
    const double h = geopotential_radius_km * altitude_km / (geopotential_radius_km + altitude_km);  // (18)
    double pressure = 1, temperature = sea_level_k;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const bool last = i + 1 == layers.size() || h < layers[i + 1].from_km;
        const double rise = (last ? h : layers[i + 1].from_km) - layers[i].from_km, lapse = layers[i].lapse;
        const double above = temperature + lapse * rise;
        pressure *= lapse == 0 ? std::exp(-hydrostatic * rise / temperature)          // (33b)
                               : std::pow(temperature / above, hydrostatic / lapse);  // (33a)
        temperature = above;
        if (last) break;
    }
    return pressure * sea_level_k / temperature;
}

void check_air(const EarthAir& air) {
    check("air.co2_ppm", air.co2_ppm, 0, 1e6);
    check("air.ozone_dobson", air.ozone_dobson, 0, 1e4);
    check("air.aerosol_beta", air.aerosol_beta, 0, 1e3);
    check("air.aerosol_alpha", air.aerosol_alpha, -4, 4);
    check("air.aerosol_scale_height_m", air.aerosol_scale_height_m, 0.01, 1e12);
    check("air.aerosol_albedo", air.aerosol_albedo, 0, 1);
    check("air.ozone.half_width_m", air.ozone.half_width_m, 0.01, 1e12);
}

template <class F>
Rgb of_each(const std::array<double, 3>& nm, F&& f) {
    return {f(nm[0]), f(nm[1]), f(nm[2])};
}

}  // namespace

TabulatedProfile standard_atmosphere_1976() {
    TabulatedProfile profile;
    for (int i = 0; i <= 1000; ++i) {
        profile.altitude_m.push_back(100.0 * i);
        profile.density.push_back(standard_density(0.1 * i));
    }
    return profile;
}

AtmosphereParameters earth(const std::array<double, 3>& nm, const EarthAir& air) {
    for (std::size_t i = 0; i < nm.size(); ++i) check(aureole::detail::element("nm", i), nm[i], first_nm, last_nm);
    check_air(air);
    const Rgb molecules = of_each(nm, [&](double l) { return rayleigh_scattering(l, air.co2_ppm); });
    const Rgb aerosol = of_each(nm, [&](double l) {
        return angstrom_optical_depth(l, air.aerosol_beta, air.aerosol_alpha) / air.aerosol_scale_height_m;
    });
    // A tent's integral is its half width.
    const double ozone_density = air.ozone_dobson * molecules_per_dobson / air.ozone.half_width_m;
    const Rgb ozone = of_each(nm, [&](double l) { return ozone_density * ozone_cross_section(l); });

    AtmosphereParameters parameters;
    parameters.planet = presets::earth().planet;
    parameters.planet.ground_albedo = Rgb(air.ground_albedo);
    parameters.terms = {{.name = "rayleigh",
                         .profile = air.molecules,
                         .scattering_per_m = molecules,
                         .absorption_per_m = Rgb(0),
                         .phase = RayleighPhase{}},
                        {.name = "mie",
                         .profile = ExponentialProfile{air.aerosol_scale_height_m},
                         .scattering_per_m = aerosol * air.aerosol_albedo,
                         .absorption_per_m = aerosol * (1 - air.aerosol_albedo),
                         .phase = CornetteShanksPhase{air.aerosol_g}},
                        {.name = "ozone",
                         .profile = air.ozone,
                         .scattering_per_m = Rgb(0),
                         .absorption_per_m = ozone,
                         .phase = RayleighPhase{}}};
    validate(parameters);
    return parameters;
}

}  // namespace aureole::spectrum
