#include <aureole/camera.h>

#include "camera/rays.h"
#include "common/check.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace aureole {
namespace {

constexpr double farthest_m = 1e13;

void check_position(const glm::dvec3& position) {
    detail::check_xyz("camera.position_m", position, -farthest_m, farthest_m);
    const double distance = std::hypot(position.x, position.y, position.z);
    if (!(distance >= 1e-6 && distance <= farthest_m))
        detail::reject("camera.position_m", detail::print(distance) + " m from the centre",
                       detail::range_text(1e-6, farthest_m) + " m");
}

void check_view(const glm::dmat4& view) {
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            detail::check(detail::FieldName("camera.view")[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)],
                          view[column][row], -2, 2);
    const glm::dmat3 rotation(view);
    const glm::dmat3 gram = glm::transpose(rotation) * rotation;
    double worst = 0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) worst = std::max(worst, std::abs(gram[column][row] - (column == row ? 1 : 0)));
    if (worst > 1e-3)
        detail::reject("camera.view", "a matrix whose axes are " + detail::print(worst) + " off length 1 and right angles",
                       "a rotation: off by at most 0.001");
}

}  // namespace

void validate(const Camera& camera) {
    check_position(camera.position_m);
    check_view(camera.view);
    detail::check_enum("camera.kind", camera.kind, Projection::fisheye, "matrix, panorama or fisheye");
    detail::check_enum("camera.depth_range", camera.depth_range, DepthRange::minus_one_to_one,
                       "zero_to_one or minus_one_to_one");
    detail::check_enum("camera.row_order", camera.row_order, RowOrder::bottom_first, "top_first or bottom_first");
    if (camera.kind == Projection::matrix) detail::check_projection(camera.projection);
}

Camera look(double bottom_radius_m, double altitude_m, double azimuth_rad, double elevation_rad, double vertical_fov_rad,
            double aspect, double near_m) {
    detail::check("bottom_radius_m", bottom_radius_m, 1e3, 1e12);
    detail::check("altitude_m", altitude_m, -bottom_radius_m / 2, farthest_m - bottom_radius_m);
    detail::check("azimuth_rad", azimuth_rad, -1e6, 1e6);
    detail::check("elevation_rad", elevation_rad, -1.5707963267948968, 1.5707963267948968);
    detail::check("vertical_fov_rad", vertical_fov_rad, 1e-6, 3.14);
    detail::check("aspect", aspect, 1e-3, 1e3);
    detail::check("near_m", near_m, 1e-6, 1e9);

    const double ca = std::cos(azimuth_rad), sa = std::sin(azimuth_rad);
    const double ce = std::cos(elevation_rad), se = std::sin(elevation_rad);
    const glm::dvec3 forward(ce * ca, ce * sa, se), top(-se * ca, -se * sa, ce), right(sa, -ca, 0);

    Camera camera;
    camera.position_m = {0, 0, bottom_radius_m + altitude_m};
    const glm::dmat3 rotation = glm::transpose(glm::dmat3(right, top, -forward));
    camera.view = glm::dmat4(rotation);
    camera.view[3] = glm::dvec4(-(rotation * camera.position_m), 1);
    const double focal = 1 / std::tan(vertical_fov_rad / 2);
    camera.projection = glm::dmat4(0);  // reversed infinite depth: clip z = near, clip w = depth
    camera.projection[0][0] = focal / aspect;
    camera.projection[1][1] = focal;
    camera.projection[2][3] = -1;
    camera.projection[3][2] = near_m;
    return camera;
}

}  // namespace aureole
