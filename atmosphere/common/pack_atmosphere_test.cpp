#include "common/pack_atmosphere.h"

#include "common/rejects.h"

#include <aureole/presets.h>

#include <doctest/doctest.h>
#include <cmath>
#include <numbers>
#include <numeric>

using namespace aureole;
using namespace aureole::detail;

namespace {

DensityTerm haze(const PhaseFunction& phase, double scattering = 1e-6) {
    return {.name = "haze",
            .profile = ExponentialProfile{1000},
            .scattering_per_m = Rgb(scattering),
            .absorption_per_m = Rgb(0),
            .phase = phase};
}

}  // namespace

TEST_CASE("pack_atmosphere: earth") {
    const PackedAtmosphere p = pack_atmosphere(presets::earth());
    CHECK(p.term_count == 3);
    CHECK(p.term_kinds == (0 | 0 << 2 | 1 << 4));
    CHECK(p.term_phases == (0 | 1 << 2 | 0 << 4));
    CHECK(p.phase_count == 2);
    CHECK(p.phase_kinds == (0 | 2 << 4));
    CHECK(p.sharp_phases == 2u);
    CHECK(p.profile_rows == 0);
    CHECK(p.phase_rows == 0);
    CHECK(p.block.radii.x == 6360.0f);
    CHECK(p.block.radii.y == 6460.0f);
    CHECK(p.block.radii.z == 100.0f);
    CHECK(p.block.radii.w == static_cast<float>(std::sqrt(6460.0 * 6460 - 6360.0 * 6360)));
    CHECK(p.block.ground_albedo == glm::vec4(0.3f, 0.3f, 0.3f, 0));
    CHECK(p.block.term_profile[0].x == 0.125f);
    CHECK(p.block.term_profile[2].x == 25.0f);
    CHECK(p.block.term_profile[2].y == static_cast<float>(1 / 15.0));
    CHECK(p.block.term_scattering[0].z == static_cast<float>(33.1e-3));
    CHECK(p.block.term_scattering[2] == glm::vec4(0));
    CHECK(p.block.term_extinction[1].x == doctest::Approx(4.44e-3f).scale(1e-300).epsilon(1e-6));
    CHECK(p.block.term_extinction[2].y == static_cast<float>(1.881e-3));
    CHECK(p.block.phase_parameters[1].x == 0.8f);
    CHECK(p.block.phase_moments[0].x == doctest::Approx(1).scale(1e-300).epsilon(1e-6));
    CHECK(p.block.phase_moments[0].z == doctest::Approx(0.1).scale(1e-300).epsilon(1e-6));
    const std::vector<double> moments = legendre_moments(CornetteShanksPhase{0.8}, 12);
    for (int l = 0; l < 12; ++l)
        CHECK(p.block.phase_moments[3 + l / 4][l % 4] == static_cast<float>(moments[static_cast<std::size_t>(l)]));
    CHECK(p.block.sun_mapping == glm::vec4(0));
}

TEST_CASE("pack_atmosphere: nothing, and terms without coefficients") {
    const PackedAtmosphere airless = pack_atmosphere(presets::airless());
    CHECK(airless.term_count == 0);
    CHECK(airless.phase_count == 1);
    CHECK(airless.phase_kinds == 0);
    CHECK(airless.sharp_phases == 0u);

    AtmosphereParameters air = presets::earth();
    air.terms.insert(air.terms.begin(), haze(HenyeyGreensteinPhase{0.3}, 0));
    const PackedAtmosphere same = pack_atmosphere(air), earth = pack_atmosphere(presets::earth());
    CHECK(static_cast<const AirStructure&>(same) == static_cast<const AirStructure&>(earth));
    CHECK(std::memcmp(&same.block, &earth.block, sizeof earth.block) == 0);
}

TEST_CASE("pack_atmosphere: equal phase functions are one; Rayleigh is 0") {
    AtmosphereParameters air;
    air.terms = {haze(HenyeyGreensteinDrainePhase{}), haze(HenyeyGreensteinPhase{0.5}), haze(HenyeyGreensteinDrainePhase{}),
                 haze(RayleighPhase{}), haze(HenyeyGreensteinPhase{0.5})};
    const PackedAtmosphere p = pack_atmosphere(air);
    CHECK(p.term_count == 5);
    CHECK(p.phase_count == 3);
    CHECK(p.phase_kinds == (0 | 3 << 4 | 1 << 8));
    CHECK(p.term_phases == (1 | 2 << 2 | 1 << 4 | 0 << 6 | 2 << 8));
    CHECK(p.sharp_phases == 6u);
    CHECK(p.block.phase_parameters[1] == glm::vec4(0.9f, 0.5f, 10, 0.3f));
    CHECK(p.block.phase_parameters[2].x == 0.5f);

    air.terms = {haze(CornetteShanksPhase{0.5})};  // no Rayleigh: the first phase function is the aerosol's
    CHECK(pack_atmosphere(air).phase_kinds == 2);
    CHECK(pack_atmosphere(air).sharp_phases == 1u);
}

