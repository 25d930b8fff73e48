// The aerial-perspective pass on every backend, from the ground to space, from noon to night.
#include <doctest/doctest.h>

#include "passes/trio.h"

using namespace aureole;
using namespace aureole::passes;

namespace {

// Light a billionth of the brightest in the froxels is not seen, and a millionth of optical depth takes nothing away.
constexpr Measure radiance{Measure::Kind::relative, 0, 1e-9};
constexpr Measure depth{Measure::Kind::relative, 1e-6};

struct Parts {
    Precision radiance, depth;

    void compare(const Images& tables, std::uint32_t rows, const std::string& where) {
        depth.compare(tables, 0, rows, ::depth, where);
        for (std::uint32_t layer = rows; layer < tables.single.extent.height; layer += rows)
            radiance.compare(tables, layer, rows, ::radiance, where);
    }
    void check(const std::string& how) const {
        radiance.check("aerial perspective", "radiance, " + how, 1e-4, 1e-3);
        depth.check("aerial perspective", "optical depth, " + how, 1e-4, 1e-3);
    }
};

Setup setup_of(const char* preset) {
    Setup setup;
    setup.air = presets::by_name(preset);
    setup.view.light = false;
    return setup;
}

}  // namespace

TEST_CASE("aerial perspective: every backend makes the same froxels, at all altitudes and hours") {
    Backends backends;
    Parts alone, chained;
    for (const char* preset : preset_names()) {
        const Setup setup = setup_of(preset);
        for (Parts* parts : {&chained, &alone}) {
            Trio<Rig> trio(backends, setup);
            trio.record_air();
            if (parts == &alone) trio.share_air();
            sweep(trio, preset, [&](const std::string& where) {
                const Images tables = trio.read(&Rig::froxels);
                CHECK_MESSAGE(tables.unsound() == "", where);
                parts->compare(tables, setup.quality.aerial_perspective.height, where);
            });
        }
    }
    alone.check("alone");
    chained.check("own tables");
}
