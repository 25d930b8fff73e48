#include "measure/metrics.h"

#include <aureole/spectrum.h>

#include <doctest/doctest.h>
#include <cmath>
#include <random>

using namespace aureole;
using namespace aureole::app;

namespace {

doctest::Approx near(double value) { return doctest::Approx(value).epsilon(1e-9).scale(1e-300); }

}  // namespace

TEST_CASE("metrics: quantiles of errors") {
    CHECK(summarize({}).rows == 0);
    const ErrorSummary one = summarize({0.25});
    CHECK(one.rows == 1);
    CHECK(one.p95 == 0.25);
    const ErrorSummary many = summarize({0.3, 0.0, 0.2, 0.1, 0.4});
    CHECK(many.rows == 5);
    CHECK(many.median == near(0.2));
    CHECK(many.p95 == near(0.38));
    CHECK(many.worst == 0.4);
}

TEST_CASE("metrics: an error is measured only where the truth is known") {
    const TrueValue truth{Rgb(1, 2, 1), Rgb(0.01)};
    CHECK(relative_error(Rgb(1.1, 2, 0.7), truth).value() == near(0.1));
    CHECK_FALSE(relative_error(Rgb(1), TrueValue{Rgb(1, 2, 1), Rgb(0.021)}).has_value());
    CHECK_FALSE(relative_error(Rgb(1), TrueValue{}).has_value());
    CHECK_FALSE(part_of_error(Rgb(1), Rgb(2), TrueValue{}).has_value());
    CHECK(part_of_error(Rgb(1), Rgb(1.5), truth).value() == near(1.5 / 4));
}

TEST_CASE("metrics: parts of an error are together never less than all of it") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> value(0, 2);
    const auto colour = [&] { return Rgb(value(random), value(random), value(random)); };
    double least = 1e9, most = 0;
    for (int i = 0; i < 1000; ++i) {
        const TrueValue truth{colour() + Rgb(0.1), Rgb(0)};
        const Rgb run = colour(), exact = colour(), fine = colour();
        const double parts = part_of_error(run, exact, truth).value() + part_of_error(exact, fine, truth).value() +
                             part_of_error(fine, truth.value, truth).value();
        const double all = relative_error(run, truth).value();
        least = std::min(least, parts - all);
        most = std::max(most, all);
    }
    CHECK(least >= -1e-12);
    CHECK(most > 1);
    // One part alone is all of it.
    const TrueValue truth{Rgb(1), Rgb(0)};
    CHECK(part_of_error(Rgb(2), Rgb(1), truth).value() == relative_error(Rgb(2), truth).value());
}

TEST_CASE("metrics: luminance, as root mean square over its mean") {
    const std::vector<TrueValue> truth{{Rgb(1), Rgb(0)}, {Rgb(3), Rgb(0)}, {Rgb(9), Rgb(1)}};  // the last is too noisy
    const std::vector<Rgb> seen{Rgb(1.2), Rgb(3), Rgb(0)};
    CHECK(luminance_rmse(seen, truth).value() == near(0.2 / std::sqrt(2.0) / 2));
    CHECK_FALSE(luminance_rmse({}, {}).has_value());
    CHECK(luminance_error(Rgb(1.1), truth[0]).value() == near(0.1));
    CHECK(luminance_error(Rgb(0.9), truth[0]).value() == near(0.1));
    CHECK_FALSE(luminance_error(Rgb(1), truth[2]).has_value());
    // Green weighs more than blue.
    const std::vector<TrueValue> white{{Rgb(1), Rgb(0)}};
    const std::vector<Rgb> green{Rgb(1, 1.1, 1)}, blue{Rgb(1, 1, 1.1)};
    CHECK(luminance_rmse(green, white).value() > 5 * luminance_rmse(blue, white).value());
}

TEST_CASE("metrics: colours as a display shows them") {
    std::vector<TrueValue> truth(11);
    for (std::size_t i = 0; i < truth.size(); ++i) truth[i].value = Rgb(static_cast<double>(i));
    const double exposure = fixed_exposure(truth);
    CHECK(exposure == near(0.8 / 9));
    CHECK(fixed_exposure({}) == 1);

    CHECK(shown_difference(Rgb(3), Rgb(3), exposure) == 0);
    CHECK(shown_difference(Rgb(50), Rgb(60), exposure) == 0);  // both white
    // Two greys: the formula along L* alone, as Sharma, Wu & Dalal state it.
    const auto lightness = [&](double grey) { return 116 * std::cbrt(grey * exposure) - 16; };
    const double a = lightness(3), b = lightness(4), middle = (a + b) / 2 - 50;
    CHECK(
        shown_difference(Rgb(3), Rgb(4), exposure) ==
        doctest::Approx((b - a) / (1 + 0.015 * middle * middle / std::sqrt(20 + middle * middle))).epsilon(1e-4).scale(1e-300));
}

TEST_CASE("metrics: a band is a step that the finer picture does not have") {
    std::vector<Rgb> smooth, banded;
    for (int i = 0; i < 40; ++i) {
        const int band = i / 4;
        smooth.emplace_back(0.2 + 0.01 * i);
        banded.emplace_back(0.2 + 0.04 * band);
    }
    CHECK(banding(smooth, smooth, 1) == 0);
    const double found = banding(banded, smooth, 1);
    CHECK(found > shown_difference(Rgb(0.2), Rgb(0.23), 1) - 0.5);
    CHECK(found < shown_difference(Rgb(0.2), Rgb(0.24), 1));
    // A shift in brightness is no band.
    std::vector<Rgb> brighter = smooth;
    for (Rgb& value : brighter) value *= 1.02;
    CHECK(banding(brighter, smooth, 1) < 0.05 * found);
}
