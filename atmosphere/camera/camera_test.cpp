#include "common/rejects.h"

#include <aureole/camera.h>

#include <doctest/doctest.h>
#include <cmath>
#include <functional>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

using namespace aureole;
using detail::rejected_field;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;

std::string rejected(const std::function<void(Camera&)>& spoil, Camera camera = look(6.36e6, 2, 0.3, 0.1, 1, 1.5)) {
    spoil(camera);
    return rejected_field([&] { validate(camera); });
}

}  // namespace

TEST_CASE("validate(Camera): what passes") {
    CHECK_NOTHROW(validate(Camera{}));
    CHECK_NOTHROW(validate(look(6.36e6, 2, 0, 0, 1, 1)));
    for (const glm::dmat4& projection :
         {glm::perspectiveRH_ZO(1.0, 1.5, 0.1, 1e5), glm::perspectiveRH_NO(1.0, 1.5, 0.1, 1e5),
          glm::perspectiveRH_ZO(1.0, 1.5, 1e5, 0.1), glm::infinitePerspective(1.0, 1.5, 0.1),
          glm::frustumRH_ZO(-1.0, 3.0, -0.5, 2.0, 1.0, 1e4), glm::orthoRH_ZO(-2.0, 5.0, -1.0, 1.0, 0.0, 1e4), glm::dmat4(1.0)})
        CHECK(rejected([&](Camera& c) { c.projection = projection; }) == "nothing");
    CHECK(rejected([](Camera& c) { c.position_m = {0, 0, 6.35e6}; }) == "nothing");  // below the ground
    CHECK(rejected([](Camera& c) { c.position_m = {-1e13, 0, 0}; }) == "nothing");
    CHECK(rejected([](Camera& c) { c.view[3] = glm::dvec4(not_a_number, inf, 1, 1); }) ==
          "nothing");  // only the rotation is used
    CHECK(rejected([](Camera& c) { c.view[0] *= 1.0004; }) == "nothing");
    for (const Projection kind : {Projection::panorama, Projection::fisheye})
        CHECK(rejected([&](Camera& c) { c.kind = kind, c.projection = glm::dmat4(0.0); }) == "nothing");
}

TEST_CASE("validate(Camera): position") {
    for (const double bad : {not_a_number, inf, -inf, 1.1e13}) {
        CHECK(rejected([&](Camera& c) { c.position_m.x = bad; }) == "camera.position_m.x");
        CHECK(rejected([&](Camera& c) { c.position_m.y = bad; }) == "camera.position_m.y");
        CHECK(rejected([&](Camera& c) { c.position_m.z = bad; }) == "camera.position_m.z");
    }
    CHECK(rejected([](Camera& c) { c.position_m = {0, 0, 0}; }) == "camera.position_m");
    CHECK(rejected([](Camera& c) { c.position_m = {9e12, 9e12, 0}; }) == "camera.position_m");
}

TEST_CASE("validate(Camera): view") {
    CHECK(rejected([](Camera& c) { c.view[1][2] = not_a_number; }) == "camera.view[1][2]");
    CHECK(rejected([](Camera& c) { c.view[0][0] = inf; }) == "camera.view[0][0]");
    CHECK(rejected([](Camera& c) { c.view = glm::dmat4(0.0); }) == "camera.view");
    CHECK(rejected([](Camera& c) { c.view[0] *= 1.002; }) == "camera.view");
    CHECK(rejected([](Camera& c) { c.view[0] = c.view[1]; }) == "camera.view");
}

TEST_CASE("validate(Camera): projection") {
    CHECK(rejected([](Camera& c) { c.projection[2][3] = not_a_number; }) == "camera.projection[2][3]");
    CHECK(rejected([](Camera& c) { c.projection[0][0] = -inf; }) == "camera.projection[0][0]");
    CHECK(rejected([](Camera& c) { c.projection = glm::dmat4(0.0); }) == "camera.projection");
    CHECK(rejected([](Camera& c) { c.projection[0][0] = 0; }) == "camera.projection");
    CHECK(rejected([](Camera& c) { c.projection[1][1] = 0; }) == "camera.projection");
    CHECK(rejected([](Camera& c) { c.projection[1] = c.projection[0]; }) == "camera.projection");
    CHECK(rejected([](Camera& c) { c.projection[0][3] = 0.1; }) == "camera.projection");  // w depends on x
    CHECK(rejected([](Camera& c) { c.projection[1][2] = 0.1, c.projection[2][2] = -1; }) ==
          "camera.projection");                                                           // oblique near plane
    CHECK(rejected([](Camera& c) { c.projection[3][0] = 0.1; }) == "camera.projection");  // rays meet beside the camera
    CHECK(rejected([](Camera& c) { c.projection = glm::dmat4(1.0), c.projection[0][0] = 0; }) == "camera.projection");
    CHECK(rejected([](Camera& c) { c.projection = glm::dmat4(1.0), c.projection[3][3] = -1; }) == "camera.projection");
}

