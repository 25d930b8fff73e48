#include "envelope/tell.h"

#include <aureole/envelope.h>
#include <aureole/models/aureole.h>
#include <aureole/models/bruneton.h>
#include <aureole/models/single.h>
#include <aureole/presets.h>

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

using namespace aureole;

namespace {

const Planet planet = presets::earth().planet;

Sun sun_at(double elevation_deg) {
    const double a = elevation_deg * std::numbers::pi / 180;
    return {.direction = {std::cos(a), 0, std::sin(a)}};
}

std::vector<OutsideEnvelope> seen(double altitude_m, double elevation_deg, const KeptInTables& kept = {}) {
    Camera camera = look(planet.bottom_radius_m, 0, 0, 0, 1, 1);
    camera.position_m = {0, 0, planet.bottom_radius_m + altitude_m};
    const Sun sun = sun_at(elevation_deg);
    return outside_envelope(planet, camera, {&sun, 1}, kept);
}

/// Its only remark is of this field, and says all there is to say.
void check_one(const std::vector<OutsideEnvelope>& found, const std::string& field, double value, EnvelopeAxis axis) {
    REQUIRE(found.size() == 1);
    CHECK(found[0].field == field);
    CHECK(found[0].value == doctest::Approx(value).scale(1e-300));
    CHECK(found[0].least == envelope_limit(axis).least);
    CHECK(found[0].greatest == envelope_limit(axis).greatest);
    CHECK(!found[0].beyond.empty());
    CHECK(found[0].beyond == envelope_limit(axis).beyond);
}

}  // namespace

TEST_CASE("envelope: the presets are inside") {
    for (const std::string_view name : presets::names()) CHECK(outside_envelope(presets::by_name(name)).empty());
}

TEST_CASE("envelope: what errors are promised for is inside") {
    AtmosphereParameters air = presets::earth();
    for (const double radius_m : {10e3, 1e9}) {
        air.planet.bottom_radius_m = radius_m;
        air.planet.top_radius_m = radius_m + 15e3;
        CHECK(outside_envelope(air).empty());
    }
    for (const double per_m : {0.0, 0.1}) {
        for (DensityTerm& term : air.terms) term.scattering_per_m = term.absorption_per_m = Rgb(0);
        air.terms[1].scattering_per_m = Rgb(0.9 * per_m);
        air.terms[1].absorption_per_m = Rgb(0.1 * per_m);
        CHECK(outside_envelope(air).empty());
    }
    for (const double altitude_m : {-10.0, 0.0, 0.01, 1e9})
        for (const double elevation_deg : {-18.0, 90.0}) CHECK(seen(altitude_m, elevation_deg).empty());
}

TEST_CASE("envelope: an air outside is told by field, value and range") {
    AtmosphereParameters air = presets::earth();
    air.planet = {.bottom_radius_m = 2e9, .top_radius_m = 2.0001e9, .ground_albedo = Rgb(0)};
    check_one(outside_envelope(air), "planet.bottom_radius_m", 2e9, EnvelopeAxis::bottom_radius_m);

    air.planet = {.bottom_radius_m = 1e6, .top_radius_m = 3e6, .ground_albedo = Rgb(0)};
    check_one(outside_envelope(air), "planet.top_radius_m / planet.bottom_radius_m - 1", 2, EnvelopeAxis::shell_over_radius);

    air = presets::earth();
    air.terms[1].profile = ExponentialProfile{0.5};
    check_one(outside_envelope(air), "terms[1].profile.scale_height_m", 0.5, EnvelopeAxis::scale_height_m);

    air = presets::earth();
    air.terms[1].phase = HenyeyGreensteinPhase{-0.995};
    const std::vector<OutsideEnvelope> found = outside_envelope(air);
    check_one(found, "terms[1].phase.g", -0.995, EnvelopeAxis::g);
    CHECK(found[0].text() == "terms[1].phase.g: -0.995 is outside the envelope of stability, [-0.99, 0.99]: expect " +
                                 std::string(envelope_limit(EnvelopeAxis::g).beyond));
    air.terms[1].scattering_per_m = Rgb(0);  // then it has no phase function
    CHECK(outside_envelope(air).empty());

    air = presets::earth();
    HenyeyGreensteinDrainePhase droplets{.g_hg = 0.998, .g_draine = 0.5, .alpha = 10, .weight = 0.5};
    air.terms[1].phase = droplets;
    check_one(outside_envelope(air), "terms[1].phase.g_hg", 0.998, EnvelopeAxis::g);
    droplets.weight = 1;
    air.terms[1].phase = droplets;
    CHECK(outside_envelope(air).empty());
}

