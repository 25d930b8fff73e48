// Sun and sky for the host's lights: the table against the sky it sums up, and the CPU's LightTable against the shaders.
#include <aureole/light.h>
#include <aureole/rhi/checks.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <numbers>

#include "host/compare.h"
#include "host/scenes.h"

using namespace aureole;
using namespace aureole::host;
using namespace aureole::passes;

namespace {

/// As a host does it: copied from State::sampled and back, then read as bytes.
std::vector<float> read_back(Shown& shown, std::size_t suns) {
    rhi::Device& device = shown.backend->device();
    const rhi::Texture table = shown.rig.view.light_table();
    std::vector<float> texels(LightTable::floats_per_sun * suns);
    const rhi::Buffer buffer = device.create_buffer({"light", texels.size() * sizeof(float), rhi::Usage::read_back});
    shown.backend->run([&](rhi::CommandList& commands) {
        const rhi::TextureBarrier before{table, rhi::State::sampled, rhi::State::copy_source};
        const rhi::TextureBarrier after{table, rhi::State::copy_source, rhi::State::sampled};
        const rhi::BufferBarrier filled{buffer, rhi::State::undefined, rhi::State::copy_destination};
        commands.barrier({&before, 1}, {&filled, 1});
        commands.copy(rhi::TextureToBuffer{table, buffer});
        commands.barrier({&after, 1}, {});
    });
    device.read_buffer(buffer, std::as_writable_bytes(std::span(texels)));
    device.destroy(buffer, 0);
    return texels;
}

std::vector<Question> looks(std::span<const glm::dvec3> directions) {
    std::vector<Question> questions;
    for (const glm::dvec3& direction : directions) {
        questions.emplace_back();
        questions.back().direction = direction;
    }
    return questions;
}

/// Integral over the sphere of the sky as the look-up gives it, weighted.
template <class Weight>
Rgb integrate(std::span<const glm::dvec3> directions, std::span<const Answer> answers, Weight weight) {
    Rgb sum(0);
    for (std::size_t i = 0; i < directions.size(); ++i) sum += answers[i].sky * weight(directions[i]);
    return sum * (4 * std::numbers::pi / static_cast<double>(directions.size()));
}

/// Real spherical harmonics by their definition in angles: N P_l^|m|(cos theta) times sqrt2 cos or sin of m phi.
double harmonic(int i, const glm::dvec3& d) {
    constexpr int degree[] = {0, 1, 1, 1, 2, 2, 2, 2, 2}, order[] = {0, -1, 0, 1, -2, -1, 0, 1, 2};
    const int l = degree[i], m = order[i], n = std::abs(m);
    const double ratio = std::tgamma(l - n + 1.0) / std::tgamma(l + n + 1.0);
    const double legendre = std::assoc_legendre(static_cast<unsigned>(l), static_cast<unsigned>(n), d.z);
    const double phi = std::atan2(d.y, d.x);
    const double wave = m == 0 ? 1 : std::numbers::sqrt2 * (m > 0 ? std::cos(n * phi) : std::sin(n * phi));
    return std::sqrt((2 * l + 1) / (4 * std::numbers::pi) * ratio) * legendre * wave;
}

std::vector<glm::dvec3> normals_of(const Scene& scene) {
    const glm::dvec3 up(0, 0, 1), sun = glm::normalize(scene.suns[0].direction);
    return {up,
            -up,
            glm::normalize(up + sun),
            glm::normalize(up - sun),
            glm::normalize(glm::cross(up, sun)),
            sun,
            -sun,
            glm::normalize(glm::dvec3(-1, 2, 0.5))};
}

}  // namespace

TEST_CASE("the light table's coefficients are those of the sky that the look-up shows") {
    const std::vector<glm::dvec3> directions = sphere(16000);
    for (const Scene& scene : scenes()) {
        if (scene.altitude_m > 1e5) continue;  // from space the limb is too thin for the table's few directions
        INFO(scene.name);
        Shown shown(open_cpu_float(), scene);
        const std::vector<Answer> answers = ask(shown.rig, looks(directions));
        const LightTable light(read_back(shown, scene.suns.size()));
        // Measured: 2.9 % of the mean radiance, at dusk.
        // A table with the aerosols' peak in it is harder on the few directions of the pass.
        Worst worst("coefficient", 0, scene.setup.model ? 0.05 : 0.03);
        for (int i = 0; i < LightTable::coefficient_count; ++i) {
            Rgb sum(0);
            for (int sun = 0; sun < light.sun_count(); ++sun) sum += light.sky_coefficient(i, sun);
            worst.add(static_cast<std::size_t>(i), sum,
                      integrate(directions, answers, [&](auto& d) { return harmonic(i, d); }));
        }
        worst.check();
    }
}

TEST_CASE("the sky's irradiance is the look-up's integral over the hemisphere, as well as degree 2 can tell") {
    const std::vector<glm::dvec3> directions = sphere(16000);
    for (const Scene& scene : scenes()) {
        INFO(scene.name);
        Shown shown(open_cpu_float(), scene);
        const std::vector<Answer> sky = ask(shown.rig, looks(directions));
        const std::vector<glm::dvec3> normals = normals_of(scene);
        const std::vector<Answer> answers = ask(shown.rig, looks(normals));
        // Measured: 5.8 % of the largest irradiance with a low sun, 1.5 % at noon.
        Worst worst("irradiance", 0, scene.suns[0].direction.z > 0.5 ? 0.02 : 0.07);
        for (std::size_t i = 0; i < normals.size(); ++i) {
            const auto lit = [&](const glm::dvec3& d) { return std::max(glm::dot(d, normals[i]), 0.0); };
            worst.add(i, answers[i].sky_irradiance, integrate(directions, sky, lit));
        }
        worst.check();
    }
}

