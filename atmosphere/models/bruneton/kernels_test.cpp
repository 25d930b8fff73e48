// The passes of a solution one by one, each given a table by hand for which its integral is known.
#include "models/bruneton/solution.h"

#include "module/air.h"

#include <doctest/doctest.h>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "passes/rig.h"
#include "physics/sky.h"

using namespace aureole;
using namespace aureole::passes;
using models::BrunetonSampling;
using models::BrunetonSettings;
using physics::even_term;
using physics::pi;

namespace {

constexpr double scale = 1024;  // TABLE_SCALE of bruneton.glsl
constexpr double radiance = 0.02;

BrunetonSettings small(BrunetonSampling sampling) {
    BrunetonSettings s;
    s.transmittance = {64, 24, 1};
    s.irradiance = {7, 4, 1};
    s.altitude_nodes = 5;
    s.view_nodes = 14;
    s.sun_nodes = 9;
    s.nu_nodes = 3;
    s.orders = 2;
    s.format = rhi::Format::rgba32_float;
    s.sampling = sampling;
    return s;
}

/// Air that scatters evenly into all directions, with molecules if asked for, over ground of this albedo.
AtmosphereParameters even_air(const Rgb& scattering, const Rgb& absorption, double albedo, bool molecules) {
    AtmosphereParameters air;
    air.planet.ground_albedo = Rgb(albedo);
    if (molecules) air.terms.push_back(even_term(scattering, absorption, RayleighPhase{}));
    air.terms.push_back(even_term(scattering, absorption, HenyeyGreensteinPhase{0}));
    return air;
}

/// A solution that stops wherever the test puts a table of its own in the place of one.
struct Passes {
    Passes(const AtmosphereParameters& air, BrunetonSampling sampling)
        : settings(small(sampling)),
          rig(*backend, {.air = air, .model = models::bruneton(settings)}),
          solution((rig.record_air(), rig.air.impl().tables->shared), settings, false),
          transmittance{rig.air.transmittance_table(), rhi::State::sampled, settings.transmittance},
          tables(solution.make_tables(rig.air.impl().tables->objects, transmittance, {})),
          sets(solution.bind(rig.air.impl().tables->shared, tables)) {
        advance(settings.altitude_nodes);  // light scattered once
    }
    void advance(int units) {
        backend->run([&](rhi::CommandList& commands) {
            PassReport report{.name = "solution"};
            detail::PassScope scope(commands, report, {}, 0);
            solution.advance(commands, scope, report, tables, sets, units);
        });
    }
    void arrive() { advance(1); }                         ///< Irradiance and field.
    void scatter() { advance(settings.altitude_nodes); }  ///< Scattering density.
    void gather() { advance(settings.altitude_nodes); }   ///< Along rays.
    Image read(detail::TrackedTexture& table) const { return backend->read(table.handle); }
    void fill(detail::TrackedTexture& table, const std::function<double(std::uint32_t z)>& value) const {
        Image image{table.extent, {}};
        for (std::uint32_t z = 0; z < table.extent.depth; ++z)
            image.texels.insert(image.texels.end(), std::size_t{table.extent.width} * table.extent.height,
                                glm::dvec4(glm::dvec3(value(z)), 0));
        backend->write(table.handle, image);
    }
    /// The same radiance from the air in all directions: layer 1 is what the even phase function 1 / (4 pi) multiplies.
    void fill_sky(double each) {
        const std::uint32_t heights = tables.scattering.extent.depth / 2;
        fill(tables.scattering, [&](std::uint32_t z) { return z < heights ? 0 : each * scale * 4 * pi; });
    }

    std::unique_ptr<Backend> backend = open_cpu_float();
    BrunetonSettings settings;
    AirRig rig;
    detail::BrunetonSolution solution;
    detail::TrackedTexture transmittance;
    detail::BrunetonTables tables;
    detail::BrunetonSolution::Bindings sets;
};

/// The largest relative distance of red, green and blue from a value.
double apart(const Image& image, double expected) {
    double worst = 0;
    for (const glm::dvec4& texel : image.texels)
        for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(texel[c] / expected - 1));
    return worst;
}

