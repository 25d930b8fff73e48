// What was measured of every setting (docs/measure.md), compactly: what the planner knows. The figures are in
// measured_*.inc, which `aureole fit` writes.
#pragma once

#include "plan/situation.h"
#include "plan/work.h"

#include <aureole/setting.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace aureole::detail {

/// An error in each scene, as its natural logarithm in thousandths; `unknown` where there is none.
struct MeasuredError {
    static constexpr std::int16_t unknown = std::numeric_limits<std::int16_t>::min();
    double spread = 0;  ///< Of the logarithm: root of the variance that Kriging's variances are shares of.
    std::vector<std::int16_t> by_scene;

    /// Tables from before an error was measured have no scenes of it.
    [[nodiscard]] bool is_known(std::size_t scene) const { return scene < by_scene.size() && by_scene[scene] != unknown; }
    /// As it was measured (of MeasuredSkies::bare: over its share); none where it was not.
    [[nodiscard]] std::optional<double> in(std::size_t scene) const {
        if (!is_known(scene)) return {};
        return std::exp(by_scene[scene] / 1000.0);
    }
    [[nodiscard]] static std::int16_t pack(double error) {
        return static_cast<std::int16_t>(std::lround(1000 * std::log(std::min(std::max(error, 1e-9), 1e9))));
    }
};

/// Of pictures whose costs are measured.
inline constexpr std::uint32_t measured_width = 1280, measured_height = 720;

/// In one air, on the machine where all were measured; milliseconds of that many pixels.
struct MeasuredCost {
    double composite_ms = 0;           ///< Of sky alone.
    double composite_geometry_ms = 0;  ///< Over a host's colour and depth.
    double view_ms = 0;                ///< Tables of the camera, without those of geometry and light.
    double aerial_perspective_ms = 0, light_ms = 0;
    double rebuild_ms = 0;  ///< Tables of the air.
    double air_mib = 0;     ///< Memory of those; 0: not measured in this air.
    double view_mib = 0;    ///< Of a view's tables, for one sun, without those of geometry.
    double aerial_perspective_mib = 0;
    double composite_sun_ms = 0;      ///< What each further sun adds to a composite.
    double shadows_ms = 0;            ///< The pass; 0 of models that have none, as the next two.
    double composite_shadows_ms = 0;  ///< What they add to a composite over a host's colour and depth.
    double shadows_mib = 0;
    TableWork work{};  ///< Of the setting in this air.
    /// Over a host's colour and depth, without the air before geometry; 0: not measured, as composite_geometry_ms.
    double composite_bare_ms = 0;
};

/// Errors of geometry are kept by its distance: near, up to near_geometry_km, and far.
inline constexpr double nearest_geometry_km = 1, near_geometry_km = 10, farthest_geometry_km = 100;
/// They are of geometry as bright as such ground under the scene's sun.
inline constexpr double geometry_albedo = 0.19;
/// Distances at which it is known what leaving the air before geometry out errs by.
inline constexpr std::array bare_distances_km{0.01, 0.0316, 0.1, 0.316, 1.0, 3.16, 10.0, 31.6};

struct MeasuredSetting {
    Setting setting;
    MeasuredError sky_median, sky_p95, aerial_p95;
    MeasuredError light;  ///< For a host's materials: of the sky's illuminance or of the sun's colour, whichever errs more.
    std::vector<MeasuredCost> by_air;
    /// Of aerial_p95 the near and the far geometry; tables from before they were told apart have neither.
    MeasuredError aerial_near_p95{}, aerial_far_p95{};
};
inline constexpr std::array measured_errors{&MeasuredSetting::sky_median,     &MeasuredSetting::sky_p95,
                                            &MeasuredSetting::aerial_p95,     &MeasuredSetting::aerial_near_p95,
                                            &MeasuredSetting::aerial_far_p95, &MeasuredSetting::light};

/// What leaving the air before geometry out errs by goes with it: in air of so much extinction the share of light that does
/// not come through. (What is left is how bright the air is beside geometry, which differs less from air to air.)
[[nodiscard]] inline double bare_share(double extinction_per_m, double distance_km) {
    return -std::expm1(-1000 * extinction_per_m * distance_km);
}

/// Errors of geometry up to this far away, in a view with aerial perspective: the worst of them counts. The others are null.
[[nodiscard]] std::array<const MeasuredError*, 2> errors_of_geometry(const MeasuredSetting& setting, double range_m);

struct MeasuredScene {
    std::string id;
    std::size_t air = 0;  ///< Index of MeasuredSkies::airs.
    double sun_elevation_deg = 0, altitude_m = 0;
    Situation situation{};
};

struct MeasuredSkies {
    std::string device;   ///< That the costs were measured on.
    Situation lengths{};  ///< Of Kriging.
    double margin = 0;    ///< So many standard deviations of an estimate are added for an upper bound.
    std::vector<std::string> airs;
    std::vector<MeasuredScene> scenes;
    std::vector<MeasuredSetting> settings;
    /// Of geometry that is shown as the host drew it, at each of bare_distances_km: 95th percentiles, the same of all settings,
    /// over bare_share there.
    std::array<MeasuredError, bare_distances_km.size()> bare{};
};

/// The figures that come with the library: of scenes in red, green and blue, and of scenes in wavelengths.
[[nodiscard]] const MeasuredSkies& measured_in_rgb();
[[nodiscard]] const MeasuredSkies& measured_in_wavelengths();

}  // namespace aureole::detail