TEST_CASE("the sun's colour is what the air lets through to the camera") {
    for (const Scene& scene : scenes()) {
        INFO(scene.name);
        Shown shown(open_cpu_float(), scene);
        const LightTable light(read_back(shown, scene.suns.size()));
        for (int sun = 0; sun < light.sun_count(); ++sun) {
            Question here;
            here.sun = sun;
            const Answer answer = ask(shown.rig, std::span(&here, 1))[0];
            const Rgb& irradiance = scene.suns[static_cast<std::size_t>(sun)].irradiance;
            for (int c = 0; c < 3; ++c) {
                CHECK(light.sun_irradiance(sun)[c] == doctest::Approx(answer.sun_irradiance[c]).scale(1e-300).epsilon(2e-5));
                CHECK(answer.sun_irradiance[c] ==
                      doctest::Approx(irradiance[c] * answer.sun_transmittance[c]).scale(1e-300).epsilon(1e-6));
            }
        }
    }
}

TEST_CASE("on the CPU LightTable gives the shaders' irradiance, from the device's texels") {
    for (const Scene& scene : scenes()) {
        INFO(scene.name);
        Shown shown(open_cpu_double(), scene);
        const LightTable light(read_back(shown, scene.suns.size()));
        REQUIRE(light.sun_count() == static_cast<int>(scene.suns.size()));
        const std::vector<glm::dvec3> normals = sphere(50);
        const std::vector<Answer> answers = ask(shown.rig, looks(normals));
        Worst worst("irradiance", 1e-6, 2e-7);  // the read-back rounds to float
        for (std::size_t i = 0; i < normals.size(); ++i) {
            worst.add(i, light.sky_irradiance(3.5 * normals[i]), answers[i].sky_irradiance);
            Rgb parts(0);
            for (int sun = 0; sun < light.sun_count(); ++sun) parts += light.sky_irradiance(normals[i], sun);
            for (int c = 0; c < 3; ++c) CHECK(parts[c] >= light.sky_irradiance(normals[i])[c] * (1 - 1e-9));
        }
        worst.check();
    }
}

TEST_CASE("a uniform sky lights every surface by pi times its radiance, and a tilted one by its gradient") {
    std::vector<float> texels(LightTable::floats_per_sun, 0.0f);
    const auto set = [&](int column, float r, float g, float b) {
        const float rgb[] = {r, g, b};
        std::copy(rgb, rgb + 3, texels.begin() + 4 * column);
    };
    const float mean = static_cast<float>(std::sqrt(4 * std::numbers::pi));  // coefficient of radiance 1
    set(0, mean, 2 * mean, 0);
    set(2, 0, 0, static_cast<float>(std::sqrt(4 * std::numbers::pi / 3)));  // radiance z
    set(9, 7, 8, 9);
    const LightTable light(texels);
    for (const glm::dvec3& normal : sphere(20)) {
        const Rgb irradiance = light.sky_irradiance(normal);
        CHECK(irradiance.r == doctest::Approx(std::numbers::pi));
        CHECK(irradiance.g == doctest::Approx(2 * std::numbers::pi));
        CHECK(irradiance.b == doctest::Approx(std::max(2 * std::numbers::pi / 3 * normal.z, 0.0)));
    }
    CHECK(light.sun_irradiance() == Rgb(7, 8, 9));
    CHECK(light.sky_coefficient(0).g == doctest::Approx(2 * mean));
    CHECK(light.sun_count() == 1);
}

TEST_CASE("LightTable refuses what cannot be a light table, by name") {
    const auto refusal = [](auto&& call) {
        try {
            call();
        } catch (const Error& error) {
            CHECK(error.code() == ErrorCode::invalid_argument);
            return error.field() + ": " + error.value();
        }
        return std::string("accepted");
    };
    std::vector<float> texels(LightTable::floats_per_sun, 1.0f);
    const auto make = [&] { (void)LightTable(texels); };
    CHECK(refusal(make) == "accepted");
    texels.resize(39);
    CHECK(refusal(make) == "texels: 39 floats");
    texels.resize(200, 1.0f);
    CHECK(refusal(make) == "texels: 200 floats");
    texels.clear();
    CHECK(refusal(make) == "texels: 0 floats");
    texels.resize(160, 1.0f);
    CHECK(refusal(make) == "accepted");
    texels[41] = std::nanf("");
    CHECK(refusal(make) == "texels[41]: nan");
    texels[41] = 0;

    const LightTable light(texels);
    CHECK(refusal([&] { (void)light.sun_irradiance(4); }) == "sun: 4");
    CHECK(refusal([&] { (void)light.sun_irradiance(-1); }) == "sun: -1");
    CHECK(refusal([&] { (void)light.sky_coefficient(9); }) == "coefficient: 9");
    CHECK(refusal([&] { (void)light.sky_coefficient(0, 4); }) == "sun: 4");
    CHECK(refusal([&] { (void)light.sky_irradiance({0, 0, 0}); }) == "normal length: 0");
    CHECK(refusal([&] { (void)light.sky_irradiance({0, 0, 1}, 4); }) == "sun: 4");
}
