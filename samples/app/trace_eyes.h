// The path tracer as `aureole trace` uses it: directions in, means of batches out.
#pragma once

#include "app/trace.h"

#include <aureole/atmosphere.h>
#include <aureole/models/reference.h>

#include <deque>

namespace aureole::app {

/// The composite knows this many frames, and as many rounds of other paths; then comes another seed.
inline constexpr std::uint64_t seed_rounds = 1024;
inline constexpr int seeds_of_one = 4096;           ///< Seeds of the model that one of TraceSettings stands for.
inline constexpr int seeds_of_trace = 4096;         ///< And so many are there of those.
inline constexpr std::uint64_t seeds_of_air = 256;  ///< Of those of one: the airs of one trace (14 at most) take others.
/// Airs whose errors have nothing in common add up to less of an error: 14 by a fourth of that of one.
[[nodiscard]] inline int nth_seed(const TraceSettings& settings, std::uint64_t n, std::size_t air) {
    return settings.seed * seeds_of_one + static_cast<int>((n + air * seeds_of_air) % seeds_of_one);
}

/// Target and directions: a line for each row of the table, a column for each batch.
class TraceTarget {
public:
    TraceTarget(Backend& backend, std::size_t rows);
    /// The chosen rows alone, in so many of their columns; where there is no direction nothing is traced.
    void look(std::span<const ProbeRow> rows, std::span<const std::size_t> chosen, std::size_t lanes);
    [[nodiscard]] const CompositeTargets& targets() const { return targets_; }
    /// Unrounded where the device is in double precision.
    [[nodiscard]] std::vector<double> read();

private:
    Backend& backend_;
    DeviceTextures textures_;
    CompositeTargets targets_;
    std::vector<float> texels_;
    bool filled_ = false;
};

/// One way to look at an air: these orders, these wavelengths.
class TraceEye {
public:
    TraceEye(Backend& backend, const AtmosphereParameters& air, const models::ReferenceSettings& settings,
             const TraceTarget& target);
    /// One composite, from where `row` stands. A value for each texel of the target.
    [[nodiscard]] std::vector<double> see(TraceTarget& target, const ProbeRow& row, std::uint64_t frame);

private:
    Backend& backend_;
    double bottom_radius_m_;
    Atmosphere air_;
    View view_;
};

/// An air in red, green and blue, or in wavelengths that add up to them.
class TraceColours {
public:
    TraceColours(const AtmosphereParameters& parameters, const std::string& spectral);
    /// Airs whose channels are three wavelengths each.
    [[nodiscard]] const std::vector<AtmosphereParameters>& airs() const { return airs_; }
    /// What the radiance in the channels of an air adds to red, green and blue, per unit of a white sun.
    [[nodiscard]] Rgb part(std::size_t air, const Rgb& channels) const;

private:
    std::vector<AtmosphereParameters> airs_;
    std::vector<glm::dmat3> matrices_;  ///< None: channels are colours.
};

}  // namespace aureole::app
