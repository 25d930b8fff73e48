#include "common/rejects.h"
#include "spectrum/relative.h"
#include "spectrum/sky_spectra.h"

#include <aureole/presets.h>
#include <aureole/spectrum.h>

#include <doctest/doctest.h>

using namespace aureole;
using namespace aureole::spectrum;
using aureole::detail::rejected_field;
using aureole::spectrum::detail::relative;

TEST_CASE("spectrum: the sun") {
    CHECK(relative(solar_irradiance(360, 370), 1.11776) < 1e-12);
    CHECK(relative(solar_irradiance(500, 510), 1.91686) < 1e-12);
    CHECK(relative(solar_irradiance(820, 830), 1.07124) < 1e-12);
    CHECK(relative(solar_irradiance(365, 375), (1.11776 + 1.14259) / 2) < 1e-12);
    CHECK(relative(solar_irradiance(505), 1.91686) < 1e-12);
    CHECK(relative(solar_irradiance(510), (1.91686 + 1.8298) / 2) < 1e-12);
    // Of 1366.1 W/m^2 (E-490), a little more than half lies in 360-830 nm: a black body of 5772 K has 52.6 % there.
    const double watts = solar_irradiance(360, 830) * (830 - 360);
    CHECK(relative(watts, 734.943) < 1e-5);  // ten times the sum of 47 numbers
    CHECK(relative(watts / 1366.1, 0.526) < 0.04);
}

TEST_CASE("spectrum: what the sun looks like outside the air") {
    Bands sun{.edge_nm = {360}, .value = {}};
    for (double nm = 360; nm < 830; nm += 10) {
        sun.edge_nm.push_back(nm + 10);
        sun.value.push_back(solar_irradiance(nm, nm + 10));
    }
    const glm::dvec3 xyz = spectrum::xyz(sun);
    CHECK(relative(xyz.y, 133.2e3) < 2e-3);  // lux
    // Warmer than D65.
    CHECK(relative(xyz.x / (xyz.x + xyz.y + xyz.z), 0.3236) < 2e-3);
    // Twenty times as many sums.
    Rgb rgb(0);
    for (const Rgb& colour : equal_bins(400).to_rec709) rgb += colour;
    CHECK(glm::length(rgb - rec709_from_xyz(xyz)) < 5e-4 * xyz.y);  // the tails beyond 380-780 nm
}

TEST_CASE("spectrum: the observer") {
    CHECK(colour_matching(555).y == 1);
    CHECK(relative(colour_matching(557.5).y, (1 + 0.995) / 2) < 1e-12);
    CHECK(relative(colour_matching(830).x, 1.251141e-6) < 1e-12);
    // CIE 15: the three areas are equal, 106.86 nm.
    const glm::dvec3 area = colour_matching(360, 830) * 470.0;
    CHECK(relative(area.x, 106.865) < 1e-5);
    CHECK(relative(area.y, 106.857) < 1e-5);
    CHECK(relative(area.z, 106.892) < 3e-5);
    const glm::dvec3 part = colour_matching(553, 558.5);  // two trapezoids and a part of one
    CHECK(relative(part.y, (2 * (0.99798004 + 1) / 2 + 3.5 * (1 + 0.9965) / 2) / 5.5) < 1e-7);
}

TEST_CASE("spectrum: ozone") {
    CHECK(relative(ozone_cross_section(605), 5.019e-25) < 1e-12);
    CHECK(relative(ozone_cross_section(380, 400), (2.818e-28 + 6.636e-28) / 2) < 1e-12);
    CHECK(relative(ozone_cross_section(360), 1.18e-27) < 1e-12);
    CHECK(relative(ozone_cross_section(360, 830), 1.423382e-25) < 1e-6);  // the mean of 47 numbers
}

TEST_CASE("spectrum: molecules as Bodhaine et al. 1999 tabulate them") {
    // Their equation 30, a fit to 0.01 % over 250-850 nm of all the formulas together, at 360 ppm.
    for (double nm = 250; nm <= 850; nm += 50) {
        CAPTURE(nm);
        const double um2 = nm * nm * 1e-6;
        const double fit =
            1e-32 * (1.0455996 - 341.29061 / um2 - 0.90230850 * um2) / (1 + 0.0027059889 / um2 - 85.968563 * um2);
        CHECK(relative(rayleigh_cross_section(nm), fit) < 3e-4);
    }
    CHECK(relative(king_factor(550), 1.0488) < 5e-5);
    CHECK(king_factor(300) > king_factor(550));
    // Edlen 1966, for 300 ppm, from other measurements.
    for (double nm = 400; nm <= 800; nm += 100) {
        const double k = 1e6 / (nm * nm);
        CHECK(relative(refractivity(nm, 300), 1e-8 * (8342.13 + 2406030 / (130 - k) + 15997 / (38.9 - k))) < 2e-5);
    }
    CHECK(refractivity(589.3, 400) > refractivity(589.3, 300));
    CHECK(relative(rayleigh_scattering(550), 1.149e-5) < 1e-3);
    CHECK(relative(angstrom_optical_depth(500, 0.1, 1.3), 0.1 * 2.4622888) < 1e-7);
}

