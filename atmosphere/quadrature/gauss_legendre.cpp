#include "quadrature/gauss_legendre.h"

#include "common/check.h"

#include <cmath>
#include <numbers>

namespace aureole::detail {

std::vector<double> legendre_polynomials(int n, double x) {
    std::vector<double> p(static_cast<std::size_t>(n) + 1, 1.0);
    if (n >= 1) p[1] = x;
    for (std::size_t l = 2; l < p.size(); ++l) {
        const double d = static_cast<double>(l);
        p[l] = ((2 * d - 1) * x * p[l - 1] - (d - 1) * p[l - 2]) / d;
    }
    return p;
}

GaussLegendre gauss_legendre(int n) {
    const std::size_t count = static_cast<std::size_t>(n);
    GaussLegendre rule{std::vector<double>(count), std::vector<double>(count)};
    for (std::size_t i = 0; i < count; ++i) {
        // Newton's method for the i-th root of P_n, from Tricomi's estimate: converges in a handful of steps.
        double x = -std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (n + 0.5));
        double derivative = 1;
        for (int step = 0; step < 16; ++step) {
            const std::vector<double> p = legendre_polynomials(n, x);
            derivative = n * (p[count - 1] - x * p[count]) / ((1 - x) * (1 + x));
            const double change = p[count] / derivative;
            x -= change;
            if (std::abs(change) < 1e-16) break;
        }
        rule.node[i] = (1 + x) / 2;
        rule.weight[i] = 1 / ((1 - x) * (1 + x) * derivative * derivative);
    }
    return rule;
}

// On (-1, 1), with t = 2 u - 1: the Lagrange polynomial of node j is sum_{m < n} (2 m + 1)/2 w_j P_m(t_j) P_m(t), since the
// rule integrates the products P_m l_j exactly. P_m has the primitive (P_{m+1} - P_{m-1}) / (2 m + 1), which vanishes at -1,
// and P_0 has t + 1. With weights that sum to 1 on (0, 1) instead of to 2, factors of 2 cancel:
//     M(k, j) = w_j / 2 (t_k + 1 + sum_{1 <= m < n} P_m(t_j) (P_{m+1}(t_k) - P_{m-1}(t_k))).
std::vector<double> running_integrals(const GaussLegendre& rule) {
    const std::size_t n = rule.node.size();
    std::vector<std::vector<double>> p;
    for (const double u : rule.node) p.push_back(legendre_polynomials(static_cast<int>(n), 2 * u - 1));
    std::vector<double> matrix(n * n);
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t j = 0; j < n; ++j) {
            double sum = 2 * rule.node[k];
            for (std::size_t m = 1; m < n; ++m) sum += p[j][m] * (p[k][m + 1] - p[k][m - 1]);
            matrix[k * n + j] = rule.weight[j] / 2 * sum;
        }
    }
    return matrix;
}

QuadratureBlock quadrature_block(int n) {
    check("nodes", n, 1, max_nodes);
    const GaussLegendre rule = gauss_legendre(n);
    const std::vector<double> matrix = running_integrals(rule);
    const std::size_t count = static_cast<std::size_t>(n);
    Blocks<double>::QuadratureBlock block{};
    for (std::size_t k = 0; k < count; ++k) {
        block.node[k] = {rule.node[k], rule.weight[k], 0, 0};
        for (std::size_t j = 0; j < count; ++j)
            block.running[4 * k + j / 4][static_cast<glm::length_t>(j % 4)] = matrix[k * count + j];
    }
    return round_block<QuadratureBlock>(block);
}

}  // namespace aureole::detail
