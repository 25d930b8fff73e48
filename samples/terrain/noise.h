// Value noise: irregular patterns that are the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>

namespace aureole::app {

/// In [0, 1), from the bits of two integers (the finalizer of MurmurHash3, Appleby 2011).
[[nodiscard]] inline double hash_noise(std::int64_t x, std::int64_t y) {
    std::uint64_t h =
        static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15ull + static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4full;
    h = (h ^ (h >> 33)) * 0xff51afd7ed558ccdull;
    h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53ull;
    return static_cast<double>((h ^ (h >> 33)) >> 11) * 0x1p-53;
}

/// Smooth between the corners of unit cells, in [0, 1].
[[nodiscard]] inline double value_noise(glm::dvec2 p) {
    const double fx = std::floor(p.x), fy = std::floor(p.y);
    const std::int64_t x = static_cast<std::int64_t>(fx), y = static_cast<std::int64_t>(fy);
    const auto ease = [](double t) { return t * t * (3 - 2 * t); };
    const double u = ease(p.x - fx), v = ease(p.y - fy);
    return std::lerp(std::lerp(hash_noise(x, y), hash_noise(x + 1, y), u),
                     std::lerp(hash_noise(x, y + 1), hash_noise(x + 1, y + 1), u), v);
}

/// Octaves from `coarsest_m` down, each half as wide and strong, none narrower than twice `footprint_m`, so that a picture
/// does not sparkle. In [0, 1], 0.5 on average.
[[nodiscard]] inline double fractal_noise(glm::dvec2 place, double coarsest_m, double footprint_m, int octaves) {
    double sum = 0, weight = 0.5, width = coarsest_m;
    for (int i = 0; i < octaves; ++i, weight *= 0.5, width *= 0.5) {
        const double fade = std::fmin(std::fmax(width / (2 * footprint_m) - 1, 0.0), 1.0);
        if (fade == 0) break;
        sum += weight * fade * (value_noise(place / width + glm::dvec2(17.3 * i, -9.1 * i)) - 0.5);
    }
    return 0.5 + sum;
}

}  // namespace aureole::app
