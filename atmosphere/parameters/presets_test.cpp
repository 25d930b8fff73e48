// Optical depth and albedo of every preset against numbers worked out by hand: a preset with scattering and absorption swapped,
// or a scale height meant for another shell, cannot pass.
#include "common/rejects.h"

#include <aureole/presets.h>

#include <doctest/doctest.h>
#include <cmath>

using namespace aureole;

namespace {

void check_rgb(const Rgb& actual, const Rgb& expected, double relative) {
    for (int c = 0; c < 3; ++c) {
        CAPTURE(c);
        CHECK(actual[c] == doctest::Approx(expected[c]).scale(1e-300).epsilon(relative));
    }
}

Rgb albedo(const DensityTerm& term) { return term.scattering_per_m / (term.scattering_per_m + term.absorption_per_m); }

void check_term(const AtmosphereParameters& air, const char* name, const Rgb& depth, const Rgb& expected_albedo) {
    CAPTURE(name);
    check_rgb(vertical_optical_depth(air, name), depth, 1e-6);
    bool found = false;
    for (const DensityTerm& term : air.terms) {
        if (term.name != name) continue;
        found = true;
        check_rgb(albedo(term), expected_albedo, 1e-5);
    }
    CHECK(found);
}

/// Bodhaine et al. 1999, equation 30: cross-section of a molecule of air, m^2.
double bodhaine(double nm) {
    const double um2 = nm * nm * 1e-6;
    return 1e-32 * (1.0455996 - 341.29061 / um2 - 0.90230850 * um2) / (1 + 0.0027059889 / um2 - 85.968563 * um2);
}
constexpr double red_nm = 680, green_nm = 550, blue_nm = 440;

}  // namespace

TEST_CASE("presets: Earth with a visibility loses 95 % of a level beam of green light over it") {
    for (const double visibility : {1e3, 5e3, 10e3, 50e3, 166e3, 220e3}) {
        const AtmosphereParameters air = presets::earth_with_visibility(visibility);
        CHECK_NOTHROW(validate(air));
        CHECK(std::exp(-sample_medium(air, 0).extinction_per_m.g * visibility) ==
              doctest::Approx(0.05).epsilon(1e-9).scale(1e-300));
        CHECK(air.planet == presets::earth().planet);
        check_rgb(vertical_optical_depth(air, "rayleigh"), vertical_optical_depth(presets::earth(), "rayleigh"), 1e-12);
        for (const DensityTerm& term : air.terms)
            if (term.name == "mie") check_rgb(albedo(term), Rgb(0.9), 1e-12);
    }
    // 2.9957 / (13.558e-6 + 3.996e-6 + 0.444e-6) m.
    const AtmosphereParameters as_it_is = presets::earth_with_visibility(166.45e3);
    check_rgb(vertical_optical_depth(as_it_is, "mie"), vertical_optical_depth(presets::earth(), "mie"), 1e-3);
    CHECK(detail::rejected_field([] { (void)presets::earth_with_visibility(999); }) == "visibility_m");
    CHECK(detail::rejected_field([] { (void)presets::earth_with_visibility(221e3); }) == "visibility_m");
    CHECK(detail::rejected_field([] { (void)presets::earth_with_visibility(std::nan("")); }) == "visibility_m");
}

TEST_CASE("presets: earth") {
    const AtmosphereParameters air = presets::earth();
    // Coefficient x 8000 m x (1 - exp(-100/8)); exp(-12.5) = 3.7267e-6.
    check_term(air, "rayleigh", {0.046415827, 0.108463596, 0.264799013}, Rgb(1));
    // 4.44e-6 x 1200 m; 3.996 / 4.44.
    check_term(air, "mie", Rgb(0.005328), Rgb(0.9));
    // Coefficient x the triangle's area, 15000 m.
    check_term(air, "ozone", {0.00975, 0.028215, 0.001275}, Rgb(0));
    check_rgb(vertical_optical_depth(air), {0.061493827, 0.142006596, 0.271402013}, 1e-6);
    // At the ground, without ozone: (5.802 + 3.996) / (5.802 + 4.44) and so on.
    const MediumSample ground = sample_medium(air, 0);
    check_rgb(ground.scattering_per_m / ground.extinction_per_m, {0.956649, 0.975331, 0.988172}, 2e-6);
    CHECK(air.planet.ground_albedo == Rgb(0.3));
    CHECK(air.planet.bottom_radius_m == 6360e3);
    CHECK(air.planet.top_radius_m == 6460e3);
}

TEST_CASE("presets: hazy earth has ten times the aerosol") {
    const AtmosphereParameters air = presets::hazy_earth();
    check_term(air, "rayleigh", {0.046415827, 0.108463596, 0.264799013}, Rgb(1));
    check_term(air, "mie", Rgb(0.05328), Rgb(0.9));
    check_term(air, "ozone", {0.00975, 0.028215, 0.001275}, Rgb(0));
    check_rgb(vertical_optical_depth(air), {0.109445827, 0.189958596, 0.319354013}, 1e-6);
    CHECK(std::get<CornetteShanksPhase>(air.terms[1].phase).g == 0.76);
    CHECK(air.planet.ground_albedo == Rgb(0.1));
}

