#include "plan/kriging.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace aureole::detail;

namespace {

Situation at(double sun, double altitude) {
    Situation place{};
    place[0] = sun;
    place[1] = altitude;
    return place;
}

const std::vector<Situation> points{at(0, 0), at(1, 0), at(0, 2), at(3, 1), at(-2, 0.5), at(2.5, 4)};
const std::vector<double> values{0.3, -1, 2, 0.5, 4, -3};

Situation lengths_of(double sun, double altitude) {
    Situation lengths;
    lengths.fill(1);
    lengths[0] = sun;
    lengths[1] = altitude;
    return lengths;
}
const Situation lengths = lengths_of(2, 3);

double sum(const std::vector<double>& list) { return std::accumulate(list.begin(), list.end(), 0.0); }
double estimate(const std::vector<double>& weights, const std::vector<double>& known) {
    return std::inner_product(weights.begin(), weights.end(), known.begin(), 0.0);
}

}  // namespace

TEST_CASE("kriging: what is known at a point is returned there, without doubt") {
    const Kriging kriging(points, lengths);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Kriging::Weights weights = kriging.at(points[i]);
        CHECK(estimate(weights.of_points, values) == doctest::Approx(values[i]).epsilon(1e-6).scale(1e-300));
        CHECK(weights.variance < 1e-7);
    }
}

TEST_CASE("kriging: between two points of equal distance it is their mean; weights add up to 1 everywhere") {
    const Kriging two({at(-1, 0), at(1, 0)}, lengths);
    const Kriging::Weights middle = two.at(at(0, 0));
    CHECK(middle.of_points[0] == doctest::Approx(0.5).epsilon(1e-12).scale(1e-300));
    // 1 - k' C^-1 k + (1 - 1' C^-1 k)^2 / (1' C^-1 1), with k = e^-1/2 and C = (1, e^-1; e^-1, 1).
    const double k = std::exp(-0.5), c = 1 + std::exp(-1.0), lacking = 1 - 2 * k / c;
    CHECK(middle.variance == doctest::Approx(1 - 2 * k * k / c + lacking * lacking * c / 2).epsilon(1e-7).scale(1e-300));
    const Kriging kriging(points, lengths);
    for (const Situation& place : {at(0.2, 0.3), at(100, -40), at(-2, 0.5)})
        CHECK(sum(kriging.at(place).of_points) == doctest::Approx(1).epsilon(1e-9).scale(1e-300));
}

TEST_CASE("kriging: doubt grows with distance, up to that of the field and of its mean") {
    const Kriging kriging(points, lengths);
    double before = 0;
    for (const double away : {0.01, 0.1, 0.5, 2.0, 8.0, 100.0}) {
        const double variance = kriging.at(at(3 + away, 1)).variance;
        CHECK(variance > before);
        before = variance;
    }
    CHECK(before > 1);
    CHECK(before < 2);
}

TEST_CASE("kriging: points left out at once are as if each had been left out by itself") {
    const Kriging kriging(points, lengths);
    const std::vector<double> variances = kriging.left_out_variances();
    const std::vector<double> residuals = kriging.left_out_residuals(values, variances);
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::vector<Situation> others = points;
        std::vector<double> known = values;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        known.erase(known.begin() + static_cast<std::ptrdiff_t>(i));
        const Kriging::Weights weights = Kriging(others, lengths).at(points[i]);
        CHECK(residuals[i] == doctest::Approx(values[i] - estimate(weights.of_points, known)).epsilon(1e-6).scale(1e-300));
        CHECK(variances[i] == doctest::Approx(weights.variance).epsilon(1e-6).scale(1e-300));
    }
}

TEST_CASE("kriging: two points in one place, and a single one, do no harm") {
    const Kriging twice({at(0, 0), at(0, 0), at(1, 0)}, lengths);
    const Kriging::Weights here = twice.at(at(0, 0));
    CHECK(std::isfinite(here.variance));
    CHECK(estimate(here.of_points, {2, 2, 5}) == doctest::Approx(2).epsilon(1e-6).scale(1e-300));
    const Kriging::Weights alone = Kriging({at(0, 0)}, lengths).at(at(50, 0));
    CHECK(alone.of_points[0] == doctest::Approx(1).epsilon(1e-9).scale(1e-300));
    CHECK(alone.variance == doctest::Approx(2).epsilon(1e-6).scale(1e-300));
}
