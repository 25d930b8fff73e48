// What a host's own shader gets from host/aureole.glsl is what the composite shows, and follows from the air itself where that
// is known in closed form.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "host/compare.h"
#include "host/scenes.h"

using namespace aureole;
using namespace aureole::host;
using namespace aureole::passes;

namespace {

Image colored(rhi::Extent extent, double value) {
    return {extent, std::vector<glm::dvec4>(std::size_t{extent.width} * extent.height, glm::dvec4(value, value, value, 1))};
}

Answer ask_one(Rig& rig, const Question& question) { return ask(rig, std::span(&question, 1))[0]; }

Question towards(const glm::dvec3& direction) {
    Question q;
    q.direction = direction;
    return q;
}
Question at(const glm::dvec3& offset_m) {
    Question q;
    q.offset_m = offset_m;
    return q;
}

/// A point `altitude_m` over the +z pole, seen from the camera there.
glm::dvec3 above_camera(const Scene& scene, double altitude_m) { return {0, 0, altitude_m - scene.altitude_m}; }

}  // namespace

TEST_CASE("the same tables give the same answers in float and in double") {
    for (const Scene& scene : scenes()) {
        INFO(scene.name);
        Shown exact(open_cpu_double(), scene), shown(open_cpu_float(), scene);
        exact.take_tables(shown);
        const std::vector<Question> questions = assorted(400, static_cast<int>(scene.suns.size()));
        check_same_answers(ask(shown.rig, questions), ask(exact.rig, questions));
    }
}

TEST_CASE("the sky is what the composite shows in every direction, and stars shine through it alike") {
    for (Scene scene : scenes()) {
        INFO(scene.name);
        scene.setup.composite = {.target_format = rhi::Format::rgba32_float, .scene_color = true, .sun_disk = false};
        Shown shown(open_cpu_float(), scene);
        constexpr rhi::Extent extent{20, 15, 1};
        std::vector<Question> questions = assorted(300, 1);
        CompositeTargets targets;
        Image directions{extent, {}};
        for (const Question& q : questions) directions.texels.emplace_back(q.direction, 0);
        targets.directions = shown.backend->make("directions", rhi::Format::rgba32_float, directions);
        targets.scene_color = shown.backend->make("darkness", rhi::Format::rgba32_float, colored(extent, 0));
        const Image sky = shown.rig.show(extent, targets);
        targets.scene_color = shown.backend->make("stars", rhi::Format::rgba32_float, colored(extent, 1));
        const Image stars = shown.rig.show(extent, targets);

        const std::vector<Answer> answers = ask(shown.rig, questions);
        Worst radiance("sky", 1e-5, 1e-7), through("sky transmittance", 1e-5, 1e-6);
        for (std::size_t i = 0; i < answers.size(); ++i) {
            radiance.add(i, answers[i].sky, Rgb(sky.texels[i]));
            through.add(i, answers[i].sky_transmittance, Rgb(stars.texels[i] - sky.texels[i]));
        }
        radiance.check();
        through.check();
    }
}

