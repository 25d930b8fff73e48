// Geometry at many distances, seen through the air: by any model, and as it truly is.
#pragma once

#include "app/backend.h"
#include "app/trace.h"
#include "app/trace_checkpoint.h"
#include "plan/measured.h"

#include <aureole/atmosphere.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace aureole::app {

/// A picture of aerial_width x aerial_height pixels, rows from the top, 60 degrees high, of a camera that looks horizontally.
/// Every pixel shows geometry.
inline constexpr std::uint32_t aerial_width = 12, aerial_height = 8;
inline constexpr std::size_t aerial_pixels = std::size_t{aerial_width} * aerial_height;
inline constexpr double aerial_nearest_km = detail::nearest_geometry_km, aerial_farthest_km = detail::farthest_geometry_km;

struct AerialView {
    double sun_zenith_deg = 0;  ///< In [0, 180].
    double altitude_km = 0;     ///< Above the ground; in [-10, 1e9]. Below 0: as from the ground.
    double azimuth_deg = 0;     ///< Whither it looks, from the sun's azimuth; in [-360, 360].
};

/// Radiance of all geometry before the air, grey, in 1/sr per unit of solar irradiance: that of dark ground, lit by the sun.
[[nodiscard]] double geometry_radiance(double sun_zenith_deg);
/// Distance of each pixel's geometry along its ray, km: spread evenly over the logarithm from aerial_nearest_km to
/// aerial_farthest_km by the golden ratio and the pixel's number, but at most nine tenths of the way to the ground, and at
/// least a metre.
[[nodiscard]] std::vector<double> aerial_distances(const Planet& planet, const AerialView& view);
/// The same, with the cosine of each ray's angle from the zenith at the camera.
struct AerialPixel {
    double distance_km = 0, mu = 0;
};
[[nodiscard]] std::vector<AerialPixel> aerial_geometry(const Planet& planet, const AerialView& view);

/// What is the same for all views, by name: what a table of their pixels must say.
[[nodiscard]] TraceParameters aerial_parameters();

/// Radiance of each pixel of each view in 1/sr per unit of solar irradiance: the composite's, without the sun's disk. Froxels
/// reach to aerial_farthest_km. Throws Error(invalid_argument) naming the view (from 1), (internal) where a value is not
/// finite.
[[nodiscard]] std::vector<std::vector<Rgb>> aerial(Backend& backend, const AtmosphereParameters& parameters,
                                                   const ModelPtr& model, std::span<const AerialView> views);
/// The same of an atmosphere whose tables have been recorded (app/solution.h).
[[nodiscard]] std::vector<std::vector<Rgb>> aerial(Backend& backend, Atmosphere& air, std::span<const AerialView> views);

struct AerialTruth {
    std::vector<Estimated> pixels;     ///< As `aerial` gives them.
    std::vector<std::uint64_t> paths;  ///< Of each.
    bool reached = false;              ///< Every error is as small as wanted; false where max_paths came first.
};

/// The same by path tracing, in rounds of trace_batch_paths paths a pixel, until each pixel's standard error is as small as
/// settings.error wants; the first order is found without paths. The result depends on settings.seed, not on threads nor on
/// when other pixels are done. Of the settings max_paths is that of a pixel, and orders is 0. `progress` is told how much is
/// done, in [0, 1]; none if `stop` says so, which is asked before each composite. Errors as above, and of TraceSettings.
[[nodiscard]] std::optional<AerialTruth> trace_aerial(Backend& backend, const AtmosphereParameters& parameters,
                                                      const AerialView& view, const TraceSettings& settings,
                                                      const std::function<void(double)>& progress = {},
                                                      const std::function<bool()>& stop = {});

}  // namespace aureole::app
