// Gauss-Legendre quadrature: n nodes integrate polynomials up to degree 2 n - 1 exactly.
#pragma once

#include "common/host_blocks.h"

#include <vector>

namespace aureole::detail {

/// Legendre polynomials P_0(x) .. P_n(x), by Bonnet's recursion.
[[nodiscard]] std::vector<double> legendre_polynomials(int n, double x);

/// Nodes in (0, 1), increasing, and weights that sum to 1.
struct GaussLegendre {
    std::vector<double> node, weight;

    /// The integral of f from a to b.
    template <class F>
    [[nodiscard]] auto integrate(double a, double b, F&& f) const {
        auto sum = (b - a) * weight[0] * f(a + (b - a) * node[0]);
        for (std::size_t i = 1; i < node.size(); ++i) sum += (b - a) * weight[i] * f(a + (b - a) * node[i]);
        return sum;
    }
};

/// The rule of n >= 1 nodes.
[[nodiscard]] GaussLegendre gauss_legendre(int n);

/// M(k, j) = integral from 0 to u_k of the j-th Lagrange polynomial through the nodes, row by row: applied to values at the
/// nodes it gives their running integral up to each node, exactly for polynomials up to degree n - 1.
[[nodiscard]] std::vector<double> running_integrals(const GaussLegendre& rule);

/// The rule of n in [1, max_nodes] as the kernels read it. Beyond n: zeros.
[[nodiscard]] QuadratureBlock quadrature_block(int n);

}  // namespace aureole::detail
