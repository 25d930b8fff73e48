#include "app/bench.h"

#include <doctest/doctest.h>

using namespace aureole::app;

TEST_CASE("spread_of: median and the inner 80 %") {
    const Spread spread = spread_of({5, 1, 2, 3, 4});
    CHECK(spread.median == 3);
    CHECK(spread.p10 == doctest::Approx(1.4));
    CHECK(spread.p90 == doctest::Approx(4.6));
}

TEST_CASE("bench: every pass of every setting is timed and counted") {
    const auto backend = open_backend({.name = "cpu"});
    BenchOptions options;
    options.width = 32;
    options.height = 16;
    options.frames = 1;
    options.warm_up = 0;
    int rounds = 0;
    const std::vector<BenchResult> results = bench(*backend, options, [&] { ++rounds; });
    CHECK(rounds == 1);
    REQUIRE(results.size() == 4);
    CHECK(results.back().quality == "published-2020");
    for (const BenchResult& result : results) {
        CAPTURE(result.quality);
        CHECK(result.table_bytes > 0);
        REQUIRE(result.passes.size() == 7);
        double frame = 0;
        for (const BenchPass& pass : result.passes) {
            CAPTURE(pass.name);
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
    // Steps of the published sampling: 256 x 64 texels with 40 evaluations each.
    CHECK(results.back().pass("transmittance").counts.evaluations == 256 * 64 * 40);
}
