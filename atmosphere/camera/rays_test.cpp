#include "camera/rays.h"

#include <aureole/camera.h>

#include <doctest/doctest.h>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_projection.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

using namespace aureole;
using namespace aureole::detail;
using glm::dvec2, glm::dvec3, glm::dvec4, glm::dmat3, glm::dmat4;

namespace {

constexpr double pi = std::numbers::pi;

/// A rotation that is aligned with nothing.
dmat4 some_view() { return glm::lookAt(dvec3(0), dvec3(0.3, -0.8, 0.5), dvec3(0.2, 0.1, 1)); }

struct Case {
    std::string name;
    dmat4 projection;
    DepthRange range;
    bool orthographic;
};

dmat4 reversed_infinite(double near_m) {
    dmat4 p(0.0);
    p[0][0] = 1.2, p[1][1] = 1.7, p[2][3] = -1, p[3][2] = near_m;
    return p;
}

std::vector<Case> cases() {
    const DepthRange zo = DepthRange::zero_to_one, no = DepthRange::minus_one_to_one;
    return {
        {"forward", glm::perspectiveRH_ZO(1.0, 1.5, 0.5, 500.0), zo, false},
        {"reversed", glm::perspectiveRH_ZO(1.0, 1.5, 500.0, 0.5), zo, false},
        {"forward, -1 to 1", glm::perspectiveRH_NO(1.0, 1.5, 0.5, 500.0), no, false},
        {"reversed, -1 to 1", glm::perspectiveRH_NO(1.0, 1.5, 500.0, 0.5), no, false},
        {"infinite, -1 to 1", glm::infinitePerspective(1.0, 1.5, 0.5), no, false},
        {"reversed infinite", reversed_infinite(0.5), zo, false},
        {"off-axis", glm::frustumRH_ZO(-0.3, 0.7, -0.1, 0.4, 0.5, 500.0), zo, false},
        {"off-axis, scaled by 3", 3.0 * glm::frustumRH_NO(-0.3, 0.7, -0.1, 0.4, 0.5, 500.0), no, false},
        {"y flipped in the projection", glm::scale(dmat4(1.0), dvec3(1, -1, 1)) * glm::perspectiveRH_ZO(1.0, 1.5, 0.5, 500.0),
         zo, false},
        {"orthographic", glm::orthoRH_ZO(-30.0, 50.0, -10.0, 20.0, 0.5, 500.0), zo, true},
        {"orthographic, reversed", glm::orthoRH_ZO(-30.0, 50.0, -10.0, 20.0, 500.0, 0.5), zo, true},
        {"orthographic, -1 to 1", glm::orthoRH_NO(-30.0, 50.0, -10.0, 20.0, 0.5, 500.0), no, true},
    };
}

/// View-space point at (x, y, depth) of the target, by GLM. Its window has y up: row 0 first is clip y = -1.
dvec3 unproject(const Case& c, RowOrder order, dvec3 point) {
    if (order == RowOrder::top_first) point.y = 1 - point.y;
    const dvec4 window(0, 0, 1, 1);
    return c.range == DepthRange::zero_to_one ? glm::unProjectZO(point, dmat4(1.0), c.projection, window)
                                              : glm::unProjectNO(point, dmat4(1.0), c.projection, window);
}

void check_vector(const dvec3& actual, const dvec3& expected, double tolerance) {
    for (int i = 0; i < 3; ++i) {
        CAPTURE(i);
        CHECK(std::abs(actual[i] - expected[i]) <= tolerance);
    }
}

}  // namespace

TEST_CASE("rays and depth: as GLM unprojects, for every projection, depth convention and row order") {
    const dmat4 view = some_view();
    for (const Case& c : cases()) {
        for (const RowOrder order : {RowOrder::top_first, RowOrder::bottom_first}) {
            CAPTURE(c.name);
            CAPTURE(static_cast<int>(order));
            Camera camera{.position_m = {1e6, 2e6, 6e6},
                          .view = view,
                          .projection = c.projection,
                          .kind = Projection::matrix,
                          .depth_range = c.range,
                          .row_order = order};
            CHECK_NOTHROW(validate(camera));
            CHECK(is_orthographic(camera.projection) == c.orthographic);
            const RayBasis rays = ray_basis(camera, glm::normalize(camera.position_m));
            const dvec4 m = depth_coefficients(camera);
            for (const double x : {0.0, 0.2, 0.9})
                for (const double y : {0.1, 0.5, 1.0})
                    for (const double d : {0.03, 0.4, 0.8, 0.97}) {
                        const dvec3 point = unproject(c, order, {x, y, d});
                        REQUIRE(point.z < 0);
                        const dvec3 ray = rays.origin + x * rays.along_x + y * rays.along_y;
                        const double depth = (m.x * d + m.y) / (m.z * d + m.w) * 1000;
                        CHECK(depth == doctest::Approx(-point.z).scale(1e-300).epsilon(1e-9));
                        const dvec3 world = glm::transpose(dmat3(view)) * point;  // relative to the camera
                        if (c.orthographic) {
                            const dvec3 other = unproject(c, order, {x, y, 0.6});
                            const dvec3 along =
                                glm::transpose(dmat3(view)) * (point.z < other.z ? point - other : other - point);
                            check_vector(ray, glm::normalize(along), 1e-9);
                        } else {
                            check_vector(ray * depth, world, 1e-9 * glm::length(world));  // distance = view depth * length
                        }
                    }
        }
    }
}

