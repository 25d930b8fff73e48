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

    /// As it was measured; none where it was not.
    [[nodiscard]] std::optional<double> in(std::size_t scene) const {
        if (by_scene[scene] == unknown) return {};
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
};

struct MeasuredSetting {
    Setting setting;
    MeasuredError sky_median, sky_p95, aerial_p95;
    MeasuredError light;  ///< For a host's materials: of the sky's illuminance or of the sun's colour, whichever errs more.
    std::vector<MeasuredCost> by_air;
};
inline constexpr std::array measured_errors{&MeasuredSetting::sky_median, &MeasuredSetting::sky_p95,
                                            &MeasuredSetting::aerial_p95, &MeasuredSetting::light};

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
};

/// The figures that come with the library: of scenes in red, green and blue, and of scenes in wavelengths.
[[nodiscard]] const MeasuredSkies& measured_in_rgb();
[[nodiscard]] const MeasuredSkies& measured_in_wavelengths();

}  // namespace aureole::detail
