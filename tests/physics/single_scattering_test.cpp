// Light scattered once, against closed forms in thin air and against quadrature of our own in air that absorbs.
#include <doctest/doctest.h>

#include "physics/reference.h"
#include "physics/sky.h"
#include "physics/worst.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

using namespace aureole;
using namespace aureole::physics;

namespace {

/// So thin that neither a second scattering nor the loss on the way matters: vertical optical depth 1e-8 over 100 km.
const Rgb thin(1e-13, 0.7e-13, 0.4e-13);

AtmosphereParameters planet_with(const DensityTerm& term) {
    AtmosphereParameters parameters;
    parameters.planet.ground_albedo = Rgb(0);
    parameters.terms = {term};
    return parameters;
}

SkyOptions of(const QualitySettings& quality) {
    SkyOptions options;
    options.quality = quality;
    return options;
}

/// Towards the sun, around it, across, away, below the horizon.
std::vector<glm::dvec3> many_directions(double sun_zenith) {
    std::vector<glm::dvec3> result;
    for (const double apart : {0.0, 0.01, 0.05, 0.2})
        for (const double sign : {-1.0, 1.0}) result.push_back(direction(sun_zenith + sign * apart));
    for (const double zenith : {0.0, 20.0, 45.0, 70.0, 80.0, 100.0, 130.0, 180.0})
        for (const double azimuth : {0.0, 35.0, 90.0, 140.0, 180.0})
            result.push_back(direction(zenith * degree, azimuth * degree));
    return result;
}

/// Thin homogeneous air above black ground is as bright as the length of air along the ray: E sigma p D. The sun stands high
/// enough for all of the ray to be lit.
Worst thin_air_error(Machine& machine, const QualitySettings& quality, const PhaseFunction& phase) {
    const Shell shell;
    Sky sky(machine, planet_with(even_term(thin, Rgb(0), phase)), of(quality));
    Worst worst;
    for (const double altitude : {0.0, 20000.0, 70000.0})
        for (const double sun_zenith : {0.0, 40.0, 65.0}) {
            sky.stand(altitude, sun_at(sun_zenith * degree));
            std::vector<glm::dvec3> directions = many_directions(sun_zenith * degree);
            const glm::dvec3 sun = direction(sun_zenith * degree);
            if (altitude == 0) std::erase_if(directions, [](const glm::dvec3& d) { return d.z < 0; });
            const std::vector<Rgb> seen = sky.radiance(directions);
            for (std::size_t i = 0; i < seen.size(); ++i) {
                const double length = static_cast<double>(shell.to_end(altitude, directions[i].z));
                const Rgb expected = thin * (length * evaluate(phase, std::clamp(glm::dot(directions[i], sun), -1.0, 1.0)));
                worst.add(apart(seen[i], expected), altitude, sun_zenith, directions[i].x, directions[i].y, directions[i].z);
            }
        }
    return worst;
}

TabulatedPhase tabulated(const PhaseFunction& phase, int samples) {
    TabulatedPhase table;
    for (int i = 0; i < samples; ++i) {
        table.angle_rad.push_back(i == samples - 1 ? pi : pi * i / (samples - 1));
        table.value.push_back(evaluate(phase, std::cos(table.angle_rad.back())));
    }
    return table;
}

}  // namespace

TEST_CASE("thin air is E sigma p(nu) times its length, for every phase function") {
    const struct {
        std::string name;
        PhaseFunction phase;
    } phases[] = {
        {"Rayleigh", RayleighPhase{}},
        {"isotropic", HenyeyGreensteinPhase{0}},
        {"Henyey-Greenstein 0.76", HenyeyGreensteinPhase{0.76}},
        {"Henyey-Greenstein 0.98, a needle forwards", HenyeyGreensteinPhase{0.98}},
        {"Henyey-Greenstein -0.98, a needle backwards", HenyeyGreensteinPhase{-0.98}},
        {"Cornette-Shanks 0.8", CornetteShanksPhase{0.8}},
        {"Cornette-Shanks -0.98", CornetteShanksPhase{-0.98}},
        {"HG + Draine, droplets of 20 um", HenyeyGreensteinDrainePhase::from_droplet_diameter(20)},
        {"tabulated Cornette-Shanks", tabulated(CornetteShanksPhase{0.8}, 1801)},
        {"tabulated, a ramp", TabulatedPhase{{0, pi / 3, pi}, {3, 1, 2}}},
    };
    for (const auto& one : phases) {
        const auto& name = one.name;
        const auto& phase = one.phase;
        CAPTURE(name);
        CHECK_WORST(thin_air_error(cpu_float(), QualitySettings::standard(), phase), 3e-3);
    }
    CHECK_WORST(thin_air_error(cpu_float(), fine_single(), RayleighPhase{}), 1e-3);
    CHECK_WORST(thin_air_error(cpu_float(), fine_single(), HenyeyGreensteinPhase{0.98}), 1e-3);
    CHECK_WORST(thin_air_error(cpu_double(), fine_single(), HenyeyGreensteinPhase{0.98}), 1e-3);
}