TEST_CASE("pack_atmosphere: sixteen terms fill every bit") {
    AtmosphereParameters air;
    for (int i = 0; i < 16; ++i) {
        air.terms.push_back(haze(HenyeyGreensteinPhase{0.1 * (i % 4)}));
        if (i == 15) air.terms.back().profile = TabulatedProfile{{0, 1}, {1, 0}};
    }
    const PackedAtmosphere p = pack_atmosphere(air);
    CHECK(static_cast<unsigned>(p.term_kinds) == 2u << 30);
    CHECK(static_cast<unsigned>(p.term_phases) == 0xe4e4e4e4u);
    CHECK(p.phase_kinds == 0x1111);
}

TEST_CASE("pack_atmosphere: tables") {
    AtmosphereParameters air;
    air.terms = {haze(TabulatedPhase{{0, std::numbers::pi}, {1, 1}}), haze(RayleighPhase{}),
                 haze(TabulatedPhase{{0, std::numbers::pi}, {1, 2}})};
    air.terms[1].profile = TabulatedProfile{{0, 4000}, {0.5, 0.25}};
    air.terms[2].profile = TabulatedProfile{{0, 9000}, {3, 3}};
    const PackedAtmosphere p = pack_atmosphere(air);
    CHECK(p.phase_rows == 2);
    CHECK(p.profile_rows == 2);
    REQUIRE(p.phase_table.size() == 2 * 4096);
    REQUIRE(p.profile_table.size() == 2 * 4096);
    CHECK(p.phase_kinds == (0 | 4 << 4 | 4 << 8));
    CHECK(p.term_kinds == (0 | 2 << 2 | 2 << 4));
    CHECK(p.block.phase_parameters[1].x == 0.0f);
    CHECK(p.block.phase_parameters[2].x == 1.0f);
    CHECK(p.block.term_profile[1].w == 0.0f);
    CHECK(p.block.term_profile[2].w == 1.0f);
    CHECK(p.block.tables.x == 2.0f);
    // The last cell lies beyond the highest sample, 9 km.
    const double end = 9 * std::pow(4095.0 / 4094, 2);
    CHECK(p.block.tables.y == static_cast<float>(end));
    CHECK(p.phase_table[17] == doctest::Approx(1 / (4 * std::numbers::pi)).scale(1e-300).epsilon(1e-6));
    // Texel i lies at end (i / 4095)^2; beyond 4 km the first profile is constant.
    CHECK(p.profile_table[0] == doctest::Approx(0.5).scale(1e-300).epsilon(1e-5));
    CHECK(p.profile_table[1930] ==
          doctest::Approx(0.5 - 0.0625 * end * std::pow(1930 / 4095.0, 2)).scale(1e-300).epsilon(1e-5));
    CHECK(p.profile_table[4000] == doctest::Approx(0.25).scale(1e-300).epsilon(1e-6));
    CHECK(p.profile_table[4096 + 2000] == doctest::Approx(3).scale(1e-300).epsilon(1e-6));
    // A table that goes on above the shell is cut at its top.
    air.terms[2].profile = TabulatedProfile{{0, 9e6}, {3, 3}};
    CHECK(pack_atmosphere(air).block.tables.y == 100.0f);
}

TEST_CASE("pack_atmosphere: validates first") {
    AtmosphereParameters air = presets::earth();
    air.planet.top_radius_m = 0;
    CHECK(rejected_field([&] { (void)pack_atmosphere(air); }) == "planet.top_radius_m");
}

TEST_CASE("pack_atmosphere: the tables' axis of altitude is stretched to the lowest air that can be seen, by powers of two") {
    AtmosphereParameters air = presets::earth();
    CHECK(pack_atmosphere(air).block.tables.z == 0);
    air.terms.push_back(haze(HenyeyGreensteinPhase{0.5}, 1e-3));
    for (const auto& [height, stretch] :
         {std::pair(1200.0, 0.0f), {900.0, 1.0f}, {300.0, 1.0f}, {100.0, 3.0f}, {60.0, 7.0f}, {10.0, 15.0f}, {0.01, 31.0f}}) {
        const double scale_height = height;
        CAPTURE(scale_height);
        std::get<ExponentialProfile>(air.terms.back().profile).scale_height_m = scale_height;
        air.terms.back().scattering_per_m = Rgb(0.1 / scale_height);
        CHECK(pack_atmosphere(air).block.tables.z == stretch);
        air.terms.back().scattering_per_m = Rgb(0.002 / scale_height);  // next to nothing
        CHECK(pack_atmosphere(air).block.tables.z == 0);
    }
}
