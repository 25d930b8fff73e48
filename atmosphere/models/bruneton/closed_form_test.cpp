// The model bruneton against closed forms.
#include <doctest/doctest.h>

#include <aureole/models/bruneton.h>

#include "physics/reference.h"
#include "physics/sky.h"
#include "physics/worst.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

using namespace aureole;
using namespace aureole::physics;
using models::BrunetonSettings;

namespace {

/// As in single_scattering_test: so thin that neither a second scattering nor the loss on the way matters.
const Rgb thin(1e-13, 0.7e-13, 0.4e-13);

AtmosphereParameters planet_with(const DensityTerm& term, double albedo) {
    AtmosphereParameters parameters;
    parameters.planet.ground_albedo = Rgb(albedo);
    parameters.terms = {term};
    return parameters;
}

SkyOptions of(BrunetonSettings settings) {
    settings.format = rhi::Format::rgba32_float;
    settings.altitude_nodes = 12;
    settings.view_nodes = 64;
    SkyOptions options;
    options.model = models::bruneton(settings);
    return options;
}

BrunetonSettings with(int orders, models::BrunetonSampling sampling = models::BrunetonSampling::gauss) {
    BrunetonSettings settings;
    settings.orders = orders;
    settings.sampling = sampling;
    return settings;
}

}  // namespace

TEST_CASE("bruneton: thin even air is as bright as the length of air along the ray") {
    const Shell shell;
    for (const auto& phase : {PhaseFunction(RayleighPhase{}), PhaseFunction(CornetteShanksPhase{0.8})})
        for (const auto sampling : {models::BrunetonSampling::gauss, models::BrunetonSampling::published}) {
            Sky sky(cpu_float(), planet_with(even_term(thin, Rgb(0), phase), 0), of(with(1, sampling)));
            Worst worst;
            for (const double altitude : {0.0, 20000.0, 70000.0})
                for (const double zenith : {0.0, 40.0, 65.0}) {
                    sky.stand(altitude, sun_at(zenith * degree));
                    const glm::dvec3 sun = direction(zenith * degree);
                    std::vector<glm::dvec3> directions;
                    for (const double view : {0.0, 20.0, 45.0, 70.0, 80.0, 130.0, 180.0})
                        for (const double azimuth : {0.0, 35.0, 90.0, 180.0})
                            if (altitude > 0 || view < 90) directions.push_back(direction(view * degree, azimuth * degree));
                    const std::vector<Rgb> seen = sky.radiance(directions);
                    for (std::size_t i = 0; i < seen.size(); ++i) {
                        const glm::dvec3& d = directions[i];
                        const double length = static_cast<double>(shell.to_end(altitude, d.z));
                        const Rgb expected = thin * (length * evaluate(phase, std::clamp(glm::dot(d, sun), -1.0, 1.0)));
                        worst.add(apart(seen[i], expected), altitude, zenith, d.x, d.y, d.z);
                    }
                }
            CHECK_WORST(worst, 0.01);
        }
}

TEST_CASE("bruneton: in thin air all orders are the first, and more orders change nothing") {
    const AtmosphereParameters air = planet_with(even_term(thin, Rgb(0), RayleighPhase{}), 0);
    Sky one(cpu_float(), air, of(with(1))), three(cpu_float(), air, of(with(3)));
    for (Sky* sky : {&one, &three}) sky->stand(1000, sun_at(50 * degree));
    for (const double view : {0.0, 50.0, 85.0, 120.0}) {
        const glm::dvec3 d = direction(view * degree, 0.7);
        CHECK(apart(three.radiance(d), one.radiance(d)) < 1e-4);
    }
}

TEST_CASE("bruneton: bright ground under thin air shines by the sun's cosine, and lights the air above it") {
    const DensityTerm air = even_term(thin, Rgb(0), RayleighPhase{});
    Sky dark(cpu_float(), planet_with(air, 0), of(with(2))), bright(cpu_float(), planet_with(air, 1), of(with(2)));
    for (const double zenith : {0.0, 60.0, 85.0}) {
        for (Sky* sky : {&dark, &bright}) sky->stand(0, sun_at(zenith * degree));
        const double irradiance = std::cos(zenith * degree);
        const Rgb ground = bright.radiance(direction(pi, 0));
        CHECK(apart(ground, Rgb(irradiance / pi)) < 1e-3);
    }
    // Over a plane of radiance E / pi everywhere below, air of even phase 3/(16 pi) (1 + nu^2) scatters half of the sphere's
    // light into any direction: sigma D (E / pi) / 2. The ground's horizon and fall-off of the sun are those of a small part of
    // the planet, so the camera's own ray is kept short: straight up from the ground, where the shell is 100 km thick.
    for (Sky* sky : {&dark, &bright}) sky->stand(0, sun_at(0));
    const Rgb added = bright.radiance(direction(0)) - dark.radiance(direction(0));
    const Rgb plane = thin * (100e3 / (2 * pi));
    CHECK(added.r < plane.r);         // the ground is a sphere, seen under less than half of all directions
    CHECK(added.r > 0.75 * plane.r);  // but not much less
}

TEST_CASE("bruneton: the order sums converge, each order fainter than the one before") {
    const AtmosphereParameters air = presets::earth();
    Rgb before(0);
    double last_gain = 1e9;
    for (const int orders : {1, 2, 3, 4, 6}) {
        BrunetonSettings settings = BrunetonSettings::low();
        settings.orders = orders;
        SkyOptions options;
        options.model = models::bruneton(settings);
        Sky sky(cpu_float(), air, options);
        sky.stand(200, sun_at(60 * degree));
        const Rgb seen = sky.radiance(direction(30 * degree, 1.0));
        if (orders > 1) {
            const double gain = seen.b - before.b;
            CHECK(gain > 0);
            CHECK(gain < 0.6 * last_gain);
            last_gain = gain;
        }
        before = seen;
    }
}
