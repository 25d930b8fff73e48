// Axes of the 4D table: look-ups go to the texel whose ray they are given, and the ends of every axis to texel centres.
#include "common/pack_atmosphere.h"
#include "common/rejects.h"

#include <aureole/models/bruneton.h>
#include <aureole/presets.h>

#include <doctest/doctest.h>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#define AUREOLE_PHASE_TABLE 1
namespace aureole::kernels {
AUREOLE_DEFINE_CPU_KERNEL(BrunetonAxes)
#include "common/blocks.glsl"
UNIFORMS(0, AtmosphereBlock, atm)
#include "models/bruneton/bruneton.glsl"
};
}  // namespace aureole::kernels
#undef AUREOLE_PHASE_TABLE

using namespace aureole;

namespace {

constexpr glm::ivec3 size(24, 20, 9);  // 4 of nu x 6 suns
constexpr int sun_nodes = 6, nu_nodes = 4;

template <class real>
struct Axes {
    explicit Axes(const Planet& planet) {
        AtmosphereParameters air = presets::airless();
        air.planet = planet;
        const auto block = detail::pack_exact(air).block;
        static_assert(sizeof kernel.atm == sizeof block);
        std::memcpy(static_cast<void*>(&kernel.atm), &block, sizeof block);
        kernel.atm.tables.z = 3;       // low air stretches the axis of altitude
        kernel.atm.sun_mapping.x = 4;  // the lowest sun kept, well below the horizon
    }
    std::array<rhi::CpuBinding, 2> bindings{};
    std::array<rhi::Specialization, 1> constants{{{30, nu_nodes}}};
    rhi::CpuArguments arguments{.specialization = constants, .bindings = bindings, .push_constants = {}};
    kernels::BrunetonAxes<real> kernel{arguments};
};

}  // namespace

TEST_CASE("bruneton: every texel's ray is looked up at its centre") {
    for (const char* preset : {"earth", "mars", "airless"}) {
        Axes<double> axes(presets::by_name(preset).planet);
        double worst = 0, worst_nu = 0;
        int free = 0;
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) {
                    const auto ray = axes.kernel.table_ray({x, y, z}, size);
                    const auto place = axes.kernel.table_place(ray, size, 1);
                    const bool ground_level = z == 0 && y < size.y / 2;  // all rays down end where they start
                    const double row = place.at.y * size.y - 0.5, slice = place.at.z * size.z - 0.5;
                    if (!ground_level) worst = std::max(worst, std::abs(row - y));
                    worst = std::max(worst, std::abs(slice - z));
                    // Within its node of nu, the sun's texel.
                    const double sun = std::fmod(place.at.x * nu_nodes, 1.0) * sun_nodes - 0.5;
                    const int sun_node = x % sun_nodes, nu_node = x / sun_nodes;
                    worst = std::max(worst, std::abs(sun - sun_node));
                    // nu, where mu and mu_s allow the node's.
                    const double node = 2.0 * nu_node / (nu_nodes - 1) - 1;
                    if (std::abs(ray.nu - node) > 1e-12) continue;
                    ++free;
                    const double nu = std::floor(place.at.x * nu_nodes) + place.share;
                    worst_nu = std::max(worst_nu, std::abs(nu - nu_node));
                }
        CAPTURE(preset);
        CHECK(free > size.x * size.y * size.z / 6);
        CHECK(worst < 1e-6);
        CHECK(worst_nu < 1e-9);
    }
}

TEST_CASE("bruneton: ends of the axes") {
    Axes<double> axes(presets::earth().planet);
    auto& k = axes.kernel;
    const int last = size.y / 2 - 1;
    for (const double altitude : {0.5, 10.0, 100.0}) {
        const double horizon = k.horizon_mu(altitude);
        CHECK(k.mu_row(altitude, -1, true, size.y) == doctest::Approx(last));
        CHECK(std::abs(k.mu_row(altitude, horizon - 1e-15, true, size.y)) < 1e-4);
        CHECK(k.mu_row(altitude, 1, false, size.y) == doctest::Approx(last + 1));
        CHECK(k.mu_row(altitude, horizon, false, size.y) == doctest::Approx(size.y - 1).scale(1e-300).epsilon(1e-6));
    }
    CHECK(k.sun_axis(1.0) == doctest::Approx(1));
    CHECK(k.sun_axis_mu(1.0) == doctest::Approx(1));
    const double lowest = k.sun_axis_mu(0.0);
    CHECK(lowest < 0);
    CHECK(k.sun_axis(lowest) == doctest::Approx(0));
    CHECK(k.sun_axis(lowest - 0.1) == 0);
    for (int i = 0; i <= 20; ++i) CHECK(k.sun_axis(k.sun_axis_mu(i / 20.0)) == doctest::Approx(i / 20.0));
}

