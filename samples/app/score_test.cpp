#include "app/score.h"

#include "app/quantile.h"
#include "app/row_error.h"
#include "io/test_files.h"

#include <doctest/doctest.h>

using namespace aureole::app;

namespace {

const std::string result_header = "sun_zenith_deg,altitude_km,view_zenith_deg,azimuth_deg,r,g,b\n";
const std::string truth_header =
    "sun_zenith_deg,altitude_km,view_zenith_deg,azimuth_deg,L_r_per_sr,L_g_per_sr,L_b_per_sr,"
    "stderr_r_per_sr,stderr_g_per_sr,stderr_b_per_sr\n";

}  // namespace

TEST_CASE("quantile: linear between neighbours") {
    const auto of = [](const std::vector<double>& sorted, double q) { return quantile(sorted, q); };
    CHECK(of({}, 0.5) == 0);
    CHECK(of({3}, 0.95) == 3);
    CHECK(of({1, 2, 3, 4}, 0.5) == doctest::Approx(2.5));
    CHECK(of({0, 10}, 0.95) == doctest::Approx(9.5));
    CHECK(of({0, 10}, 1) == 10);
}

TEST_CASE("row_error: rows that say nothing, and light where there is none") {
    const Channels none{0, 0, 0};
    CHECK(row_error({1.1, 2, 3}, {1, 2, 3}, {0, 0, 0.06}) == doctest::Approx(0.1 / 6));
    CHECK_FALSE(row_error({1, 2, 3}, {1, 2, 3}, {0, 0.041, 0}));
    CHECK_FALSE(row_error(none, none, none));
    CHECK(row_error({0, 0, 1e-9}, none, none) == INFINITY);
}

TEST_CASE("score: errors, skipped rows, groups") {
    const auto result = put(
        "result.csv", result_header + "0,0,90,0,1.1,2,3\n0,0,120,0,1,1,0\n0,5,90,0,4,0,0\n60,0,0,0,0,0,0\n60,0,10,0,9,9,9\n");
    const auto truth = put("truth.csv", "# bottom_radius_km=6360 and more\n" + truth_header +
                                            "0,0,90,0,1,2,3,0,0,0.06\n"      // 0.1 / 6; noise of 2 % is not above 2 %
                                            "0,0,120,0,1,1,2,0,0,0\n"        // 2 / 4
                                            "0,5,90,0,1,0,0,0,0,0\n"         // 3
                                            "60,0,0,0,0,0,0,0,0,0\n"         // nothing, and nothing seen
                                            "60,0,10,0,1,1,1,0,0.021,0\n");  // too noisy
    const std::vector<ScoreLine> all = score(result, truth, {});
    REQUIRE(all.size() == 2);
    CHECK(all[0].rows == 3);
    CHECK(all[0].median == doctest::Approx(0.5));
    CHECK(all[0].p95 == doctest::Approx(0.5 + 0.9 * 2.5));
    CHECK(all[0].worst == doctest::Approx(3));
    CHECK(all[0].worst_line == 5);
    CHECK(all[1].rows == 0);
    CHECK(all[1].skipped == 2);
    CHECK(all[1].median == 0);

    ScoreOptions split;
    split.by_altitude = split.by_ray = true;
    const std::vector<ScoreLine> lines = score(result, truth, split);
    REQUIRE(lines.size() == 4);
    CHECK(lines[0].ray == "ground");
    CHECK(lines[0].median == doctest::Approx(0.5));
    CHECK(lines[1].ray == "sky");  // horizontal from altitude 0
    CHECK(lines[1].median == doctest::Approx(0.1 / 6));
    CHECK(lines[2].altitude_km == 5);
    CHECK(lines[2].ray == "sky");
}

TEST_CASE("score: the horizon of a height") {
    // From 5 km above 6360 km the horizon is 2.27 degrees below the horizontal.
    const auto result = put("result2.csv", result_header + "0,5,92.2,0,1,1,1\n0,5,92.3,0,1,1,1\n");
    const auto truth = put("truth2.csv", truth_header + "0,5,92.2,0,1,1,1,0,0,0\n0,5,92.3,0,1,1,1,0,0,0\n");
    ScoreOptions options;
    options.by_ray = true;
    CHECK(contains(complaint([&] { (void)score(result, truth, options); }), "give --bottom-radius-km"));
    options.bottom_radius_km = 6360;
    const std::vector<ScoreLine> lines = score(result, truth, options);
    REQUIRE(lines.size() == 2);
    CHECK(lines[0].rows == 1);
    CHECK(lines[1].rows == 1);
}

TEST_CASE("score: a missing row or column") {
    const auto truth = put("truth3.csv", truth_header + "0,5,92.2,0,1,1,1,0,0,0\n");
    CHECK(complaint([&] { (void)score(put("result3.csv", result_header + "0,5,92,0,1,1,1\n"), truth, {}); }) ==
          "result3.csv has no row for line 2 of truth3.csv");
    CHECK(contains(complaint([&] { (void)score(truth, truth, {}); }), "column r is missing"));
}
