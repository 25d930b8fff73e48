#include "camera/pack_view.h"

#include "camera/rays.h"
#include "common/check.h"
#include "parameters/validate.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace aureole::detail {
namespace {

using ExactView = Blocks<double>::ViewBlock;
using glm::dvec3, glm::dvec4;

/// hypot neither overflows nor underflows.
double length_of(const dvec3& v) { return std::hypot(v.x, v.y, v.z); }
dvec3 unit(const dvec3& v) { return glm::normalize(v / length_of(v)); }

/// Angle below the horizontal at which a sphere of radius `radius` is grazed from `height` above it. From the tangent's length
/// sqrt(h (2 R + h)): exact for a camera a centimetre up, where an arc cosine would find nothing.
double dip(double height, double radius) { return std::atan2(std::sqrt(height * (2 * radius + height)), radius); }

void pack_place(const Camera& camera, const Planet& planet, const dvec3& up, ExactView& view) {
    const double shell = planet.top_radius_m - planet.bottom_radius_m;
    const double altitude = std::max(length_of(camera.position_m) - planet.bottom_radius_m, 0.0);
    const bool above = altitude > shell;
    const double in_air = std::min(altitude, shell);
    view.camera = {in_air * 1e-3, 0, 0, above ? 1 : 0};
    const double top_dip = above ? dip(altitude - shell, planet.top_radius_m) : -std::numbers::pi / 2;
    const double seen_dip = dip(altitude, planet.bottom_radius_m);
    view.space = {altitude * 1e-3, top_dip, seen_dip, 0};
    const double upper = above ? seen_dip - top_dip : std::numbers::pi / 2 + seen_dip;
    const double lower = std::numbers::pi / 2 - seen_dip;
    view.horizon = {std::cos(seen_dip), std::sin(seen_dip), 1 / (2 * std::sin(upper / 2)), 1 / (2 * std::sin(lower / 2))};

    // East as on a globe whose axis is z, so that the frame turns with the place and not with the camera.
    dvec3 east = glm::cross(dvec3(0, 0, 1), up);
    east = glm::length(east) > 1e-6 ? glm::normalize(east) : dvec3(1, 0, 0);
    east = glm::normalize(east - up * glm::dot(east, up));
    view.up = dvec4(up, 0);
    view.east = dvec4(east, 0);
}

void pack_rays(const Camera& camera, const dvec3& up, ExactView& view) {
    const RayBasis rays = ray_basis(camera, up);
    view.ray_origin = dvec4(rays.origin, static_cast<double>(camera.kind));
    view.ray_x = dvec4(rays.along_x, 0);
    view.ray_y = dvec4(rays.along_y, 0);
    view.depth = depth_coefficients(camera);
}

/// Exponents alpha of limb darkening mu^alpha. Hestroffer & Magnan 1998 at 680, 550 and 440 nm, from Neckel & Labs 1994.
dvec3 limb_exponents(LimbDarkening limb) { return limb == LimbDarkening::none ? dvec3(0) : dvec3(0.397, 0.503, 0.652); }

// Measured by the squared chord c = 4 sin^2(theta/2) from the centre, a solid angle is exactly pi dc, so a disk of squared
// chord C covers pi C. With mu = sqrt(1 - c / C) the integral of mu^alpha over it is 2 / (alpha + 2) of that.
void pack_disk(const Sun& sun, dvec4& disk, dvec4& limb) {
    const double half = 2 * std::sin(sun.angular_radius_rad / 2);
    const double squared_chord = half * half;
    const dvec3 alpha = limb_exponents(sun.limb_darkening);
    if (squared_chord < 1e-15) {  // nothing that float directions could hit, and brighter than floats
        disk = limb = dvec4(0);
        return;
    }
    disk = dvec4((alpha + 2.0) / (2 * std::numbers::pi * squared_chord), 1 / squared_chord);
    limb = dvec4(alpha, squared_chord);
}

/// What the tables of a sun are multiplied by: a power of two (exact), 1 by day, growing as the sun sinks below the horizon by
/// the decade in 3 degrees that twilight loses at most. `elevation`: of the sun above the horizon, rad.
double table_exposure(double elevation) {
    const double decades = std::clamp(-elevation * 180 / std::numbers::pi / 3, 0.0, 6.0);
    return std::exp2(std::floor(decades * std::log2(10.0)));
}

void pack_suns(std::span<const Sun> suns, const dvec3& up, ExactView& view) {
    const dvec3 east(view.east);
    view.table_exposure = view.table_exposure_inverse = dvec4(1);
    for (std::size_t i = 0; i < static_cast<std::size_t>(max_suns); ++i) {
        view.sun_direction[i] = dvec4(up, 1);
        view.sun_azimuth[i] = dvec4(east, 0);
        view.sun_irradiance[i] = dvec4(0, 0, 0, static_cast<double>(suns.size()));
        view.sun_disk[i] = view.sun_limb[i] = dvec4(0);
        if (i >= suns.size()) continue;

        const dvec3 direction = unit(suns[i].direction);
        const double mu_s = std::clamp(glm::dot(direction, up), -1.0, 1.0);
        const dvec3 horizontal = glm::cross(up, glm::cross(direction, up));  // its length is the sine of the zenith angle
        const double sine = glm::length(horizontal);
        view.sun_direction[i] = dvec4(direction, mu_s);
        view.sun_azimuth[i] = dvec4(sine > 1e-12 ? horizontal / sine : east, sine);
        view.sun_irradiance[i] = dvec4(suns[i].irradiance, static_cast<double>(suns.size()));
        const auto component = static_cast<glm::length_t>(i);
        view.table_exposure[component] = table_exposure(std::asin(mu_s) + view.space.z);
        view.table_exposure_inverse[component] = 1 / view.table_exposure[component];
        pack_disk(suns[i], view.sun_disk[i], view.sun_limb[i]);
    }
}

void check_inputs(std::span<const Sun> suns, const ViewInputs& inputs) {
    check_count("suns", suns.size(), 0, static_cast<std::size_t>(max_suns));
    for (std::size_t i = 0; i < suns.size(); ++i) check_sun(FieldName("suns")[i], suns[i]);
    check("aerial_perspective_distance_m", inputs.aerial_perspective_distance_m, 1e-3, 1e13);
    check("exposure", inputs.exposure, 1e-30, 1e30);
}

}  // namespace

ViewBlock pack_view(const Camera& camera, std::span<const Sun> suns, const Planet& planet, const ViewInputs& inputs) {
    validate(camera);
    check_inputs(suns, inputs);

    ExactView view{};
    const dvec3 up = unit(camera.position_m);
    pack_place(camera, planet, up, view);
    pack_rays(camera, up, view);
    pack_suns(suns, up, view);
    const double distance = inputs.aerial_perspective_distance_m * 1e-3;
    view.froxels = {distance, 1 / distance, 1 / (inputs.shadow_distance_m * 1e-3), inputs.shadowed_sun};
    view.composite = {inputs.exposure, inputs.sun_lobe_g, far_depth(camera), 0};
    return round_block<ViewBlock>(view);
}

}  // namespace aureole::detail
