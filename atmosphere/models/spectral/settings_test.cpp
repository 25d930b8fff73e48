// What the settings of models in N wavelengths may be, and what an atmosphere in red, green and blue is at a wavelength.
#include <doctest/doctest.h>

#include <aureole/atmosphere.h>
#include <aureole/models/aureole.h>
#include <aureole/models/fog.h>
#include <aureole/models/spectral.h>
#include <aureole/presets.h>

#include "common/rejects.h"
#include "passes/backend.h"

#include <cmath>

using namespace aureole;
using detail::rejected_field;
using models::at_wavelengths;
using models::SpectralSettings;

namespace {

std::string field_of(const SpectralSettings& settings, const ModelPtr& inner = models::aureole()) {
    return rejected_field([&] { (void)models::spectral(inner, settings); });
}

}  // namespace

TEST_CASE("spectral: settings are checked, by field") {
    CHECK(field_of({}) == "nothing");
    CHECK(field_of({spectrum::equal_bins(42)}) == "nothing");
    CHECK(field_of({spectrum::equal_bins(43)}) == "spectral.wavelengths.nm");
    CHECK(field_of({{}}) == "spectral.wavelengths.nm");
    CHECK(field_of({{{550, 600}, {Rgb(1)}}}) == "spectral.wavelengths.to_rec709");
    CHECK(field_of({{{550, 900}, {Rgb(1), Rgb(1)}}}) == "spectral.wavelengths.nm[1]");
    CHECK(field_of({{{550, 600}, {Rgb(1), Rgb(1, NAN, 1)}}}) == "spectral.wavelengths.to_rec709[1]");
    CHECK(field_of({{{550, 600}, {Rgb(1), Rgb(1, -2, 1)}}}) == "sum of spectral.wavelengths.to_rec709");
    CHECK(field_of({}, nullptr) == "spectral.inner");
    CHECK(field_of({}, models::spectral(models::aureole())) == "spectral.inner");
    CHECK(field_of({}, models::spectral(models::fog())) == "spectral.inner");
    for (const std::string_view name : model_names())
        for (const std::string_view quality : quality_names()) CHECK(field_of({}, model_by_name(name, quality)) == "nothing");
    for (const char* name : {"rgb", "", "2", "43", "4.5", "-4", "4 "})
        CHECK(rejected_field([&] { (void)models::wavelengths_by_name(name); }) == "spectral");
    CHECK(models::wavelengths_by_name("4").nm == spectrum::fitted(4).nm);
    CHECK(models::wavelengths_by_name("40").nm == spectrum::equal_bins(40).nm);
}

TEST_CASE("spectral: air at wavelengths that does not fit the atmosphere is rejected, and changes nothing") {
    const auto cpu = passes::open_cpu_float();
    const auto rejected = [&](auto change) {
        const auto air = [change](const AtmosphereParameters& rgb, const std::array<double, 3>&) {
            AtmosphereParameters other = rgb;
            change(other);
            return other;
        };
        const ModelPtr model = models::spectral(models::aureole(QualitySettings::low()), {spectrum::fitted(3), air});
        return rejected_field([&] { Atmosphere(cpu->device(), presets::earth(), model); });
    };
    CHECK(rejected([](AtmosphereParameters& air) { air.terms[0].scattering_per_m *= 2; }) == "nothing");
    CHECK(rejected([](AtmosphereParameters& air) { air.planet.top_radius_m += 1e3; }) == "spectral.air");
    CHECK(rejected([](AtmosphereParameters& air) { air.terms[1].phase = CornetteShanksPhase{0.7}; }) == "spectral.air");
    CHECK(rejected([](AtmosphereParameters& air) { air.terms.pop_back(); }) == "nothing");
    CHECK(rejected([](AtmosphereParameters& air) { air.terms.erase(air.terms.begin() + 1); }) == "spectral.air");
    CHECK(rejected([](AtmosphereParameters& air) { air.terms[0].scattering_per_m.g = -1; }) == "terms[0].scattering_per_m.g");
}

