// The path tracer as tests ask it: radiance with its standard error, and differences in units of that.
#pragma once

#include <aureole/models/reference.h>

#include "physics/sky.h"
#include "physics/worst.h"

#include <vector>

namespace aureole::physics {

[[nodiscard]] models::ReferenceSettings paths(int count, int seed = 1);
[[nodiscard]] SkyOptions traced(const models::ReferenceSettings& settings);

/// A sky in double precision with its standard error: two composites of the same paths, one showing each.
class TracedSky {
public:
    TracedSky(const AtmosphereParameters& air, const models::ReferenceSettings& settings);
    void stand(double altitude_m, const Sun& sun);
    /// Another frame, other paths.
    void frame(std::uint64_t number);
    struct Values {
        std::vector<Rgb> radiance, error;
    };
    [[nodiscard]] Values look(std::span<const glm::dvec3> directions);
    /// Radiance alone.
    [[nodiscard]] std::vector<Rgb> radiance(std::span<const glm::dvec3> directions) { return mean_.radiance(directions); }

private:
    Sky mean_, error_;
};

/// Differences in standard errors.
class Scores {
public:
    template <class... Where>
    void add(double difference, double error, const Where&... where) {
        const double score = std::abs(difference) / error;
        all_.push_back(score);
        worst_.add(score, where...);
    }
    /// They are distributed as a normal variable is, of which three in a thousand lie beyond three standard errors.
    void check(const char* what, std::size_t least) const;

private:
    std::vector<double> all_;
    Worst worst_;
};

}  // namespace aureole::physics
