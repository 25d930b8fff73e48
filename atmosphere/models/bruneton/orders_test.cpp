// Sums of orders against the path tracer's: light that has been scattered or reflected once, twice, ... as often as the tables
// hold.
#include <doctest/doctest.h>

#include <aureole/models/bruneton.h>

#include "physics/sky.h"
#include "physics/traced.h"

#include <cmath>
#include <cstdio>
#include <vector>

using namespace aureole;
using namespace aureole::physics;
using models::BrunetonSettings;

namespace {

/// All around, with rays to the ground and near the horizon.
std::vector<glm::dvec3> directions() {
    std::vector<glm::dvec3> result;
    for (const double zenith : {10.0, 50.0, 75.0, 87.0, 100.0, 150.0})
        for (const double azimuth : {20.0, 100.0, 170.0}) result.push_back(direction(zenith * degree, azimuth * degree));
    return result;
}

SkyOptions of(int orders) {
    BrunetonSettings settings;
    settings.orders = orders;
    settings.format = rhi::Format::rgba32_float;
    settings.altitude_nodes = 24;
    SkyOptions options;
    options.model = models::bruneton(settings);
    return options;
}

}  // namespace

TEST_CASE("bruneton: each sum of orders is the path tracer's") {
    const std::vector<glm::dvec3> rays = directions();
    for (const int orders : {1, 2, 3, 4}) {
        Sky sky(cpu_float(), presets::earth(), of(orders));
        models::ReferenceSettings settings = paths(1000);
        settings.max_order = orders;
        TracedSky truth(presets::earth(), settings);
        for (const double zenith : {30.0, 75.0}) {
            sky.stand(500, sun_at(zenith * degree));
            truth.stand(500, sun_at(zenith * degree));
            const std::vector<Rgb> seen = sky.radiance(rays);
            const TracedSky::Values traced = truth.look(rays);
            double bias = 0, worst = 0;
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const double all = sum(traced.radiance[i]);
                bias += (sum(seen[i]) / all - 1) / static_cast<double>(rays.size());
                worst = std::max(worst, std::max(0.0, std::abs(sum(seen[i]) - all) - 3 * sum(traced.error[i])) / all);
            }
            std::printf("orders to %d, sun %g deg: %+.2f %% on average, %.1f %% at most beyond the noise\n", orders, zenith,
                        100 * bias, 100 * worst);
            CAPTURE(orders);
            CAPTURE(zenith);
            CHECK(std::abs(bias) < 0.015);
            CHECK(worst < 0.05);
        }
    }
}
