#include "common/check.h"

#include <aureole/presets.h>
#include <aureole/spectrum.h>

#include <array>
#include <cmath>
#include <string>

namespace aureole::presets {
namespace {

DensityTerm rayleigh(const Rgb& scattering_per_m, double scale_height_m) {
    return {.name = "rayleigh",
            .profile = ExponentialProfile{scale_height_m},
            .scattering_per_m = scattering_per_m,
            .absorption_per_m = Rgb(0),
            .phase = RayleighPhase{}};
}

DensityTerm aerosol(const char* name, const Rgb& scattering_per_m, const Rgb& absorption_per_m, double scale_height_m,
                    double g) {
    return {.name = name,
            .profile = ExponentialProfile{scale_height_m},
            .scattering_per_m = scattering_per_m,
            .absorption_per_m = absorption_per_m,
            .phase = CornetteShanksPhase{g}};
}

DensityTerm ozone() {
    return {.name = "ozone",
            .profile = TentProfile{.center_m = 25e3, .half_width_m = 15e3},
            .scattering_per_m = Rgb(0),
            .absorption_per_m = {0.650e-6, 1.881e-6, 0.085e-6},
            .phase = RayleighPhase{}};
}

AtmosphereParameters earth_with(const DensityTerm& mie, double albedo) {
    return {.planet = {.bottom_radius_m = 6360e3, .top_radius_m = 6460e3, .ground_albedo = Rgb(albedo)},
            .terms = {rayleigh({5.802e-6, 13.558e-6, 33.1e-6}, 8e3), mie, ozone()}};
}

}  // namespace

AtmosphereParameters earth() { return earth_with(aerosol("mie", Rgb(3.996e-6), Rgb(0.444e-6), 1.2e3, 0.8), 0.3); }

AtmosphereParameters hazy_earth() { return earth_with(aerosol("mie", Rgb(39.96e-6), Rgb(4.44e-6), 1.2e3, 0.76), 0.1); }

AtmosphereParameters earth_with_visibility(double visibility_m) {
    detail::check("visibility_m", visibility_m, 1e3, 220e3);
    AtmosphereParameters air = earth();
    DensityTerm* aerosol = nullptr;
    double others = 0;
    for (DensityTerm& term : air.terms) {
        if (term.name == "mie")
            aerosol = &term;
        else if (std::holds_alternative<ExponentialProfile>(term.profile))  // ozone does not reach the ground
            others += term.scattering_per_m.g + term.absorption_per_m.g;
    }
    const double scale = (std::log(20) / visibility_m - others) / (aerosol->scattering_per_m.g + aerosol->absorption_per_m.g);
    aerosol->scattering_per_m *= scale;
    aerosol->absorption_per_m *= scale;
    return air;
}

AtmosphereParameters mars() {
    return {.planet = {.bottom_radius_m = 3389.5e3, .top_radius_m = 3509.5e3, .ground_albedo = Rgb(0.25)},
            .terms = {rayleigh({19.918e-6, 13.57e-6, 5.75e-6}, 11.1e3),
                      aerosol("dust", Rgb(9.66e-6), {0.5e-6, 1.3e-6, 3.8e-6}, 11.1e3, 0.76)}};
}

AtmosphereParameters airless() {
    // The shell is empty; its top only has to be above the ground. Albedo: the Moon's, Bond.
    return {.planet = {.bottom_radius_m = 1737.4e3, .top_radius_m = 1747.4e3, .ground_albedo = Rgb(0.11)}, .terms = {}};
}

AtmosphereParameters us_standard_1976() { return spectrum::earth({680, 550, 440}); }

AtmosphereParameters titan() {
    constexpr double molecules_per_m3 = 146700 / (1.380649e-23 * 93.65);
    constexpr double amagat = 2.6868e25;  // molecules in a cubic metre at 0 degrees and 1 atm
    const auto scattering = [](double nm) { return molecules_per_m3 * spectrum::rayleigh_cross_section(nm); };
    DensityTerm methane{.name = "methane",
                        .profile = ExponentialProfile{12e3},
                        .scattering_per_m = Rgb(0),
                        .absorption_per_m = Rgb(0.1, 0.02, 0.002) * (1e-3 * 0.0565 * molecules_per_m3 / amagat),
                        .phase = RayleighPhase{}};
    // Optical depth 4, 6, 9 of which 0.95, 0.87, 0.72 scatters.
    constexpr double haze_height = 50e3;
    const Rgb haze = Rgb(4, 6, 9) / haze_height, albedo(0.95, 0.87, 0.72);
    return {.planet = {.bottom_radius_m = 2574.7e3, .top_radius_m = 3174.7e3, .ground_albedo = {0.2, 0.15, 0.1}},
            .terms = {rayleigh({scattering(680), scattering(550), scattering(440)}, 20e3), methane,
                      aerosol("haze", haze * albedo, haze * (Rgb(1) - albedo), haze_height, 0.6)}};
}

namespace {

struct Entry {
    std::string_view name;
    AtmosphereParameters (*make)();
};
constexpr std::array entries{Entry{"earth", earth},
                             Entry{"hazy_earth", hazy_earth},
                             Entry{"mars", mars},
                             Entry{"airless", airless},
                             Entry{"us_standard_1976", us_standard_1976},
                             Entry{"titan", titan}};
constexpr auto all_names = [] {
    std::array<std::string_view, entries.size()> result;
    for (std::size_t i = 0; i < entries.size(); ++i) result[i] = entries[i].name;
    return result;
}();

}  // namespace

std::span<const std::string_view> names() { return all_names; }

AtmosphereParameters by_name(std::string_view name) {
    std::string known;
    for (const Entry& entry : entries) {
        if (entry.name == name) return entry.make();
        known.append(known.empty() ? "" : ", ").append(entry.name);
    }
    throw Error(ErrorCode::invalid_argument, "preset", "\"" + std::string(name) + "\"", "one of " + known);
}

}  // namespace aureole::presets
