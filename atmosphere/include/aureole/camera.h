// Where a view looks from and how its pixels map to rays.
#pragma once

#include <aureole/rhi/error.h>

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace aureole {

/// How pixel coordinates become directions.
enum class Projection : std::uint8_t {
    matrix,    ///< `Camera::projection`: perspective (any depth convention, off-axis too) or orthographic.
    panorama,  ///< Equirectangular: x is azimuth (centre: forward), y from zenith (top) to nadir.
    fisheye,   ///< Equidistant, upper hemisphere in the inscribed circle, forward at the top; black outside it.
};
/// Clip-space depth between the near and the far plane, as `Camera::projection` makes it.
enum class DepthRange : std::uint8_t {
    zero_to_one,       ///< Vulkan, D3D, Metal, and GL with glClipControl. Stored as it is.
    minus_one_to_one,  ///< GL: stored as half of it, plus a half.
};
/// Where row 0 of the target (and of colour and depth) is in clip space. In Vulkan the viewport decides, never the projection:
/// its sign is read from the matrix.
enum class RowOrder : std::uint8_t {
    top_first,     ///< Where clip-space y is +1: D3D, Metal, Vulkan with a viewport of negative height, GL on screen.
    bottom_first,  ///< Where it is -1: Vulkan with a viewport of positive height, whatever the projection; GL textures.
};

/// A value out of range is Error(invalid_argument) from `validate` and View::update.
/// Axes: any right-handed world axes with the origin at the planet's centre. There is no fixed up axis: up at the camera is
/// its direction from the centre. View space is right-handed with -z forward, as in OpenGL and GLM.
struct Camera {
    glm::dvec3 position_m{0, 0, 6.36e6 + 2};  ///< From the planet's centre. At a distance in [1e-6, 1e13] m. Below the ground
                                              ///< is allowed: the view is then that of a camera on the ground above it.
    glm::dmat4 view{1.0};                     ///< World to view; only its rotation is used (must be orthonormal within 1e-3).
    /// View (metres) to clip; forward, reversed or infinite depth, perspective or orthographic. Must be invertible in x and y,
    /// with rays that meet at the position (off-axis and jittered ones are fine, oblique near planes are not). Ignored by
    /// panorama and fisheye, where every pixel is sky.
    glm::dmat4 projection{1.0};
    Projection kind = Projection::matrix;  ///< Of the picture; a View takes cameras of ViewSettings::projection alone.
    DepthRange depth_range = DepthRange::zero_to_one;  ///< Of `projection`. Ignored by panorama and fisheye.
    RowOrder row_order = RowOrder::top_first;          ///< Of the target, and of the host's colour and depth.
};

/// Throws Error(invalid_argument) naming the field.
void validate(const Camera& camera);

/// A camera `altitude_m` above the ground, for tools and tests: the planet's +z pole is up, forward has the given azimuth
/// (counter-clockwise from +x, seen from above) and elevation. Reversed infinite depth in [0, 1], the first row the top one
/// (DepthRange::zero_to_one, RowOrder::top_first): change these members after it. bottom_radius_m in [1e3, 1e12],
/// altitude_m from half of it below the ground to 1e13 m from the centre, azimuth in [-1e6, 1e6], elevation in [-pi/2, pi/2],
/// vertical_fov_rad in [1e-6, 3.14], aspect (width / height) in [1e-3, 1e3], near_m in [1e-6, 1e9]; else
/// Error(invalid_argument).
[[nodiscard]] Camera look(double bottom_radius_m, double altitude_m, double azimuth_rad, double elevation_rad,
                          double vertical_fov_rad, double aspect, double near_m = 0.1);

}  // namespace aureole
