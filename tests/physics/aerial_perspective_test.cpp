// Geometry seen through the air: what the air takes from it and what it adds.
#include <doctest/doctest.h>

#include "physics/reference.h"
#include "physics/sky.h"
#include "physics/worst.h"

#include <aureole/models/bruneton.h>
#include <aureole/models/single.h>

#include <cmath>
#include <glm/geometric.hpp>

using namespace aureole;
using namespace aureole::physics;

namespace {

constexpr double vertical_fov = 0.6;

QualitySettings fine_froxels() {
    QualitySettings quality = fine();
    quality.aerial_perspective = {32, 32, 64};
    quality.aerial_perspective_nodes = 3;
    quality.froxel_format = rhi::Format::rgba32_float;
    return quality;
}

Camera camera_at(double bottom_radius, double altitude, double azimuth, double elevation) {
    return look(bottom_radius, altitude, azimuth, elevation, vertical_fov, double{Picture::width} / Picture::height);
}

std::vector<Rgb> difference(const std::vector<Rgb>& a, const std::vector<Rgb>& b) {
    std::vector<Rgb> result;
    for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - b[i]);
    return result;
}

}  // namespace

TEST_CASE("geometry is dimmed by exp(-extinction x distance), each colour by its own") {
    const Rgb extinction(1e-5, 3e-5, 1e-4);
    AtmosphereParameters air;
    air.terms = {even_term(extinction * 0.3, extinction * 0.7, RayleighPhase{})};
    for (const QualitySettings& quality : {QualitySettings::low(), QualitySettings::standard(), fine_froxels()}) {
        CAPTURE(quality.name);
        Picture picture(cpu_float(), air, quality, 64e3);
        const Sun sun = sun_at(0.5);
        picture.place(camera_at(6360e3, 3000, 0.3, 0.1), {&sun, 1});
        Worst worst;
        for (const double distance : {50.0, 1000.0, 9000.0, 40000.0, 64000.0}) {
            // Colour times transmittance is what white geometry shows beyond black geometry.
            const std::vector<Rgb> through = difference(picture.render(distance, Rgb(1)), picture.render(distance, Rgb(0)));
            for (std::size_t i = 0; i < through.size(); ++i)
                for (int c = 0; c < 3; ++c)
                    worst.add(std::abs(through[i][c] - std::exp(-extinction[c] * distance)), distance, i, c, through[i][c]);
        }
        CHECK_WORST(worst, 5e-4);
    }
}

TEST_CASE("geometry in exponential air is dimmed by the column of air before it") {
    Shell shell;
    shell.density = [](Real h) { return std::exp(-h / 2000); };
    AtmosphereParameters air;
    air.terms = {{"haze", ExponentialProfile{2000}, Rgb(5e-5), Rgb(1e-5, 2e-5, 3e-5), HenyeyGreensteinPhase{0.7}}};
    for (const bool finest : {false, true}) {
        CAPTURE(finest);
        Picture picture(cpu_float(), air, finest ? fine_froxels() : QualitySettings::standard(), 96e3);
        const Sun sun = sun_at(1);
        const double altitude = 3000;
        picture.place(camera_at(6360e3, altitude, 0, 0.25), {&sun, 1});  // all of the picture looks up or level
        Worst worst;
        for (const double distance : {500.0, 5000.0, 30000.0, 90000.0}) {
            const std::vector<Rgb> through = difference(picture.render(distance, Rgb(1)), picture.render(distance, Rgb(0)));
            for (std::uint32_t i = 0; i < through.size(); ++i) {
                const glm::dvec3 ray = picture.direction(i % Picture::width, i / Picture::width);
                const double column = static_cast<double>(shell.column(altitude, ray.z, 0, distance));
                for (int c = 0; c < 3; ++c) {
                    const double expected =
                        std::exp(-column * (air.terms[0].scattering_per_m[c] + air.terms[0].absorption_per_m[c]));
                    worst.add(std::abs(through[i][c] - expected), distance, i, c, expected);
                }
            }
        }
        CHECK_WORST(worst, 1e-2);  // froxels are wide: towards the horizon depth grows steeply
    }
}

TEST_CASE("sky = air before a point + what passes it x sky from that point") {
    // A camera at the point sees the rest of the ray: aerial perspective and sky-view must share it out without loss.
    const AtmosphereParameters earth = presets::earth();
    const double radius = earth.planet.bottom_radius_m, altitude = 3000;
    for (const bool finest : {false, true}) {
        CAPTURE(finest);
        const QualitySettings quality = finest ? fine_froxels() : QualitySettings::standard();
        Picture picture(cpu_float(), earth, quality, 90e3);
        SkyOptions options;
        options.quality = quality;
        Sky near(cpu_float(), earth, options), far(cpu_float(), earth, options);
        Worst worst;
        for (const double sun_zenith : {0.5, 1.4})
            for (const double azimuth : finest ? std::vector{0.2} : std::vector{0.2, 2.5}) {
                const Sun sun = sun_at(sun_zenith);
                picture.place(camera_at(radius, altitude, azimuth, 0.15), {&sun, 1});
                near.stand(altitude, sun);
                for (const double distance : {4000.0, 90000.0}) {
                    const std::vector<Rgb> added = picture.render(distance, Rgb(0));
                    const std::vector<Rgb> through = difference(picture.render(distance, Rgb(1)), added);
                    for (const std::uint32_t pixel : {0u, 21u, 88u, 104u, 191u}) {
                        const glm::dvec3 ray = picture.direction(pixel % Picture::width, pixel / Picture::width);
                        const glm::dvec3 point = glm::dvec3(0, 0, radius + altitude) + distance * ray;
                        if (glm::length(point) < radius) continue;
                        far.place(point, {&sun, 1});
                        const Rgb whole = near.radiance(ray), rest = far.radiance(ray);
                        worst.add(apart(added[pixel] + through[pixel] * rest, whole), sun_zenith, azimuth, distance, pixel);
                    }
                }
            }
        CHECK_WORST(worst, finest ? 2e-3 : 5e-3);
    }
}

