// Phase functions on the host: values and Legendre moments by the kernels' own formulas (phase.glsl).
#include "common/check.h"
#include "common/host_air.h"
#include "common/pack_atmosphere.h"
#include "parameters/validate.h"
#include "quadrature/gauss_legendre.h"

#include <aureole/parameters.h>

#include <cmath>
#include <numbers>

namespace aureole {
namespace {

/// Cuts of (0, pi) between which p(cos theta) is smooth on the scale of the piece. Analytic lobes peak at 0 or pi, so pieces
/// shrink by halves towards both; the smallest is far narrower than the narrowest lobe (1 - |g| = 1e-3). Tables are linear
/// between their texels.
std::vector<double> smooth_pieces(const PhaseFunction& phase) {
    constexpr double pi = std::numbers::pi;
    std::vector<double> cuts{0};
    if (std::holds_alternative<TabulatedPhase>(phase)) {
        for (int i = 1; i < detail::table_width; ++i) cuts.push_back(pi * i / (detail::table_width - 1));
        return cuts;
    }
    constexpr int halvings = 16;
    for (int k = halvings; k >= 1; --k) cuts.push_back(std::ldexp(pi, -k));
    for (int k = 2; k <= halvings; ++k) cuts.push_back(pi - std::ldexp(pi, -k));
    cuts.push_back(pi);
    return cuts;
}

}  // namespace

double evaluate(const PhaseFunction& phase, double cos_theta) {
    detail::check_phase("phase", phase);
    detail::check("cos_theta", cos_theta, -1, 1);
    return detail::HostAir(detail::pack_exact(phase)).phase(0, cos_theta);
}

std::vector<double> legendre_moments(const PhaseFunction& phase, int count) {
    detail::check_phase("phase", phase);
    detail::check("count", count, 1, 256);
    detail::HostAir air(detail::pack_exact(phase));
    const std::vector<double> cuts = smooth_pieces(phase);
    // The widest piece of an analytic function is pi/4, on which P_l swings l / 8 times.
    const bool tabulated = std::holds_alternative<TabulatedPhase>(phase);
    const detail::GaussLegendre rule = detail::gauss_legendre(tabulated ? 4 : 24 + count / 2);
    std::vector<double> moments(static_cast<std::size_t>(count), 0.0);
    for (std::size_t piece = 0; piece + 1 < cuts.size(); ++piece) {
        const double width = cuts[piece + 1] - cuts[piece];
        for (std::size_t q = 0; q < rule.node.size(); ++q) {
            const double theta = cuts[piece] + width * rule.node[q];
            const double solid_angle = 2 * std::numbers::pi * std::sin(theta) * width * rule.weight[q];
            const double share = air.phase(0, std::cos(theta)) * solid_angle;
            const std::vector<double> p = detail::legendre_polynomials(count - 1, std::cos(theta));
            for (std::size_t l = 0; l < moments.size(); ++l) moments[l] += share * p[l];
        }
    }
    return moments;
}

// Jendersie & d'Eon 2023, "An Approximate Mie Scattering Function for Fog and Cloud Rendering", equations for 5 <= d <= 50 um.
HenyeyGreensteinDrainePhase HenyeyGreensteinDrainePhase::from_droplet_diameter(double diameter_um) {
    detail::check("diameter_um", diameter_um, 5, 50);
    return {
        .g_hg = std::exp(-0.0990567 / (diameter_um - 1.67154)),
        .g_draine = std::exp(-2.20679 / (diameter_um + 3.91029) - 0.428934),
        .alpha = std::exp(3.62489 - 8.29288 / (diameter_um + 5.52825)),
        .weight = std::exp(-0.599085 / (diameter_um - 0.641583) - 0.665888),
    };
}

}  // namespace aureole
