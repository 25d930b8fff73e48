// Models on a Vulkan device, over the numbers of generated skies: of one structure, for which drivers compile once.
#include "passes/compare.h"
#include "passes/rig.h"
#include "stability/rungs.h"
#include "stability/worst.h"

#include <string_view>

using namespace aureole;
using namespace aureole::passes;
using namespace aureole::stability;

namespace {

/// A case's numbers in air of two scattering layers and an absorbing one.
AtmosphereParameters regular(const Case& c) {
    AtmosphereParameters given = c.air();
    given.terms.resize(3);
    const double g = std::holds_alternative<HenyeyGreensteinPhase>(given.terms[1].phase)
                         ? std::get<HenyeyGreensteinPhase>(given.terms[1].phase).g
                         : 0.999 * (2 * c.random(1200) - 1);
    for (int i = 0; i < 3; ++i) {
        DensityTerm& term = given.terms[static_cast<std::size_t>(i)];
        if (!std::holds_alternative<ExponentialProfile>(term.profile)) term.profile = ExponentialProfile{};
        term.scattering_per_m += Rgb(i < 2 ? 1e-18 : 0.0);  // what scatters has a phase function
    }
    given.terms[0].phase = RayleighPhase{};
    given.terms[1].phase = HenyeyGreensteinPhase{g};
    given.terms[2].absorption_per_m += given.terms[2].scattering_per_m;
    given.terms[2].scattering_per_m = Rgb(0);
    const double shell = given.planet.top_radius_m - given.planet.bottom_radius_m;
    given.terms[2].profile = TentProfile{std::min(0.3 * shell, 1e12), std::clamp(0.1 * shell, 0.01, 1e12)};
    return given;
}

/// Not those whose programs take drivers seconds to compile.
bool is_quick(std::string_view rung) { return rung == "fog, in-scatter" || rung == "aureole, half"; }

}  // namespace

TEST_CASE("stability, Vulkan: no number that is none") {
    const auto vulkan = open_vulkan();
    if (!vulkan) return;
    for (const Rung& rung : rungs()) {
        if (!is_quick(rung.name) && std::getenv("AUREOLE_STABILITY_CASES") == nullptr) continue;
        if (rung.random) continue;
        Ledger ledger(std::string(rung.name) + " on Vulkan");
        Setup setup;
        setup.model = rung.model;
        setup.view.projection = Projection::panorama;
        setup.composite.target_format = rhi::Format::rgba32_float;
        setup.air = regular(Case(0));
        Rig rig(*vulkan, setup);
        const Range range = cases(10);
        for (std::uint64_t i = range.begin; i < range.end; ++i) {
            const Case c(i);
            std::vector<Sun> suns = c.suns();
            if (!suns.empty()) suns.resize(1);
            rig.air.set_parameters(regular(c));
            rig.record_air();
            rig.record_view(c.camera(), suns);
            const Image seen = rig.show({32, 16, 1});
            ledger.check("radiance is finite and not negative", c, unsound(seen).empty());
            ledger.check("light is finite", c, unsound(rig.light(), true).empty());
        }
        ledger.verify();
    }
}