TEST_CASE("spectral: an atmosphere in red, green and blue at their own wavelengths is itself") {
    AtmosphereParameters air = presets::mars();
    air.terms[0].name = "carbon dioxide";
    air.planet.ground_albedo = {0.4, 0.2, 0.1};
    AtmosphereParameters same = at_wavelengths(air, {680, 550, 440});
    for (std::size_t i = 0; i < air.terms.size(); ++i) {
        CHECK(glm::length(same.terms[i].scattering_per_m - air.terms[i].scattering_per_m) < 1e-18);
        CHECK(glm::length(same.terms[i].absorption_per_m - air.terms[i].absorption_per_m) < 1e-18);
    }
    CHECK(same.planet.ground_albedo == air.planet.ground_albedo);
    CHECK(same.terms[0].phase == air.terms[0].phase);
    // Constant stays constant, on both sides and between.
    CHECK(glm::length(at_wavelengths(presets::earth(), {380, 600, 780}).terms[1].scattering_per_m - Rgb(3.996e-6)) < 1e-18);
    CHECK(glm::length(at_wavelengths(air, {380, 495, 780}).planet.ground_albedo - Rgb(0.1, 0.15, 0.4)) < 1e-15);
}

TEST_CASE("spectral: molecules and ozone follow their laws, by name") {
    const AtmosphereParameters rgb = presets::earth();
    const AtmosphereParameters air = at_wavelengths(rgb, {400, 500, 700});
    const Rgb molecules = air.terms[0].scattering_per_m, ozone = air.terms[2].absorption_per_m;
    CHECK(
        molecules.r / molecules.b ==
        doctest::Approx(spectrum::rayleigh_scattering(400) / spectrum::rayleigh_scattering(700)).scale(1e-300).epsilon(1e-12));
    CHECK(
        ozone.g / ozone.b ==
        doctest::Approx(spectrum::ozone_cross_section(500) / spectrum::ozone_cross_section(700)).scale(1e-300).epsilon(1e-12));
    const AtmosphereParameters known = at_wavelengths(rgb, {680, 550, 440});
    for (int c = 0; c < 3; ++c)
        CHECK(known.terms[0].scattering_per_m[c] ==
              doctest::Approx(rgb.terms[0].scattering_per_m[c]).scale(1e-300).epsilon(0.03));
    const auto sum = [](const Rgb& v) { return v.r + v.g + v.b; };
    CHECK(sum(known.terms[2].absorption_per_m) ==
          doctest::Approx(sum(rgb.terms[2].absorption_per_m)).scale(1e-300).epsilon(1e-12));

    // Numbers that are no molecules' are taken as they stand.
    AtmosphereParameters grey = rgb;
    grey.terms[0].scattering_per_m = Rgb(1e-5);
    CHECK(glm::length(at_wavelengths(grey, {400, 500, 700}).terms[0].scattering_per_m - Rgb(1e-5)) < 1e-18);
}

TEST_CASE("spectral: powers between and beyond, none too steep, lines where there is a zero") {
    AtmosphereParameters air;
    air.terms = {{.name = "dust",
                  .profile = ExponentialProfile{},
                  .scattering_per_m = {1e-6, 2e-6, 0},
                  .absorption_per_m = {},
                  .phase = RayleighPhase{}}};
    const auto at = [&](double nm) { return at_wavelengths(air, {nm, nm, nm}).terms[0].scattering_per_m.r; };
    CHECK(at(495) == doctest::Approx(1e-6).scale(1e-300).epsilon(1e-9));
    CHECK(at(780) == doctest::Approx(1e-6).scale(1e-300).epsilon(1e-9));
    CHECK(at(400) == doctest::Approx(2e-18).scale(1e-300).epsilon(1e-9));  // next to nothing, but its phase function stays
    for (const double alpha : {1.3, -2.0, 9.0}) {
        const auto law = [&](double nm) { return 1e-6 * std::pow(nm / 550, -alpha); };
        air.terms[0].scattering_per_m = {law(680), law(550), law(440)};
        for (const double nm : {440.0, 470.0, 600.0, 680.0})
            CHECK(at(nm) == doctest::Approx(law(nm)).scale(1e-300).epsilon(1e-12));
        const double kept = std::clamp(alpha, -5.0, 5.0);
        CHECK(at(780) == doctest::Approx(law(680) * std::pow(780.0 / 680, -kept)).scale(1e-300).epsilon(1e-12));
        CHECK(at(380) == doctest::Approx(law(440) * std::pow(380.0 / 440, -kept)).scale(1e-300).epsilon(1e-12));
    }
    CHECK(rejected_field([&] { (void)at_wavelengths(air, {400, 900, 500}); }) == "nm[1]");
    air.terms[0].scattering_per_m.r = -1;
    CHECK(rejected_field([&] { (void)at_wavelengths(air, {400, 500, 600}); }) == "terms[0].scattering_per_m.r");
}
