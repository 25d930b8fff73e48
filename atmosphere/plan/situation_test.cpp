#include "plan/situation.h"

#include <aureole/presets.h>

#include <doctest/doctest.h>

#include <cmath>

using namespace aureole;
using namespace aureole::detail;

namespace {

std::size_t axis(std::string_view name) {
    for (std::size_t i = 0; i < situation_axes.size(); ++i)
        if (situation_axes[i] == name) return i;
    FAIL("no such axis");
    return 0;
}

/// Molecules alone, over black ground: optical depth 0.1 in every channel, scale height 8 km.
AtmosphereParameters molecules() {
    AtmosphereParameters air;
    air.planet = {6e6, 6.2e6, Rgb(0)};
    air.terms = {{"rayleigh", ExponentialProfile{8000}, Rgb(0.1 / 8000), Rgb(0), RayleighPhase{}}};
    return air;
}

}  // namespace

TEST_CASE("situation: coordinates of air that is known in closed form") {
    const AirCoordinates air(molecules());
    const Situation ground = air.at(3 * std::sinh(1.0), 0);
    const auto near = [](double value) { return doctest::Approx(value).epsilon(0.01).scale(1e-300); };
    CHECK(ground[axis("sun")] == near(1));
    CHECK(ground[axis("altitude")] == 0);
    CHECK(ground[axis("space")] == 0);
    CHECK(ground[axis("depth")] == near(std::log(0.11)));
    CHECK(ground[axis("sharpness")] == near(std::log(0.002)));  // molecules have no third moment
    CHECK(ground[axis("absorption")] == near(std::log(0.005)));
    CHECK(ground[axis("whiteness")] == near(4));
    CHECK(ground[axis("ground")] == 0);
    CHECK(ground[axis("curvature")] == near(std::log(8.0 / 6000)));
    CHECK(air.at(0, 16000)[axis("altitude")] == near(2));
    CHECK(air.at(0, 1e9)[axis("altitude")] == 8);
    CHECK(air.at(0, 200e3 + 6e6)[axis("space")] == near(std::log(21.0)));
    CHECK(air.at(0, -10) == air.at(0, 0));
}

TEST_CASE("situation: what air is made of tells airs apart") {
    const Situation earth = AirCoordinates(presets::earth()).at(30, 2), hazy = AirCoordinates(presets::hazy_earth()).at(30, 2);
    CHECK(hazy[axis("sharpness")] > earth[axis("sharpness")] + 1);
    CHECK(hazy[axis("depth")] > earth[axis("depth")]);
    AtmosphereParameters snow = presets::earth();
    snow.planet.ground_albedo = Rgb(0.9);
    const Situation snowy = AirCoordinates(snow).at(30, 2);
    CHECK(snowy[axis("ground")] == doctest::Approx(1.8).epsilon(1e-12).scale(1e-300));
    CHECK(snowy[axis("order ratio")] > earth[axis("order ratio")]);
    AtmosphereParameters clean = presets::earth();
    std::erase_if(clean.terms, [](const DensityTerm& term) { return term.name == "ozone"; });
    CHECK(AirCoordinates(clean).at(30, 2)[axis("absorption")] < earth[axis("absorption")] - 0.5);
}

TEST_CASE("situation: coordinates and altitude tell extinction") {
    for (const std::string_view name : presets::names()) {
        CAPTURE(name);
        const AtmosphereParameters parameters = presets::by_name(name);
        const AirCoordinates air(parameters);
        const double densest = densest_extinction_per_m(parameters);
        for (const double altitude_m : {2.0, 300.0, 5000.0}) {
            const std::optional<double> found = densest_extinction_per_m(air.at(20, altitude_m), altitude_m);
            REQUIRE(found);
            CHECK(*found == doctest::Approx(densest).epsilon(1e-9).scale(1e-6));
        }
        CHECK_FALSE(densest_extinction_per_m(air.at(20, 0), 0));
        CHECK_FALSE(densest_extinction_per_m(air.at(20, 1e9), 1e9));
    }
}

TEST_CASE("situation: every preset, and a body without air, has finite coordinates anywhere") {
    std::vector<AtmosphereParameters> airs{AtmosphereParameters{}};
    for (const std::string_view name : presets::names()) airs.push_back(presets::by_name(name));
    for (const AtmosphereParameters& parameters : airs) {
        const AirCoordinates air(parameters);
        for (const double sun : {-90.0, 0.0, 90.0})
            for (const double altitude : {-1e4, 0.0, 1e5, 1e12})
                for (const double coordinate : air.at(sun, altitude)) CHECK(std::isfinite(coordinate));
    }
}
