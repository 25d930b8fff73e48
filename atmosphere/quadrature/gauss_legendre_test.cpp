#include "quadrature/gauss_legendre.h"

#include "common/rejects.h"

#include <doctest/doctest.h>
#include <cmath>

using namespace aureole;
using namespace aureole::detail;

TEST_CASE("gauss_legendre: n nodes integrate powers up to 2 n - 1 exactly, and the next one not") {
    for (const int n : {1, 2, 3, 5, 8, 10, 16, 40}) {
        CAPTURE(n);
        const GaussLegendre rule = gauss_legendre(n);
        for (int power = 0; power <= 2 * n - 1; ++power) {
            CAPTURE(power);
            const double integral = rule.integrate(0, 1, [&](double u) { return std::pow(u, power); });
            CHECK(integral == doctest::Approx(1.0 / (power + 1)).scale(1e-300).epsilon(1e-13));
        }
        if (n > 8) continue;  // beyond, the error sinks into rounding
        // The error for u^(2 n) is the integral of the squared monic Legendre polynomial: (n!)^4 / ((2 n)!^2 (2 n + 1)).
        const double error = 1.0 / (2 * n + 1) - rule.integrate(0, 1, [&](double u) { return std::pow(u, 2 * n); });
        const double factorials = std::exp(4 * std::lgamma(n + 1.0) - 2 * std::lgamma(2 * n + 1.0));
        CHECK(error == doctest::Approx(factorials / (2 * n + 1)).scale(1e-300).epsilon(1e-4));
    }
}

TEST_CASE("gauss_legendre: known nodes, in order, symmetric") {
    const GaussLegendre three = gauss_legendre(3);
    CHECK(three.node[0] == doctest::Approx((1 - std::sqrt(0.6)) / 2).scale(1e-300).epsilon(1e-15));
    CHECK(three.node[1] == doctest::Approx(0.5).scale(1e-300).epsilon(1e-15));
    CHECK(three.weight[0] == doctest::Approx(5.0 / 18).scale(1e-300).epsilon(1e-15));
    CHECK(three.weight[1] == doctest::Approx(8.0 / 18).scale(1e-300).epsilon(1e-15));
    const GaussLegendre many = gauss_legendre(200);
    for (std::size_t i = 0; i < 200; ++i) {
        CHECK(many.node[i] > (i ? many.node[i - 1] : 0));
        CHECK(many.node[i] + many.node[199 - i] == doctest::Approx(1).scale(1e-300).epsilon(1e-14));
        CHECK(many.weight[i] > 0);
    }
    CHECK(many.node[199] < 1);
    CHECK(many.integrate(2, 5, [](double x) { return std::exp(x); }) ==
          doctest::Approx(std::exp(5.0) - std::exp(2.0)).scale(1e-300).epsilon(1e-14));
}

TEST_CASE("running_integrals: exact up to every node for polynomials up to degree n - 1") {
    for (const int n : {1, 2, 3, 8, 12, 16}) {
        CAPTURE(n);
        const GaussLegendre rule = gauss_legendre(n);
        const std::vector<double> matrix = running_integrals(rule);
        const std::size_t count = rule.node.size();
        for (int power = 0; power < n; ++power) {
            CAPTURE(power);
            for (std::size_t k = 0; k < count; ++k) {
                double running = 0;
                for (std::size_t j = 0; j < count; ++j) running += matrix[k * count + j] * std::pow(rule.node[j], power);
                CHECK(running == doctest::Approx(std::pow(rule.node[k], power + 1) / (power + 1)).scale(1).epsilon(1e-12));
            }
        }
    }
}

TEST_CASE("running_integrals: converges for an exponential") {
    const auto worst = [](int n) {
        const GaussLegendre rule = gauss_legendre(n);
        const std::vector<double> matrix = running_integrals(rule);
        const std::size_t count = rule.node.size();
        double error = 0;
        for (std::size_t k = 0; k < count; ++k) {
            double running = 0;
            for (std::size_t j = 0; j < count; ++j) running += matrix[k * count + j] * std::exp(-3 * rule.node[j]);
            error = std::max(error, std::abs(running - (1 - std::exp(-3 * rule.node[k])) / 3));
        }
        return error;
    };
    CHECK(worst(4) < 1e-3);
    CHECK(worst(8) < 1e-7);
    CHECK(worst(16) < 1e-15);
}

TEST_CASE("quadrature_block: the layout that kernels read, zero beyond n") {
    const int n = 6;
    const GaussLegendre rule = gauss_legendre(n);
    const std::vector<double> matrix = running_integrals(rule);
    const QuadratureBlock block = quadrature_block(n);
    for (int k = 0; k < max_nodes; ++k) {
        const bool used = k < n;
        const auto index = static_cast<std::size_t>(k);
        CHECK(block.node[k].x == (used ? static_cast<float>(rule.node[index]) : 0.0f));
        CHECK(block.node[k].y == (used ? static_cast<float>(rule.weight[index]) : 0.0f));
        for (int j = 0; j < max_nodes; ++j) {
            const double expected = used && j < n ? matrix[index * n + static_cast<std::size_t>(j)] : 0.0;
            CHECK(block.running[4 * k + j / 4][j % 4] == static_cast<float>(expected));
        }
    }
    CHECK(rejected_field([] { (void)quadrature_block(0); }) == "nodes");
    CHECK(rejected_field([] { (void)quadrature_block(17); }) == "nodes");
}
