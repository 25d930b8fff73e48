// The passes that follow from the air alone, against the CPU backend.
#include <aureole/presets.h>

#include <algorithm>

#include "rhi/checks.h"
#include "rhi/pass_rig.h"

namespace aureole::conformance {
namespace {

constexpr const char* airs[] = {"earth", "hazy_earth", "mars"};

PassSetup setup_of(const char* preset) {
    PassSetup setup;
    setup.air = presets::by_name(preset);
    return setup;
}

}  // namespace

void check_transmittance(const Target& target) {
    Difference depth("optical depth");
    for (const char* preset : airs) {
        const Context context(preset);
        PassPair pair(target, setup_of(preset));
        pair.record_air();
        const auto tables = pair.read([](const PassRig& rig) { return rig.air.transmittance_table(); });
        expect(passes::unsound(tables.checked).empty(), "no number of the table is negative or none at all");
        // A thousandth of an optical depth takes a thousandth of the light.
        depth.compare(tables, 0, tables.checked.extent.height, {Measure::Kind::relative, 1e-3}, preset);
    }
    depth.tell(target.pass_tolerance);
}

void check_multi_scatter(const Target& target) {
    // Rows of the table: logarithms of the mean radiance, moments over it, and the logarithm of the light on the ground.
    Difference mean("mean radiance"), moments("moments over the mean"), ground("irradiance of the ground");
    double tolerance = target.pass_tolerance;
    for (const char* preset : airs) {
        const Context context(preset);
        const PassSetup setup = setup_of(preset);
        PassPair pair(target, setup);
        pair.record_air();
        const auto table = [](const PassRig& rig) { return rig.air.multi_scatter_table(); };
        // Logarithms in half have steps of 2^-7, and their orders of scattering go on from each other's rounding.
        if (pair.checked->device.desc(table(*pair.checked)).format != rhi::Format::rgba32_float)
            tolerance = std::max(tolerance, 0.03);
        const auto tables = pair.read(table);
        expect(passes::unsound(tables.checked, true).empty(), "every number of the table is finite");
        const std::uint32_t rows = setup.quality.multi_scatter.height, last = tables.checked.extent.height - 1;
        mean.compare(tables, 0, rows, {Measure::Kind::logarithm}, preset);
        moments.compare(tables, rows, last - rows, {Measure::Kind::absolute}, preset);
        ground.compare(tables, last, 1, {Measure::Kind::logarithm}, preset);
    }
    for (const Difference* difference : {&mean, &moments, &ground}) difference->tell(tolerance);
}

}  // namespace aureole::conformance
