// New numbers for the same structure of air: no new device objects, and the tables of an atmosphere made so.
#include <doctest/doctest.h>

#include <numbers>

#include "common/rejects.h"
#include "passes/rig.h"

using namespace aureole;
using namespace aureole::passes;

namespace {

/// All numbers follow x: ground, coefficients, profiles, phase functions; with tables of the user's where asked for.
AtmosphereParameters numbered(double x, bool tables = false) {
    AtmosphereParameters air = presets::earth();
    air.planet.ground_albedo = Rgb(0.1 + 0.5 * x);
    for (DensityTerm& term : air.terms) {
        term.scattering_per_m *= 1 + x;
        term.absorption_per_m *= 1 + 2 * x;
    }
    air.terms[0].profile = ExponentialProfile{8000 + 500 * x};
    air.terms[1].phase = CornetteShanksPhase{0.8 - 0.1 * x};
    if (tables) {
        air.terms[1].phase = TabulatedPhase{{0, 0.3, 1.5, std::numbers::pi}, {30 - 10 * x, 4, 1, 0.7}};
        air.terms[2].profile = TabulatedProfile{{0, 15e3, 30e3 + 1e3 * x, 60e3}, {0.1, 0.5 + x, 1, 0}};
    }
    return air;
}

/// More terms than kernels take, which become tabulated sums (medium/merge.h).
AtmosphereParameters merged(double x) {
    AtmosphereParameters air = presets::earth();
    for (int i = 0; i < 20; ++i)
        air.terms.push_back({.name = "layer",
                             .profile = TentProfile{1e3 * i, 2e3},
                             .scattering_per_m = Rgb(1e-7 * (i + x)),
                             .phase = HenyeyGreensteinPhase{0.6}});
    return air;
}

const Camera camera = camera_at(presets::earth().planet, 50);
const Sun sun = sun_at(12);

void record(Rig& rig) {
    rig.record_air();
    rig.record_view(camera, sun);
}

/// Objects that the device makes for a change from one air to the other, whose tables are those of an atmosphere made so.
std::uint64_t objects_made(Backend& backend, const AtmosphereParameters& before, const AtmosphereParameters& after) {
    Setup setup;
    setup.air = before;
    Rig rig(backend, setup);
    record(rig);
    const Image old_sky = rig.sky_view();
    const std::uint64_t created = backend.device().created, live = backend.device().live();
    rig.air.set_parameters(after);
    record(rig);
    const std::uint64_t made = backend.device().created - created;
    CHECK(backend.device().live() == live);
    CHECK(rig.sky_view() != old_sky);

    setup.air = after;
    Rig wanted(backend, setup);
    record(wanted);
    CHECK(rig.transmittance() == wanted.transmittance());
    CHECK(rig.multi_scatter() == wanted.multi_scatter());
    CHECK(rig.sky_view() == wanted.sky_view());
    CHECK(rig.froxels() == wanted.froxels());
    CHECK(rig.light() == wanted.light());
    return made;
}

}  // namespace

TEST_CASE("numbers of the air: no device object, and of tables an upload buffer") {
    for (const auto& backend : {open_cpu_float(), open_vulkan()}) {
        if (!backend) continue;
        INFO(backend->name());
        CHECK(objects_made(*backend, numbered(0), numbered(1)) == 0);
        CHECK(objects_made(*backend, numbered(0, true), numbered(1, true)) == 2);  // a profile and a phase function
        AtmosphereParameters same_tables = numbered(0, true);
        same_tables.planet.ground_albedo = Rgb(0.9);
        same_tables.terms[0].scattering_per_m *= 2;
        CHECK(objects_made(*backend, numbered(0, true), same_tables) == 0);
        CHECK(objects_made(*backend, merged(0), merged(1)) == 1);
        CHECK(objects_made(*backend, numbered(0), numbered(0, true)) > 20);  // another structure
    }
}

TEST_CASE("numbers of the air: tables that cannot be uploaded change nothing") {
    const auto cpu = open_cpu_float();
    Setup setup;
    setup.air = numbered(0, true);
    Rig rig(*cpu, setup);
    record(rig);
    const std::uint64_t live = cpu->device().live();
    std::uint64_t failures = 0;
    for (;; ++failures) {
        cpu->device().fail_after(failures);
        try {
            rig.air.set_parameters(numbered(1, true));
            break;
        } catch (const Error& error) {
            CHECK(error.code() == ErrorCode::out_of_memory);
        }
        CHECK(cpu->device().live() == live);
        CHECK(rig.air.parameters() == setup.air);
        CHECK(rig.record_air().total() == 0);
        CHECK(rig.record_view(camera, sun).total() == 0);
    }
    cpu->device().fail_after(std::nullopt);
    CHECK(failures == 4);  // two buffers, each made and written
    CHECK(rig.record_air().total() > 0);
}