TEST_CASE("spectrum: the standard atmosphere") {
    const TabulatedProfile air = standard_atmosphere_1976();
    REQUIRE(air.altitude_m.size() == 1001);
    // U.S. Standard Atmosphere 1976, table I: density in kg/m^3 at geometric altitudes, over 1.2250 at sea level.
    const std::vector<std::pair<std::size_t, double>> table{
        {0, 1.2250},     {10, 1.1117},    {50, 0.73643},    {100, 0.41351},   {150, 0.19476},
        {200, 0.088910}, {300, 0.018410}, {500, 1.0269e-3}, {700, 8.2829e-5}, {800, 1.8458e-5}};
    for (const auto& row : table) {
        const auto& hundreds = row.first;
        const auto& density = row.second;
        CAPTURE(hundreds);
        CHECK(air.altitude_m[hundreds] == 100.0 * static_cast<double>(hundreds));
        CHECK(relative(air.density[hundreds], density / 1.2250) < 2e-4);
    }
    CHECK(relative(air.density[1000], 5.604e-7 / 1.2250) < 0.04);
}

TEST_CASE("spectrum: the Earth's air by wavelength") {
    const AtmosphereParameters air = earth({550, 440, 680});
    // Bodhaine's equation 30 times the molecules over a square metre at sea level: 0.0021520 x 45.105 = 0.09707 at 550 nm.
    CHECK(relative(vertical_optical_depth(air, "rayleigh").r, 0.09707) < 2e-3);
    CHECK(relative(vertical_optical_depth(air, "mie").g, 5.328e-3) < 1e-4);
    CHECK(relative(vertical_optical_depth(air, "ozone").r, 300 * 2.6867e20 * ozone_cross_section(550)) < 1e-6);
    CHECK(relative(vertical_optical_depth(air, "ozone").b, 300 * 2.6867e20 * ozone_cross_section(680)) < 1e-6);
    // Aerosol by Angstrom's law, one part in ten absorbed.
    EarthAir hazy;
    hazy.aerosol_beta = 0.1;
    hazy.aerosol_alpha = 1.3;
    const AtmosphereParameters haze = earth({500, 600, 700}, hazy);
    CHECK(relative(vertical_optical_depth(haze, "mie").r, 0.1 * 2.4622888) < 1e-4);
    const DensityTerm& mie = haze.terms[1];
    CHECK(relative(mie.absorption_per_m.g, 0.1 * (mie.absorption_per_m.g + mie.scattering_per_m.g)) < 1e-12);
    // The spectra that the sets are judged by are of the same air.
    const spectrum::detail::SkySpectrum zenith{.direct = true,
                                               .air_mass = 1,
                                               .ozone_mass = 1,
                                               .view_mass = 0,
                                               .forward = 0,
                                               .again = 0,
                                               .aerosol_beta = 5.328e-3,
                                               .aerosol_alpha = 0,
                                               .ozone_dobson = 300};
    CHECK(relative(std::exp(-vertical_optical_depth(air).g), zenith(440)) < 2e-4);
}

TEST_CASE("spectrum: sets of wavelengths") {
    const Wavelengths forty = equal_bins(40);
    CHECK(forty.nm.front() == 385);
    CHECK(forty.nm.back() == 775);
    // Against the integral over the bands of a spectrum that is constant in them: exact, and so in luminance.
    Bands red{.edge_nm = {380}, .value = {}};
    Rgb sum(0);
    for (std::size_t i = 0; i < 40; ++i) {
        const double radiance = std::exp(-1e4 * std::pow(forty.nm[i], -1.5));
        red.edge_nm.push_back(390 + 10 * static_cast<double>(i));
        red.value.push_back(radiance * solar_irradiance(red.edge_nm[i], red.edge_nm[i + 1]));
        sum += radiance * forty.to_rec709[i];
    }
    const glm::dvec3 direct = xyz(red);
    CHECK(glm::length(sum - rec709_from_xyz(direct)) < 1e-12 * direct.y);
    CHECK(relative(xyz_from_rec709(sum).y, direct.y) < 1e-12);
    // More bins come closer.
    CHECK(spectrum::detail::judge_set(equal_bins(20)).p95 < 0.5 * spectrum::detail::judge_set(equal_bins(10)).p95);
}

