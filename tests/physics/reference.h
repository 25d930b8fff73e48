// Closed forms and adaptive quadrature in long double, written for the tests alone: nothing here is shared with the kernels.
#pragma once

#include <functional>
#include <vector>

namespace aureole::physics {

using Real = long double;

/// Adaptive: Gauss-Legendre with ten nodes, halved until two halves agree with the whole to `relative` of the total.
[[nodiscard]] Real integrate(const std::function<Real(Real)>& f, Real a, Real b, Real relative = 1e-8L);

/// The ten nodes of a Gauss-Legendre rule on (a, b), with their weights.
struct Node {
    double at, weight;
};
[[nodiscard]] std::vector<Node> gauss_nodes(double a, double b);

/// A spherical shell of air; lengths in metres.
struct Shell {
    Real bottom = 6360e3L, top = 6460e3L;
    std::function<Real(Real)> density = [](Real) { return 1.0L; };  ///< By altitude.

    [[nodiscard]] Real horizon_mu(Real altitude) const;
    [[nodiscard]] bool hits_ground(Real altitude, Real mu) const { return mu < horizon_mu(altitude); }
    [[nodiscard]] Real altitude_after(Real altitude, Real mu, Real t) const;
    [[nodiscard]] Real to_top(Real altitude, Real mu) const;
    /// Of a ray that hits it.
    [[nodiscard]] Real to_ground(Real altitude, Real mu) const;
    /// To whatever comes first.
    [[nodiscard]] Real to_end(Real altitude, Real mu) const;
    /// Integral of density along the ray from distance a to b.
    [[nodiscard]] Real column(Real altitude, Real mu, Real a, Real b) const;
    [[nodiscard]] Real column_to_top(Real altitude, Real mu) const { return column(altitude, mu, 0, to_top(altitude, mu)); }
};

/// Column of exp(-h / H) without an upper end, from a point at radius r in the horizontal direction: half of a grazing ray,
/// H X e^X K_1(X) e^(-h/H) with X = r / H and K_1 the modified Bessel function (Chapman 1931).
[[nodiscard]] Real horizontal_column_exponential(Real bottom, Real altitude, Real scale_height);

}  // namespace aureole::physics
