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
enum class DepthRange : std::uint8_t { zero_to_one, minus_one_to_one };
enum class RowOrder : std::uint8_t {
    top_first,     ///< Row 0 of the target is where clip-space y points up (+1): y up in clip space, D3D and GL-on-screen.
    bottom_first,  ///< Row 0 is where clip-space y is -1: Vulkan's clip space with an unflipped projection, GL textures.
};

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
    Projection kind = Projection::matrix;
    DepthRange depth_range = DepthRange::zero_to_one;
    RowOrder row_order = RowOrder::top_first;
};

/// Throws Error(invalid_argument) naming the field.
void validate(const Camera& camera);

/// A camera `altitude_m` above the ground, for tools and tests: the planet's +z pole is up, forward has the given azimuth
/// (counter-clockwise from +x, seen from above) and elevation. Vertical field of view in radians; reversed infinite depth.
[[nodiscard]] Camera look(double bottom_radius_m, double altitude_m, double azimuth_rad, double elevation_rad,
                          double vertical_fov_rad, double aspect, double near_m = 0.1);

}  // namespace aureole