TEST_CASE("bruneton: a ray of the table is what the geometry says") {
    Axes<double> axes(presets::earth().planet);
    auto& k = axes.kernel;
    for (int z = 1; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y) {
            const auto ray = k.table_ray({7, y, z}, size);
            CAPTURE(y);
            CAPTURE(z);
            CHECK(ray.ground == (y < size.y / 2));
            const bool horizon = y == 0;
            if (ray.ground && !horizon) {
                CHECK(k.hits_ground(ray.altitude, ray.mu));
                CHECK(ray.end == doctest::Approx(k.distance_to_ground(ray.altitude, ray.mu)).scale(1e-300).epsilon(1e-6));
            }
            const double sines = std::sqrt((1 - ray.mu * ray.mu) * (1 - ray.mu_s * ray.mu_s));
            CHECK(std::abs(ray.nu - ray.mu * ray.mu_s) <= sines + 1e-12);
        }
}

TEST_CASE("bruneton: settings are checked when a model is made") {
    using models::BrunetonSettings;
    const auto rejected = [](auto change) {
        BrunetonSettings settings;
        change(settings);
        return detail::rejected_field([&] { (void)models::bruneton(settings); });
    };
    CHECK(rejected([](BrunetonSettings&) {}) == "nothing");
    CHECK(rejected([](BrunetonSettings& s) { s.transmittance.width = 1; }) == "bruneton.transmittance.width");
    CHECK(rejected([](BrunetonSettings& s) { s.transmittance.depth = 2; }) == "bruneton.transmittance.depth");
    CHECK(rejected([](BrunetonSettings& s) { s.irradiance.height = 5000; }) == "bruneton.irradiance.height");
    CHECK(rejected([](BrunetonSettings& s) { s.altitude_nodes = 1; }) == "bruneton.altitude_nodes");
    CHECK(rejected([](BrunetonSettings& s) { s.view_nodes = 33; }) == "bruneton.view_nodes");
    CHECK(rejected([](BrunetonSettings& s) { s.sun_nodes = 257; }) == "bruneton.sun_nodes");
    CHECK(rejected([](BrunetonSettings& s) { s.nu_nodes = 1; }) == "bruneton.nu_nodes");
    CHECK(rejected([](BrunetonSettings& s) { s.sun_nodes = 256, s.nu_nodes = 9; }) == "bruneton.nu_nodes");
    CHECK(rejected([](BrunetonSettings& s) { s.orders = 0; }) == "bruneton.orders");
    CHECK(rejected([](BrunetonSettings& s) { s.format = rhi::Format::rgba8_unorm; }) == "bruneton.format");
    CHECK(rejected([](BrunetonSettings& s) { s.sampling = static_cast<models::BrunetonSampling>(2); }) == "bruneton.sampling");
    CHECK(rejected([](BrunetonSettings& s) { s.transmittance_nodes = 17; }) == "bruneton.transmittance_nodes");
    CHECK(rejected([](BrunetonSettings& s) { s.ray_nodes = 1; }) == "bruneton.ray_nodes");
    CHECK(rejected([](BrunetonSettings& s) { s.zenith_nodes = 17; }) == "bruneton.zenith_nodes");
    CHECK(rejected([](BrunetonSettings& s) { s.azimuth_nodes = 1; }) == "bruneton.azimuth_nodes");
    CHECK(rejected([](BrunetonSettings& s) { s.lowest_sun_deg = std::nan(""); }) == "bruneton.lowest_sun_deg");
    CHECK(rejected([](BrunetonSettings& s) { s.slices_per_frame = -1; }) == "bruneton.slices_per_frame");
    CHECK(detail::rejected_field([] { (void)models::BrunetonSettings::by_name("best"); }) == "quality");
}
