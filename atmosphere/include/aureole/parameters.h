// What an atmosphere is made of. SI units throughout; colours are scene-linear Rec.709 triples (r, g, b).
//
// Radiometric contract: every table holds radiance per unit of solar irradiance (1/sr). What a pixel gets is
//     radiance = solar_irradiance * table
// so the output's unit follows the sun's: give `Sun::irradiance` in W/m^2 per band and get W/(m^2 sr), give it in lux and get
// cd/m^2. Nothing else is multiplied in, except `CompositeSettings::exposure` where a host asks for it.
//
// Every field is checked by `validate`; a rejected value throws aureole::Error naming field, value and allowed range.
#pragma once

#include <aureole/rhi/error.h>

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <variant>
#include <vector>

namespace aureole {

using Rgb = glm::dvec3;  ///< Scene-linear Rec.709, or one number for each wavelength of three.

// ---- How a term's density changes with altitude. Densities are relative: 1 means the coefficients as stated. ----

/// density(h) = exp(-h / scale_height_m).
struct ExponentialProfile {
    double scale_height_m = 8000;  ///< In [0.01, 1e12].
    [[nodiscard]] bool operator==(const ExponentialProfile&) const = default;
};
/// density(h) = max(0, 1 - |h - center_m| / half_width_m): Bruneton 2017's ozone layer.
struct TentProfile {
    double center_m = 25000;      ///< In [-1e12, 1e12].
    double half_width_m = 15000;  ///< In [0.01, 1e12].
    [[nodiscard]] bool operator==(const TentProfile&) const = default;
};
/// Linear between the samples, constant beyond them.
struct TabulatedProfile {
    std::vector<double> altitude_m;  ///< Strictly increasing, in [-1e12, 1e12]; 2 to 4096 entries.
    std::vector<double> density;     ///< As many, in [0, 1e6].
    [[nodiscard]] bool operator==(const TabulatedProfile&) const = default;
};
using Profile = std::variant<ExponentialProfile, TentProfile, TabulatedProfile>;  ///< How density changes with altitude.

// ---- Phase functions p(cos theta), 1/sr, each integrating to 1 over the sphere. theta = 0 is forward. ----

/// 3/(16 pi) (1 + cos^2): molecules, without depolarization.
struct RayleighPhase {
    [[nodiscard]] bool operator==(const RayleighPhase&) const = default;
};
/// Henyey & Greenstein 1941.
struct HenyeyGreensteinPhase {
    double g = 0.76;  ///< Mean cosine, in [-0.999, 0.999].
    [[nodiscard]] bool operator==(const HenyeyGreensteinPhase&) const = default;
};
/// Cornette & Shanks 1992: Henyey-Greenstein times 3/2 (1 + cos^2) / (2 + g^2).
struct CornetteShanksPhase {
    double g = 0.8;  ///< In [-0.999, 0.999]. The mean cosine is 3 g (4 + g^2) / (5 (2 + g^2)).
    [[nodiscard]] bool operator==(const CornetteShanksPhase&) const = default;
};
/// (1 - weight) HG(g_hg) + weight Draine(g_draine, alpha): Jendersie & d'Eon 2023, a fit of Mie theory for fog and cloud.
struct HenyeyGreensteinDrainePhase {
    double g_hg = 0.9;      ///< In [-0.999, 0.999].
    double g_draine = 0.5;  ///< In [-0.999, 0.999].
    double alpha = 10;      ///< In [0, 1e4].
    double weight = 0.3;    ///< Share of the Draine lobe, in [0, 1].
    /// The published fit for droplets of the given diameter, in [5, 50] micrometres.
    [[nodiscard]] static HenyeyGreensteinDrainePhase from_droplet_diameter(double diameter_um);
    [[nodiscard]] bool operator==(const HenyeyGreensteinDrainePhase&) const = default;
};
/// Linear in theta between samples; renormalized to integrate to 1.
struct TabulatedPhase {
    std::vector<double> angle_rad;  ///< From 0 to pi (within 1e-6), strictly increasing; 2 to 4096 entries.
    std::vector<double> value;      ///< As many, in [0, 1e100], not all 0. Any scale.
    [[nodiscard]] bool operator==(const TabulatedPhase&) const = default;
};
/** How a term spreads light over directions. */ using PhaseFunction =
    std::variant<RayleighPhase, HenyeyGreensteinPhase, CornetteShanksPhase, HenyeyGreensteinDrainePhase, TabulatedPhase>;

/// Phase value in 1/sr for cos_theta in [-1, 1]. Evaluated by the kernels' own formula, in double. Throws Error naming what
/// is out of range. A tabulated function is resampled at every call.
[[nodiscard]] double evaluate(const PhaseFunction& phase, double cos_theta);
/// Legendre moments p_l = integral of p(cos) P_l(cos) over the sphere, l = 0 .. count-1, count in [1, 256].
/// p_0 is 1; p_1 is the mean cosine.
[[nodiscard]] std::vector<double> legendre_moments(const PhaseFunction& phase, int count);

/// One constituent: molecules, an aerosol, an absorber.
struct DensityTerm {
    std::string name;               ///< For messages: "rayleigh", "mie", "ozone".
    Profile profile;                ///< Density at each altitude.
    Rgb scattering_per_m{0, 0, 0};  ///< At density 1. In [0, 1e6].
    Rgb absorption_per_m{0, 0, 0};  ///< At density 1. In [0, 1e6].
    PhaseFunction phase;            ///< Unused when scattering is 0.
    /// Artists' factors of the two coefficients, which leave the measured numbers as they are. In [0, 1e6], and the product in
    /// [0, 1e6] too. With exactly 1, nothing changes by a bit.
    double scattering_scale = 1;  ///< Artists' factor of scattering_per_m; 1 changes nothing.
    double absorption_scale = 1;  ///< The same of absorption_per_m.
    [[nodiscard]] bool operator==(const DensityTerm&) const = default;
};

/// A sphere of ground, and how high its air goes.
struct Planet {
    double bottom_radius_m = 6.36e6;   ///< Of the ground. In [1e3, 1e12].
    double top_radius_m = 6.46e6;      ///< Where the atmosphere ends. At least 1 m above the bottom, at most 11 bottom radii.
    Rgb ground_albedo{0.3, 0.3, 0.3};  ///< Lambertian, in [0, 1].
    [[nodiscard]] bool operator==(const Planet&) const = default;
};

/// All that an air is: validated whole, by `validate`.
struct AtmosphereParameters {
    Planet planet;  ///< The ground, and where the air ends.
    /// Any number, with at most `max_phase_functions` different scattering phase functions among them (terms with equal phase
    /// functions share). None: an airless body. Kernels take 16; of more, those with equal profiles are added up, and if that
    /// is not enough, sums of terms are tabulated: cost does not grow further.
    std::vector<DensityTerm> terms;

