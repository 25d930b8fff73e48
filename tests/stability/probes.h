// Functions of the kernels, each of the same inputs in float and in double, and how far they are apart.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>

namespace aureole::stability {

/// A point of the unit cube, which stands for planet, ray and air (probes.cpp).
using Point = std::array<double, 10>;

struct Probe {
    const char* name;
    const char* relative_to;  ///< What the error is divided by.
    double bound;             ///< Of the error, in steps of float (2^-23).
};
[[nodiscard]] std::span<const Probe> probes();

class Prober {
public:
    Prober();
    ~Prober();
    /// Error of a function at a point, in steps of float; 0 where its value underflows.
    [[nodiscard]] double error(std::size_t probe, const Point& at);
    /// What the point stands for.
    [[nodiscard]] static std::string text(const Point& at);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace aureole::stability
