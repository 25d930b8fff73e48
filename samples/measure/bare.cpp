#include "measure/bare.h"

#include "common/host_air.h"
#include "quadrature/gauss_legendre.h"

#include <algorithm>
#include <cmath>

namespace aureole::app {
namespace {

constexpr double reach = 3.17;  // from one distance to the next

/// What the air takes along rays from one place.
class Rays {
public:
    Rays(const AtmosphereParameters& air, double altitude_km)
        : air_(detail::pack_exact(air)),
          altitude_km_(std::max(altitude_km, 0.0)),
          radius_km_(air.planet.bottom_radius_m / 1000 + altitude_km_),
          thickness_km_((air.planet.top_radius_m - air.planet.bottom_radius_m) / 1000) {}

    /// Of what the air changes up to a pixel's geometry, what it has changed at `nearer_km`.
    [[nodiscard]] Rgb share(const AerialPixel& pixel, double nearer_km) {
        const Rgb near = optical_depth(pixel.mu, nearer_km), far = optical_depth(pixel.mu, pixel.distance_km);
        Rgb result;
        for (int c = 0; c < 3; ++c)
            result[c] = far[c] > 0 ? std::expm1(-near[c]) / std::expm1(-far[c]) : nearer_km / pixel.distance_km;
        return result;
    }

private:
    [[nodiscard]] Rgb optical_depth(double mu, double distance_km) {
        static const detail::GaussLegendre rule = detail::gauss_legendre(8);
        constexpr int pieces = 8;
        Rgb depth(0);
        for (int i = 0; i < pieces; ++i)
            depth += rule.integrate(distance_km * i / pieces, distance_km * (i + 1) / pieces,
                                    [&](double s) { return extinction_per_km(mu, s); });
        return depth;
    }
    [[nodiscard]] Rgb extinction_per_km(double mu, double s) {
        const double rise = s * (s + 2 * radius_km_ * mu);  // of the squared radius: no difference of two that are alike
        const double up = rise / (std::sqrt(std::max(radius_km_ * radius_km_ + rise, 0.0)) + radius_km_);
        const double altitude = std::max(altitude_km_ + up, 0.0);
        return altitude > thickness_km_ ? Rgb(0) : Rgb(air_.formulas().sample_medium(altitude).extinction);
    }

    detail::HostAir air_;
    double altitude_km_, radius_km_, thickness_km_;
};

}  // namespace

Rgb brought_nearer(const AtmosphereParameters& air, double altitude_km, const AerialPixel& pixel, double nearer_km,
                   const Rgb& shown, const Rgb& truth) {
    return shown + Rays(air, altitude_km).share(pixel, nearer_km) * (truth - shown);
}

BareErrors bare_errors(const AtmosphereParameters& air, const Place& place) {
    const AerialView& view = place.aerial.value();
    const std::vector<AerialPixel> pixels = aerial_geometry(air.planet, view);
    Rays rays(air, view.altitude_km);
    const Rgb shown(geometry_radiance(view.sun_zenith_deg));
    BareErrors result;
    for (std::size_t i = 0; i < result.size(); ++i) {
        const double at = detail::bare_distances_km[i], from = std::max(at, aerial_nearest_km);
        std::vector<double> errors;
        for (std::size_t k = 0; k < place.pixels.size(); ++k) {
            const auto& [distance, mu] = pixels[place.pixels[k]];
            if (distance < from || distance >= reach * from) continue;
            ++result[i].asked;
            TrueValue truth = place.truth[place.points.size() + k];
            if (!relative_error(shown, truth)) continue;
            const Rgb part = rays.share({distance, mu}, at);
            truth = {shown + part * (truth.value - shown), part * truth.error};
            if (const auto error = relative_error(shown, truth)) errors.push_back(*error);
        }
        result[i].error = summarize(std::move(errors));
    }
    return result;
}

}  // namespace aureole::app
