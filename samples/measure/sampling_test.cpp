#include "measure/sampling.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace aureole;
using namespace aureole::app;

namespace {

/// Round r gives value i: `mean` plus or minus 1 in turn, in red and half of it in the others.
Rgb alternating(double mean, std::uint64_t round) {
    const double off = round % 2 == 0 ? 1 : -1;
    return {mean + off, mean + off / 2, mean - off / 2};
}

}  // namespace

TEST_CASE("sample: means and standard errors, each as long as it takes") {
    std::vector<std::vector<std::size_t>> asked;
    double before = 0;
    const auto draw = [&](std::uint64_t round, std::span<const std::size_t> wanted, std::span<Rgb> values) {
        CHECK(round == asked.size());
        asked.emplace_back(wanted.begin(), wanted.end());
        for (const std::size_t i : wanted) values[i] = i == 2 ? Rgb(7) : alternating(i == 0 ? 100 : 10, round);
        return true;
    };
    const auto result = sample(3, 0.01, 1000, draw, [&](double share) {
        CHECK(share > 0);
        CHECK(share <= 1);
        before = share;
    });
    REQUIRE(result);
    CHECK(before == 1);
    CHECK(result->reached);
    // 1 / sqrt(n - 1) of 100 is within 1 % at once; of 10 from n = 101 on, and the next look is at 112.
    CHECK(result->rounds == std::vector<std::uint64_t>{16, 112, 16});
    CHECK(asked.size() == 112);
    CHECK(asked[15].size() == 3);
    CHECK(asked[16] == std::vector<std::size_t>{1});
    const Estimated one = result->values[0];
    CHECK(one.radiance.r == doctest::Approx(100));
    CHECK(one.error.r == doctest::Approx(1 / std::sqrt(15.0)));
    CHECK(one.error.b == doctest::Approx(0.5 / std::sqrt(15.0)));
    CHECK(result->values[2].radiance == Rgb(7));
    CHECK(result->values[2].error == Rgb(0));
}

TEST_CASE("sample: ends at the most rounds, and when it is stopped") {
    const auto draw = [&](std::uint64_t round, std::span<const std::size_t>, std::span<Rgb> values) {
        values[0] = alternating(10, round);
        return round < 30;
    };
    const auto most = sample(1, 0.01, 20, draw, {});
    REQUIRE(most);
    CHECK_FALSE(most->reached);
    CHECK(most->rounds[0] == 20);
    CHECK_FALSE(sample(1, 0.01, 1000, draw, {}));
}
