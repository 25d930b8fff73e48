#include "camera/pack_view.h"

#include "common/rejects.h"
#include "quadrature/gauss_legendre.h"

#include <aureole/presets.h>

#include <doctest/doctest.h>
#include <array>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

using namespace aureole;
using namespace aureole::detail;
using glm::dvec3;

namespace {

constexpr double pi = std::numbers::pi;
const Planet planet = presets::earth().planet;

ViewBlock at_altitude(double altitude_m) { return pack_view(look(planet.bottom_radius_m, altitude_m, 0, 0, 1, 1), {}, planet); }

dvec3 xyz(const glm::vec4& v) { return dvec3(v.x, v.y, v.z); }

ViewBlock with_sun(const Sun& sun, const Camera& camera = look(6.36e6, 2, 0, 0, 1, 1)) {
    return pack_view(camera, std::array{sun}, planet);
}

}  // namespace

TEST_CASE("pack_view: altitude and horizon keep a centimetre") {
    for (const double h : {0.01, 1.0, 100.0, 10e3, 99e3}) {
        CAPTURE(h);
        const ViewBlock view = at_altitude(h);
        CHECK(view.camera.x == doctest::Approx(h / 1000).scale(1e-300).epsilon(1e-6));
        // cos(dip) = R / (R + h); for small h, dip = sqrt(2 h / R) to first order.
        const double dip = std::acos(6.36e6 / (6.36e6 + h));
        CHECK(view.space.z == doctest::Approx(dip).scale(1e-300).epsilon(h < 1 ? 1e-5 : 1e-6));
        CHECK(view.space.z == doctest::Approx(std::sqrt(2 * h / 6.36e6)).scale(1e-300).epsilon(h / 6.36e6 + 1e-6));
        CHECK(view.camera.w == 0);
        CHECK(view.space.x == view.camera.x);
        CHECK(view.space.y == doctest::Approx(-pi / 2));
    }
}

TEST_CASE("pack_view: on the ground and below it") {
    for (const double h : {0.0, -0.5, -10.0, -1e6}) {
        CAPTURE(h);
        const ViewBlock view = at_altitude(h);
        CHECK(view.camera == glm::vec4(0));
        CHECK(view.space.x == 0);
        CHECK(view.space.z == 0);
        CHECK(xyz(view.up) == dvec3(0, 0, 1));
    }
}

TEST_CASE("pack_view: above the atmosphere") {
    const ViewBlock edge = at_altitude(100e3);
    CHECK(edge.camera.w == 0);
    CHECK(edge.camera.x == 100.0f);
    for (const double h : {100.001e3, 400e3, 1e6, 4e8}) {
        CAPTURE(h);
        const ViewBlock view = at_altitude(h);
        CHECK(view.camera.w == 1);
        CHECK(view.camera.x == 100.0f);
        CHECK(view.space.x == doctest::Approx(h / 1000).scale(1e-300).epsilon(1e-6));
        CHECK(view.space.y == doctest::Approx(std::acos(6.46e6 / (6.36e6 + h))).scale(1e-300).epsilon(1e-5));
        CHECK(view.space.z == doctest::Approx(std::acos(6.36e6 / (6.36e6 + h))).scale(1e-300).epsilon(1e-6));
    }
}

TEST_CASE("pack_view: up and east are at right angles everywhere, the poles and far ends included") {
    for (const dvec3& position : {dvec3(0, 0, 6.4e6), dvec3(0, 0, -6.4e6), dvec3(6.4e6, 0, 0), dvec3(0, -6.4e6, 0),
                                  dvec3(1e6, 2e6, -6e6), dvec3(1e-3, 0, 6.4e6), dvec3(5e12, 5e12, 5e12), dvec3(1e-6, 0, 0)}) {
        CAPTURE(position.x);
        CAPTURE(position.z);
        const ViewBlock view = pack_view(Camera{.position_m = position}, {}, planet);
        const dvec3 up = xyz(view.up), east = xyz(view.east);
        CHECK(glm::length(up - position / glm::length(position)) < 1e-6);
        CHECK(std::abs(glm::dot(up, east)) < 1e-6);
        CHECK(glm::length(east) == doctest::Approx(1).scale(1e-300).epsilon(1e-6));
    }
    const ViewBlock equator = pack_view(Camera{.position_m = {6.4e6, 0, 0}}, {}, planet);
    CHECK(xyz(equator.east) == dvec3(0, 1, 0));
}