TEST_CASE("validate(Camera): choices") {
    CHECK(rejected([](Camera& c) { c.kind = static_cast<Projection>(3); }) == "camera.kind");
    CHECK(rejected([](Camera& c) { c.depth_range = static_cast<DepthRange>(2); }) == "camera.depth_range");
    CHECK(rejected([](Camera& c) { c.row_order = static_cast<RowOrder>(2); }) == "camera.row_order");
}

TEST_CASE("look: where it stands and looks") {
    const Camera c = look(6.36e6, 1000, 0.7, 0.2, 1, 1.5, 0.25);
    CHECK(c.position_m == glm::dvec3(0, 0, 6.361e6));
    const glm::dvec3 forward(std::cos(0.2) * std::cos(0.7), std::cos(0.2) * std::sin(0.7), std::sin(0.2));
    const glm::dvec4 ahead = c.view * glm::dvec4(c.position_m + 10.0 * forward, 1);
    CHECK(ahead.x == doctest::Approx(0).epsilon(1e-8));
    CHECK(ahead.y == doctest::Approx(0).epsilon(1e-8));
    CHECK(ahead.z == doctest::Approx(-10).scale(1e-300).epsilon(1e-8));
    // Half the field of view above the axis lands on the upper edge of clip space; the near plane on depth 1, infinity on 0.
    const glm::dvec4 edge = c.projection * glm::dvec4(0, std::tan(0.5), -1, 1);
    CHECK(edge.y / edge.w == doctest::Approx(1).scale(1e-300).epsilon(1e-14));
    const glm::dvec4 side = c.projection * glm::dvec4(1.5 * std::tan(0.5), 0, -1, 1);
    CHECK(side.x / side.w == doctest::Approx(1).scale(1e-300).epsilon(1e-14));
    const glm::dvec4 near_point = c.projection * glm::dvec4(0, 0, -0.25, 1),
                     far_point = c.projection * glm::dvec4(0, 0, -1e12, 1);
    CHECK(near_point.z / near_point.w == doctest::Approx(1).scale(1e-300).epsilon(1e-14));
    CHECK(far_point.z / far_point.w < 1e-12);
    // Straight up and down are no special cases.
    for (const double elevation : {-pi / 2, pi / 2}) {
        const Camera vertical = look(6.36e6, 0, 0.4, elevation, 1, 1);
        CHECK_NOTHROW(validate(vertical));
        const glm::dvec3 axis = -glm::dvec3(vertical.view[0][2], vertical.view[1][2], vertical.view[2][2]);
        CHECK(axis.z == doctest::Approx(elevation > 0 ? 1 : -1));
    }
}

TEST_CASE("look: every argument has its range") {
    struct Argument {
        const char* name;
        std::function<Camera(double)> call;
        std::vector<double> bad;
    };
    const std::vector<Argument> arguments{
        {"bottom_radius_m", [](double v) { return look(v, 2, 0, 0, 1, 1); }, {0, -6e6, 999, 1.1e12}},
        {"altitude_m", [](double v) { return look(6.36e6, v, 0, 0, 1, 1); }, {-4e6, 1e13}},
        {"azimuth_rad", [](double v) { return look(6.36e6, 2, v, 0, 1, 1); }, {1e7}},
        {"elevation_rad", [](double v) { return look(6.36e6, 2, 0, v, 1, 1); }, {-1.6, 1.6}},
        {"vertical_fov_rad", [](double v) { return look(6.36e6, 2, 0, 0, v, 1); }, {0, -1, pi}},
        {"aspect", [](double v) { return look(6.36e6, 2, 0, 0, 1, v); }, {0, -1, 1e4}},
        {"near_m", [](double v) { return look(6.36e6, 2, 0, 0, 1, 1, v); }, {0, -0.1, 1e10}},
    };
    for (const Argument& a : arguments) {
        CAPTURE(a.name);
        std::vector<double> bad = a.bad;
        bad.insert(bad.end(), {not_a_number, inf, -inf});
        for (const double value : bad) CHECK(rejected_field([&] { (void)a.call(value); }) == a.name);
    }
    CHECK_NOTHROW((void)look(6.36e6, -10, 0, 0, 1, 1));
}