TEST_CASE("the air before a point is what the composite puts before white and black geometry") {
    for (Scene scene : scenes()) {
        if (scene.setup.view.projection != Projection::matrix) continue;  // there every pixel is sky
        INFO(scene.name);
        scene.setup.composite = {.target_format = rhi::Format::rgba32_float, .scene_color = true, .scene_depth = true};
        if (scene.altitude_m > 1e5)
            scene.camera = look(6.36e6, scene.altitude_m, 0.7, -0.6, 1, 1.5);  // down at the limb and below it
        Shown shown(open_cpu_float(), scene);
        constexpr rhi::Extent extent{24, 16, 1};
        const double near = scene.camera.projection[3][2];  // reversed, infinite: stored depth = near / view depth
        const glm::dvec3 forward = -glm::dvec3(glm::transpose(scene.camera.view)[2]);
        Image depth = colored(extent, 0);
        std::vector<Question> questions;
        for (std::uint32_t i = 0; i < extent.width * extent.height; ++i) {
            Question q = pixel_question(scene.camera, extent, i % extent.width, i / extent.width);
            const double stored = static_cast<float>(near / std::pow(10.0, 1 + 5.5 * (i % 37) / 37));
            depth.texels[i].x = stored;
            q.distance_m = near / stored / glm::dot(q.direction, forward);
            questions.push_back(q);
        }
        CompositeTargets targets;
        targets.scene_depth = shown.backend->make("depth", rhi::Format::r32_float, depth);
        targets.scene_color = shown.backend->make("black", rhi::Format::rgba32_float, colored(extent, 0));
        const Image black = shown.rig.show(extent, targets);
        targets.scene_color = shown.backend->make("white", rhi::Format::rgba32_float, colored(extent, 1));
        const Image white = shown.rig.show(extent, targets);

        const std::vector<Answer> answers = ask(shown.rig, questions);
        Worst radiance("air radiance", 2e-5, 1e-7), through("air transmittance", 2e-5, 1e-6);
        for (std::size_t i = 0; i < answers.size(); ++i) {
            radiance.add(i, answers[i].air_radiance, Rgb(black.texels[i]));
            through.add(i, answers[i].air_transmittance, Rgb(white.texels[i] - black.texels[i]));
        }
        radiance.check();
        through.check();
    }
}

TEST_CASE("without froxels the air before a point is clear") {
    Scene scene = noon();
    scene.setup.view.aerial_perspective = false;
    Shown shown(open_cpu_float(), scene);
    Question q = towards({0.6, 0, 0.8});
    q.distance_m = 5e4;
    const Answer answer = ask_one(shown.rig, q);
    CHECK(answer.air_transmittance == Rgb(1));
    CHECK(answer.air_radiance == Rgb(0));
    const std::string define = "#define AUREOLE_SPEC_25 ";  // so that no device computes rows of a table that has none
    CHECK(shown.rig.view.shader_defines().find(define + "0") != std::string::npos);
    CHECK(Shown(open_cpu_float(), noon()).rig.view.shader_defines().find(define + "1") != std::string::npos);
    CHECK(answer.sky.b > 0.01);
    shown.rig.show({4, 4, 1});
}

TEST_CASE("a shader that is compiled ahead gets the constants that the text defines") {
    Shown shown(open_cpu_float(), noon());
    const std::vector<rhi::Specialization> defined = specialization_of(shown.rig.view),
                                           given = shown.rig.view.shader_constants();
    REQUIRE(given.size() == defined.size());
    REQUIRE(given.size() > 5);
    for (std::size_t i = 0; i < given.size(); ++i) {
        CHECK(given[i].id == defined[i].id);
        CHECK(given[i].bits == defined[i].bits);
        CHECK(given[i].id < 64);
    }
}

TEST_CASE("a zenith sun reaches the ground, any height and space through the air that is above them") {
    for (const char* preset : {"earth", "hazy_earth", "mars"}) {
        INFO(preset);
        Scene scene = noon();
        scene.setup.air = presets::by_name(preset);
        scene.setup.quality.transmittance = {128, 128, 1};
        scene.setup.quality.transmittance_nodes = 16;
        scene.altitude_m = 500;
        scene.camera = camera_at(scene.setup.air.planet, scene.altitude_m);
        scene.suns = {sun_at(90)};
        scene.suns[0].irradiance = {2, 3, 5};
        Shown shown(open_cpu_double(), scene);
        const Planet& planet = scene.setup.air.planet;
        const double top = planet.top_radius_m - planet.bottom_radius_m;
        for (const double altitude : {0.0, 3e3, 4e4, top, 2 * top}) {
            CAPTURE(altitude);
            // The column above, by the trapezium rule on the medium itself.
            constexpr int steps = 4000;
            Rgb depth(0);
            for (int i = 0; i <= steps && altitude < top; ++i) {
                const double h = altitude + (top - altitude) * i / steps;
                depth += sample_medium(scene.setup.air, std::min(h, top - 1)).extinction_per_m * (i % steps == 0 ? 0.5 : 1.0);
            }
            const Rgb expected = glm::exp(-depth * std::max(top - altitude, 0.0) / double{steps});
            const Answer answer = ask_one(shown.rig, at(above_camera(scene, altitude)));
            for (int c = 0; c < 3; ++c) {
                CHECK(answer.sun_transmittance[c] == doctest::Approx(expected[c]).scale(1e-300).epsilon(1e-3));
                CHECK(answer.sun_irradiance[c] == doctest::Approx(answer.sun_transmittance[c] * scene.suns[0].irradiance[c]));
            }
        }
    }
}