TEST_CASE("pack_view: rays, kinds, froxels") {
    Camera camera = look(6.36e6, 2, 0.5, 0.25, 1, 1.5);
    ViewBlock view = pack_view(camera, {}, planet, {.aerial_perspective_distance_m = 32000, .exposure = 3});
    CHECK(view.ray_origin.w == 0);
    const dvec3 forward(std::cos(0.25) * std::cos(0.5), std::cos(0.25) * std::sin(0.5), std::sin(0.25));
    const dvec3 centre = xyz(view.ray_origin) + 0.5 * xyz(view.ray_x) + 0.5 * xyz(view.ray_y);
    CHECK(glm::length(centre - forward) < 1e-6);
    CHECK(view.froxels == glm::vec4(32, 1 / 32.0f, 1 / 8.0f, 0));
    CHECK(view.composite == glm::vec4(3, 0, 0, 0));  // reversed depth: the far end is 0
    Camera forward_depth = camera;
    forward_depth.projection = glm::perspectiveRH_ZO(1.0, 1.5, 0.1, 100.0);
    CHECK(pack_view(forward_depth, {}, planet).composite.z == 1);
    CHECK((view.depth.x * 0.01f + view.depth.y) / (view.depth.z * 0.01f + view.depth.w) ==
          doctest::Approx(0.01).scale(1e-300).epsilon(1e-6));
    camera.kind = Projection::panorama;
    CHECK(pack_view(camera, {}, planet).ray_origin.w == 1);
    camera.kind = Projection::fisheye;
    CHECK(pack_view(camera, {}, planet).ray_origin.w == 2);
    camera.kind = Projection::matrix;
    camera.projection = glm::dmat4(1.0);
    view = pack_view(camera, {}, planet);
    CHECK(view.ray_x == glm::vec4(0));
    CHECK(glm::length(xyz(view.ray_origin) - forward) < 1e-6);
}

TEST_CASE("pack_view: the sun's place") {
    const Sun sun{.direction = dvec3(3, -4, 12),
                  .irradiance = {1, 2, 3},
                  .angular_radius_rad = 0.01,
                  .limb_darkening = LimbDarkening::none};
    const ViewBlock view = with_sun(sun);
    CHECK(glm::length(xyz(view.sun_direction[0]) - dvec3(3, -4, 12) / 13.0) < 1e-6);
    CHECK(view.sun_direction[0].w == doctest::Approx(12 / 13.0).scale(1e-300).epsilon(1e-6));
    CHECK(view.sun_azimuth[0].w == doctest::Approx(5 / 13.0).scale(1e-300).epsilon(1e-6));
    CHECK(glm::length(xyz(view.sun_azimuth[0]) - dvec3(0.6, -0.8, 0)) < 1e-6);
    CHECK(view.sun_irradiance[0] == glm::vec4(1, 2, 3, 1));

    // A sun near the zenith keeps its azimuth; at zenith and nadir there is none, and east stands in.
    const ViewBlock close = with_sun(Sun{.direction = {0, 1e-6, 1}});
    CHECK(close.sun_azimuth[0].w == doctest::Approx(1e-6).scale(1e-300).epsilon(1e-5));
    CHECK(glm::length(xyz(close.sun_azimuth[0]) - dvec3(0, 1, 0)) < 1e-6);
    for (const double z : {1.0, -1.0}) {
        const ViewBlock exact = with_sun(Sun{.direction = {0, 0, z}});
        CHECK(exact.sun_direction[0].w == z);
        CHECK(exact.sun_azimuth[0].w == 0);
        CHECK(xyz(exact.sun_azimuth[0]) == xyz(exact.east));
    }
    // Lengths at the ends of the range.
    for (const double length : {1e-100, 1e100})
        CHECK(with_sun(Sun{.direction = {0, length, 0}}).sun_direction[0] == glm::vec4(0, 1, 0, 0));
}

TEST_CASE("pack_view: none, several and too many suns") {
    const Camera camera = look(6.36e6, 2, 0, 0, 1, 1);
    const ViewBlock night = pack_view(camera, {}, planet);
    for (int i = 0; i < max_suns; ++i) {
        CHECK(night.sun_irradiance[i] == glm::vec4(0));
        CHECK(glm::length(xyz(night.sun_direction[i])) == doctest::Approx(1));
        CHECK(night.sun_disk[i] == glm::vec4(0));
    }
    const std::vector<Sun> four{Sun{.direction = {1, 0, 0}}, Sun{.direction = {0, 1, 0}}, Sun{}, Sun{.irradiance = {0, 0, 9}}};
    const ViewBlock day = pack_view(camera, four, planet);
    for (const glm::vec4& irradiance : day.sun_irradiance) CHECK(irradiance.w == 4);
    CHECK(day.sun_direction[1].y == 1);
    CHECK(day.sun_irradiance[3].z == 9);
    std::vector<Sun> bad = four;
    bad[1].irradiance.g = -1;
    CHECK(rejected_field([&] { (void)pack_view(camera, bad, planet); }) == "suns[1].irradiance.g");
    bad.assign(5, Sun{});
    CHECK(rejected_field([&] { (void)pack_view(camera, bad, planet); }) == "suns");
}

