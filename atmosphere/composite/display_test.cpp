// What the composite does after the light: exposure, tone map, the sRGB curve, dither; and the sun's disk.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "passes/scene.h"
#include "passes/trio.h"

using namespace aureole;
using namespace aureole::passes;

namespace {

constexpr rhi::Extent size{61, 45, 1};

Setup setup_of(const CompositeSettings& composite) {
    Setup setup;
    setup.composite = composite;
    setup.view.light = false;
    setup.view.aerial_perspective = false;
    return setup;
}

/// The sky over 2 m at a sun of 12 degrees. It is about 0.03 bright for a sun of irradiance 1.
Image sky(Backend& backend, const CompositeSettings& composite) {
    Rig rig(backend, setup_of(composite));
    rig.record_air();
    rig.record_view(camera_at(rig.setup.air.planet, 2), sun_at(12));
    return rig.show(size);
}

CompositeSettings linear() { return {.target_format = rhi::Format::rgba32_float, .exposure = 20}; }

/// Hill's fit of the ACES transforms, from its published matrices.
glm::dvec3 aces(const glm::dvec3& color) {
    const glm::dmat3 in =
        glm::transpose(glm::dmat3(0.59719, 0.35458, 0.04823, 0.07600, 0.90834, 0.01566, 0.02840, 0.13383, 0.83777));
    const glm::dmat3 out =
        glm::transpose(glm::dmat3(1.60475, -0.53108, -0.07367, -0.10208, 1.10813, -0.00605, -0.00327, -0.07276, 1.07602));
    const glm::dvec3 v = in * color;
    const glm::dvec3 fitted = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
    return glm::clamp(out * fitted, 0.0, 1.0);
}

double srgb(double x) {
    x = std::clamp(x, 0.0, 1.0);
    return x < 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

template <class Check>
void on_every_backend(const Check& check) {
    for (const auto& backend : {open_cpu_float(), open_cpu_double(), open_vulkan()})
        if (backend) check(*backend);
}

}  // namespace

TEST_CASE("display: exposure multiplies, and can be set anew without recording the tables") {
    on_every_backend([](Backend& backend) {
        CompositeSettings once = linear(), thrice = linear();
        once.exposure = 1;
        thrice.exposure = 3;
        const Image reference = sky(backend, once), bright = sky(backend, thrice);
        for (std::size_t i = 0; i < reference.texels.size(); ++i)
            for (int channel = 0; channel < 3; ++channel)
                CHECK(bright.texels[i][channel] ==
                      doctest::Approx(3 * reference.texels[i][channel]).scale(1e-300).epsilon(1e-6));

        Rig rig(backend, setup_of(once));
        rig.record_air();
        rig.record_view(camera_at(rig.setup.air.planet, 2), sun_at(12));
        rig.view.set_exposure(3);
        CHECK_THROWS_AS(rig.view.set_exposure(0), Error);
        CHECK_THROWS_AS(rig.view.set_exposure(-1), Error);
        CHECK_THROWS_AS(rig.view.set_exposure(std::nan("")), Error);
        backend.run([&](rhi::CommandList& commands) { rig.view.record(commands); });
        CHECK(!rig.view.reports()[0].recorded);
        CHECK(rig.show(size) == bright);
    });
}

TEST_CASE("display: tone map and sRGB curve are the published ones") {
    on_every_backend([](Backend& backend) {
        const Image reference = sky(backend, linear());
        CompositeSettings settings = linear();
        settings.tone_map = ToneMap::aces_fitted;
        const Image mapped = sky(backend, settings);
        settings.encode_srgb = true;
        const Image encoded = sky(backend, settings);
        for (std::size_t i = 0; i < reference.texels.size(); ++i) {
            const glm::dvec3 expected = aces(glm::dvec3(reference.texels[i]));
            for (int channel = 0; channel < 3; ++channel) {
                CHECK(mapped.texels[i][channel] == doctest::Approx(expected[channel]).scale(1e-300).epsilon(1e-5));
                CHECK(encoded.texels[i][channel] == doctest::Approx(srgb(expected[channel])).scale(1e-300).epsilon(1e-4));
            }
        }
    });
}

TEST_CASE("display: dither stays within one 8-bit step, is there, and has no bias") {
    on_every_backend([](Backend& backend) {
        CompositeSettings settings = linear();
        settings.exposure = 5;
        settings.encode_srgb = true;
        const Image plain = sky(backend, settings);
        settings.dither = true;
        const Image dithered = sky(backend, settings);
        double sum = 0, squares = 0, most = 0;
        for (std::size_t i = 0; i < plain.texels.size(); ++i) {
            const double noise = (dithered.texels[i].y - plain.texels[i].y) * 255;
            most = std::max(most, std::abs(noise));
            sum += noise;
            squares += noise * noise;
            CHECK(dithered.texels[i].x - plain.texels[i].x == doctest::Approx(noise / 255).scale(1e-300).epsilon(1e-3));
        }
        const double count = static_cast<double>(plain.texels.size());
        CHECK(most <= 1.0001);
        CHECK(most > 0.8);
        CHECK(std::abs(sum / count) < 0.02);
        CHECK(squares / count ==
              doctest::Approx(1.0 / 6).scale(1e-300).epsilon(0.1));  // the variance of a triangle from -1 to 1
    });
}

TEST_CASE("display: in 8 bits every backend shows the same within a step, dithered or not") {
    const auto single = open_cpu_float(), vulkan = open_vulkan();
    if (!vulkan) return;
    for (const bool raster : {false, true}) {
        for (const bool dither : {false, true}) {
            CompositeSettings settings = linear();
            settings.target_format = rhi::Format::rgba8_unorm;
            settings.raster = raster;
            settings.tone_map = ToneMap::aces_fitted;
            settings.encode_srgb = true;
            settings.dither = dither;
            Worst worst;
            worst.compare(sky(*vulkan, settings), sky(*single, settings), {Measure::Kind::absolute});
            INFO(worst.text());
            CHECK(worst.error() <= 1.0001 / 255);
        }
    }
}

TEST_CASE("display: half-float and packed targets hold what full ones do") {
    on_every_backend([](Backend& backend) {
        const Image reference = sky(backend, linear());
        CompositeSettings settings = linear();
        settings.target_format = rhi::Format::rgba16_float;
        for (const bool raster : {false, true}) {
            settings.raster = raster;
            Worst worst;
            worst.compare(sky(backend, settings), reference, {Measure::Kind::half_steps});
            INFO(worst.text());
            CHECK(worst.error() <= 1);
        }
    });
}

namespace {

/// Looks straight at a sun of a big disk, one pixel a twentieth of its radius.
Image at_the_sun(Backend& backend, double elevation_deg, const Sun& sun, bool disk, const AtmosphereParameters& air) {
    CompositeSettings settings{.target_format = rhi::Format::rgba32_float, .sun_disk = disk};
    Setup setup = setup_of(settings);
    setup.air = air;
    Rig rig(backend, setup);
    rig.record_air();
    const double degree = std::numbers::pi / 180;
    const Camera camera =
        look(air.planet.bottom_radius_m, 2, 0, elevation_deg * degree, 2.25 * sun.angular_radius_rad, 61.0 / 45.0);
    rig.record_view(camera, sun);
    return rig.show(size);
}

}  // namespace

TEST_CASE("display: the sun's disk adds up to its irradiance, through the air, with and without darkening to its edge") {
    on_every_backend([](Backend& backend) {
        for (const LimbDarkening limb : {LimbDarkening::none, LimbDarkening::neckel94}) {
            for (const auto& air : {presets::airless(), presets::earth()}) {
                Sun sun = sun_at(35);
                sun.limb_darkening = limb;
                sun.irradiance = {2, 3, 5};
                const Image with = at_the_sun(backend, 35, sun, true, air), without = at_the_sun(backend, 35, sun, false, air);
                // Pixels are squares on a plane in front of the eye; so near its axis their solid angle is the same for all.
                const double side = 2 * std::tan(1.125 * sun.angular_radius_rad) / size.height;
                glm::dvec3 sum(0);
                for (std::size_t i = 0; i < with.texels.size(); ++i)
                    sum += (glm::dvec3(with.texels[i]) - glm::dvec3(without.texels[i])) * side * side;
                const double air_mass = 1 / std::sin(35 * std::numbers::pi / 180);
                const glm::dvec3 expected = sun.irradiance * glm::exp(-air_mass * vertical_optical_depth(air));
                for (int channel = 0; channel < 3; ++channel)
                    CHECK(sum[channel] == doctest::Approx(expected[channel]).scale(1e-300).epsilon(0.02));
                // Darkening: the edge of the disk, nine tenths out, against its middle.
                const double middle = with.at(30, 22).z - without.at(30, 22).z, edge = with.at(30, 40).z - without.at(30, 40).z;
                if (limb == LimbDarkening::none)
                    CHECK(edge == doctest::Approx(middle).scale(1e-300).epsilon(0.01));
                else
                    CHECK(edge < 0.8 * middle);
            }
        }
    });
}

TEST_CASE("display: no disk through the ground, for a sun below the horizon, or where there is geometry") {
    const auto cpu = open_cpu_float();
    const Sun sun = sun_at(-1.5);
    const Image with = at_the_sun(*cpu, -1.5, sun, true, presets::earth());
    const Image without = at_the_sun(*cpu, -1.5, sun, false, presets::earth());
    CHECK(with == without);

    Setup setup;
    setup.composite = {.target_format = rhi::Format::rgba32_float, .scene_color = true, .scene_depth = true};
    setup.view.aerial_perspective = false;
    Rig rig(*cpu, setup);
    rig.record_air();
    const DepthConvention depth = perspective_conventions(61.0 / 45.0).front();
    Camera camera = look(setup.air.planet.bottom_radius_m, 2, 0, 0.3, 0.05, 61.0 / 45.0);
    camera.projection = depth.projection;
    rig.record_view(camera, sun_at(0.3 * 180 / std::numbers::pi));
    const SceneTextures wall = upload(
        *cpu, size, [](auto, auto) { return 50.0; }, depth);
    const Image scene = cpu->read(wall.color);
    const Image seen = rig.show(size, {.scene_color = wall.color, .scene_depth = wall.depth});
    for (std::size_t i = 0; i < scene.texels.size(); ++i) CHECK(glm::dvec3(seen.texels[i]) == glm::dvec3(scene.texels[i]));
}