TEST_CASE("depth: the sky is infinitely far") {
    constexpr double inf = std::numeric_limits<double>::infinity();
    const auto at = [](const dmat4& projection, DepthRange range, double d) {
        const dvec4 m = depth_coefficients(Camera{.projection = projection, .depth_range = range});
        const double over = m.x * d + m.y, under = m.z * d + m.w;
        return under == 0 && over > 0 ? inf : over / under;
    };
    CHECK(at(reversed_infinite(0.5), DepthRange::zero_to_one, 0) == inf);
    CHECK(at(reversed_infinite(0.5), DepthRange::zero_to_one, 1) == doctest::Approx(0.5e-3).scale(1e-300).epsilon(1e-5));
    CHECK(at(glm::perspectiveRH_ZO(1.0, 1.5, 0.5, 500.0), DepthRange::zero_to_one, 1) == doctest::Approx(0.5));
    CHECK(at(glm::perspectiveRH_ZO(1.0, 1.5, 500.0, 0.5), DepthRange::zero_to_one, 0) == doctest::Approx(0.5));
    dmat4 no_depth = reversed_infinite(0.5);
    no_depth[3][2] = 0;
    CHECK(at(no_depth, DepthRange::zero_to_one, 0.3) == inf);
    CHECK(at(no_depth, DepthRange::minus_one_to_one, 0.3) == inf);
    for (const Projection kind : {Projection::panorama, Projection::fisheye})
        CHECK(depth_coefficients(Camera{.kind = kind}) == dvec4(0, 1, 0, 0));
}

TEST_CASE("depth: which end is far") {
    for (const Case& c : cases()) {
        CAPTURE(c.name);
        const bool reversed = c.name.find("reversed") != std::string::npos;
        CHECK(far_depth(Camera{.projection = c.projection, .depth_range = c.range}) == (reversed ? 0 : 1));
    }
    // Parallel rays may start at the camera, or behind it.
    for (const double nearest : {0.0, -40.0}) {
        CHECK(far_depth(Camera{.projection = glm::orthoRH_ZO(-30.0, 50.0, -10.0, 20.0, nearest, 500.0)}) == 1);
        CHECK(far_depth(Camera{.projection = glm::orthoRH_ZO(-30.0, 50.0, -10.0, 20.0, 500.0, nearest)}) == 0);
    }
}

TEST_CASE("panorama: zenith is the planet's, forward the camera's heading") {
    const double azimuth = 0.7;
    for (const double elevation : {-pi / 2, -0.5, 0.0, 1.2, pi / 2}) {
        CAPTURE(elevation);
        Camera camera = look(6.36e6, 100, azimuth, elevation, 1, 1);
        camera.kind = Projection::panorama;
        const RayBasis top = ray_basis(camera, {0, 0, 1});
        check_vector(top.origin, {std::cos(azimuth), std::sin(azimuth), 0}, 1e-9);
        check_vector(top.along_x, {std::sin(azimuth), -std::cos(azimuth), 0}, 1e-9);  // right, seen from above clockwise
        check_vector(top.along_y, {0, 0, 1}, 1e-9);
        camera.row_order = RowOrder::bottom_first;
        const RayBasis bottom = ray_basis(camera, {0, 0, 1});
        check_vector(bottom.origin, top.origin, 0);
        check_vector(bottom.along_x, top.along_x, 0);
        check_vector(bottom.along_y, -top.along_y, 0);
    }
}

TEST_CASE("fisheye: forward towards the first row, not mirrored") {
    Camera camera = look(6.36e6, 100, 0, 0.3, 1, 1);  // facing +x; +y is to its left
    camera.kind = Projection::fisheye;
    const RayBasis rays = ray_basis(camera, {0, 0, 1});
    check_vector(rays.origin, {1, 0, 0}, 1e-9);
    check_vector(rays.along_x, {0, 1, 0}, 1e-9);
    check_vector(rays.along_y, {0, 0, 1}, 1e-9);
    // A picture that is not mirrored: right x up = towards the viewer, here away from the zenith.
    check_vector(glm::cross(rays.along_x, rays.origin), {0, 0, -1}, 1e-9);
    camera.row_order = RowOrder::bottom_first;
    check_vector(ray_basis(camera, {0, 0, 1}).origin, {-1, 0, 0}, 1e-9);
    check_vector(ray_basis(camera, {0, 0, 1}).along_x, {0, 1, 0}, 1e-9);
}