TEST_CASE("spectrum: triplets add up to the same as the set") {
    for (const Wavelengths& set : {fitted(3), fitted(4), equal_bins(5), equal_bins(40)}) {
        const spectrum::detail::SkySpectrum sky = spectrum::detail::sky_spectrum(4);
        const std::vector<Triplet> parts = triplets(set);
        CHECK(parts.size() == (set.nm.size() + 2) / 3);
        Rgb sum(0);
        for (const Triplet& t : parts) sum += t.to_rec709 * Rgb(sky(t.nm[0]), sky(t.nm[1]), sky(t.nm[2]));
        const Rgb whole = spectrum::detail::colour_of(sky, set);
        CHECK(glm::length(sum - whole) < 1e-12 * glm::length(whole));
        CHECK_NOTHROW((void)earth(parts.back().nm));
    }
}

TEST_CASE("spectrum: air at the ends of the tables' wavelengths is air, and a step beyond is refused") {
    const AtmosphereParameters ends = earth({360, 830, 595});
    validate(ends);
    const Rgb depth = vertical_optical_depth(ends);
    CHECK(depth.r > depth.b);
    CHECK(depth.b > depth.g);
    CHECK(depth.g > 0);
    CHECK(rejected_field([] { (void)earth({359.9, 550, 440}); }) == "nm[0]");
    CHECK(rejected_field([] { (void)earth({550, 440, 830.1}); }) == "nm[2]");
}

TEST_CASE("spectrum: what is out of range is rejected") {
    CHECK(rejected_field([] { (void)solar_irradiance(359); }) == "nm");
    CHECK(rejected_field([] { (void)ozone_cross_section(831); }) == "nm");
    CHECK(rejected_field([] { (void)colour_matching(NAN); }) == "nm");
    CHECK(rejected_field([] { (void)colour_matching(500, 500); }) == "to_nm");
    CHECK(rejected_field([] { (void)solar_irradiance(300, 400); }) == "from_nm");
    CHECK(rejected_field([] { (void)solar_irradiance(400, 900); }) == "to_nm");
    CHECK(rejected_field([] { (void)rayleigh_cross_section(229); }) == "nm");
    CHECK(rejected_field([] { (void)king_factor(500, -1); }) == "co2_ppm");
    CHECK(rejected_field([] { (void)angstrom_optical_depth(500, 0.1, 5); }) == "alpha");
    CHECK(rejected_field([] { (void)angstrom_optical_depth(500, -1, 1); }) == "beta");
    CHECK(rejected_field([] { (void)equal_bins(0); }) == "n");
    CHECK(rejected_field([] { (void)equal_bins(401); }) == "n");
    CHECK(rejected_field([] { (void)fitted(5); }) == "n");
    CHECK(rejected_field([] { (void)triplets({}); }) == "wavelengths.nm");
    CHECK(rejected_field([] { (void)triplets({.nm = {500}, .to_rec709 = {}}); }) == "wavelengths.to_rec709");
    CHECK(rejected_field([] { (void)earth({500, 900, 500}); }) == "nm[1]");
    const auto with = [](auto change) {
        EarthAir air;
        change(air);
        return rejected_field([&] { (void)earth({500, 550, 600}, air); });
    };
    CHECK(with([](EarthAir& a) { a.ozone_dobson = -1; }) == "air.ozone_dobson");
    CHECK(with([](EarthAir& a) { a.co2_ppm = 2e6; }) == "air.co2_ppm");
    CHECK(with([](EarthAir& a) { a.aerosol_beta = NAN; }) == "air.aerosol_beta");
    CHECK(with([](EarthAir& a) { a.aerosol_alpha = 9; }) == "air.aerosol_alpha");
    CHECK(with([](EarthAir& a) { a.aerosol_scale_height_m = 0; }) == "air.aerosol_scale_height_m");
    CHECK(with([](EarthAir& a) { a.aerosol_albedo = 1.1; }) == "air.aerosol_albedo");
    CHECK(with([](EarthAir& a) { a.ozone.half_width_m = 0; }) == "air.ozone.half_width_m");
    CHECK(with([](EarthAir& a) { a.aerosol_g = 1; }).find('g') != std::string::npos);
    CHECK(with([](EarthAir& a) { a.ground_albedo = 2; }) == "planet.ground_albedo.r");
}
