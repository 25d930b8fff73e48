#include "physics/reference.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace aureole::physics {
namespace {

// Nodes and weights of the ten-point rule on (-1, 1), positive half; Abramowitz & Stegun, table 25.4.
constexpr std::array<Real, 5> nodes{0.148874338981631210884826001129719985L, 0.433395394129247190799265943165784162L,
                                    0.679409568299024406234327365114873576L, 0.865063366688984510732096688423493049L,
                                    0.973906528517171720077964012084452053L};
constexpr std::array<Real, 5> weights{0.295524224714752870173815619188769420L, 0.269266719309996355091226921569469353L,
                                      0.219086362515982043995534934228163192L, 0.149451349150580593145863396957993697L,
                                      0.066671344308688137593568809893331793L};

Real gauss(const std::function<Real(Real)>& f, Real a, Real b) {
    const Real middle = (a + b) / 2, half = (b - a) / 2;
    Real result = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        result += weights[i] * (f(middle - half * nodes[i]) + f(middle + half * nodes[i]));
    return result * half;
}

Real refine(const std::function<Real(Real)>& f, Real a, Real b, Real whole, Real tolerance, int depth) {
    const Real middle = (a + b) / 2;
    const Real left = gauss(f, a, middle), right = gauss(f, middle, b);
    if (depth == 0 || std::abs(left + right - whole) <= tolerance) return left + right;
    return refine(f, a, middle, left, tolerance / 2, depth - 1) + refine(f, middle, b, right, tolerance / 2, depth - 1);
}

}  // namespace

Real integrate(const std::function<Real(Real)>& f, Real a, Real b, Real relative) {
    // A first estimate in many parts, so that a peak in a corner is not overlooked.
    constexpr int parts = 16;
    std::array<Real, parts> part{};
    Real total = 0;
    const auto at = [&](int i) { return a + (b - a) * static_cast<Real>(i) / parts; };
    for (int i = 0; i < parts; ++i) total += std::abs(part[static_cast<std::size_t>(i)] = gauss(f, at(i), at(i + 1)));
    Real result = 0;
    for (int i = 0; i < parts; ++i)
        result += refine(f, at(i), at(i + 1), part[static_cast<std::size_t>(i)], relative * total / parts, 40);
    return result;
}

std::vector<Node> gauss_nodes(double a, double b) {
    const double middle = (a + b) / 2, half = (b - a) / 2;
    std::vector<Node> result;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (const double sign : {-1.0, 1.0})
            result.push_back({middle + sign * half * static_cast<double>(nodes[i]), half * static_cast<double>(weights[i])});
    return result;
}

Real Shell::horizon_mu(Real altitude) const { return -std::sqrt(altitude * (2 * bottom + altitude)) / (bottom + altitude); }

Real Shell::altitude_after(Real altitude, Real mu, Real t) const {
    const Real r = bottom + altitude;
    return std::max(std::sqrt(r * r + t * t + 2 * r * t * mu) - bottom, 0.0L);
}

Real Shell::to_top(Real altitude, Real mu) const {
    const Real r = bottom + altitude;
    return -r * mu + std::sqrt(std::max(r * r * (mu * mu - 1) + top * top, 0.0L));
}

Real Shell::to_ground(Real altitude, Real mu) const {
    const Real r = bottom + altitude;
    return -r * mu - std::sqrt(std::max(r * r * mu * mu - altitude * (2 * bottom + altitude), 0.0L));
}

Real Shell::to_end(Real altitude, Real mu) const {
    return hits_ground(altitude, mu) ? to_ground(altitude, mu) : to_top(altitude, mu);
}

Real Shell::column(Real altitude, Real mu, Real a, Real b) const {
    const auto f = [&](Real t) { return density(altitude_after(altitude, mu, t)); };
    // At the lowest point the integrand turns.
    const Real lowest = std::clamp(-(bottom + altitude) * mu, a, b);
    return (lowest > a ? integrate(f, a, lowest) : 0) + (b > lowest ? integrate(f, lowest, b) : 0);
}

Real horizontal_column_exponential(Real bottom, Real altitude, Real scale_height) {
    const Real x = (bottom + altitude) / scale_height;
    return scale_height * x * std::exp(x) * std::cyl_bessel_k(1.0L, x) * std::exp(-altitude / scale_height);
}

}  // namespace aureole::physics
