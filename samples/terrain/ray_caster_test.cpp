#include "terrain/ray_caster.h"

#include <doctest/doctest.h>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

using namespace aureole::app;

namespace {

constexpr double radius = 6.36e6;

HeightMap make_map(std::uint32_t side, double spacing, const std::function<double(double, double)>& f) {
    HeightMap map{side, side, {}, spacing, spacing};
    for (std::uint32_t r = 0; r < side; ++r)
        for (std::uint32_t c = 0; c < side; ++c)
            map.meters.push_back(static_cast<float>(f(spacing * (c - 0.5 * (side - 1)), spacing * (0.5 * (side - 1) - r))));
    return map;
}

glm::dvec3 towards(double bearing_deg, double elevation_deg) {
    const double b = bearing_deg * std::numbers::pi / 180, e = elevation_deg * std::numbers::pi / 180;
    return {std::cos(e) * std::cos(b), -std::cos(e) * std::sin(b), std::sin(e)};
}

}  // namespace

TEST_CASE("RayCaster: flat land is a sphere") {
    const HeightField field(make_map(20, 100, [](double, double) { return 0; }), 1);
    const RayCaster caster(field, radius, {0, 0});
    const glm::dvec3 eye(0, 0, radius + 1000);
    for (const double down : {90.0, 45.0, 10.0, 3.0, 1.2}) {
        CAPTURE(down);
        const auto hit = caster.cast(eye, towards(30, -down), 0, 1e6);
        REQUIRE(hit);
        // Where a line at this angle meets the sphere: r sin - sqrt(R^2 - r^2 cos^2).
        const double s = std::sin(down * std::numbers::pi / 180), c = std::cos(down * std::numbers::pi / 180),
                     r = radius + 1000;
        CHECK(hit->distance_m ==
              doctest::Approx(r * s - std::sqrt(radius * radius - r * r * c * c)).scale(1e-300).epsilon(1e-6));
    }
    // The horizon of 1000 m is at acos(R / (R + 1000)) = 1.016 degrees.
    CHECK(caster.cast(eye, towards(30, -1.02), 0, 1e6));
    CHECK_FALSE(caster.cast(eye, towards(30, -1.01), 0, 1e6));
    CHECK_FALSE(caster.cast(eye, towards(30, 5), 0, 1e6));
    CHECK_FALSE(caster.cast(eye, towards(30, -1.2), 0, 1e4));  // not so far
}

TEST_CASE("RayCaster: places and points are each other's inverse, with true distances and bearings") {
    const HeightField field(make_map(20, 100, [](double, double) { return 0; }), 1);
    const RayCaster caster(field, radius, {500, -300});
    CHECK(caster.place_of({0, 0, radius}) == glm::dvec2(500, -300));
    for (const glm::dvec2 offset : {glm::dvec2(0, 1000), glm::dvec2(-2e4, 3e4), glm::dvec2(2.5e5, 0), glm::dvec2(0, 6e5)}) {
        const glm::dvec2 place = glm::dvec2(500, -300) + offset;
        const glm::dvec3 point = caster.point_at(place, 123);
        CHECK(caster.altitude_of(point) == doctest::Approx(123).scale(1e-300).epsilon(1e-6));
        CHECK(glm::length(caster.place_of(point) - place) < 1e-3);
        CHECK(std::acos(point.z / glm::length(point)) * radius == doctest::Approx(glm::length(offset)));
    }
    CHECK(caster.point_at({500, 700}, 0).x == doctest::Approx(1000).scale(1e-300).epsilon(1e-6));     // north is +x
    CHECK(caster.point_at({1500, -300}, 0).y == doctest::Approx(-1000).scale(1e-300).epsilon(1e-6));  // east is -y
    const glm::dvec3 up = caster.to_world(caster.point_at({500, 1e5}, 0), {0, 0, 1});
    CHECK(glm::dot(up, glm::normalize(caster.point_at({500, 1e5}, 0))) == doctest::Approx(1));
    CHECK(caster.to_world({0, 0, radius}, {1, 0, 0}).y == doctest::Approx(-1));
}

TEST_CASE("RayCaster: agrees with small steps on hills") {
    const HeightField field(
        make_map(80, 60,
                 [](double e, double n) { return 300 + 120 * std::sin(e / 310) * std::cos(n / 270) + 40 * std::sin(n / 140); }),
        1);
    const RayCaster caster(field, radius, {100, 200});
    const glm::dvec3 eye(0, 0, radius + 520);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> bearing(0, 360), elevation(-25, 1);
    int hits = 0, apart = 0;
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 direction = towards(bearing(random), elevation(random));
        constexpr double step = 0.5, reach = 12000;
        double expected = -1;
        for (double t = 0; t < reach; t += step) {
            const glm::dvec3 p = eye + t * direction;
            if (caster.altitude_of(p) < field.height(caster.place_of(p))) {
                expected = t;
                break;
            }
        }
        const auto hit = caster.cast(eye, direction, 0, reach);
        hits += hit.has_value();
        // A ray that grazes a summit inside one cell may pass.
        if (hit.has_value() != (expected >= 0) || (hit && std::abs(hit->distance_m - expected) > 2 * step)) ++apart;
        if (hit) CHECK(std::abs(caster.altitude_of(eye + hit->distance_m * direction) - field.height(hit->place)) < 0.01);
    }
    CHECK(hits > 200);
    CHECK(apart <= 2);
}

TEST_CASE("RayCaster: a ridge hides what is behind it") {
    // A wall 400 m high, 2 km north; the map's mirror images are far away.
    const HeightField field(make_map(201, 100, [](double, double n) { return std::max(0.0, 400 - 2 * std::abs(n - 2000)); }),
                            1);
    const RayCaster caster(field, radius, {0, 0});
    const glm::dvec3 eye(0, 0, radius + 10);
    CHECK(caster.cast(eye, towards(0, 10), 0, 5000));  // atan(390 / 2000) = 11.0 degrees
    CHECK_FALSE(caster.cast(eye, towards(0, 12), 0, 5000));
    CHECK_FALSE(caster.cast(eye, towards(180, 3), 0, 5000));
    const auto wall = caster.cast(eye, towards(0, 5), 0, 5000);
    REQUIRE(wall);
    CHECK(wall->place.y == doctest::Approx(1884).scale(1e-300).epsilon(0.02));  // 10 + n tan 5 = 400 - 2 (2000 - n)
}

TEST_CASE("RayCaster: vertical rays and rays from inside") {
    const HeightField field(make_map(20, 100, [](double, double) { return 250; }), 1);
    const RayCaster caster(field, radius, {0, 0});
    CHECK(caster.cast({0, 0, radius + 1000}, {0, 0, -1}, 0, 1e5)->distance_m == doctest::Approx(750));
    CHECK_FALSE(caster.cast({0, 0, radius + 1000}, {0, 0, 1}, 0, 1e5));
    CHECK(caster.cast({0, 0, radius + 100}, {0, 0, 1}, 0, 1e5)->distance_m == 0);
}
