// Tabulated functions of the user, brought to the even grids that the kernels read.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace aureole::detail {

/// The axis of a table: node i of n stands for s = i / (n - 1), and s for the user's coordinate x.
struct TableAxis {
    std::function<double(double)> x_of_s, s_of_x;
    std::function<double(double)> weight;  ///< Measure in which integrals are kept, per ds.
};

/// Values at n nodes for the function that is linear in x between the samples and constant beyond them. Each value is the mean
/// of the function under the node's hat, so that the integral of what the kernels interpolate equals that of the function,
/// however thin its features are; where the function is smooth this is its value at the node.
[[nodiscard]] std::vector<double> resample(std::span<const double> x, std::span<const double> y, int n, const TableAxis& axis);

/// The integral, in the axis' measure, of what is linear in s between the nodes.
[[nodiscard]] double integral(std::span<const double> nodes, const TableAxis& axis);

}  // namespace aureole::detail
