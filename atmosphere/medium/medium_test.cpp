#include "common/host_air.h"
#include "common/rejects.h"

#include <aureole/presets.h>

#include <doctest/doctest.h>
#include <array>
#include <cmath>
#include <limits>

using namespace aureole;
using detail::rejected_field;

namespace {

AtmosphereParameters one_term(const Profile& profile) {
    return {.planet = {},
            .terms = {{.name = "only",
                       .profile = profile,
                       .scattering_per_m = {1e-5, 2e-5, 0},
                       .absorption_per_m = {1e-5, 0, 3e-5},
                       .phase = RayleighPhase{}}}};
}

double density(const Profile& profile, double altitude_m) {
    return sample_medium(one_term(profile), altitude_m).extinction_per_m.r / 2e-5;
}

}  // namespace

TEST_CASE("sample_medium: exponential, tent and tabulated density") {
    CHECK(density(ExponentialProfile{8000}, 0) == doctest::Approx(1).scale(1e-300).epsilon(1e-14));
    CHECK(density(ExponentialProfile{8000}, 8000) == doctest::Approx(std::exp(-1.0)).scale(1e-300).epsilon(1e-14));
    CHECK(density(ExponentialProfile{8000}, 1e5) == doctest::Approx(std::exp(-12.5)).scale(1e-300).epsilon(1e-12));
    CHECK(density(TentProfile{25e3, 15e3}, 25e3) == doctest::Approx(1).scale(1e-300).epsilon(1e-14));
    CHECK(density(TentProfile{25e3, 15e3}, 17.5e3) == doctest::Approx(0.5).scale(1e-300).epsilon(1e-12));
    CHECK(density(TentProfile{25e3, 15e3}, 32.5e3) == doctest::Approx(0.5).scale(1e-300).epsilon(1e-12));
    CHECK(density(TentProfile{25e3, 15e3}, 9.9e3) == 0);
    CHECK(density(TentProfile{25e3, 15e3}, 40.1e3) == 0);
    const TabulatedProfile table{{1000, 2000, 6000}, {1, 3, 0.5}};
    CHECK(density(table, 0) == doctest::Approx(1).scale(1e-300).epsilon(1e-12));
    CHECK(density(table, 1500) == doctest::Approx(2).scale(1e-300).epsilon(1e-4));
    CHECK(density(table, 4000) == doctest::Approx(1.75).scale(1e-300).epsilon(1e-4));
    CHECK(density(table, 6010) == doctest::Approx(0.5).scale(1e-300).epsilon(1e-12));
    CHECK(density(table, 50e3) == doctest::Approx(0.5).scale(1e-300).epsilon(1e-12));
}

TEST_CASE("sample_medium: scattering, extinction, below the ground and above the top") {
    const AtmosphereParameters air = one_term(ExponentialProfile{8000});
    const MediumSample ground = sample_medium(air, 0);
    for (int c = 0; c < 3; ++c) {
        CHECK(ground.scattering_per_m[c] == doctest::Approx(Rgb(1e-5, 2e-5, 0)[c]).scale(1e-300).epsilon(1e-14));
        CHECK(ground.extinction_per_m[c] == doctest::Approx(Rgb(2e-5, 2e-5, 3e-5)[c]).scale(1e-300).epsilon(1e-14));
        CHECK(sample_medium(air, -10).extinction_per_m[c] == ground.extinction_per_m[c]);
        CHECK(sample_medium(air, -1e9).scattering_per_m[c] == ground.scattering_per_m[c]);
    }
    CHECK(sample_medium(air, 99999).extinction_per_m.r > 0);
    CHECK(sample_medium(air, 100001).extinction_per_m == Rgb(0));
    CHECK(sample_medium(air, 100001).scattering_per_m == Rgb(0));
}

TEST_CASE("vertical_optical_depth: closed forms") {
    const auto depth = [](const Profile& profile) { return vertical_optical_depth(one_term(profile)).r / 2e-5; };
    for (const double height : {0.01, 1.0, 100.0, 8000.0, 1e5, 1e7, 1e12}) {
        CAPTURE(height);
        CHECK(depth(ExponentialProfile{height}) ==
              doctest::Approx(-height * std::expm1(-1e5 / height)).scale(1e-300).epsilon(1e-12));
    }
    CHECK(depth(TentProfile{25e3, 15e3}) == doctest::Approx(15e3).scale(1e-300).epsilon(1e-12));
    CHECK(depth(TentProfile{0, 10e3}) == doctest::Approx(5e3).scale(1e-300).epsilon(1e-12));  // half of it is below the ground
    CHECK(depth(TentProfile{1e5, 10e3}) == doctest::Approx(5e3).scale(1e-300).epsilon(1e-12));  // half of it is above the top
    CHECK(depth(TentProfile{-5e3, 10e3}) == doctest::Approx(1.25e3).scale(1e-300).epsilon(1e-12));
    CHECK(depth(TentProfile{2e5, 10e3}) == 0);
    CHECK(depth(TabulatedProfile{{0, 1e5}, {1, 0}}) == doctest::Approx(5e4).scale(1e-300).epsilon(1e-10));
    CHECK(depth(TabulatedProfile{{0, 5e3, 10e3}, {1, 1, 0}}) == doctest::Approx(7.5e3).scale(1e-300).epsilon(1e-10));
    CHECK(depth(TabulatedProfile{{0, 5e3}, {1, 0.5}}) == doctest::Approx(0.75 * 5e3 + 0.5 * 95e3).scale(1e-300).epsilon(1e-10));
    CHECK(depth(TabulatedProfile{{-2e3, -1e3}, {1, 2}}) == doctest::Approx(2e5).scale(1e-300).epsilon(1e-12));
    // A layer 20 m thick at 80 km, where the kernels' texels lie 44 m apart.
    CHECK(depth(TabulatedProfile{{0, 79990, 80000, 80010, 1e5}, {0, 0, 1, 0, 0}}) ==
          doctest::Approx(10).scale(1e-300).epsilon(1e-9));
}