TEST_CASE("the sun sets for a point where its horizon is, disk by disk, and the planet's shadow is dark at any height") {
    Scene scene = noon();
    scene.setup.air = presets::airless();  // nothing but the horizon
    scene.suns[0].angular_radius_rad = 0.01;
    const double radius = scene.setup.air.planet.bottom_radius_m;
    scene.camera = camera_at(scene.setup.air.planet, scene.altitude_m = 1000);
    const auto share_at = [&](double altitude, double elevation) {
        scene.suns[0].direction = {std::cos(elevation), 0, std::sin(elevation)};
        Shown shown(open_cpu_double(), scene);
        return ask_one(shown.rig, at(above_camera(scene, altitude))).sun_transmittance.g;
    };
    for (const double altitude : {0.0, 1000.0, 4e4, 4e5, 1e8}) {
        CAPTURE(altitude);
        const double dip = std::acos(radius / (radius + altitude));
        const auto share = [&](double elevation) { return share_at(altitude, elevation); };
        CHECK(share(-dip) == doctest::Approx(0.5).scale(1e-300).epsilon(1e-3));
        CHECK(share(-dip + 0.0101) == doctest::Approx(1));
        CHECK(share(-dip - 0.0101) == doctest::Approx(0).epsilon(1e-6));
        // Half a radius up: a chord at c = 1/2 leaves 1/2 + (c sqrt(1 - c^2) + asin c) / pi of the disk.
        CHECK(share(-dip + 0.005) ==
              doctest::Approx(0.5 + (std::sqrt(0.75) / 2 + std::asin(0.5)) / std::numbers::pi).scale(1e-300).epsilon(1e-3));
        CHECK(share(-std::numbers::pi / 2) == 0);  // behind the planet's middle
        CHECK(share(std::numbers::pi / 2) == 1);
    }
    CHECK(share_at(1e9, std::numbers::pi / 2) == 1);  // the planet is opposite, and smaller than the sun
}

TEST_CASE("nothing jumps where a point passes the top of the air, low suns behind the limb included") {
    Scene scene = noon();
    const Planet& planet = scene.setup.air.planet;
    const double top = planet.top_radius_m - planet.bottom_radius_m;
    const double limb = -glm::degrees(std::acos(planet.bottom_radius_m / planet.top_radius_m));
    for (const double elevation : {60.0, 1.0, -1.0, limb / 2, limb + 0.5, limb + 0.1, limb - 0.2}) {
        CAPTURE(elevation);
        scene.suns = {sun_at(elevation)};
        Shown shown(open_cpu_double(), scene);
        const Rgb below = ask_one(shown.rig, at(above_camera(scene, top - 0.05))).sun_transmittance;
        const Rgb above = ask_one(shown.rig, at(above_camera(scene, top + 0.05))).sun_transmittance;
        for (int c = 0; c < 3; ++c) CHECK(above[c] == doctest::Approx(below[c]).scale(1e-300).epsilon(1e-3));
        if (elevation > 0) CHECK(above == Rgb(1));
        if (elevation < -9) CHECK(above.b < 0.5 * above.r);  // the limb takes its share
        if (elevation < -9) CHECK(above.r > 0);
    }
}

