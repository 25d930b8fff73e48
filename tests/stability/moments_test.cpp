// Legendre moments of phase functions, and the harmonics by which the model `aureole` keeps the directions of light.
#include "stability/formulas.h"
#include "stability/worst.h"

#include <aureole/parameters.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace aureole;
using namespace aureole::stability;

namespace {

constexpr int moments = 12;  // as AtmosphereBlock has them
constexpr double pi = std::numbers::pi;
template <class real>
constexpr double step = static_cast<double>(std::numeric_limits<real>::epsilon());

/// A phase function is positive and integrates to 1, and no Legendre polynomial leaves [-1, 1]: so no moment does.
void check_moments(Ledger& ledger, const Case& c, const PhaseFunction& phase) {
    const std::vector<double> p = legendre_moments(phase, moments);
    ledger.add("the moment of degree 0 is 1", c, std::abs(p[0] - 1) / 1e-9);
    for (int l = 0; l < moments; ++l) {
        const double moment = p[static_cast<std::size_t>(l)];
        ledger.add("no moment is larger than that of degree 0", c, std::abs(moment) / (p[0] * (1 + 1e-14)));
        if (const auto* lobe = std::get_if<HenyeyGreensteinPhase>(&phase))
            ledger.add("moments of Henyey and Greenstein are powers of g", c, std::abs(moment - std::pow(lobe->g, l)) / 1e-9);
    }
}

/// What kernels get of them.
void check_packed(Ledger& ledger, const Case& c, const Inputs& in, const std::vector<PhaseFunction>& phases) {
    for (std::size_t i = 0; i < phases.size(); ++i) {
        const std::vector<double> p = legendre_moments(phases[i], moments);
        for (std::size_t l = 0; l < moments; ++l) {
            const double packed = in.air.phase_moments[3 * i + l / 4][static_cast<int>(l % 4)];
            ledger.add("a packed moment is one", c, std::abs(packed));
            ledger.add("packed moments are rounded, no more", c,
                       std::abs(packed - p[l]) / (0.5 * step<float> * std::abs(p[l]) + 1e-38));
        }
    }
}

/// Moments of what the kernels make of the phase function, by one rule for both precisions. Errors of values are relative
/// (docs/stability.md, Functions), so that of a moment is no more than their sum.
void check_values(Ledger& ledger, const Case& c, kernels::StabilityFormulas<float>& single,
                  kernels::StabilityFormulas<double>& exact) {
    static const detail::GaussLegendre rule = detail::gauss_legendre(12);
    for (int i = 0; i < exact.PHASE_COUNT; ++i) {
        if (exact.phase_kind(i) == kernels::StabilityFormulas<double>::PHASE_TABULATED)
            continue;  // its axis is the angle, which a float knows to 1e-7
        double apart[moments] = {}, whole = 0;
        // Halves towards both poles, where lobes are.
        for (int half = -12; half <= 12; ++half) {
            const double near = half < 0 ? std::ldexp(pi, half - 1) : pi - std::ldexp(pi, -half - 1);
            const double far = half < 0 ? std::ldexp(pi, half) : pi - std::ldexp(pi, -half - 2);
            if (half == 0) continue;
            for (std::size_t q = 0; q < rule.node.size(); ++q) {
                const float nu = static_cast<float>(std::cos(near + (far - near) * rule.node[q]));
                const double weight = 2 * pi * rule.weight[q] * (far - near) * std::sqrt(std::max(0.0, 1.0 - double{nu} * nu));
                const double value = exact.phase_value(i, nu), rounded = single.phase_value(i, nu);
                const std::vector<double> p = detail::legendre_polynomials(moments - 1, nu);
                whole += weight * value;
                for (std::size_t l = 0; l < moments; ++l) apart[l] += weight * (rounded - value) * p[l];
            }
        }
        for (const double difference : apart)
            ledger.add("moments of values in float and double", c, std::abs(difference) / (16 * step<float> * whole));
    }
}

struct Direction {
    double z, azimuth;
};
Direction direction_of(const Case& c, std::uint64_t use) {
    const double u = c.random(use);
    if (u < 0.1) return {u < 0.05 ? 1.0 : -1.0, 0};
    return {2 * c.random(use + 1) - 1, 2 * pi * c.random(use + 2)};
}

/// norm y_lm of a direction, its azimuth counted from another's.
template <class real>
double harmonic(kernels::StabilityFormulas<real>& k, int l, int m, real z, double azimuth) {
    const real across = std::sqrt(std::max((1 - z) * (1 + z), real(0)));
    return static_cast<double>(k.harmonic_norm(l, m) * k.harmonic(l, m, z, across * static_cast<real>(std::cos(azimuth))));
}

/// Sum over m of y_lm(a) y_lm(b) = (2 l + 1) P_l(a b), so no y_lm is larger than sqrt(2 l + 1).
template <class real>
void check_harmonics(Ledger& ledger, const Case& c, kernels::StabilityFormulas<real>& k) {
    const Direction a = direction_of(c, 650), b = direction_of(c, 660);
    const real za = static_cast<real>(a.z), zb = static_cast<real>(b.z);
    const double sines = std::sqrt((1 - double{za} * double{za}) * (1 - double{zb} * double{zb}));
    const double together = std::clamp(double{za} * double{zb} + sines * std::cos(a.azimuth), -1.0, 1.0);
    const std::vector<double> p = detail::legendre_polynomials(k.MAX_ANGULAR_ORDER, together);
    for (int l = 0; l <= k.MAX_ANGULAR_ORDER; ++l) {
        double sum = 0;
        // A cosine is off by a step, and P_l as steep as l (l + 1) / 2.
        const double steps = (16 + 8 * l * (l + 1)) * step<real>;
        for (int m = 0; m <= l; ++m) {
            const double at_a = harmonic(k, l, m, za, a.azimuth), at_b = harmonic(k, l, m, zb, 0);
            ledger.add("no harmonic is larger than sqrt(2 l + 1)", c, std::abs(at_a) / ((1 + steps) * std::sqrt(2 * l + 1)));
            sum += at_a * at_b;
        }
        const double wanted = (2 * l + 1) * p[static_cast<std::size_t>(l)];
        ledger.add("harmonics add up to Legendre's polynomials", c, std::abs(sum - wanted) / (steps * (2 * l + 1)));
    }
}

/// A phase function cut off is the sum of its moments, whichever way they are added up.
template <class real>
void check_smooth(Ledger& ledger, const Case& c, kernels::StabilityFormulas<real>& k) {
    const Direction a = direction_of(c, 670), b = direction_of(c, 680);
    const real za = static_cast<real>(a.z), zb = static_cast<real>(b.z);
    const double sines = std::sqrt((1 - double{za} * double{za}) * (1 - double{zb} * double{zb}));
    const real nu = static_cast<real>(std::clamp(double{za} * double{zb} + sines * std::cos(a.azimuth), -1.0, 1.0));
    for (int i = 0; i < k.PHASE_COUNT; ++i)
        for (const int last : {1, 3, 8}) {
            k.SHARPEST_DEGREE = last;
            double sum = 0, slack = 0;
            for (int l = 0; l <= last; ++l) {
                const double moment = l == 0 ? 1 : static_cast<double>(k.atm.phase_moments[3 * i + l / 4][l % 4]);
                for (int m = 0; m <= l; ++m) sum += moment * harmonic(k, l, m, za, a.azimuth) * harmonic(k, l, m, zb, 0);
                slack += std::abs(moment) * (2 * l + 1) * (16 + 8 * l * (l + 1)) * step<real>;
            }
            const double value = 4 * pi * static_cast<double>(k.smooth_phase(i, nu));
            ledger.add("a smooth phase function by its moments", c, std::abs(value - sum) / slack);
        }
}

/// The directions in which the moments are taken: the whole sphere; and light that is the same from everywhere has no moment
/// but its mean, up to the degree that so many directions tell apart. Nodes and weights are floats for both precisions.
template <class real>
void check_directions(Ledger& ledger, const Case& c, Formulas<real>& formulas) {
    auto& k = formulas.kernel;
    const int order = 2 + 2 * static_cast<int>(3 * c.random(690));
    k.ZENITH_NODES = k.AZIMUTH_NODES = order + 2;
    formulas.rule(k.zenith_quadrature, order + 2);
    const real h = std::min(static_cast<real>(c.altitude_in_air_m() * 1e-3), k.shell_thickness());
    double sum[64] = {}, whole = 0;
    for (int q = 0; q < k.direction_count(); ++q) {
        const auto at = k.scatter_direction(q, h);
        ledger.check("a direction is one, and its solid angle positive", c, std::abs(at.mu) <= 1 && at.solid_angle >= 0);
        whole += at.solid_angle;
        const real x = at.azimuth_cosine * std::sqrt(std::max((1 - at.mu) * (1 + at.mu), real(0)));
        for (int l = 1; l <= order; ++l)
            for (int m = 0; m <= l; ++m)
                sum[k.moment_layer(l, m)] +=
                    static_cast<double>(at.solid_angle * k.harmonic_norm(l, m) * k.harmonic(l, m, at.mu, x));
    }
    ledger.add("solid angles add up to the sphere", c, std::abs(whole / (4 * pi) - 1) / (16 * step<float>));
    for (int l = 1; l <= order; ++l)
        for (int m = 0; m <= l; ++m)
            ledger.add(
                "even light has no moments but its mean", c,
                std::abs(sum[k.moment_layer(l, m)]) / (4 * pi * std::sqrt(2 * l + 1) * (16 + 8 * l * (l + 1)) * step<float>));
}

}  // namespace