    static constexpr int max_phase_functions = 4;  ///< Different ones, among all terms.
    [[nodiscard]] bool operator==(const AtmosphereParameters&) const = default;
};

/// Throws Error(invalid_argument) at the first field outside its range.
void validate(const AtmosphereParameters& parameters);

/// How the solar disk darkens towards its edge, as a power of mu, the cosine between the ray and the star's surface normal.
enum class LimbDarkening : std::uint8_t {
    none,      ///< A uniform disk.
    neckel94,  ///< Hestroffer & Magnan 1998: mu^alpha with alpha for 680, 550, 440 nm from Neckel & Labs 1994.
};

/// A distant light: the sun, a second sun, a moon.
struct Sun {
    glm::dvec3 direction{0, 0, 1};         ///< Towards the sun, in the axes of `Camera`. Of any length in [1e-100, 1e100].
    Rgb irradiance{1, 1, 1};               ///< At the top of the atmosphere, on a surface that faces the sun. In [0, 1e20].
    double angular_radius_rad = 0.004675;  ///< In [0, pi/4]. 0: no visible disk.
    LimbDarkening limb_darkening = LimbDarkening::neckel94;  ///< Of the disk.
    [[nodiscard]] bool operator==(const Sun&) const = default;
};
/// Throws Error(invalid_argument) at the first field outside its range.
void validate(const Sun& sun);

/// Scattering and extinction at an altitude, and what a vertical column adds up to: for tests, tools and the curious.
/// The altitude is finite; below 0 counts as 0, and above the top there is nothing. A term name that occurs nowhere is
/// rejected.
struct MediumSample {
    Rgb scattering_per_m, extinction_per_m;  ///< Sums over all terms.
};
[[nodiscard]] MediumSample sample_medium(const AtmosphereParameters& parameters, double altitude_m);  ///< Of all terms.
/// Optical depth of the vertical column from the ground to the top, by term name or all of them.
[[nodiscard]] Rgb vertical_optical_depth(const AtmosphereParameters& parameters);
[[nodiscard]] Rgb vertical_optical_depth(const AtmosphereParameters& parameters, const std::string& term);

}  // namespace aureole
