#include "viewer/core/curves.h"

#include <aureole/camera.h>
#include <aureole/light.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aureole::viewer {
namespace {

constexpr int altitudes = 128;
constexpr int suns_at_once = 4;
constexpr double radians_per_degree = std::numbers::pi / 180;

/// Where there is air worth a plot.
double highest_m(const AtmosphereParameters& air) {
    double highest = 0;
    for (const DensityTerm& term : air.terms) {
        if (const auto* p = std::get_if<ExponentialProfile>(&term.profile))
            highest = std::max(highest, 10 * p->scale_height_m);
        else if (const auto* p = std::get_if<TentProfile>(&term.profile))
            highest = std::max(highest, p->center_m + p->half_width_m);
        else
            highest = std::max(highest, std::get<TabulatedProfile>(term.profile).altitude_m.back());
    }
    const double top = air.planet.top_radius_m - air.planet.bottom_radius_m;
    return highest > 0 ? std::min(highest, top) : top;
}

/// Elevations that are close where the air is thick: -2 to 90 degrees.
std::vector<double> elevations() {
    std::vector<double> result;
    constexpr int count = 32;
    for (int i = 0; i < count; ++i) {
        const double t = static_cast<double>(i) / (count - 1);
        result.push_back(-2 + 92 * t * t);
    }
    return result;
}

}  // namespace

Curves profiles_of(const AtmosphereParameters& air) {
    Curves curves;
    const double top = highest_m(air);
    for (int i = 0; i < altitudes; ++i) {
        const double altitude = top * i / (altitudes - 1);
        const MediumSample medium = sample_medium(air, altitude);
        curves.altitude_m.push_back(altitude);
        curves.scattering_per_m.push_back(medium.scattering_per_m);
        curves.extinction_per_m.push_back(medium.extinction_per_m);
    }
    return curves;
}

Curves curves_of(app::Backend& backend, Atmosphere& air, double altitude_m) {
    Curves curves = profiles_of(air.parameters());
    View view(air, {.max_suns = suns_at_once, .aerial_perspective = false});
    app::DeviceTextures textures(backend);
    const Camera camera = look(air.parameters().planet.bottom_radius_m, altitude_m, 0, 0, 1, 1);
    const std::vector<double> all = elevations();
    for (std::size_t first = 0; first < all.size(); first += suns_at_once) {
        std::vector<Sun> suns;
        for (std::size_t i = first; i < first + suns_at_once; ++i) {
            const double e = all[i] * radians_per_degree;
            suns.push_back({{std::cos(e), 0, std::sin(e)}, Rgb(1), 0});
        }
        view.update(camera, suns);
        backend.run([&](rhi::CommandList& commands) { view.record(commands); });
        const LightTable light = textures.read_light(view, suns_at_once);
        for (int s = 0; s < suns_at_once; ++s) {
            curves.sun_elevation_deg.push_back(all[first + static_cast<std::size_t>(s)]);
            curves.transmittance.push_back(light.sun_irradiance(s));
        }
    }
    return curves;
}

}  // namespace aureole::viewer
