#include "terrain/terrain.h"

#include "terrain/noise.h"

#include <aureole/light.h>

#include <doctest/doctest.h>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

using namespace aureole;
using namespace aureole::app;

namespace {

constexpr double radius = 6.36e6, pi = std::numbers::pi;

HeightMap flat_map(float height) { return {20, 20, std::vector<float>(400, height), 100, 100}; }

/// A sky of radiance 1 everywhere: Y00 coefficient 2 sqrt(pi).
std::array<Rgb, 9> uniform_sky(double radiance) {
    std::array<Rgb, 9> sky{};
    sky[0] = Rgb(radiance * 2 * std::sqrt(pi));
    return sky;
}

TerrainLight light_of(const Rgb& sun, double sky, const glm::dvec3& direction) {
    return {0, 1000, {{uniform_sky(sky), sun}}, {{uniform_sky(sky), sun}}, {direction}};
}

}  // namespace

TEST_CASE("sky_irradiance: closed forms") {
    // A uniform sky of radiance L gives pi L; a sky of radiance d.z (degree 1) gives 2 pi / 3 n.z; one of radiance
    // 3 d.z^2 - 1 (degree 2) gives pi / 4 (3 n.z^2 - 1).
    const glm::dvec3 n = glm::normalize(glm::dvec3(1, 2, 3));
    CHECK(sky_irradiance(uniform_sky(2), n).g == doctest::Approx(2 * pi));
    std::array<Rgb, 9> sky{};
    sky[2] = Rgb(1 / std::sqrt(3 / (4 * pi)));
    CHECK(sky_irradiance(sky, n).g == doctest::Approx(2 * pi / 3 * n.z));
    sky = {};
    sky[6] = Rgb(1 / std::sqrt(5 / (16 * pi)));
    CHECK(sky_irradiance(sky, n).g == doctest::Approx(pi / 4 * (3 * n.z * n.z - 1)));
    const double y2 = std::sqrt(15 / (4 * pi));
    const double expected[9] = {
        0, 0, 0, 0, y2 * n.x * n.y, y2 * n.y * n.z, 0, y2 * n.x * n.z, y2 * (n.x * n.x - n.y * n.y) / 2};
    for (const std::size_t i : {4u, 5u, 7u, 8u}) {
        sky = {};
        sky[i] = Rgb(expected[i] < 0 ? -1 : 1);
        CHECK(sky_irradiance(sky, n).r == doctest::Approx(std::abs(expected[i]) * pi / 4));
    }
    sky = {};
    sky[0] = Rgb(-1);
    CHECK(sky_irradiance(sky, n) == Rgb(0));  // never negative
}

TEST_CASE("cast_terrain: colour, depth and sky of a flat land") {
    const HeightField field(flat_map(0), 1);
    const RayCaster caster(field, radius, {0, 0});
    const double near_m = 0.1;
    const Camera camera = aureole::look(radius, 1000, 0, -0.2, 1.2, 1.5, near_m);
    const glm::dvec3 sun = glm::normalize(glm::dvec3(0.3, -0.4, 0.8));
    TerrainLook look;
    look.albedo = Rgb(0.2, 0.4, 0.6);
    look.range_m = 1e6;
    const TerrainPicture picture = cast_terrain(field, caster, camera, light_of({3, 2, 1}, 0.5, sun), look, 60, 40);

    double covered = 0;
    for (std::uint32_t y = 0; y < 40; ++y) {
        for (std::uint32_t x = 0; x < 60; ++x) {
            const std::size_t i = y * 60 + x;
            const double px = (2 * (x + 0.5) / 60 - 1) / camera.projection[0][0],
                         py = (1 - 2 * (y + 0.5) / 40) / camera.projection[1][1];
            const glm::dvec3 view = glm::normalize(glm::dvec3(px, py, -1));
            // The same sphere as in closed form.
            const double mu = std::cos(-0.2) * view.y + std::sin(-0.2) * -view.z;
            const double r = radius + 1000, reach = radius * radius - r * r * (1 - mu * mu);
            if (mu >= 0 || reach < 0) {
                CHECK(picture.depth[i] == 0);
                CHECK(picture.rgba[4 * i] == 0);
                continue;
            }
            ++covered;
            const double distance = -r * mu - std::sqrt(reach);
            CHECK(near_m / (-view.z * distance) == doctest::Approx(picture.depth[i]).scale(1e-300).epsilon(1e-4));
        }
    }
    CHECK(picture.covered == doctest::Approx(covered / 2400));
    CHECK(picture.nearest_m > 1000);
    CHECK(picture.farthest_m > 20000);

    // Roughness turns normals about the vertical, so the mean of the nearest row is what a flat surface gives:
    // albedo / pi (pi 0.5 + sun cos), within the spread of the roughness.
    Rgb mean(0);
    for (std::size_t x = 0; x < 60; ++x)
        mean += Rgb(picture.rgba[4 * (39 * 60 + x)], picture.rgba[4 * (39 * 60 + x) + 1], picture.rgba[4 * (39 * 60 + x) + 2]) /
                60.0;
    const Rgb expected = *look.albedo / pi * (pi * 0.5 + Rgb(3, 2, 1) * sun.z);
    for (int c = 0; c < 3; ++c) CHECK(mean[c] == doctest::Approx(expected[c]).scale(1e-300).epsilon(0.05));
}