TEST_CASE("envelope: extinction is that of all terms, their scales and tables included") {
    AtmosphereParameters air = presets::earth();
    for (DensityTerm& term : air.terms) term.scattering_per_m = term.absorption_per_m = Rgb(0);
    air.terms[0].scattering_per_m = Rgb(0.06, 0.01, 0.01);
    air.terms[2].absorption_per_m = Rgb(0.01, 0.01, 0.01);
    CHECK(outside_envelope(air).empty());
    air.terms[2].absorption_scale = 6;
    check_one(outside_envelope(air), "terms: extinction in 1/m", 0.12, EnvelopeAxis::extinction_per_m);
    air.terms[2].absorption_scale = 1;
    air.terms[2].profile = TabulatedProfile{{0, 1e4, 2e4}, {1, 7, 0}};
    check_one(outside_envelope(air), "terms: extinction in 1/m", 0.13, EnvelopeAxis::extinction_per_m);
}

TEST_CASE("envelope: a camera and suns outside") {
    check_one(seen(1.5e9, 30), "camera.position_m: altitude in m", 1.5e9, EnvelopeAxis::altitude_m);
    CHECK(seen(2, -90).empty());
    CHECK(seen(2, -8, {.half_sky = true}).empty());
    CHECK(seen(2, 1, {.half_sky = true, .half_difference = true}).empty());
    check_one(seen(2, -4, {.half_sky = true, .half_difference = true}), "suns[0].direction: elevation in degrees, of geometry",
              -4, EnvelopeAxis::half_difference_sun_elevation_deg);
    check_one(seen(2, -12, {.half_sky = true}), "suns[0].direction: elevation in degrees", -12,
              EnvelopeAxis::half_sun_elevation_deg);
    // Directions of any length.
    Camera camera = look(planet.bottom_radius_m, 2, 0, 0, 1, 1);
    const Sun suns[] = {{.direction = {0, 0, 1e-100}}, {.direction = {0, 1e100, -2e100}}};
    check_one(outside_envelope(planet, camera, suns, {.half_sky = true}), "suns[1].direction: elevation in degrees",
              -std::atan(2.0) * 180 / std::numbers::pi, EnvelopeAxis::half_sun_elevation_deg);
    CHECK(seen(2, -11, {.coarse_sun_axis = true}).empty());
    CHECK(seen(2, -18).empty());
    check_one(seen(2, -13, {.coarse_sun_axis = true}), "suns[0].direction: elevation in degrees, in so large or thick an air",
              -13, EnvelopeAxis::table_sun_elevation_deg);
}

TEST_CASE("envelope: what of a model's tables ends in twilight") {
    AtmosphereParameters air = presets::earth();
    models::BrunetonSettings tables;
    for (const rhi::Format format : {rhi::Format::rgba16_float, rhi::Format::rgba32_float}) {
        tables.format = format;
        const KeptInTables kept = detail::kept_in_tables(*models::bruneton(tables), air);
        CHECK(!kept.half_sky);
        CHECK(kept.half_difference == (format == rhi::Format::rgba16_float));
        CHECK(!kept.coarse_sun_axis);
    }
    const ModelPtr by_tables = models::bruneton(tables), by_rays = models::single({});
    CHECK(!detail::kept_in_tables(*models::aureole(QualitySettings::high()), air).half_sky);
    air.planet.bottom_radius_m = 8e6, air.planet.top_radius_m = 8.1e6;
    CHECK(detail::kept_in_tables(*by_tables, air).coarse_sun_axis);
    CHECK(!detail::kept_in_tables(*by_rays, air).coarse_sun_axis);
    air = presets::earth();
    air.terms[1].absorption_per_m = Rgb(0, 0, 2e-3);
    CHECK(detail::kept_in_tables(*by_tables, air).coarse_sun_axis);
}
