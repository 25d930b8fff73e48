#include "common/resample.h"

#include <doctest/doctest.h>
#include <cmath>
#include <numbers>

using namespace aureole::detail;

namespace {

// As pack_atmosphere's axis of profiles: h = top s^2.
TableAxis square_axis(double top) {
    return {[top](double s) { return top * s * s; }, [top](double h) { return std::sqrt(h / top); },
            [top](double s) { return 2 * top * s; }};
}

}  // namespace

TEST_CASE("resample: a constant and its integral") {
    const std::vector<double> x{-5, 200}, y{3, 3};
    const std::vector<double> nodes = resample(x, y, 65, square_axis(100));
    for (const double v : nodes) CHECK(v == doctest::Approx(3).scale(1e-300).epsilon(1e-14));
    CHECK(integral(nodes, square_axis(100)) == doctest::Approx(300).scale(1e-300).epsilon(1e-14));
}

TEST_CASE("resample: between samples the nodes follow the function, beyond them it is constant") {
    const std::vector<double> x{10, 20, 40}, y{1, 5, 2};
    const int n = 4096;
    const std::vector<double> nodes = resample(x, y, n, square_axis(100));
    const auto at = [&](double h) { return nodes[static_cast<std::size_t>(std::lround(std::sqrt(h / 100) * (n - 1)))]; };
    CHECK(at(3) == doctest::Approx(1).scale(1e-300).epsilon(1e-12));
    CHECK(at(15) == doctest::Approx(3).scale(1e-300).epsilon(1e-3));
    CHECK(at(30) == doctest::Approx(3.5).scale(1e-300).epsilon(1e-3));
    CHECK(at(90) == doctest::Approx(2).scale(1e-300).epsilon(1e-12));
}

TEST_CASE("resample: a layer thinner than the grid keeps its column") {
    // A triangle 2 m wide at 80 km, where nodes lie 44 m apart: 1 km x 1e-3 = an area of 1e-3 (km x relative density).
    const std::vector<double> x{0, 79.999, 80, 80.001, 100}, y{0, 0, 1, 0, 0};
    const std::vector<double> nodes = resample(x, y, 4096, square_axis(100));
    CHECK(integral(nodes, square_axis(100)) == doctest::Approx(1e-3).scale(1e-300).epsilon(1e-9));
}

TEST_CASE("integral: on the sphere") {
    const TableAxis sphere{[](double s) { return s * std::numbers::pi; }, [](double t) { return t / std::numbers::pi; },
                           [](double s) { return 2 * std::numbers::pi * std::numbers::pi * std::sin(std::numbers::pi * s); }};
    const std::vector<double> ones(181, 1.0);
    CHECK(integral(ones, sphere) == doctest::Approx(4 * std::numbers::pi).scale(1e-300).epsilon(1e-12));
}
