#include "medium/merge.h"

#include "common/pack_atmosphere.h"

#include <aureole/presets.h>

#include <doctest/doctest.h>
#include <algorithm>
#include <cmath>
#include <string>

using namespace aureole;
using detail::max_kernel_terms;
using detail::merged_terms;

namespace {

Profile profile_of(int i) {
    if (i % 3 == 1) return TentProfile{400.0 * i, 700.0 + 50 * i};
    if (i % 3 == 2) return TabulatedProfile{{0, 900.0 * i, 1000.0 * i, 60e3}, {0.2, 1, 0.1, 0}};
    return ExponentialProfile{500.0 + 300 * i};
}

/// Terms of every kind of profile, all different, by `phases` different phase functions; every fifth only absorbs.
AtmosphereParameters many_terms(int count, int phases) {
    AtmosphereParameters air;
    for (int i = 0; i < count; ++i) {
        const PhaseFunction phase =
            i % phases == 0 ? PhaseFunction(RayleighPhase{}) : HenyeyGreensteinPhase{0.2 * (i % phases)};
        air.terms.push_back({.name = "term " + std::to_string(i),
                             .profile = profile_of(i),
                             .scattering_per_m = i % 5 == 4 ? Rgb(0) : Rgb(1e-6 * (i + 1), 2e-6, 3e-6 / (i + 1)),
                             .absorption_per_m = i % 5 >= 3 ? Rgb(1e-6, 3e-7, 2e-6 * i) : Rgb(0),
                             .phase = phase});
    }
    return air;
}

/// The sum of what the first and the rest of the terms give alone, each few enough to stay as they are.
MediumSample sample_in_parts(const AtmosphereParameters& air, double altitude_m) {
    MediumSample sum{Rgb(0), Rgb(0)};
    for (const DensityTerm& term : air.terms) {
        const MediumSample one = sample_medium({air.planet, {term}}, altitude_m);
        sum.scattering_per_m += one.scattering_per_m;
        sum.extinction_per_m += one.extinction_per_m;
    }
    return sum;
}

}  // namespace

TEST_CASE("merged terms: few enough stay as they are, without those of no effect") {
    AtmosphereParameters air = many_terms(static_cast<int>(max_kernel_terms), 4);
    CHECK(merged_terms(air) == air.terms);
    const std::vector<DensityTerm> before = air.terms;
    for (int i = 0; i < 50; ++i) air.terms.insert(air.terms.begin(), DensityTerm{});
    CHECK(merged_terms(air) == before);
}

TEST_CASE("merged terms: equal profiles are added up before anything is tabulated") {
    AtmosphereParameters air;
    for (int i = 0; i < 40; ++i)
        air.terms.push_back({.name = "gas",
                             .profile = ExponentialProfile{1000.0 * (1 + i % 4)},
                             .scattering_per_m = i % 2 ? Rgb(1e-6, 2e-6, 4e-6) : Rgb(0),
                             .absorption_per_m = Rgb(0, 1e-6, 0),
                             .phase = i % 2 ? PhaseFunction(HenyeyGreensteinPhase{0.5}) : RayleighPhase{}});
    const std::vector<DensityTerm> merged = merged_terms(air);
    REQUIRE(merged.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(merged[i].profile == Profile(ExponentialProfile{1000.0 * (1 + static_cast<double>(i))}));
        CHECK(merged[i].absorption_per_m.g == doctest::Approx(10e-6).scale(1e-300).epsilon(1e-12));
        CHECK(merged[i].scattering_per_m.b == doctest::Approx(i % 2 ? 40e-6 : 0).scale(1e-300).epsilon(1e-12));
    }
    CHECK(merged[1].phase == PhaseFunction(HenyeyGreensteinPhase{0.5}));
}

TEST_CASE("merged terms: any number becomes few tables of the same air") {
    for (const int phases : {1, 2, 4}) {
        CAPTURE(phases);
        const AtmosphereParameters air = many_terms(60, phases);
        CHECK(merged_terms(air).size() == static_cast<std::size_t>(3 * phases + 3));
        CHECK(detail::pack_atmosphere(air).term_count == 3 * phases + 3);
        for (double h = 3; h < 1e5; h *= 1.19) {
            CAPTURE(h);
            const MediumSample merged = sample_medium(air, h), parts = sample_in_parts(air, h);
            for (int c = 0; c < 3; ++c) {
                CAPTURE(c);
                CHECK(merged.scattering_per_m[c] == doctest::Approx(parts.scattering_per_m[c]).scale(1e-300).epsilon(1e-3));
                CHECK(merged.extinction_per_m[c] == doctest::Approx(parts.extinction_per_m[c]).scale(1e-300).epsilon(1e-3));
            }
        }
        Rgb depth(0);
        for (const DensityTerm& term : air.terms) depth += vertical_optical_depth(air, term.name);
        for (int c = 0; c < 3; ++c)
            CHECK(vertical_optical_depth(air)[c] == doctest::Approx(depth[c]).scale(1e-300).epsilon(1e-5));
    }
}

TEST_CASE("merged terms: artists' factors act as coefficients of that size, and 1 changes nothing") {
    const AtmosphereParameters plain = many_terms(5, 2);
    AtmosphereParameters scaled = plain, written = plain;
    for (DensityTerm& term : scaled.terms) term.scattering_scale = 0.75, term.absorption_scale = 4;  // exact in binary
    for (DensityTerm& term : written.terms) term.scattering_per_m *= 0.75, term.absorption_per_m *= 4.0;
    CHECK(merged_terms(scaled) == merged_terms(written));
    CHECK_FALSE(merged_terms(scaled) == merged_terms(plain));
    const MediumSample sample = sample_medium(scaled, 1000), expected = sample_medium(written, 1000);
    CHECK(sample.scattering_per_m == expected.scattering_per_m);
    CHECK(sample.extinction_per_m == expected.extinction_per_m);
    // What is scaled to nothing takes no room, nor a phase function.
    AtmosphereParameters off = many_terms(20, 4);
    off.terms.resize(4);
    off.terms.push_back({.name = "fifth",
                         .profile = ExponentialProfile{},
                         .scattering_per_m = Rgb(1e-6),
                         .absorption_per_m = Rgb(0),
                         .phase = HenyeyGreensteinPhase{0.99}});
    CHECK_THROWS_AS(validate(off), Error);
    off.terms.back().scattering_scale = 0;
    CHECK_NOTHROW(validate(off));
    CHECK(merged_terms(off).size() == 4);
}
