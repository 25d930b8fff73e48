// Ordinary kriging with an exponential covariance (Cressie 1993, sections 3.2 and 3.4): what is known at some points, at
// others. At the points themselves it returns what is known there, and between them nothing beyond what the points suggest;
// its variance grows with the distance to them.
#pragma once

#include "plan/situation.h"

#include <span>
#include <vector>

namespace aureole::detail {

/// exp(-|a - b|), each axis measured in its length.
[[nodiscard]] double covariance(const Situation& a, const Situation& b, const Situation& lengths);
/// Sum of products of two lists of one length.
[[nodiscard]] double dot(std::span<const double> a, std::span<const double> b);

class Kriging {
public:
    /// At least one point. Lengths are above 0. Takes as long as the cube of their number; what follows, its square.
    Kriging(std::vector<Situation> points, const Situation& lengths);

    struct Weights {
        std::vector<double> of_points;  ///< Their sum is 1.
        double variance = 0;            ///< Of the estimate, where that of the field is 1.
    };
    [[nodiscard]] Weights at(const Situation& place) const;

    /// What is known at each point less what the others alone would say (Dubrule 1983), and the variance of that where that of
    /// the field is 1. The latter does not depend on values, and takes as long as making this object does.
    [[nodiscard]] std::vector<double> left_out_residuals(std::span<const double> values,
                                                         std::span<const double> variances) const;
    [[nodiscard]] std::vector<double> left_out_variances() const;

private:
    [[nodiscard]] std::vector<double> solve(std::vector<double> x) const;

    std::vector<Situation> points_;
    Situation lengths_;
    std::vector<double> factor_;  // Cholesky's, row by row
    std::vector<double> ones_;    // the inverse times a vector of ones
    double sum_of_ones_ = 0;
};

}  // namespace aureole::detail
