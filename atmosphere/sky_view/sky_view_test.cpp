// The sky-view pass on every backend, from the ground to space, from noon to night.
#include <doctest/doctest.h>

#include "passes/trio.h"

using namespace aureole;
using namespace aureole::passes;

namespace {

// Light a billionth of the brightest in the table is not seen, nor 1e-20 of the sun's; a millionth of optical depth takes
// nothing away.
constexpr Measure radiance{Measure::Kind::relative, 1e-20, 1e-9};
constexpr Measure depth{Measure::Kind::relative, 1e-6};
// In double, the float's rounding shows where little is left: light that hardly reaches a place. Each row is measured by its
// own brightest, so that the zenith at dusk counts as the glow above the sun does, and by a millionth of the sun's light, which
// is what a cosine next to 0 may be off at the terminator; the last row by the layer's brightest, since from above the air it
// grazes the top, where float leaves nothing and double a trace.
constexpr Measure by_row{.kind = Measure::Kind::relative, .least = 1e-6, .least_of_row = 1e-2};
constexpr Measure by_layer{.kind = Measure::Kind::relative, .least_of_largest = 1e-3};
constexpr Measure coarse_depth{Measure::Kind::relative, 1e-3};

struct Parts {
    Precision radiance, depth;

    void compare(const Images& tables, std::uint32_t rows, const std::string& where) {
        const std::uint32_t last = tables.single.extent.height - rows;
        for (std::uint32_t layer = 0; layer < last; layer += rows) {
            if (tables.vulkan) radiance.vulkan.compare(*tables.vulkan, tables.single, layer, rows, ::radiance, where);
            radiance.exact.compare(tables.single, tables.exact, layer, rows - 1, by_row, where);
            radiance.exact.compare(tables.single, tables.exact, layer, rows, by_layer, where);
        }
        depth.compare(tables, last, rows, ::depth, coarse_depth, where);
    }
    void check(const std::string& how) const {
        radiance.check("sky-view", "radiance, " + how, 1e-4, 1e-3);
        depth.check("sky-view", "optical depth, " + how, 1e-4, 1e-3);
    }
};

Setup setup_of(const char* preset) {
    Setup setup;
    setup.air = presets::by_name(preset);
    setup.view.aerial_perspective = false;
    setup.view.light = false;
    return setup;
}

}  // namespace

TEST_CASE("sky-view: every backend makes the same table, at all altitudes and hours") {
    Backends backends;
    Parts alone, chained;
    for (const char* preset : preset_names()) {
        const Setup setup = setup_of(preset);
        for (Parts* parts : {&chained, &alone}) {
            Trio<Rig> trio(backends, setup);
            trio.record_air();
            if (parts == &alone) trio.share_air();
            sweep(trio, preset, [&](const std::string& where) {
                const Images tables = trio.read(&Rig::sky_view);
                CHECK_MESSAGE(tables.unsound() == "", where);
                parts->compare(tables, setup.quality.sky_view.height, where);
            });
        }
    }
    alone.check("alone");
    chained.check("own tables");
}

namespace {

/// A few places and hours that take every path through the kernel: day, twilight, night; in the air, at its top, in space.
template <class Visit>
void visit_some(Trio<Rig>& trio, const std::string& name, const Visit& visit) {
    const Planet& planet = trio.single.setup.air.planet;
    for (const double altitude : {0.0, 5e3, 99e3, 4e5}) {
        for (const double elevation : {60.0, 4.0, -2.0, -7.0}) {
            trio.each([&](Rig& rig) { rig.record_view(camera_at(planet, altitude), sun_at(elevation)); });
            visit(place_name(name, altitude, elevation));
        }
    }
}

}  // namespace

TEST_CASE("sky-view: tables of any shape") {
    Backends backends;
    Parts parts;
    for (const rhi::Extent shape : {rhi::Extent{33, 8, 1}, {16, 16, 1}, {4, 50, 1}}) {
        Setup setup = setup_of("hazy_earth");
        setup.quality.sky_view = shape;
        Trio<Rig> trio(backends, setup);
        trio.record_air();
        trio.share_air();
        visit_some(trio, std::to_string(shape.width) + "x" + std::to_string(shape.height), [&](const std::string& where) {
            const Images tables = trio.read(&Rig::sky_view);
            CHECK_MESSAGE(tables.unsound() == "", where);
            parts.compare(tables, shape.height, where);
        });
    }
    parts.check("other shapes, alone");
}

TEST_CASE("sky-view: half floats differ by a step at most") {
    Backends backends;
    Precision worst;
    // Of a ray that grazes the top of the air float leaves nothing, double a trace: below half a thousandth of the sun's light
    // their difference counts in steps of that size.
    constexpr double grazing = 0x1p-11;
    for (const char* preset : preset_names()) {
        Setup setup = setup_of(preset);
        setup.quality.table_format = rhi::Format::rgba16_float;
        Trio<Rig> trio(backends, setup);
        trio.record_air();
        trio.share_air();
        sweep(trio, preset, [&](const std::string& where) {
            const Images tables = trio.read(&Rig::sky_view);
            CHECK_MESSAGE(tables.unsound() == "", where);
            worst.compare(tables, 0, tables.single.extent.height, {Measure::Kind::half_steps},
                          {Measure::Kind::half_steps, grazing}, where);
        });
    }
    worst.check("sky-view", "in half, steps", 1, 1.2);  // half a step, and what float itself is off
}

TEST_CASE("sky-view: every sun has its layers, which are those of that sun alone") {
    const auto cpu = open_cpu_float();
    Setup setup = setup_of("earth");
    Rig alone(*cpu, setup);
    setup.view.max_suns = 3;
    Rig together(*cpu, setup);
    const Camera camera = camera_at(setup.air.planet, 2);
    const Sun suns[] = {sun_at(50), sun_at(5), sun_at(20)};
    alone.record_air();
    together.record_air();
    together.record_view(camera, suns);
    const Image all = together.sky_view();
    const std::uint32_t rows = 2 * setup.quality.sky_view.height;  // the layers of a sun
    for (std::uint32_t sun = 0; sun < 3; ++sun) {
        alone.record_view(camera, suns[sun]);
        const Image one = alone.sky_view();
        Worst worst;
        for (std::uint32_t y = 0; y < rows; ++y)
            for (std::uint32_t x = 0; x < one.extent.width; ++x)
                for (int channel = 0; channel < 3; ++channel) {
                    const double a = all.at(x, sun * rows + y)[channel], b = one.at(x, y)[channel];
                    worst.add(difference(a, b, {}), a, b, "sun " + std::to_string(sun));
                }
        INFO(worst.text());
        CHECK(worst.error() < 1e-6);
    }
}
