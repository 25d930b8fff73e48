// The transmittance pass on every backend.
#include <doctest/doctest.h>

#include "passes/trio.h"

using namespace aureole;
using namespace aureole::passes;

namespace {

// An optical depth of a millionth takes nothing from the light: below it, differences are measured against it.
constexpr Measure optical_depth{Measure::Kind::relative, 1e-6};

struct Variant {
    rhi::Extent size;
    int nodes;
};

Setup setup_of(const char* preset, const Variant& variant) {
    Setup setup;
    setup.air = presets::by_name(preset);
    setup.quality.transmittance = variant.size;
    setup.quality.transmittance_nodes = variant.nodes;
    return setup;
}

std::string name_of(const char* preset, const Variant& variant) {
    return std::string(preset) + " " + std::to_string(variant.size.width) + "x" + std::to_string(variant.size.height);
}

}  // namespace

TEST_CASE("transmittance: every backend makes the same table, of any shape") {
    Backends backends;
    Precision worst;
    for (const char* preset : preset_names()) {
        for (const Variant& variant :
             {Variant{{40, 12, 1}, 10}, {{12, 40, 1}, 16}, {{16, 16, 1}, 6}, {{130, 3, 1}, 2}, {{2, 2, 1}, 2}}) {
            const std::string where = name_of(preset, variant);
            CAPTURE(where);
            Setup setup = setup_of(preset, variant);
            setup.quality.table_format = rhi::Format::rgba32_float;
            Trio<AirRig> trio(backends, setup);
            trio.record_air();
            const Images tables = trio.read(&AirRig::transmittance);
            CHECK(tables.unsound() == "");
            worst.compare(tables, optical_depth, where);
        }
    }
    worst.check("transmittance", "optical depth", 1e-4, 3e-5);
}

TEST_CASE("transmittance: half floats differ by a step at most") {
    Backends backends;
    Precision worst;
    for (const char* preset : preset_names()) {
        const Variant variant{{40, 12, 1}, 10};
        Setup setup = setup_of(preset, variant);
        setup.quality.table_format = rhi::Format::rgba16_float;
        Trio<AirRig> trio(backends, setup);
        trio.record_air();
        worst.compare(trio.read(&AirRig::transmittance), {Measure::Kind::half_steps}, name_of(preset, variant));
    }
    worst.check("transmittance", "optical depth in half, steps", 1, 0.6);
}

TEST_CASE("transmittance: more air from the side than from above, none at the top") {
    const auto cpu = open_cpu_float();
    for (const char* preset : {"earth", "hazy_earth", "mars"}) {
        CAPTURE(preset);
        AirRig rig(*cpu, setup_of(preset, {{40, 12, 1}, 10}));
        rig.record_air();
        const Image table = rig.transmittance();
        const glm::dvec3 vertical = vertical_optical_depth(rig.setup.air);
        for (int channel = 0; channel < 3; ++channel) {
            // Row 0: the ground. Column 0: straight up; the last one: along the horizon.
            CHECK(table.at(0, 0)[channel] == doctest::Approx(vertical[channel]).scale(1e-300).epsilon(1e-4));
            for (std::uint32_t x = 1; x < table.extent.width; ++x) CHECK(table.at(x, 0)[channel] > table.at(x - 1, 0)[channel]);
            CHECK(table.at(0, table.extent.height - 1)[channel] < 1e-10);  // rounding leaves a hair's breadth of air
        }
    }
}