TEST_CASE(
    "pack_view: radiance integrated over the disk is the irradiance, small disks and huge ones, with and without limb "
    "darkening") {
    for (const LimbDarkening limb : {LimbDarkening::none, LimbDarkening::neckel94}) {
        for (const double radius : {1e-6, 0.004675, 0.1, pi / 4}) {
            CAPTURE(radius);
            const ViewBlock view = with_sun(
                Sun{.direction = {1, 2, 3}, .irradiance = {1, 1, 1}, .angular_radius_rad = radius, .limb_darkening = limb});
            const glm::vec4 disk = view.sun_disk[0], edge = view.sun_limb[0];
            const dvec3 exponent = limb == LimbDarkening::none ? dvec3(0) : dvec3(0.397, 0.503, 0.652);
            const GaussLegendre rule = gauss_legendre(64);
            for (int c = 0; c < 3; ++c) {
                CHECK(edge[c] == doctest::Approx(exponent[c]).scale(1e-300).epsilon(1e-6));
                // Over the angle theta from the centre, as the kernels evaluate it: by the squared chord. theta = radius (1 -
                // v^2) puts nodes where mu goes to 0.
                const double sum = rule.integrate(0, 1, [&](double v) {
                    const double theta = radius * (1 - v * v), chord = 2 * std::sin(theta / 2);
                    const double mu = std::sqrt(std::max(0.0, 1 - chord * chord * disk.w));
                    return disk[c] * std::pow(mu, edge[c]) * 2 * pi * std::sin(theta) * 2 * radius * v;
                });
                CHECK(sum == doctest::Approx(1).scale(1e-300).epsilon(2e-5));
            }
            CHECK(edge.w * disk.w == doctest::Approx(1).scale(1e-300).epsilon(1e-6));
            CHECK(edge.w == doctest::Approx(4 * std::sin(radius / 2) * std::sin(radius / 2)).scale(1e-300).epsilon(1e-6));
            if (limb == LimbDarkening::none && radius > 1e-3)
                CHECK(disk.x == doctest::Approx(1 / (2 * pi * (1 - std::cos(radius)))).scale(1e-300).epsilon(1e-5));
        }
        const ViewBlock none = with_sun(Sun{.angular_radius_rad = 0, .limb_darkening = limb});
        CHECK(none.sun_disk[0] == glm::vec4(0));
        CHECK(none.sun_limb[0].w == 0);
    }
}

TEST_CASE("pack_view: everything it makes is finite, at the ends of all ranges") {
    for (const double radius : {1e3, 1e12})
        for (const double altitude : {0.0, 1.0, 1e12}) {
            const Planet extreme{.bottom_radius_m = radius, .top_radius_m = 11 * radius, .ground_albedo = Rgb(1)};
            const Sun sun{.direction = {0, 1e-100, 0},
                          .irradiance = Rgb(1e20),
                          .angular_radius_rad = 1e-12,
                          .limb_darkening = LimbDarkening::none};
            const ViewBlock view = pack_view(look(radius, altitude, 0, 0, 1e-6, 1e3), std::array{sun}, extreme,
                                             {.aerial_perspective_distance_m = 1e13, .exposure = 1e30});
            float numbers[sizeof view / sizeof(float)];
            std::memcpy(numbers, &view, sizeof view);
            for (const float number : numbers) REQUIRE(std::isfinite(number));
        }
}

TEST_CASE("pack_view: bad input") {
    const Camera camera = look(6.36e6, 2, 0, 0, 1, 1);
    Camera bad = camera;
    bad.position_m = dvec3(0);
    CHECK(rejected_field([&] { (void)pack_view(bad, {}, planet); }) == "camera.position_m");
    for (const double value : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        CHECK(rejected_field([&] { (void)pack_view(camera, {}, planet, {.aerial_perspective_distance_m = value}); }) ==
              "aerial_perspective_distance_m");
        CHECK(rejected_field([&] { (void)pack_view(camera, {}, planet, {.exposure = value}); }) == "exposure");
    }
}
