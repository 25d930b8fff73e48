#include "plan/kriging.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace aureole::detail {
namespace {

constexpr double nugget = 1e-9;  // two points in one place do no harm

}  // namespace

// Four sums side by side: none waits for the addition before it.
double dot(std::span<const double> a, std::span<const double> b) {
    double sums[4] = {0, 0, 0, 0};
    const std::size_t fours = a.size() / 4 * 4;
    for (std::size_t i = 0; i < fours; i += 4)
        for (std::size_t k = 0; k < 4; ++k) sums[k] += a[i + k] * b[i + k];
    for (std::size_t i = fours; i < a.size(); ++i) sums[0] += a[i] * b[i];
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

double covariance(const Situation& a, const Situation& b, const Situation& lengths) {
    double square = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double apart = (a[i] - b[i]) / lengths[i];
        square += apart * apart;
    }
    return std::exp(-std::sqrt(square));
}

Kriging::Kriging(std::vector<Situation> points, const Situation& lengths) : points_(std::move(points)), lengths_(lengths) {
    const std::size_t n = points_.size();
    factor_.assign(n * n, 0);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k <= i; ++k) {
            const std::span row_i(&factor_[i * n], k), row_k(&factor_[k * n], k);
            const double rest = covariance(points_[i], points_[k], lengths_) + (i == k ? nugget : 0) - dot(row_i, row_k);
            factor_[i * n + k] = i == k ? std::sqrt(std::max(rest, nugget)) : rest / factor_[k * n + k];
        }
    ones_ = solve(std::vector<double>(n, 1.0));
    sum_of_ones_ = std::accumulate(ones_.begin(), ones_.end(), 0.0);
}

std::vector<double> Kriging::solve(std::vector<double> x) const {
    const std::size_t n = points_.size();
    for (std::size_t i = 0; i < n; ++i)
        x[i] = (x[i] - dot(std::span(&factor_[i * n], i), std::span(x).first(i))) / factor_[i * n + i];
    for (std::size_t i = n; i-- > 0;) {
        x[i] /= factor_[i * n + i];
        for (std::size_t k = 0; k < i; ++k) x[k] -= factor_[i * n + k] * x[i];
    }
    return x;
}

Kriging::Weights Kriging::at(const Situation& place) const {
    std::vector<double> near;
    near.reserve(points_.size());
    for (const Situation& point : points_) near.push_back(covariance(point, place, lengths_));
    Weights result{solve(near), 0};
    const double known = dot(near, result.of_points);
    const double lacking = 1 - std::accumulate(result.of_points.begin(), result.of_points.end(), 0.0);
    for (std::size_t i = 0; i < near.size(); ++i) result.of_points[i] += ones_[i] * lacking / sum_of_ones_;
    result.variance = std::max(1 - known + lacking * lacking / sum_of_ones_, 0.0);
    return result;
}

// With B = C^-1 - C^-1 1 1^T C^-1 / (1^T C^-1 1), the residual is (B y)_i / B_ii and its variance 1 / B_ii.
std::vector<double> Kriging::left_out_residuals(std::span<const double> values, std::span<const double> variances) const {
    std::vector<double> result = solve({values.begin(), values.end()});
    const double mean = dot(ones_, values) / sum_of_ones_;
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = (result[i] - ones_[i] * mean) * variances[i];
    return result;
}

// The inverse's diagonal is that of L^-T L^-1: of each column of L^-1, which begins at its own row, the sum of squares.
std::vector<double> Kriging::left_out_variances() const {
    const std::size_t n = points_.size();
    std::vector<double> result(n), column(n);
    for (std::size_t i = 0; i < n; ++i) {
        column[i] = 1 / factor_[i * n + i];
        for (std::size_t k = i + 1; k < n; ++k) {
            const std::span row(&factor_[k * n + i], k - i);
            column[k] = -dot(row, std::span(column).subspan(i, k - i)) / factor_[k * n + k];
        }
        const auto own = std::span(column).subspan(i);
        const double told = dot(own, own) - ones_[i] * ones_[i] / sum_of_ones_;
        result[i] = told > 0 ? 1 / told : std::numeric_limits<double>::infinity();  // of a single point: by nothing
    }
    return result;
}

}  // namespace aureole::detail
