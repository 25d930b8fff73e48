#include "common/resample.h"

#include "quadrature/gauss_legendre.h"

#include <algorithm>
#include <cstddef>

namespace aureole::detail {
namespace {

double interpolate(std::span<const double> x, std::span<const double> y, double at) {
    const auto upper = std::upper_bound(x.begin(), x.end(), at);
    if (upper == x.begin()) return y.front();
    if (upper == x.end()) return y.back();
    const std::size_t i = static_cast<std::size_t>(upper - x.begin());
    const double t = (at - x[i - 1]) / (x[i] - x[i - 1]);
    return (1 - t) * y[i - 1] + t * y[i];
}

/// Where the integrand is not smooth: the nodes' hats and the samples, in order.
std::vector<double> breakpoints(std::span<const double> x, int n, const TableAxis& axis) {
    std::vector<double> breaks;
    breaks.reserve(static_cast<std::size_t>(n) + x.size());
    for (int i = 0; i < n; ++i) breaks.push_back(static_cast<double>(i) / (n - 1));
    const double first = axis.x_of_s(0), last = axis.x_of_s(1);
    for (const double sample : x)
        if (sample > first && sample < last) breaks.push_back(axis.s_of_x(sample));
    std::sort(breaks.begin(), breaks.end());
    return breaks;
}

}  // namespace

std::vector<double> resample(std::span<const double> x, std::span<const double> y, int n, const TableAxis& axis) {
    // Between breakpoints both axes' integrands are polynomials of low degree, or nearly: four nodes leave nothing.
    const GaussLegendre rule = gauss_legendre(4);
    const std::vector<double> breaks = breakpoints(x, n, axis);
    const std::size_t count = static_cast<std::size_t>(n);
    std::vector<double> sum(count, 0.0), norm(count, 0.0);
    for (std::size_t b = 0; b + 1 < breaks.size(); ++b) {
        const double begin = breaks[b], width = breaks[b + 1] - breaks[b];
        if (!(width > 0)) continue;
        const std::size_t cell = std::min(static_cast<std::size_t>((begin + width / 2) * (n - 1)), count - 2);
        for (std::size_t q = 0; q < rule.node.size(); ++q) {
            const double s = begin + width * rule.node[q];
            const double w = width * rule.weight[q] * axis.weight(s);
            const double f = interpolate(x, y, axis.x_of_s(s));
            const double t = std::clamp(s * (n - 1) - static_cast<double>(cell), 0.0, 1.0);
            sum[cell] += (1 - t) * w * f, norm[cell] += (1 - t) * w;
            sum[cell + 1] += t * w * f, norm[cell + 1] += t * w;
        }
    }
    for (std::size_t i = 0; i < count; ++i) sum[i] /= norm[i];
    return sum;
}

double integral(std::span<const double> nodes, const TableAxis& axis) {
    const GaussLegendre rule = gauss_legendre(4);
    const double cells = static_cast<double>(nodes.size() - 1);
    double sum = 0;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
        const double cell = static_cast<double>(i);
        sum += rule.integrate(
            0, 1, [&](double t) { return ((1 - t) * nodes[i] + t * nodes[i + 1]) * axis.weight((cell + t) / cells) / cells; });
    }
    return sum;
}

}  // namespace aureole::detail
