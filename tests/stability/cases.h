// Configurations at and between the extremes of every axis: planet, air, camera, sun, view. Case i is the same everywhere and
// for ever, so that a failure names the one number that brings it back.
#pragma once

#include <aureole/camera.h>
#include <aureole/parameters.h>

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace aureole::stability {

enum class Axis : std::uint8_t {
    radius,        ///< Of the ground.
    shell,         ///< Thickness of the air.
    terms,         ///< How many there are.
    profile,       ///< Kind of the first one's, as of the next axes.
    scale_height,  ///< Or half width.
    extinction,
    albedo,  ///< Of single scattering.
    phase,   ///< Kind.
    g,
    ground_albedo,
    altitude,  ///< Of the camera.
    place,     ///< Direction from the planet's centre to the camera.
    sun_zenith,
    sun_azimuth,  ///< From the view's.
    sun_radius,
    irradiance,
    suns,      ///< How many.
    view,      ///< Zenith angle of a direction.
    distance,  ///< Share of the ray's length.
    count,
};

class Case {
public:
    /// The first `pair_cases()` have, in turn, every two corners of every two axes, and are random but for these; all others
    /// are random, each axis at one of its corners in one of three.
    explicit Case(std::uint64_t index);
    [[nodiscard]] static std::uint64_t pair_cases();

    [[nodiscard]] std::uint64_t index() const noexcept { return index_; }
    [[nodiscard]] double bottom_radius_m() const;
    [[nodiscard]] double shell_m() const;
    [[nodiscard]] Planet planet() const;
    [[nodiscard]] AtmosphereParameters air() const;
    [[nodiscard]] double altitude_m() const;
    /// The same, but within the shell.
    [[nodiscard]] double altitude_in_air_m() const;
    [[nodiscard]] double view_zenith() const;
    [[nodiscard]] double sun_zenith() const;
    /// Of the sun, the view being at 0.
    [[nodiscard]] double sun_azimuth() const;
    [[nodiscard]] double distance_share() const;
    /// Camera of a panorama, view straight ahead at azimuth 0.
    [[nodiscard]] Camera camera() const;
    [[nodiscard]] std::vector<Sun> suns() const;
    /// World axes, of a zenith angle and an azimuth at the camera.
    [[nodiscard]] glm::dvec3 world(double zenith, double azimuth) const;
    /// An even number in [0, 1) that belongs to this case and to the name of its use.
    [[nodiscard]] double random(std::uint64_t use) const;
    [[nodiscard]] std::string text() const;

private:
    struct Draw {
        std::optional<std::size_t> corner;
        double u = 0;
        bool pinned = false;
    };
    [[nodiscard]] Draw draw(Axis axis, std::uint64_t copy = 0) const;
    [[nodiscard]] double dip() const;
    [[nodiscard]] Profile profile(std::uint64_t term) const;
    [[nodiscard]] PhaseFunction phase(std::uint64_t term) const;
    [[nodiscard]] DensityTerm term(std::uint64_t i) const;
    [[nodiscard]] double zenith(std::span<const double> special, const Draw& d) const;

    std::uint64_t index_;
    Axis pinned_[2] = {Axis::count, Axis::count};
    std::size_t corner_[2] = {0, 0};
};

/// The least length over which anything in the case's air changes.
[[nodiscard]] double finest_m(const Case& c);

/// Which cases a test runs: `quick` of them, or as many as the environment's AUREOLE_STABILITY_CASES says (all tests alike), or
/// the one that AUREOLE_STABILITY_CASE names.
struct Range {
    std::uint64_t begin = 0, end = 0;
};
[[nodiscard]] Range cases(std::uint64_t quick);

}  // namespace aureole::stability
