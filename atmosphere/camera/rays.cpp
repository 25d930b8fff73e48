#include "camera/rays.h"

#include "common/check.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace aureole::detail {
namespace {

// GLM's matrices are indexed [column][row].
glm::dvec3 row_xyz(const glm::dmat4& m, int row) { return {m[0][row], m[1][row], m[2][row]}; }

/// Rows x, y and w of the projection, without translation: maps a view direction d to (clip x, clip y, clip w).
glm::dmat3 clip_rows(const glm::dmat4& projection) {
    return glm::transpose(glm::dmat3(row_xyz(projection, 0), row_xyz(projection, 1), row_xyz(projection, 3)));
}

/// How far from singular, whatever the rows' scales: the volume spanned by their unit vectors.
double independence(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const double scale = glm::length(a) * glm::length(b) * glm::length(c);
    return scale > 0 ? std::abs(glm::dot(a, glm::cross(b, c))) / scale : 0;
}

/// View-space direction along which all points fall on one pixel of an orthographic projection, away from the camera.
glm::dvec3 parallel_direction(const glm::dmat4& projection) {
    const glm::dvec3 d = glm::cross(row_xyz(projection, 0), row_xyz(projection, 1));
    return glm::normalize(d.z < 0 ? d : -d);
}

/// Clip-space y of the first row, and its change down to the last one.
glm::dvec2 clip_y(RowOrder order) { return order == RowOrder::top_first ? glm::dvec2(1, -2) : glm::dvec2(-1, 2); }

RayBasis matrix_basis(const Camera& camera) {
    const glm::dmat3 to_world = view_to_world(camera);
    if (is_orthographic(camera.projection))
        return {glm::normalize(to_world * parallel_direction(camera.projection)), glm::dvec3(0), glm::dvec3(0)};
    // Points at view direction d have clip (x, y, w) = rows * d, so the ray of (x / w, y / w) is rows^-1 (x / w, y / w, 1):
    // affine.
    const glm::dmat3 to_view = glm::inverse(clip_rows(camera.projection));
    const double depth = -to_view[2].z;  // of the ray with w = 1, the same for all since w depends on depth alone
    const glm::dmat3 to_ray = to_world * (to_view / depth);
    const glm::dvec2 y = clip_y(camera.row_order);
    return {to_ray * glm::dvec3(-1, y.x, 1), to_ray[0] * 2.0, to_ray[1] * y.y};
}

/// The horizontal direction that the camera faces. One that looks straight up or down faces where the lower or upper edge of
/// its picture points: the limit of tilting it there.
glm::dvec3 heading(const glm::dmat3& to_world, const glm::dvec3& up) {
    const glm::dvec3 forward = -to_world[2], top = to_world[1];
    const auto horizontal = [&](const glm::dvec3& v) { return v - up * glm::dot(v, up); };
    const glm::dvec3 flat = horizontal(forward);
    if (glm::length(flat) > 1e-6) return glm::normalize(flat);
    return glm::normalize(horizontal(glm::dot(forward, up) > 0 ? -top : top));
}

}  // namespace

glm::dmat3 view_to_world(const Camera& camera) { return glm::inverse(glm::dmat3(camera.view)); }

bool is_orthographic(const glm::dmat4& projection) {
    return glm::length(row_xyz(projection, 3)) <= 1e-12 * std::abs(projection[3][3]);
}

RayBasis ray_basis(const Camera& camera, const glm::dvec3& up) {
    if (camera.kind == Projection::matrix) return matrix_basis(camera);
    const glm::dvec3 ahead = heading(view_to_world(camera), up);
    const glm::dvec3 right = glm::cross(ahead, up);
    const double rows = camera.row_order == RowOrder::top_first ? 1 : -1;
    if (camera.kind == Projection::panorama) return {ahead, right, rows * up};
    // Seen from below with forward at the top, what is to the right of the camera lies to the left.
    return {rows * ahead, -right, up};
}

// With clip z = a z + b and clip w = c z + e for view-space z = -depth: the depth buffer's ndc = (a z + b) / (c z + e), hence
// depth = (ndc e - b) / (ndc c - a). A depth range of [-1, 1] is stored as (ndc + 1) / 2: substitute ndc = 2 d - 1.
glm::dvec4 depth_coefficients(const Camera& camera) {
    const glm::dvec4 infinitely_far(0, 1, 0, 0);
    if (camera.kind != Projection::matrix) return infinitely_far;
    const glm::dmat4& p = camera.projection;
    const double a = p[2][2], b = p[3][2], c = p[2][3], e = p[3][3];
    if (a * e == b * c) return infinitely_far;
    glm::dvec4 m(e, -b, c, -a);
    if (camera.depth_range == DepthRange::minus_one_to_one) m = {2 * m.x, m.y - m.x, 2 * m.z, m.w - m.z};
    // Scale for float, and sign so that the denominator is positive between the planes: then 0 there means +infinity.
    const double scale = std::max(std::abs(m.z), std::abs(m.w));
    const double sign = m.z * 0.5 + m.w < 0 ? -1 : 1;
    m *= sign / scale;
    return glm::dvec4(m.x * 1e-3, m.y * 1e-3, m.z, m.w) + 0.0;  // + 0 turns -0 into 0
}

double far_depth(const Camera& camera) {
    const glm::dvec4 m = depth_coefficients(camera);
    // Of the distances (x d + y) / (z d + w) at 0 and 1, whose denominators are not negative, the greater; it may be infinite.
    return m.y * (m.z + m.w) > (m.x + m.y) * m.w ? 0 : 1;
}

void check_projection(const glm::dmat4& p) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            check(FieldName("camera.projection")[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)],
                  p[column][row], -1e30, 1e30);
    const glm::dvec3 x = row_xyz(p, 0), y = row_xyz(p, 1), z = row_xyz(p, 2), w = row_xyz(p, 3);
    constexpr double tiny = 1e-9;
    const bool parallel = is_orthographic(p);
    const bool invertible = parallel ? p[3][3] > 0 && independence(x, y, {0, 0, 1}) > tiny : independence(x, y, w) > tiny;
    if (!invertible)
        reject("camera.projection", "a matrix that is singular in x, y and w", "one that maps directions to pixels one to one");
    // Depth along the axis must be what tells clip w and clip z, or depth is not a function of the depth buffer's value.
    const auto on_axis = [](const glm::dvec3& v) { return std::abs(v.x) + std::abs(v.y) <= 1e-6 * std::abs(v.z); };
    if (!parallel && !on_axis(w))
        reject("camera.projection", "clip w that depends on view x or y", "clip w that depends on view z alone");
    if (z != glm::dvec3(0) && !on_axis(z))
        reject("camera.projection", "an oblique near plane (clip z depends on view x or y)",
               "clip z that depends on view z alone");
    if (!parallel) {
        const glm::dvec3 eye = -(glm::inverse(clip_rows(p)) * glm::dvec3(p[3][0], p[3][1], p[3][3]));
        if (glm::length(eye) > 1e-3)
            reject("camera.projection", "rays that meet " + print(glm::length(eye)) + " m from the camera's position",
                   "rays that meet at the position (move the camera instead)");
    }
}

}  // namespace aureole::detail
