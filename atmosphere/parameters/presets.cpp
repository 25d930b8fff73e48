#include <aureole/presets.h>

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

AtmosphereParameters mars() {
    return {.planet = {.bottom_radius_m = 3389.5e3, .top_radius_m = 3509.5e3, .ground_albedo = Rgb(0.25)},
            .terms = {rayleigh({19.918e-6, 13.57e-6, 5.75e-6}, 11.1e3),
                      aerosol("dust", Rgb(9.66e-6), {0.5e-6, 1.3e-6, 3.8e-6}, 11.1e3, 0.76)}};
}

AtmosphereParameters airless() {
    // The shell is empty; its top only has to be above the ground. Albedo: the Moon's, Bond.
    return {.planet = {.bottom_radius_m = 1737.4e3, .top_radius_m = 1747.4e3, .ground_albedo = Rgb(0.11)}, .terms = {}};
}

AtmosphereParameters by_name(std::string_view name) {
    if (name == "earth") return earth();
    if (name == "hazy_earth") return hazy_earth();
    if (name == "mars") return mars();
    if (name == "airless") return airless();
    throw Error(ErrorCode::invalid_argument, "preset", "\"" + std::string(name) + "\"", "earth, hazy_earth, mars or airless");
}

}  // namespace aureole::presets
