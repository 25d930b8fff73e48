// What the air lets through: the sun's colour that a host gets, and light from beyond the air, against closed forms.
#include <doctest/doctest.h>

#include "physics/reference.h"
#include "physics/sky.h"
#include "physics/worst.h"

#include <cmath>

using namespace aureole;
using namespace aureole::physics;

namespace {

constexpr double scale_height = 8000;
const Rgb scattering(1e-5, 2e-5, 4e-5), absorption(1e-6, 0, 2e-6);

AtmosphereParameters planet_of(const Shell& shell, const std::vector<DensityTerm>& terms) {
    AtmosphereParameters parameters;
    parameters.planet.bottom_radius_m = static_cast<double>(shell.bottom);
    parameters.planet.top_radius_m = static_cast<double>(shell.top);
    parameters.terms = terms;
    return parameters;
}

Shell exponential_shell() {
    Shell shell;
    shell.density = [](Real h) { return std::exp(-h / static_cast<Real>(scale_height)); };
    return shell;
}
DensityTerm exponential_term() { return {"air", ExponentialProfile{scale_height}, scattering, absorption, RayleighPhase{}}; }

/// A sky of which only the sun's colour is wanted: the smallest sky-view table will do.
SkyOptions sun_color_only(const QualitySettings& quality) {
    SkyOptions options;
    options.quality = quality;
    options.quality.sky_view = {4, 4, 1};
    options.light = true;
    return options;
}

/// Error of the optical depth towards the sun, relative to the depth or to 0.1, whichever is more.
Worst sun_depth_error(Machine& machine, const QualitySettings& quality, const Shell& shell, const DensityTerm& term) {
    Sky sky(machine, planet_of(shell, {term}), sun_color_only(quality));
    Worst worst;
    for (const double altitude : {0.0, 2.0, 1000.0, 20000.0, 60000.0, 90000.0}) {
        const double horizon = std::acos(static_cast<double>(shell.horizon_mu(altitude)));
        for (const double share : {0.0, 0.3, 0.6, 0.8, 0.9, 0.95, 0.98, 0.999}) {
            sky.stand(altitude, sun_at(share * horizon));
            const Rgb seen(sky.light()[9]);
            const double column = static_cast<double>(shell.column_to_top(altitude, std::cos(share * horizon)));
            for (int c = 0; c < 3; ++c) {
                const double expected = column * (term.scattering_per_m[c] + term.absorption_per_m[c]);
                if (expected > 60) continue;  // nothing comes through
                worst.add(std::abs(-std::log(seen[c]) - expected) / std::max(expected, 0.1), altitude, share, c, expected);
            }
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("transmittance: our own quadrature agrees with Chapman's closed form") {
    Shell shell = exponential_shell();
    shell.top = shell.bottom + 500e3L;  // exp(-62) of the air is left out
    for (const Real altitude : {0.0L, 1000.0L, 30000.0L}) {
        const Real closed = horizontal_column_exponential(shell.bottom, altitude, scale_height);
        CHECK(static_cast<double>(shell.column_to_top(altitude, 0) / closed) == doctest::Approx(1).scale(1e-300).epsilon(1e-7));
        // Straight up it is the scale height times the density here.
        CHECK(static_cast<double>(shell.column_to_top(altitude, 1)) ==
              doctest::Approx(scale_height * std::exp(-static_cast<double>(altitude) / scale_height))
                  .scale(1e-300)
                  .epsilon(1e-7));
    }
}

TEST_CASE("transmittance: homogeneous air is exp(-extinction x distance)") {
    const DensityTerm even = even_term(scattering / 10.0, absorption / 10.0, RayleighPhase{});
    CHECK_WORST(sun_depth_error(cpu_float(), QualitySettings::low(), Shell{}, even), 1e-2);
    CHECK_WORST(sun_depth_error(cpu_float(), QualitySettings::standard(), Shell{}, even), 2e-3);
    CHECK_WORST(sun_depth_error(cpu_float(), fine_single(), Shell{}, even), 4e-4);
    CHECK_WORST(sun_depth_error(cpu_double(), fine_single(), Shell{}, even), 4e-4);
}

TEST_CASE("transmittance: exponential air is its column by quadrature") {
    CHECK_WORST(sun_depth_error(cpu_float(), QualitySettings::low(), exponential_shell(), exponential_term()), 5e-2);
    CHECK_WORST(sun_depth_error(cpu_float(), QualitySettings::standard(), exponential_shell(), exponential_term()), 1e-2);
    CHECK_WORST(sun_depth_error(cpu_float(), fine_single(), exponential_shell(), exponential_term()), 2e-3);
}

TEST_CASE("transmittance: a grazing ray of exponential air is Chapman's closed form") {
    AtmosphereParameters air = planet_of(exponential_shell(), {exponential_term()});
    air.planet.top_radius_m = air.planet.bottom_radius_m + 200e3;
    Sky sky(cpu_float(), air, sun_color_only(fine_single()));
    for (const double altitude : {0.0, 10000.0, 30000.0}) {
        CAPTURE(altitude);
        sky.stand(altitude, sun_at(pi / 2));
        const double column =
            static_cast<double>(horizontal_column_exponential(air.planet.bottom_radius_m, altitude, scale_height));
        const double share = altitude > 0 ? 1 : 0.5;  // of the disk: from the ground, half of it has set
        const double depth = -std::log(sky.light()[9].r / share);
        CHECK(depth == doctest::Approx(column * 1.1e-5).scale(1e-300).epsilon(4e-3));
    }
}

TEST_CASE("transmittance: a tent's kinks are met") {
    Shell shell;
    shell.density = [](Real h) { return std::max(0.0L, 1 - std::abs(h - 25000) / 15000); };
    const DensityTerm ozone{"ozone", TentProfile{25000, 15000}, Rgb(0), scattering, RayleighPhase{}};
    CHECK_WORST(sun_depth_error(cpu_float(), QualitySettings::low(), shell, ozone), 3e-2);
    CHECK_WORST(sun_depth_error(cpu_float(), QualitySettings::standard(), shell, ozone), 1e-2);
    CHECK_WORST(sun_depth_error(cpu_float(), fine_single(), shell, ozone), 3e-3);
}

TEST_CASE("transmittance: light from beyond the air, from the ground to space") {
    // At night, with light of radiance 1 behind the air, what is seen is the transmittance.
    const Shell shell = exponential_shell();
    for (const QualitySettings& quality : {QualitySettings::standard(), fine_single()}) {
        SkyOptions options;
        options.quality = quality;
        options.beyond = 1;
        Sky sky(cpu_float(), planet_of(shell, {exponential_term()}), options);
        Worst worst;
        for (const double altitude : {0.0, 500.0, 20000.0, 99999.0, 100001.0, 400e3, 36e6}) {
            sky.place({0, 0, static_cast<double>(shell.bottom) + altitude}, {});
            const double horizon = std::acos(static_cast<double>(shell.horizon_mu(altitude)));
            std::vector<glm::dvec3> directions;
            for (const double above : {1e-4, 1e-3, 0.01, 0.03, 0.1, 0.3, 1.0}) directions.push_back(direction(horizon - above));
            const std::vector<Rgb> seen = sky.radiance(directions);
            for (std::size_t i = 0; i < seen.size(); ++i) {
                const Real mu = directions[i].z, r = shell.bottom + altitude;
                const bool past = altitude > 100e3 && (mu >= 0 || r * r * (1 - mu * mu) > shell.top * shell.top);
                const Real column = past               ? 0
                                    : altitude > 100e3 ? shell.column(altitude, mu, -2 * r * mu - shell.to_top(altitude, mu),
                                                                      shell.to_top(altitude, mu))
                                                       : shell.column_to_top(altitude, mu);
                for (int c = 0; c < 3; ++c) {
                    const double expected = std::exp(-static_cast<double>(column) * (scattering[c] + absorption[c]));
                    worst.add(std::abs(seen[i][c] - expected), altitude, horizon - std::acos(static_cast<double>(mu)),
                              expected);
                }
            }
        }
        CHECK_WORST(worst, quality.name == "fine" ? 6e-3 : 1e-2);
    }
}

TEST_CASE("transmittance: doubling the nodes multiplies the correct digits") {
    // At the corners of the table nothing is interpolated: what is left is the quadrature along the ray.
    const Shell shell = exponential_shell();
    for (const double zenith : {0.0, pi / 2}) {
        CAPTURE(zenith);
        const double expected = static_cast<double>(shell.column_to_top(0, std::cos(zenith))) * 1.1e-5;
        std::vector<double> errors;
        for (const int nodes : {2, 4, 8, 16}) {
            SkyOptions options = sun_color_only(QualitySettings::low());
            options.quality.transmittance_nodes = nodes;
            Sky sky(cpu_double(), planet_of(shell, {exponential_term()}), options);
            sky.stand(0, sun_at(zenith));
            const double share = zenith > 0 ? 0.5 : 1;
            errors.push_back(std::abs(-std::log(sky.light()[9].r / share) / expected - 1));
        }
        CAPTURE(errors[0]);
        CAPTURE(errors[1]);
        CAPTURE(errors[2]);
        CAPTURE(errors[3]);
        CHECK(errors[1] < errors[0] / 5);
        CHECK(errors[2] < errors[1] / 20);
        CHECK(errors[3] < 2e-7);  // parameters are rounded to float on their way
    }
}