TEST_CASE("cast_terrain: shadows, and light between two heights") {
    // A wall to the west; the sun is low behind it.
    HeightMap map = flat_map(0);
    for (std::size_t row = 0; row < 20; ++row) map.meters[row * 20 + 4] = 400;
    const HeightField field(map, 1);
    const RayCaster caster(field, radius, {0, 0});
    const Camera down = aureole::look(radius, 3000, 0, -pi / 2, 0.02, 1);
    TerrainLook look;
    look.albedo = Rgb(0.5);
    const glm::dvec3 west_sun = glm::normalize(glm::dvec3(0, 1, 0.2));  // +y is west
    const glm::dvec3 east_sun = glm::normalize(glm::dvec3(0, -1, 0.2));
    const auto middle = [&](const TerrainLight& light) {
        const TerrainPicture picture = cast_terrain(field, caster, down, light, look, 3, 3);
        return static_cast<double>(picture.rgba[4 * 4]);
    };
    // tan^-1(400 m / 550 m) = 36 degrees: the wall hides a sun at 11 degrees in the west, not in the east.
    CHECK(middle(light_of(Rgb(1), 0, west_sun)) < 0.2 * middle(light_of(Rgb(1), 0, east_sun)));
    // Land at height 0 takes the light of the lower table alone.
    TerrainLight split = light_of(Rgb(0), 1, {0, 0, 1});
    split.high[0] = {uniform_sky(100), Rgb(0)};
    CHECK(middle(split) == doctest::Approx(middle(light_of(Rgb(0), 1, {0, 0, 1}))).scale(1e-300).epsilon(0.01));
    CHECK(middle({0, 1, {}, {}, {}}) == 0);  // night
}

TEST_CASE("cast_terrain: level land under the sky alone is not smooth") {
    const HeightField field(flat_map(0), 1);
    const RayCaster caster(field, radius, {0, 0});
    const auto spread = [&](const TerrainLook& look) {
        const Camera down = aureole::look(radius, 800, 0, -pi / 2, 0.5, 1);
        const TerrainPicture picture = cast_terrain(field, caster, down, light_of(Rgb(0), 1, {0, 0, 1}), look, 64, 64);
        double sum = 0, squares = 0;
        for (std::size_t i = 0; i < 64 * 64; ++i) {
            const double green = picture.rgba[4 * i + 1];
            sum += green;
            squares += green * green;
        }
        const double mean = sum / (64 * 64);
        return std::sqrt(squares / (64 * 64) - mean * mean) / mean;
    };
    CHECK(spread({Rgb(0.5), 1e6}) > 0.1);
    CHECK(spread({std::nullopt, 1e6}) > 0.15);
}

TEST_CASE("natural_albedo: plausible everywhere") {
    for (double e = -3000; e < 3000; e += 171) {
        for (const double steep : {0.0, 0.3, 0.7, 1.2}) {
            const glm::dvec3 normal = glm::normalize(glm::dvec3(steep, 0, 1));
            const Rgb albedo = natural_albedo({e, 2 * e}, 300 + e / 10, normal, 1);
            for (int c = 0; c < 3; ++c) {
                CHECK(albedo[c] > 0.003);
                CHECK(albedo[c] < 0.4);
            }
        }
    }
}

TEST_CASE("noise: range, continuity, average") {
    double sum = 0, low = 1, high = 0;
    for (int i = 0; i < 10000; ++i) {
        const double v = value_noise({0.37 * i, 0.11 * i - 500});
        sum += v, low = std::min(low, v), high = std::max(high, v);
    }
    CHECK(low >= 0);
    CHECK(high <= 1);
    CHECK(high - low > 0.9);
    CHECK(sum / 10000 == doctest::Approx(0.5).scale(1e-300).epsilon(0.03));
    for (const double x : {0.0, 5.0, -7.0})
        CHECK(value_noise({x - 1e-9, 0.3}) == doctest::Approx(value_noise({x + 1e-9, 0.3})).scale(1e-300).epsilon(1e-6));
    CHECK(fractal_noise({3, 4}, 100, 1000, 5) == 0.5);  // finer than a pixel: nothing left
}
