#include "measure/light.h"

#include "io/test_files.h"

#include <aureole/models/aureole.h>
#include <aureole/models/reference.h>
#include <aureole/models/spectral.h>
#include <aureole/presets.h>

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <glm/exponential.hpp>

using namespace aureole;
using namespace aureole::app;

namespace {

TraceSettings coarse(double error) {
    TraceSettings settings;
    settings.error = error;
    settings.max_paths = 4096;
    return settings;
}

ModelPtr tables() { return models::aureole(QualitySettings::high()); }

}  // namespace

TEST_CASE("light: without air the sun as it is, and no sky; through air that absorbs what Beer leaves") {
    const auto backend = open_backend({.name = "cpu-double"});
    AtmosphereParameters air = presets::airless();
    air.planet.ground_albedo = Rgb(0);
    const std::vector<LightPlace> places{{40, 1}, {120, 1}};
    const auto bare = light(*backend, air, tables(), places);
    REQUIRE(bare.size() == 2);
    CHECK(bare[0].sun_irradiance.g == doctest::Approx(1));
    CHECK(bare[0].sky_irradiance_up == Rgb(0));
    CHECK(bare[1].sun_irradiance == Rgb(0));

    DensityTerm term;
    term.name = "grey";
    term.profile = ExponentialProfile{8000};
    term.absorption_per_m = Rgb(2e-5, 5e-5, 1e-4);
    air = {};
    air.terms = {term};
    const auto expected = glm::exp(-vertical_optical_depth(air));
    const std::vector<LightPlace> below{{0, 0}};
    const Rgb found = light(*backend, air, tables(), below)[0].sun_irradiance;
    const auto truth = trace_light(*backend, air, below[0], coarse(1));
    REQUIRE(truth);
    for (int c = 0; c < 3; ++c) {
        CHECK(found[c] == doctest::Approx(expected[c]).scale(1e-300).epsilon(1e-4));
        CHECK(truth->sun_irradiance[c] == doctest::Approx(expected[c]).scale(1e-300).epsilon(1e-6));
    }
}

TEST_CASE("light: a dusk on Earth by tables is the truth within both errors" * doctest::test_suite("long")) {
    const auto backend = open_backend({.name = "cpu-double"});
    const AtmosphereParameters air = presets::earth();
    const std::vector<LightPlace> places{{50, 0.002}, {93, 0.002}}, alone{places[1]};
    const auto measured = light(*backend, air, tables(), places);
    CHECK(measured[0].sun_irradiance.g > 0.5);
    CHECK(measured[0].sky_irradiance_up.g > 10 * measured[1].sky_irradiance_up.g);
    CHECK(light(*backend, air, tables(), alone)[0].sky_irradiance_up == measured[1].sky_irradiance_up);

    double share = 0;
    const auto truth = trace_light(*backend, air, places[1], coarse(0.01), [&](double now) { share = now; });
    REQUIRE(truth);
    CHECK(truth->reached);
    CHECK(share == 1);
    CHECK(truth->paths >= 256);
    const Estimated& sky = truth->sky_irradiance_up;
    for (int c = 0; c < 3; ++c) {
        CHECK(sky.error[c] > 0);
        CHECK(sky.error[c] <= 0.01 * sky.radiance[c]);
        CHECK(std::abs(measured[1].sky_irradiance_up[c] - sky.radiance[c]) < 3 * sky.error[c] + 0.005 * sky.radiance[c]);
    }
    CHECK(measured[1].sun_irradiance == Rgb(0));
    CHECK(truth->sun_irradiance == Rgb(0));
    std::printf("light: tables are %.2f %% from the truth in green, standard error %.2f %%, %llu paths\n",
                100 * std::abs(measured[1].sky_irradiance_up.g / sky.radiance.g - 1), 100 * sky.error.g / sky.radiance.g,
                static_cast<unsigned long long>(truth->paths));
}

TEST_CASE("light: of every model, and in wavelengths" * doctest::test_suite("long")) {
    const auto backend = open_backend({.name = "cpu"});
    const std::vector<LightPlace> places{{40, 0.1}};
    for (const std::string_view name : model_names()) {
        CAPTURE(name);
        if (name == "bruneton") continue;  // its tables take seconds
        const auto measured = light(*backend, presets::earth(), model_by_name(name, "low"), places);
        REQUIRE(measured.size() == 1);
        CHECK(measured[0].sky_irradiance_up.b > 0);
    }
    const ModelPtr model = models::spectral(tables(), {.wavelengths = models::wavelengths_by_name("3")});
    const Rgb in_three = light(*backend, presets::earth(), model, places)[0].sky_irradiance_up;
    TraceSettings settings = coarse(1);
    settings.spectral = "3";
    const auto truth = trace_light(*backend, presets::earth(), places[0], settings);
    REQUIRE(truth);
    const Estimated& sky = truth->sky_irradiance_up;
    for (int c = 0; c < 3; ++c) CHECK(std::abs(in_three[c] - sky.radiance[c]) < 3 * sky.error[c] + 0.01 * sky.radiance[c]);
    // Pixels of the path tracer in the same wavelengths, added up on the device.
    models::ReferenceSettings paths;
    paths.light_paths = 1;
    const ModelPtr pixels = models::spectral(models::reference(paths), {.wavelengths = models::wavelengths_by_name("3")});
    const Rgb sun = light(*backend, presets::earth(), pixels, places)[0].sun_irradiance;
    for (int c = 0; c < 3; ++c) CHECK(truth->sun_irradiance[c] == doctest::Approx(sun[c]).scale(1e-300).epsilon(1e-5));
}

TEST_CASE("light: stopped, and refused") {
    const auto backend = open_backend({.name = "cpu"});
    const AtmosphereParameters air = presets::earth();
    CHECK_FALSE(trace_light(*backend, air, {60, 1}, coarse(1), {}, [] { return true; }));
    const std::vector<LightPlace> places{{30, 0}, {-1, 0}};
    CHECK(contains(complaint([&] { (void)light(*backend, air, tables(), places); }), "place 2: sun_zenith_deg: -1"));
    CHECK(light(*backend, air, tables(), {}).empty());
    CHECK(contains(complaint([&] { (void)trace_light(*backend, air, {30, 2e9}, coarse(1)); }), "altitude_km"));
    TraceSettings orders = coarse(1);
    orders.orders = 1;
    CHECK(contains(complaint([&] { (void)trace_light(*backend, air, {}, orders); }), "orders: 1"));
}