TEST_CASE("nothing jumps where the camera passes the top of the air") {
    Scene scene = noon();
    // Both sides as exact as they get: a jump would remain, the errors of small tables would not.
    scene.setup.quality.sky_view = {12, 600, 1};
    scene.setup.quality.sky_view_nodes = 16;
    const Planet& planet = scene.setup.air.planet;
    const double top = planet.top_radius_m - planet.bottom_radius_m;
    std::vector<Question> questions;
    for (int i = 0; i < 60; ++i) {
        const double angle = glm::radians(-90 + 1.5 * i + 0.7);
        questions.push_back(towards({std::cos(angle) * 0.8, std::cos(angle) * 0.6, std::sin(angle)}));
        questions.back().distance_m = 5e5;
    }
    for (const double elevation : {60.0, -3.0}) {
        CAPTURE(elevation);
        scene.suns = {sun_at(elevation)};
        const auto from = [&](double altitude) {
            scene.camera = camera_at(planet, altitude);
            Shown shown(open_cpu_double(), scene);
            return ask(shown.rig, questions);
        };
        const std::vector<Answer> inside = from(top - 0.5), outside = from(top + 0.5);
        Worst sky("sky", 3e-3, 3e-4), through("sky transmittance", 3e-3, 3e-4), sun("sun irradiance", 1e-4, 0);
        Worst air("air transmittance", 1e-4, 0), haze("air radiance", 1e-3, 1e-4);
        for (std::size_t i = 0; i < questions.size(); ++i) {
            sky.add(i, outside[i].sky, inside[i].sky);
            through.add(i, outside[i].sky_transmittance, inside[i].sky_transmittance);
            sun.add(i, outside[i].sun_irradiance, inside[i].sun_irradiance);
            air.add(i, outside[i].air_transmittance, inside[i].air_transmittance);
            haze.add(i, outside[i].air_radiance, inside[i].air_radiance);
        }
        for (const Worst* part : {&sky, &through, &sun, &air, &haze}) part->check();
    }
}

TEST_CASE("below the horizon lies the lit ground: on an airless body exactly, up to the horizon's own line") {
    Scene scene = scenes()[5];
    const Planet& planet = scene.setup.air.planet;
    const double r = planet.bottom_radius_m + scene.altitude_m;
    const double dip = std::acos(planet.bottom_radius_m / r);
    Shown shown(open_cpu_double(), scene);
    const glm::dvec3 sun = glm::normalize(scene.suns[0].direction);
    for (const double below_deg : {90 - glm::degrees(dip), 45.0, 5.0, 0.2, 0.01}) {
        CAPTURE(below_deg);
        const double elevation = -dip - glm::radians(below_deg);
        const glm::dvec3 direction{0, std::cos(elevation), std::sin(elevation)};
        // Where the ray meets the sphere.
        const double b = r * direction.z;
        const double t = -b - std::sqrt(b * b - (r - planet.bottom_radius_m) * (r + planet.bottom_radius_m));
        const glm::dvec3 normal = (glm::dvec3(0, 0, r) + t * direction) / planet.bottom_radius_m;
        const Rgb expected = planet.ground_albedo / std::numbers::pi * glm::dot(normal, sun);
        const Rgb got = ask_one(shown.rig, towards(direction)).sky;
        for (int c = 0; c < 3; ++c) CHECK(got[c] == doctest::Approx(expected[c]).scale(1e-300).epsilon(2e-3));
    }
    const double just_above = -dip + glm::radians(0.01);
    CHECK(ask_one(shown.rig, towards({0, std::cos(just_above), std::sin(just_above)})).sky == Rgb(0));
}

TEST_CASE("suns that update was not given are dark") {
    Scene scene = noon();
    scene.setup.view.max_suns = 3;
    Shown shown(open_cpu_float(), scene);
    Question q = towards({0, 0, 1});
    q.sun = 2;
    CHECK(ask_one(shown.rig, q).sun_irradiance == Rgb(0));
    Shown alone(open_cpu_float(), noon());
    const Rgb one = ask_one(alone.rig, towards({0, 0, 1})).sky_irradiance, three = ask_one(shown.rig, q).sky_irradiance;
    for (int c = 0; c < 3; ++c) CHECK(three[c] == doctest::Approx(one[c]).scale(1e-300).epsilon(1e-5));
}