TEST_CASE("thin flat air is E tau p / mu") {
    // A planet so large that it is flat: the secant law down to 85 degrees, with exponential air of 1 km.
    AtmosphereParameters air = planet_with({"air", ExponentialProfile{1000}, Rgb(1e-8), Rgb(0), HenyeyGreensteinPhase{0.5}});
    air.planet.bottom_radius_m = 1e9;
    air.planet.top_radius_m = 1e9 + 15e3;
    Sky sky(cpu_float(), air, of(QualitySettings::standard()));
    const double depth = 1e-5 * (1 - std::exp(-15.0));
    Worst worst;
    for (const double sun_zenith : {0.0, 30.0, 80.0, 89.0}) {
        sky.stand(0, sun_at(sun_zenith * degree));
        for (const double zenith : {0.0, 50.0, 75.0, 85.0})
            for (const double azimuth : {0.0, 60.0, 180.0}) {
                const glm::dvec3 view = direction(zenith * degree, azimuth * degree);
                const double nu = glm::dot(view, direction(sun_zenith * degree));
                const double expected = depth * evaluate(HenyeyGreensteinPhase{0.5}, std::clamp(nu, -1.0, 1.0)) / view.z;
                worst.add(std::abs(sky.radiance(view).g / expected - 1), sun_zenith, zenith, azimuth);
            }
    }
    CHECK_WORST(worst, 5e-3);
}

TEST_CASE("after sunset the zenith shines from above the planet's shadow: E p sigma H exp(-shadow height / H)") {
    const double scale_height = 8000;
    AtmosphereParameters air = planet_with({"air", ExponentialProfile{scale_height}, thin, Rgb(0), RayleighPhase{}});
    const double radius = air.planet.bottom_radius_m, shell = air.planet.top_radius_m - radius;
    for (const QualitySettings& quality : {QualitySettings::standard(), fine_single()}) {
        CAPTURE(quality.name);
        Sky sky(cpu_float(), air, of(quality));
        Worst worst;
        for (const double depression : {1.0, 3.0, 5.0, 7.0, 9.0}) {
            sky.stand(0, sun_at((90 + depression) * degree));
            const double shadow = radius * (1 / std::cos(depression * degree) - 1);
            const double lit = scale_height * (std::exp(-shadow / scale_height) - std::exp(-shell / scale_height));
            const Rgb expected = thin * (lit * evaluate(RayleighPhase{}, -std::sin(depression * degree)));
            worst.add(apart(sky.radiance(glm::dvec3(0, 0, 1)), expected), depression);
        }
        // Sunbeams that graze the ground lose a millionth; the shadow's edge is met exactly.
        CHECK_WORST(worst, 2e-3);
    }
}

TEST_CASE("in the planet's shadow nothing shines: the terminator is where geometry puts it") {
    // Homogeneous air up to 100 km. A ray is dark up to where it leaves the shadow, and not a metre further.
    const Shell shell;
    Sky sky(cpu_double(), planet_with(even_term(thin, Rgb(0), HenyeyGreensteinPhase{0})), of(fine_single()));
    for (const double depression : {2.0, 6.0, 9.0, 9.9}) {
        const double sun_zenith = (90 + depression) * degree;
        sky.stand(0, sun_at(sun_zenith));
        const glm::dvec3 sun = direction(sun_zenith);
        Worst worst;
        for (const double zenith : {0.0, 30.0, 60.0, 75.0})
            for (const double azimuth : {0.0, 45.0, 90.0, 180.0}) {
                const glm::dvec3 view = direction(zenith * degree, azimuth * degree);
                const double radius = static_cast<double>(shell.bottom);
                const auto lit = [&](Real t) {
                    const glm::dvec3 p = glm::dvec3(0, 0, radius) + static_cast<double>(t) * view;
                    const double along = glm::dot(p, sun);
                    return along > 0 || glm::dot(p, p) - along * along > radius * radius ? 1.0L : 0.0L;
                };
                const double length = static_cast<double>(integrate(lit, 0, shell.to_top(0, view.z), 1e-7L));
                const Rgb expected = thin * (length / (4 * pi));
                // Where next to nothing is lit, relative to a kilometre of lit air.
                worst.add(sum(glm::abs(sky.radiance(view) - expected)) / sum(thin * (std::max(length, 1000.0) / (4 * pi))),
                          depression, zenith, azimuth, length);
            }
        CHECK_WORST(worst, 1e-2);
    }
}

