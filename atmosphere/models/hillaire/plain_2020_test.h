// The equations of Hillaire 2020 once more, written from the paper and the published code in vectors and radii, in double,
// without tables: what the model's kernels are tested against.
#pragma once

#include <aureole/parameters.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <optional>
#include <variant>

namespace aureole::plain_2020 {

struct Air {
    AtmosphereParameters parameters;

    struct Sample {
        glm::dvec3 scattering{0}, extinction{0}, with_phase{0};
    };
    /// At a distance from the planet's centre; with_phase: scattering times the phase functions at the cosine nu.
    [[nodiscard]] Sample at(double radius, double nu) const {
        Sample s;
        const double h = std::max(radius - parameters.planet.bottom_radius_m, 0.0);
        for (const DensityTerm& term : parameters.terms) {
            double density = 0;
            if (const auto* e = std::get_if<ExponentialProfile>(&term.profile)) density = std::exp(-h / e->scale_height_m);
            if (const auto* t = std::get_if<TentProfile>(&term.profile))
                density = std::max(0.0, 1 - std::abs(h - t->center_m) / t->half_width_m);
            s.scattering += density * term.scattering_per_m;
            s.extinction += density * (term.scattering_per_m + term.absorption_per_m);
            s.with_phase += density * evaluate(term.phase, nu) * term.scattering_per_m;
        }
        return s;
    }
    /// Distance along a ray to a sphere; none if it is behind or missed.
    [[nodiscard]] static std::optional<double> meets(const glm::dvec3& p, const glm::dvec3& d, double radius, bool far) {
        const double b = glm::dot(p, d), c = glm::dot(p, p) - radius * radius, q = b * b - c;
        if (q < 0) return {};
        const double t = far ? -b + std::sqrt(q) : -b - std::sqrt(q);
        return t > 0 ? std::optional(t) : std::nullopt;
    }
    [[nodiscard]] double top() const { return parameters.planet.top_radius_m; }
    [[nodiscard]] double bottom() const { return parameters.planet.bottom_radius_m; }

    [[nodiscard]] glm::dvec3 optical_depth(const glm::dvec3& p, const glm::dvec3& d, int steps = 40) const {
        const double end = meets(p, d, top(), true).value_or(0);
        glm::dvec3 depth(0);
        double before = 0;
        for (int i = 0; i < steps; ++i) {
            const double t = end * (i + 0.3) / steps;
            depth += (t - before) * at(glm::length(p + t * d), 0).extinction;
            before = t;
        }
        return depth;
    }
    [[nodiscard]] glm::dvec3 sunlight(const glm::dvec3& p, const glm::dvec3& sun) const {
        if (meets(p, sun, bottom(), false)) return glm::dvec3(0);
        return glm::exp(-optical_depth(p, sun));
    }

    struct Second {
        glm::dvec3 light{0}, share{0};
    };
    /// One of the 64 rays of the multiple scattering.
    [[nodiscard]] Second second_order(const glm::dvec3& p, const glm::dvec3& d, const glm::dvec3& sun) const {
        const std::optional<double> ground = meets(p, d, bottom(), false);
        const double end = ground ? *ground : meets(p, d, top(), true).value_or(0);
        Second result;
        glm::dvec3 throughput(1);
        double before = 0;
        for (int i = 0; i < 20; ++i) {
            const double t = end * (i + 0.3) / 20, dt = t - before;
            before = t;
            const glm::dvec3 place = p + t * d;
            const Sample air = at(glm::length(place), 0);
            const glm::dvec3 passed = glm::exp(-air.extinction * dt);
            const glm::dvec3 whole = throughput * air.scattering * (1.0 - passed) / air.extinction;
            result.light += whole * sunlight(place, sun) / (4 * std::numbers::pi);
            result.share += whole;
            throughput *= passed;
        }
        if (ground) {
            const glm::dvec3 place = p + *ground * d;
            const double cosine = std::max(glm::dot(glm::normalize(place), sun), 0.0);
            // Just above the ground, lest it hides the sun from itself.
            result.light +=
                throughput * parameters.planet.ground_albedo / std::numbers::pi * cosine * sunlight(place * (1 + 1e-9), sun);
        }
        return result;
    }
    [[nodiscard]] glm::dvec3 psi(double radius, double mu_s) const {
        const glm::dvec3 p(0, 0, radius), sun(std::sqrt(1 - mu_s * mu_s), 0, mu_s);
        Second mean;
        for (int i = 0; i < 8; ++i)
            for (int j = 0; j < 8; ++j) {
                const double theta = 2 * std::numbers::pi * (i + 0.5) / 8, z = 1 - 2 * (j + 0.5) / 8;
                const double s = std::sqrt(1 - z * z);
                const Second one = second_order(p, {s * std::cos(theta), s * std::sin(theta), z}, sun);
                mean.light += one.light / 64.0;
                mean.share += one.share / 64.0;
            }
        return mean.light / (1.0 - mean.share);
    }
    /// What a camera sees, the sun's irradiance being 1: cells that grow with the square.
    [[nodiscard]] glm::dvec3 sky(const glm::dvec3& p, const glm::dvec3& d, const glm::dvec3& sun, int steps) const {
        const double end = meets(p, d, top(), true).value_or(0), nu = glm::dot(d, sun);
        glm::dvec3 radiance(0), throughput(1);
        for (int i = 0; i < steps; ++i) {
            const double t0 = end * std::pow(i / double(steps), 2), t1 = end * std::pow((i + 1) / double(steps), 2);
            const glm::dvec3 place = p + (t0 + 0.3 * (t1 - t0)) * d;
            const double radius = glm::length(place);
            const Sample air = at(radius, nu);
            const glm::dvec3 source =
                air.with_phase * sunlight(place, sun) + air.scattering * psi(radius, glm::dot(place, sun) / radius);
            const glm::dvec3 passed = glm::exp(-air.extinction * (t1 - t0));
            radiance += throughput * source * (1.0 - passed) / air.extinction;
            throughput *= passed;
        }
        return radiance;
    }
};

}  // namespace aureole::plain_2020