TEST_CASE("black geometry in thick air takes the fog's colour, whatever its own was") {
    AtmosphereParameters foggy;
    const Rgb extinction(2e-3, 3e-3, 4e-3);
    foggy.planet.top_radius_m = foggy.planet.bottom_radius_m + 1000;
    foggy.terms = {even_term(extinction * 0.8, extinction * 0.2, HenyeyGreensteinPhase{0.3})};
    Picture picture(cpu_float(), foggy, QualitySettings::standard(), 10e3);
    const Sun sun = sun_at(0.7);
    picture.place(camera_at(6360e3, 500, 1, 0), {&sun, 1});
    const std::size_t level = std::size_t{Picture::width} * (Picture::height / 2);  // a ray that stays at one altitude
    const Rgb fog = picture.render(9000, Rgb(0))[level];
    CHECK(sum(fog) > 0.01);
    CHECK(apart(picture.render(9000, Rgb(10))[level], fog) < 1e-4);
    CHECK(apart(picture.render(5000, Rgb(0))[level], fog) < 2e-2);
    for (const double distance : {20.0, 100.0, 300.0, 1000.0}) {
        CAPTURE(distance);
        // In even air, a level ray gathers the fog's colour as the geometry's goes: (1 - T) fog + T colour.
        const Rgb passing = glm::exp(-extinction * distance);
        CHECK(apart(picture.render(distance, Rgb(0))[level], fog * (Rgb(1) - passing)) < 2e-2);
        const Rgb color(0.5, 0.2, 0.1);
        CHECK(apart(picture.render(distance, color)[level], fog * (Rgb(1) - passing) + color * passing) < 2e-2);
    }
}

TEST_CASE("geometry at no distance keeps its colour, and from space the air begins where it begins") {
    const AtmosphereParameters earth = presets::earth();
    Picture picture(cpu_float(), earth, QualitySettings::standard(), 96e3);
    const Sun sun = sun_at(0.5);
    const Rgb color(0.3, 0.2, 0.1);
    picture.place(camera_at(earth.planet.bottom_radius_m, 1000, 0, 0), {&sun, 1});
    for (const Rgb& pixel : picture.render(0.2, color)) CHECK(apart(pixel, color) < 1e-4);

    picture.place(camera_at(earth.planet.bottom_radius_m, 300e3, 0, -pi / 2), {&sun, 1});
    for (const Rgb& pixel : picture.render(150e3, color)) CHECK(apart(pixel, color) < 1e-6);  // still above the air
    const std::size_t centre = std::size_t{Picture::width} * (Picture::height / 2) + Picture::width / 2;
    CHECK(apart(picture.render(290e3, color)[centre], color) > 0.01);  // deep in it
}

TEST_CASE("bruneton: the air before near geometry is what a march finds, through air that thins quickly too") {
    // Its own is a difference of look-ups, off by what both are off by, and near the camera a share of that by how the air
    // thins.
    models::BrunetonSettings once;
    once.orders = 1;
    for (const double scale_height : {8000.0, 1200.0, 300.0}) {
        AtmosphereParameters air;
        air.planet.ground_albedo = Rgb(0);
        air.terms = {{"air", ExponentialProfile{scale_height}, Rgb(2e-5, 5e-5, 1e-4), Rgb(0), RayleighPhase{}}};
        Picture table(cpu_double(), air, models::bruneton(once), 96e3), march(cpu_double(), air, models::single({}), 96e3);
        const Sun sun = sun_at(0.7);
        Worst worst;
        for (const double elevation : {1.2, 0.6, 0.0}) {
            const Camera camera = camera_at(6360e3, 100, 2, elevation);
            table.place(camera, {&sun, 1});
            march.place(camera, {&sun, 1});
            for (const double distance : {1.0, 10.0, 60.0, 200.0, 1000.0}) {
                const auto by_table = table.render(distance, Rgb(0)), by_march = march.render(distance, Rgb(0));
                const std::size_t centre = std::size_t{Picture::width} * (Picture::height / 2) + Picture::width / 2;
                worst.add(apart(by_table[centre], by_march[centre]), elevation, distance, by_march[centre].g);
            }
        }
        CAPTURE(scale_height);
        CHECK_WORST(worst, 0.08);
    }
}
