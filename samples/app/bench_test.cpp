#include "app/bench.h"

#include <doctest/doctest.h>
#include <algorithm>

using namespace aureole::app;

TEST_CASE("spread_of: median and the inner 80 %") {
    const Spread spread = spread_of({5, 1, 2, 3, 4});
    CHECK(spread.median == 3);
    CHECK(spread.p10 == doctest::Approx(1.4));
    CHECK(spread.p90 == doctest::Approx(4.6));
}

TEST_CASE("bench: every pass of every setting is timed and counted" * doctest::test_suite("long")) {
    const auto backend = open_backend({.name = "cpu"});
    BenchOptions options;
    options.width = 32;
    options.height = 16;
    options.frames = 1;
    options.warm_up = 0;
    for (const std::string_view name : {"aureole", "hillaire"})
        for (const std::string_view quality : aureole::quality_names())
            options.models.push_back({std::string(name), std::string(quality)});
    int rounds = 0;
    const std::vector<BenchResult> results = bench(*backend, options, [&] { ++rounds; });
    CHECK(rounds == 1);
    REQUIRE(results.size() == 6);
    for (const BenchResult& result : results) {
        CAPTURE(result.label());
        CHECK(result.table_bytes > 0);
        CHECK(result.air_passes == 2);
        REQUIRE(result.passes.size() == result.air_passes + result.view_passes + 2);
        double frame = 0;
        for (const PassCost& pass : result.passes) {
            CAPTURE(pass.name);
            if (result.label() == "hillaire high" && pass.name == "aerial_perspective") {  // it marches instead
                CHECK(pass.invocations == 0);
                continue;
            }
            CHECK(pass.milliseconds.median > 0);
            CHECK(pass.invocations > 0);
            CHECK(pass.counts.bytes > 0);
            CHECK(pass.counts.samples + pass.counts.fetches + pass.counts.evaluations > 0);
            if (pass.name == "sky_view" || pass.name == "aerial_perspective" || pass.name == "light")
                frame += pass.milliseconds.p10;
        }
        CHECK(result.per_frame.p90 >= frame);
        CHECK(result.rebuild.median > result.per_frame.median);
        CHECK(result.pass("transmittance").counts.evaluations > 0);
    }
    CHECK(results.at(4).label() == "hillaire default");
    // As published: 256 x 64 texels with 40 evaluations each.
    CHECK(results.at(4).pass("transmittance").counts.evaluations == 256 * 64 * 40);
}

TEST_CASE("bench: the counts of a pass are its own, however its pipelines are called" * doctest::test_suite("long")) {
    const auto backend = open_backend({.name = "cpu"});
    BenchOptions options;
    options.width = 16;
    options.height = 8;
    options.frames = 1;
    options.warm_up = 0;
    for (const std::string_view name : aureole::model_names()) options.models.push_back({std::string(name), "low"});
    options.models.push_back({"aureole", "low", "3"});
    const std::vector<BenchResult> results = bench(*backend, options, [] {});
    REQUIRE(results.size() == aureole::model_names().size() + 1);
    for (const BenchResult& result : results) {
        CAPTURE(result.label());
        for (const PassCost& pass : result.passes) {
            CAPTURE(pass.name);
            CHECK(pass.invocations > 0);
            CHECK(pass.counts.bytes > 0);
            const bool closed_form = result.model.name == "fog";  // neither looks anything up nor samples the air
            CHECK((pass.counts.evaluations + pass.counts.samples + pass.counts.fetches > 0 || closed_form));
        }
    }
    const auto result_of = [&](const std::string& label) -> const BenchResult& {
        return *std::ranges::find(results, label, &BenchResult::label);
    };
    // Two of the paths' tables of directions: the paths are traced in the one, and only added up in the other.
    const BenchResult& reference = result_of("reference low");
    CHECK(reference.pass("light paths").counts.evaluations > 192 * 256);
    CHECK(reference.pass("light").counts.evaluations < 100);  // of the sun, as seen through the air
    CHECK(reference.pass("light").counts.fetches > 0);
    CHECK(result_of("bruneton low").pass("precomputation").counts.samples > 0);
    // A composite with geometry differs from one without.
    CHECK(result_of("aureole low").pass("composite_geometry").counts.samples >
          result_of("aureole low").pass("composite").counts.samples);
}