const Rgb clear(1e-13, 0.7e-13, 0.4e-13);  // even its longest ray takes nothing

}  // namespace

TEST_CASE("bruneton: the same radiance from everywhere irradiates by pi, and is scattered into the same radiance") {
    // Over a ground that reflects nothing the lower half sphere is as bright, as rays that end there have air before them.
    for (const auto sampling : {BrunetonSampling::gauss, BrunetonSampling::published}) {
        Passes passes(even_air(clear, Rgb(0), 0, true), sampling);
        passes.fill_sky(radiance);
        passes.arrive();
        const double most = sampling == BrunetonSampling::gauss ? 1e-4 : 0.01;  // published: midpoints
        CHECK(apart(passes.read(passes.tables.irradiance), pi * radiance) < most);
        passes.scatter();
        CHECK(apart(passes.read(passes.solution.source()), scale * radiance) < most);
    }
}

TEST_CASE("bruneton: ground under a dark sky lights the air on it from one half of all directions") {
    for (const auto sampling : {BrunetonSampling::gauss, BrunetonSampling::published}) {
        Passes passes(even_air(clear, Rgb(0), 0.6, true), sampling);
        passes.fill_sky(0);
        passes.arrive();
        for (const glm::dvec4& texel : passes.read(passes.tables.irradiance).texels) CHECK(texel == glm::dvec4(0));
        passes.scatter();
        const Image source = passes.read(passes.solution.source());
        // Texel of the sun at the zenith: the last of each nu. Its irradiance is 1, so the ground's radiance is albedo / pi.
        const double expected = scale * 0.6 / pi / 2;
        for (std::uint32_t y = 0; y < source.extent.height; ++y)
            for (std::uint32_t x = 8; x < source.extent.width; x += 9)
                CHECK(source.at(x, y).x == doctest::Approx(expected).scale(1e-300).epsilon(0.01));
    }
}

TEST_CASE("bruneton: an even source adds up along a ray to its share of what the air takes on the way") {
    // Radiance S from all of the scattering, even extinction e: S (scattering / e) (1 - exp(-e d)).
    for (const auto sampling : {BrunetonSampling::gauss, BrunetonSampling::published})
        for (const double absorbed : {0.0, 0.5}) {
            const double extinction = 2e-6;  // 1 / m: depths of 0.2 to 2.3
            Passes passes(even_air(Rgb(extinction * (1 - absorbed)), Rgb(extinction * absorbed), 0, false), sampling);
            passes.arrive();
            passes.scatter();
            passes.fill(passes.solution.source(), [](std::uint32_t) { return scale * radiance; });
            passes.gather();
            const Image light = passes.read(passes.tables.scattering);
            const BrunetonSettings& s = passes.settings;
            const double bottom = passes.rig.setup.air.planet.bottom_radius_m, top = passes.rig.setup.air.planet.top_radius_m;
            // The highest sun: nu is mu there, whichever node it is of.
            const auto rows = static_cast<std::uint32_t>(s.view_nodes), sun = static_cast<std::uint32_t>(s.sun_nodes) - 1;
            const std::uint32_t half = rows / 2, last = half - 1;
            double worst = 0;
            for (std::uint32_t y = 0; y < rows; ++y) {
                // From the ground, the lengths are evenly spread between the least and the greatest; down there is nothing.
                const double least = top - bottom, greatest = std::sqrt(top * top - bottom * bottom);
                const double d = y < half ? 0 : least + (greatest - least) * (y - half) / last;
                const double mu = d > 0 ? (top * top - bottom * bottom - d * d) / (2 * bottom * d) : y == last ? -1 : 0;
                const double expected = radiance * (1 - absorbed) * -std::expm1(-extinction * d);
                const double seen = light.at(sun, y).x / scale * 3 / (16 * pi) * (1 + mu * mu);
                worst = std::max(worst, std::abs(seen - expected) / radiance);
            }
            CAPTURE(absorbed);
            CHECK(worst < (sampling == BrunetonSampling::gauss ? 1e-4 : 5e-3));
        }
}
