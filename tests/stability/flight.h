// Frame by frame: a camera that climbs from 1 cm to 10^6 km, and a sun that sets from 90 to -18 degrees, in 2000 frames each.
#pragma once

#include "stability/sky_of.h"

#include <aureole/setting.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <vector>

namespace aureole::stability {

inline constexpr int frames = 2000;
inline constexpr int window = 10;  // neighbouring frames of a part of the sequence

struct Frame {
    double altitude_m, sun_elevation_deg;
};
using Sequence = Frame (*)(double share);

inline Frame climb(double share) { return {std::exp(std::log(1e-2) + share * std::log(1e11)), 25}; }
inline Frame climb_at_dusk(double share) { return {std::exp(std::log(1e-2) + share * std::log(1e11)), -3}; }
inline Frame set(double share) { return {1.8, 90 - 108 * share}; }
inline Frame set_from_a_plane(double share) { return {11e3, 90 - 108 * share}; }

inline constexpr std::size_t up = 5, down = 3;  // of each azimuth
inline bool is_low(std::size_t i) { return i % (up + down) < 2 || i % (up + down) >= up; }

/// Between the horizon and straight up, or what is left of that beside the planet: the limb of the air; and down.
inline std::vector<glm::dvec3> directions(const Planet& planet, double altitude_m) {
    const double horizon = horizon_zenith(planet.bottom_radius_m, altitude_m);
    const double above_top = altitude_m - (planet.top_radius_m - planet.bottom_radius_m);
    const double highest = above_top > 0 ? horizon_zenith(planet.top_radius_m, above_top) : 0;
    std::vector<glm::dvec3> all;
    for (const double azimuth_deg : {4.0, 90.0, 176.0}) {
        for (const double share : {0.002, 0.02, 0.1, 0.4, 0.8})
            all.push_back(physics::direction(horizon + share * (highest - horizon), azimuth_deg * physics::degree));
        for (const double share : {0.002, 0.05, 0.5})
            all.push_back(physics::direction(horizon + share * (physics::pi - horizon), azimuth_deg * physics::degree));
    }
    return all;
}

/// How far a frame is from the middle between its neighbours, relative, and how much farther than the scene itself is, then or
/// a frame before or after: what does not come from a steady change, nor from a sudden one of the scene. Left aside are rays to
/// the ground and just above the horizon as the sun sets: to the air the sun is a point, and the planet's shadow falls on all
/// of such a ray in one frame.
class Jumps {
public:
    void next(const std::vector<Rgb>& seen, const std::vector<Rgb>& scene, bool sun_sets) {
        seen_.push_back(seen);
        scene_.push_back(scene);
        if (seen_.size() < 5) return;
        for (std::size_t i = 0; i < seen.size(); ++i)
            for (int c = 0; c < 3 && !(sun_sets && is_low(i)); ++c) {
                const double steady = std::max({jump(scene_, 1, i, c), jump(scene_, 2, i, c), jump(scene_, 3, i, c)});
                worst_ = std::max(worst_, jump(seen_, 2, i, c) - steady);
            }
        seen_.erase(seen_.begin());
        scene_.erase(scene_.begin());
    }
    void cut() {
        seen_.clear();
        scene_.clear();
    }
    [[nodiscard]] double worst() const { return worst_; }

private:
    using Frames = std::vector<std::vector<Rgb>>;
    static double jump(const Frames& f, std::size_t at, std::size_t i, int c) {
        const double before = f[at - 1][i][c], now = f[at][i][c], after = f[at + 1][i][c];
        const double least = 1e-4 * brightest(f[at]) + 1e-10;
        return std::abs(now - (before + after) / 2) / std::max({before, now, after, least});
    }
    Frames seen_, scene_;
    double worst_ = 0;
};
/// The part of a sunset in which it leaves rays aside.
inline bool sun_sets(const Frame& f) { return f.sun_elevation_deg < 0.2 && f.sun_elevation_deg > -1; }

struct Flight {
    const char* name;
    Sequence at;
};
inline constexpr Flight flights[] = {
    {"climb by day", climb}, {"climb at dusk", climb_at_dusk}, {"sunset", set}, {"sunset from a plane", set_from_a_plane}};

inline int frames_wanted() {
    const char* text = std::getenv("AUREOLE_STABILITY_CASES");
#ifdef __SANITIZE_ADDRESS__
    constexpr int quick = 30;  // each takes many times as long
#else
    constexpr int quick = 120;
#endif
    return std::clamp(text != nullptr ? std::atoi(text) : quick, window, frames);
}

class Show {
public:
    Show(physics::Machine& machine, const Setting& setting) : ready_(prepare(setting, presets::earth()).value()) {
        physics::SkyOptions options;
        options.model = ready_.model;
        sky_ = std::make_unique<physics::Sky>(machine, ready_.air, options);
    }
    std::vector<Rgb> frame(const Frame& f) {
        sky_->stand(f.altitude_m, physics::sun_at((90 - f.sun_elevation_deg) * physics::degree, 0.00465));
        return sky_->radiance(directions(ready_.air.planet, f.altitude_m));
    }

private:
    Prepared ready_;
    std::unique_ptr<physics::Sky> sky_;
};

}  // namespace aureole::stability