TEST_CASE("presets: mars") {
    const AtmosphereParameters air = presets::mars();
    // Coefficient x 11100 m x (1 - exp(-120/11.1)); exp(-10.8108) = 2.018e-5.
    check_term(air, "rayleigh", {0.22108534, 0.15062396, 0.06382371}, Rgb(1));
    check_term(air, "dust", {0.11277372, 0.12165354, 0.14940299}, {0.950787, 0.881387, 0.717682});
    check_rgb(vertical_optical_depth(air), {0.33385906, 0.27227750, 0.21322670}, 1e-6);
    CHECK(air.planet.ground_albedo == Rgb(0.25));
    CHECK(air.planet.bottom_radius_m == 3389.5e3);
    CHECK(air.planet.top_radius_m == 3509.5e3);
}

TEST_CASE("presets: airless") {
    const AtmosphereParameters air = presets::airless();
    CHECK(air.terms.empty());
    CHECK(vertical_optical_depth(air) == Rgb(0));
    CHECK(sample_medium(air, 0).extinction_per_m == Rgb(0));
    CHECK(air.planet.bottom_radius_m == 1737.4e3);
}

TEST_CASE("presets: us_standard_1976") {
    const AtmosphereParameters air = presets::us_standard_1976();
    CHECK(std::holds_alternative<TabulatedProfile>(air.terms.at(0).profile));
    // 2.152e29 molecules over a square metre at sea level.
    const Rgb molecules = 2.152e29 * Rgb(bodhaine(red_nm), bodhaine(green_nm), bodhaine(blue_nm));
    // 5.328e-3 of aerosol in all colours; 300 Dobson units of ozone, each colour between two bins.
    const Rgb ozone = 300 * 2.6867e20 * Rgb(1.341e-25, 3.2955e-25, 1.21355e-26);
    check_rgb(vertical_optical_depth(air, "rayleigh"), molecules, 2e-3);
    check_term(air, "mie", Rgb(5.328e-3), Rgb(0.9));
    check_term(air, "ozone", ozone, Rgb(0));
    check_rgb(albedo(air.terms[0]), Rgb(1), 1e-15);
    check_rgb(vertical_optical_depth(air), molecules + Rgb(5.328e-3) + ozone, 2e-3);
    // Bodhaine 1999, table 3: Rayleigh optical depth 0.0974 at 550 nm, 1013.25 hPa and 45 degrees of latitude (0.09748).
    CHECK(vertical_optical_depth(air, "rayleigh").g == doctest::Approx(0.0975).scale(1e-300).epsilon(0.01));
    // Half the density at 6.66 km, a hundredth at 32.64 km.
    const double ground = sample_medium({air.planet, {air.terms[0]}}, 0).scattering_per_m.g;
    CHECK(sample_medium({air.planet, {air.terms[0]}}, 6660).scattering_per_m.g ==
          doctest::Approx(0.5 * ground).scale(1e-300).epsilon(0.01));
    CHECK(sample_medium({air.planet, {air.terms[0]}}, 32.64e3).scattering_per_m.g ==
          doctest::Approx(0.01 * ground).scale(1e-300).epsilon(0.01));
}

TEST_CASE("presets: titan") {
    const AtmosphereParameters air = presets::titan();
    // 1.135e26 / 2.547e25 = 4.455 times the molecules of air at sea level, over 20 km: 4.455 x 1.149e-5 x 20e3 = 1.02.
    CHECK(vertical_optical_depth(air, "rayleigh").g == doctest::Approx(1.02).scale(1e-300).epsilon(0.01));
    check_rgb(vertical_optical_depth(air, "rayleigh"),
              1.1346e26 * 20e3 * Rgb(bodhaine(red_nm), bodhaine(green_nm), bodhaine(blue_nm)), 2e-3);
    // 5.65 % of 4.223 amagat, 0.1 per km-amagat, 12 km.
    CHECK(vertical_optical_depth(air, "methane").r == doctest::Approx(0.2386 * 0.1 * 12).scale(1e-300).epsilon(0.002));
    check_rgb(vertical_optical_depth(air, "methane"), 0.2386 * 12 * Rgb(0.1, 0.02, 0.002), 0.002);
    check_rgb(albedo(air.terms[0]), Rgb(1), 1e-15);
    check_rgb(albedo(air.terms[1]), Rgb(0), 1e-15);
    check_term(air, "haze", Rgb(4, 6, 9) * (1 - std::exp(-12.0)), {0.95, 0.87, 0.72});
}

TEST_CASE("presets: by name") {
    for (const std::string_view name : presets::names()) CHECK_NOTHROW(validate(presets::by_name(name)));
    CHECK(presets::names().size() == 6);

    CHECK(presets::by_name("earth") == presets::earth());
    CHECK(presets::by_name("hazy_earth") == presets::hazy_earth());
    CHECK(presets::by_name("mars") == presets::mars());
    CHECK(presets::by_name("airless") == presets::airless());
    CHECK_FALSE(presets::earth() == presets::hazy_earth());
    for (const char* wrong : {"", "Earth", "venus"})
        CHECK(detail::rejected_field([&] { (void)presets::by_name(wrong); }) == "preset");
}