TEST_CASE("air that absorbs: single scattering with both losses is what quadrature says") {
    // Of the light that is lost a thousandth is scattered, so what is scattered twice is a thousandth of what is seen.
    const double scale_height = 8000;
    const Rgb extinction(6e-6, 13e-6, 33e-6);
    const AtmosphereParameters air =
        planet_with({"air", ExponentialProfile{scale_height}, extinction * 1e-3, extinction * 0.999, RayleighPhase{}});
    Shell shell;
    shell.density = [=](Real h) { return std::exp(-h / static_cast<Real>(scale_height)); };
    Sky sky(cpu_float(), air, of(QualitySettings::standard()));
    Worst worst;
    for (const double altitude : {0.0, 10000.0})
        for (const double sun_zenith : {0.0, 60.0, 85.0}) {
            sky.stand(altitude, sun_at(sun_zenith * degree));
            const glm::dvec3 sun = direction(sun_zenith * degree);
            for (const double zenith : {0.0, 60.0, 85.0, 120.0})
                for (const double azimuth : {10.0, 120.0}) {
                    const glm::dvec3 view = direction(zenith * degree, azimuth * degree);
                    if (altitude == 0 && view.z < 0) continue;
                    const double radius = static_cast<double>(shell.bottom);
                    const auto gathered = [&](int c) {
                        return integrate(
                            [&](Real t) -> Real {
                                const glm::dvec3 p = glm::dvec3(0, 0, radius + altitude) + static_cast<double>(t) * view;
                                const Real h = shell.altitude_after(altitude, view.z, t);
                                const Real mu_s = glm::dot(p, sun) / glm::length(p);
                                if (shell.hits_ground(h, mu_s)) return 0;
                                const Real columns = shell.column(altitude, view.z, 0, t) + shell.column_to_top(h, mu_s);
                                return shell.density(h) * std::exp(-columns * extinction[c]);
                            },
                            0, shell.to_end(altitude, view.z), 1e-5L);
                    };
                    const double phase = evaluate(RayleighPhase{}, glm::dot(view, sun));
                    Rgb expected;
                    for (int c = 0; c < 3; ++c) expected[c] = static_cast<double>(gathered(c)) * phase * extinction[c] * 1e-3;
                    worst.add(apart(sky.radiance(view), expected), altitude, sun_zenith, zenith, azimuth);
                }
        }
    CHECK_WORST(worst, 1e-2);
}

TEST_CASE("HG + Draine of weight 0 is Henyey-Greenstein, and a tabulated function is the one that it tabulates") {
    const auto hazy_with = [](const PhaseFunction& phase) {
        AtmosphereParameters air = presets::hazy_earth();
        air.terms[1].phase = phase;
        return air;
    };
    const auto compare = [&](const PhaseFunction& a, const PhaseFunction& b) {
        Sky first(cpu_float(), hazy_with(a), of(QualitySettings::standard()));
        Sky second(cpu_float(), hazy_with(b), of(QualitySettings::standard()));
        Worst worst;
        for (const double sun_zenith : {20.0, 80.0}) {
            first.stand(200, sun_at(sun_zenith * degree));
            second.stand(200, sun_at(sun_zenith * degree));
            const std::vector<glm::dvec3> directions = many_directions(sun_zenith * degree);
            const std::vector<Rgb> seen = first.radiance(directions), other = second.radiance(directions);
            for (std::size_t i = 0; i < seen.size(); ++i) worst.add(apart(seen[i], other[i]), sun_zenith, i);
        }
        return worst;
    };
    CHECK_WORST(compare(HenyeyGreensteinDrainePhase{0.76, 0.2, 5, 0}, HenyeyGreensteinPhase{0.76}), 1e-5);
    CHECK_WORST(compare(HenyeyGreensteinDrainePhase{0.2, 0.76, 1, 1}, CornetteShanksPhase{0.76}), 1e-5);
    CHECK_WORST(compare(tabulated(CornetteShanksPhase{0.76}, 3601), CornetteShanksPhase{0.76}), 1e-3);
    // The comparison sees differences.
    CHECK(compare(HenyeyGreensteinPhase{0.70}, HenyeyGreensteinPhase{0.76}).value() > 0.05);
}