TEST_CASE("stability, moments: of every phase function they are bounded, and what kernels are given") {
    Ledger ledger("moments of phase functions");
    const Range range = cases(400);
    Formulas<float> single;
    Formulas<double> exact;
    for (std::uint64_t i = range.begin; i < range.end; ++i) {
        const Case c(i);
        const AtmosphereParameters air = c.air();
        const std::vector<PhaseFunction> phases = detail::pack_exact(air).phases;
        for (const PhaseFunction& phase : phases) check_moments(ledger, c, phase);
        Inputs in(air);
        in.add_moments(air);
        check_packed(ledger, c, in, phases);
        check_values(ledger, c, single.set(in), exact.set(in));
    }
    ledger.verify();
}

TEST_CASE_TEMPLATE("stability, moments: harmonics add up, and their directions are the sphere", real, float, double) {
    Ledger ledger(sizeof(real) == 4 ? "harmonics in float" : "harmonics in double");
    const Range range = cases(3000);
    Formulas<real> formulas;
    for (std::uint64_t i = range.begin; i < range.end; ++i) {
        const Case c(i);
        Inputs in(without_air(c.planet()));
        if (i % 8 == 0) {  // moments take longer than the rest together
            const AtmosphereParameters air = c.air();
            in = Inputs(air);
            in.add_moments(air);
        }
        auto& kernel = formulas.set(in);
        check_harmonics(ledger, c, kernel);
        if (i % 8 == 0) check_smooth(ledger, c, kernel);
        check_directions(ledger, c, formulas);
    }
    ledger.verify();
}
