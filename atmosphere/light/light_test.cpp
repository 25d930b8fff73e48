// The light pass on every backend, from the ground to space, from noon to night.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "passes/trio.h"

using namespace aureole;
using namespace aureole::passes;

namespace {

constexpr std::uint32_t sun_column = 9;

Setup setup_of(const char* preset) {
    Setup setup;
    setup.air = presets::by_name(preset);
    setup.view.aerial_perspective = false;
    return setup;
}

/// The coefficients against the mean of the sky (the first, up to a factor), which bounds all of them; the sun against itself.
struct Parts {
    Precision sky, sun;

    void compare(const Images& tables, const std::string& where) {
        compare_to(sky.exact, sun.exact, tables.single, tables.exact, where);
        if (tables.vulkan) compare_to(sky.vulkan, sun.vulkan, *tables.vulkan, tables.single, where);
    }
    static void compare_to(Worst& sky, Worst& sun, const Image& a, const Image& b, const std::string& where) {
        for (int channel = 0; channel < 3; ++channel) {
            // A millionth of a millionth of the sun's irradiance is dark.
            const double mean = std::max(std::abs(a.at(0, 0)[channel]), 1e-12);
            for (std::uint32_t i = 0; i < sun_column; ++i) {
                const double p = a.at(i, 0)[channel], q = b.at(i, 0)[channel];
                sky.add(std::abs(p - q) / mean, p, q, where + " coefficient " + std::to_string(i));
            }
            const double p = a.at(sun_column, 0)[channel], q = b.at(sun_column, 0)[channel];
            sun.add(difference(p, q, {Measure::Kind::relative, 1e-6}), p, q, where);
        }
    }
    void check(const std::string& how) const {
        sky.check("light", "harmonics of the sky, " + how, 1e-4, 1e-3);
        sun.check("light", "sun at the camera, " + how, 1e-4, 1e-3);
    }
};

}  // namespace

TEST_CASE("light: the sun's colour has lost what each term takes, ozone too, on every backend") {
    Backends backends;
    Setup setup = setup_of("earth");
    setup.quality.transmittance = {128, 128, 1};
    Trio<Rig> trio(backends, setup);
    trio.record_air();
    trio.each([&](Rig& rig) { rig.record_view(camera_at(setup.air.planet, 0), sun_at(90)); });
    const Images tables = trio.read(&Rig::light);
    // Vertical optical depths of Earth's molecules, aerosol and ozone, by hand (presets_test.cpp). Without ozone green is 3 %
    // more.
    const Rgb expected = glm::exp(-Rgb(0.061493827, 0.142006596, 0.271402013));
    for (const Image* table : {&tables.single, &tables.exact, tables.vulkan ? &*tables.vulkan : &tables.single})
        for (int c = 0; c < 3; ++c)
            CHECK(table->at(sun_column, 0)[c] == doctest::Approx(expected[c]).scale(1e-300).epsilon(1e-3));
}

TEST_CASE("light: every backend makes the same table, at all altitudes and hours") {
    Backends backends;
    Parts chained;
    for (const char* preset : preset_names()) {
        Trio<Rig> trio(backends, setup_of(preset));
        trio.record_air();
        sweep(trio, preset, [&](const std::string& where) {
            const Images tables = trio.read(&Rig::light);
            CHECK_MESSAGE(tables.unsound(true) == "", where);
            chained.compare(tables, where);
        });
    }
    chained.check("own tables");
}

TEST_CASE("light: every sun has its row, in proportion to its irradiance; without suns there is none") {
    const auto cpu = open_cpu_float();
    Setup setup = setup_of("earth");
    Rig alone(*cpu, setup);
    setup.view.max_suns = 3;
    Rig together(*cpu, setup);
    alone.record_air();
    together.record_air();
    const Camera camera = camera_at(setup.air.planet, 2);
    Sun suns[] = {sun_at(50), sun_at(5)};
    suns[1].irradiance = {0.25, 2, 100};
    together.record_view(camera, suns);
    const Image all = together.light();
    REQUIRE(all.extent == rhi::Extent{10, 3, 1});
    for (std::uint32_t sun = 0; sun < 2; ++sun) {
        Sun unit = suns[sun];
        unit.irradiance = Rgb(1);
        alone.record_view(camera, unit);
        const Image one = alone.light();
        for (std::uint32_t i = 0; i < 10; ++i)
            for (int channel = 0; channel < 3; ++channel) {
                const double expected = one.at(i, 0)[channel] * suns[sun].irradiance[channel];
                const double scale = one.at(i < sun_column ? 0 : i, 0)[channel] * suns[sun].irradiance[channel];
                CHECK(std::abs(all.at(i, sun)[channel] - expected) <= 1e-6 * scale);
            }
    }
    for (std::uint32_t i = 0; i < 10; ++i) CHECK(glm::dvec3(all.at(i, 2)) == glm::dvec3(0));
    together.record_view(camera, std::span<const Sun>());
    for (const glm::dvec4& texel : together.light().texels) CHECK(glm::dvec3(texel) == glm::dvec3(0));
}

TEST_CASE("light: the first coefficient is the mean of what the composite shows in all directions") {
    const auto cpu = open_cpu_double();
    Setup setup = setup_of("earth");
    setup.quality = QualitySettings::standard();
    setup.view.projection = Projection::panorama;
    setup.composite = {.target_format = rhi::Format::rgba32_float, .sun_disk = false};
    Rig rig(*cpu, setup);
    rig.record_air();
    Camera camera = camera_at(setup.air.planet, 1000);
    camera.kind = Projection::panorama;
    for (const double elevation : {70.0, 20.0, 2.0}) {
        CAPTURE(elevation);
        rig.record_view(camera, sun_at(elevation));
        const rhi::Extent size{512, 256, 1};
        const Image picture = rig.show(size);
        const glm::dvec4 first = rig.light().at(0, 0);
        for (int channel = 0; channel < 3; ++channel) {
            double integral = 0;
            for (std::uint32_t y = 0; y < size.height; ++y) {
                const double pixel = std::numbers::pi / size.height;
                const double weight = std::cos((0.5 * size.height - 0.5 - y) * pixel) * pixel * pixel;
                for (std::uint32_t x = 0; x < size.width; ++x) integral += weight * picture.at(x, y)[channel];
            }
            CHECK(first[channel] == doctest::Approx(integral / std::sqrt(4 * std::numbers::pi)).scale(1e-300).epsilon(0.02));
        }
    }
}