TEST_CASE("vertical_optical_depth: by name; terms of one name add up; the same planet a thousand times smaller") {
    AtmosphereParameters air = presets::earth();
    const Rgb all = vertical_optical_depth(air);
    Rgb sum(0);
    for (const char* name : {"rayleigh", "mie", "ozone"}) sum += vertical_optical_depth(air, name);
    for (int c = 0; c < 3; ++c) CHECK(sum[c] == doctest::Approx(all[c]).scale(1e-300).epsilon(1e-13));

    const Rgb mie = vertical_optical_depth(air, "mie");
    air.terms.push_back(air.terms[1]);
    CHECK(vertical_optical_depth(air, "mie").g == doctest::Approx(2 * mie.g).scale(1e-300).epsilon(1e-13));
    CHECK(rejected_field([&] { (void)vertical_optical_depth(air, "Mie"); }) == "term");
    CHECK(rejected_field([&] { (void)vertical_optical_depth(presets::airless(), "mie"); }) == "term");

    AtmosphereParameters small = presets::mars();
    small.planet.bottom_radius_m /= 1000, small.planet.top_radius_m /= 1000;
    for (DensityTerm& term : small.terms) {
        std::get<ExponentialProfile>(term.profile).scale_height_m /= 1000;
        term.scattering_per_m *= 1000.0, term.absorption_per_m *= 1000.0;
    }
    for (int c = 0; c < 3; ++c)
        CHECK(vertical_optical_depth(small)[c] ==
              doctest::Approx(vertical_optical_depth(presets::mars())[c]).scale(1e-300).epsilon(1e-9));
}

TEST_CASE("medium: bad input") {
    AtmosphereParameters air = presets::earth();
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        CHECK(rejected_field([&] { (void)sample_medium(air, bad); }) == "altitude_m");
    air.terms[0].scattering_per_m.g = -1;
    CHECK(rejected_field([&] { (void)sample_medium(air, 0); }) == "terms[0].scattering_per_m.g");
    CHECK(rejected_field([&] { (void)vertical_optical_depth(air); }) == "terms[0].scattering_per_m.g");
    CHECK(rejected_field([&] { (void)vertical_optical_depth(air, "ozone"); }) == "terms[0].scattering_per_m.g");
}

TEST_CASE("medium.glsl: float, from the block that devices get, agrees with double; terms go to their phase function") {
    AtmosphereParameters air = presets::hazy_earth();
    air.terms.push_back({.name = "dust",
                         .profile = TabulatedProfile{{0, 2e3, 9e3}, {1, 2, 0}},
                         .scattering_per_m = {1e-5, 2e-5, 3e-5},
                         .absorption_per_m = Rgb(1e-6),
                         .phase = HenyeyGreensteinPhase{0.6}});
    const detail::PackedAtmosphere packed = detail::pack_atmosphere(air);

    std::vector<float> texels(4 * packed.profile_table.size(), 0.0f);
    for (std::size_t i = 0; i < packed.profile_table.size(); ++i) texels[4 * i] = packed.profile_table[i];
    std::array<rhi::CpuBinding, 3> bindings{};
    bindings[1].extent = {detail::table_width, 1, 1};
    bindings[1].texels = texels.data();
    bindings[2].constants = reinterpret_cast<const std::byte*>(&packed.block);
    bindings[2].constants_size = sizeof packed.block;
    const auto bits = [](int value) { return static_cast<std::uint32_t>(value); };
    const std::array<rhi::Specialization, 5> constants{{{0, bits(packed.term_count)},
                                                        {1, bits(packed.term_kinds)},
                                                        {2, bits(packed.term_phases)},
                                                        {3, bits(packed.phase_count)},
                                                        {4, bits(packed.phase_kinds)}}};
    rhi::CpuCounts counts;
    const rhi::CpuArguments arguments{
        .specialization = constants, .bindings = bindings, .push_constants = {}, .counts = &counts};
    kernels::AirFormulas<float> single(arguments);
    detail::HostAir exact(detail::pack_exact(air));

    for (const float altitude : {-1.0f, 0.0f, 1e-5f, 0.3f, 1.7f, 5.0f, 12.0f, 26.0f, 60.0f, 100.0f}) {
        CAPTURE(altitude);
        const auto a = single.sample_medium(altitude);
        const auto b = exact.formulas().sample_medium(static_cast<double>(altitude));
        for (int c = 0; c < 3; ++c) {
            CHECK(a.extinction[c] == doctest::Approx(b.extinction[c]).scale(1e-300).epsilon(1e-5));
            CHECK(a.extinction[c] == single.medium_extinction(altitude)[c]);
            for (int p = 0; p < 4; ++p)
                CHECK(a.scattering[p][c] == doctest::Approx(b.scattering[p][c]).scale(1e-300).epsilon(1e-5));
        }
    }
    CHECK(counts.evaluations == 4 * 10);
    const auto ground = exact.formulas().sample_medium(0.0);
    CHECK(ground.scattering[0].g == doctest::Approx(13.558e-3).scale(1e-300).epsilon(1e-12));
    CHECK(ground.scattering[1].g == doctest::Approx(39.96e-3).scale(1e-300).epsilon(1e-12));
    CHECK(ground.scattering[2].g == doctest::Approx(20e-3).scale(1e-300).epsilon(1e-6));
    CHECK(ground.scattering[3].g == 0);
}
