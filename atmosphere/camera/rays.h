// What follows from a camera's matrices: directions of pixels and depth.
#pragma once

#include <aureole/camera.h>

#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

namespace aureole::detail {

/// View to world; the inverse of the view matrix' upper left 3x3.
[[nodiscard]] glm::dmat3 view_to_world(const Camera& camera);

/// True if `projection` has parallel rays: clip-space w does not depend on the position.
[[nodiscard]] bool is_orthographic(const glm::dmat4& projection);

/// World direction of the target's point (x, y) = origin + x * along_x + y * along_y, x and y in [0, 1] from the first row's
/// first pixel's corner. Perspective: its component along the view axis is 1, so distance = view depth * length. Orthographic:
/// the same unit vector everywhere. Panorama and fisheye: three unit vectors, see common/blocks.glsl.
struct RayBasis {
    glm::dvec3 origin, along_x, along_y;
};
/// `up`: unit vector from the planet's centre to the camera.
[[nodiscard]] RayBasis ray_basis(const Camera& camera, const glm::dvec3& up);

/// (x, y, z, w): the stored depth d in [0, 1] means the view depth (x d + y) / (z d + w), km. Where the projection does not
/// tell depth (panorama, fisheye, a projection without it): (0, 1, 0, 0), infinitely far.
[[nodiscard]] glm::dvec4 depth_coefficients(const Camera& camera);

/// The stored depth of the far end, 0 or 1: what a host clears its depth to. A pixel that has it is sky, however near a finite
/// far plane is.
[[nodiscard]] double far_depth(const Camera& camera);

/// Throws Error(invalid_argument) if rays or depth cannot be had from the projection matrix.
void check_projection(const glm::dmat4& projection);

}  // namespace aureole::detail
