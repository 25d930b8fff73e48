// Air that changes while a solution is spread over frames: tables of one air each, whole, and never far behind.
#include <doctest/doctest.h>

#include "module/air.h"
#include "passes/rig.h"

using namespace aureole;
using namespace aureole::passes;

namespace {

/// The weather of a frame: ground, aerosol, and with `tabulated` the ozone's profile, all of which a solution reads.
AtmosphereParameters weather(int frame, bool tabulated) {
    AtmosphereParameters air = presets::earth();
    air.planet.ground_albedo = Rgb(0.1 + 0.02 * frame);
    air.terms[1].scattering_per_m *= 1 + 0.1 * frame;
    if (tabulated) air.terms[2].profile = TabulatedProfile{{0, 15e3, 30e3, 60e3}, {0.1, 0.3 + 0.1 * frame, 1, 0}};
    return air;
}

struct Truth {
    Image table;
    int passes = 0;
};
Truth solved_at_once(Backend& backend, const AtmosphereParameters& air) {
    Setup setup;
    setup.air = air;
    AirRig rig(backend, setup);
    const auto dispatches = rig.record_air().dispatches;
    return {rig.multi_scatter(), static_cast<int>(dispatches - 1) / 2};
}

/// Air that changes before every frame: solutions follow one another, each for the air of the frame in which it began.
void check_following(Backend& backend, int per_frame, bool tabulated) {
    CAPTURE(backend.name());
    CAPTURE(per_frame);
    CAPTURE(tabulated);
    Setup setup;
    setup.air = weather(0, tabulated);
    AirRig rig(backend, setup);
    rig.air.set_multi_scatter_passes_per_frame(per_frame);
    rig.record_air();
    Truth shown = solved_at_once(backend, setup.air), next;
    int left = 0, published = 0;
    for (int frame = 1; frame <= 9; ++frame) {
        CAPTURE(frame);
        const AtmosphereParameters air = weather(frame, tabulated);
        rig.air.set_parameters(air);
        rig.record_air();
        CHECK(rig.air.reports()[0].recorded);
        CHECK(rig.air.reports()[1].recorded);
        if (left == 0) {
            next = solved_at_once(backend, air);
            left = (next.passes + per_frame - 1) / per_frame;
            CHECK(left <= 4);
        }
        if (--left == 0) {
            CHECK(next.table != shown.table);
            shown = next;
            ++published;
        }
        CHECK(rig.multi_scatter() == shown.table);
    }
    CHECK(published >= 2);
    // The weather stays as it is: what is running is finished, and one more solution is for the last air.
    int frames = 0;
    while (rig.record_air().total() > 0) ++frames;
    CHECK(frames <= 8);
    CHECK(rig.multi_scatter() == solved_at_once(backend, weather(9, tabulated)).table);
}

}  // namespace

TEST_CASE("multi-scatter spread: air that changes in every frame is followed" * doctest::test_suite("long")) {
    for (const auto& backend : {open_cpu_float(), open_vulkan()}) {
        if (!backend) continue;
        for (const int per_frame : {1, 2, 3}) check_following(*backend, per_frame, false);
        check_following(*backend, 1, true);
    }
}

TEST_CASE("multi-scatter spread: a planet of another size, or no more spreading, is solved at once") {
    const auto cpu = open_cpu_float();
    Setup setup;
    AirRig rig(*cpu, setup);
    rig.air.set_multi_scatter_passes_per_frame(1);
    rig.record_air();
    rig.air.set_parameters(weather(1, false));
    rig.record_air();
    AtmosphereParameters small = weather(2, false);
    small.planet.bottom_radius_m = 3e6;
    small.planet.top_radius_m = 3.1e6;
    rig.air.set_parameters(small);  // the table's axes are those of the planet
    rig.record_air();
    CHECK(rig.multi_scatter() == solved_at_once(*cpu, small).table);
    CHECK(rig.record_air().total() == 0);

    for (const bool newer : {false, true}) {
        CAPTURE(newer);
        AtmosphereParameters air = small;
        air.planet.ground_albedo = Rgb(newer ? 0.7 : 0.6);
        rig.air.set_multi_scatter_passes_per_frame(1);
        rig.air.set_parameters(air);
        rig.record_air();
        if (newer) {
            air.planet.ground_albedo = Rgb(0.8);
            rig.air.set_parameters(air);
        }
        rig.air.set_multi_scatter_passes_per_frame(0);
        rig.record_air();
        CHECK(rig.multi_scatter() == solved_at_once(*cpu, air).table);
        CHECK(rig.record_air().total() == 0);
    }
}

TEST_CASE("multi-scatter spread: the copy's memory is counted, and given back") {
    const auto cpu = open_cpu_float();
    for (const bool tabulated : {false, true}) {
        Setup setup;
        setup.air = weather(0, tabulated);
        AirRig rig(*cpu, setup);
        const std::uint64_t before = rig.air.table_bytes(), device = cpu->device().texture_bytes(), live = cpu->device().live();
        for (std::uint64_t more = 0;; ++more) {
            cpu->device().fail_after(more);
            try {
                rig.air.set_multi_scatter_passes_per_frame(2);
                break;
            } catch (const Error& error) {
                CHECK(error.code() == ErrorCode::out_of_memory);
            }
            CHECK(cpu->device().live() == live);
            CHECK(rig.air.table_bytes() == before);
        }
        cpu->device().fail_after(std::nullopt);
        const std::uint64_t copy = 40 * 12 * 16 + (tabulated ? 4096 * 4 : 0);
        CHECK(rig.air.table_bytes() == before + copy);
        CHECK(cpu->device().texture_bytes() == device + copy);
        rig.air.set_parameters(presets::mars());
        CHECK(rig.air.table_bytes() == before - (tabulated ? 4096 * 4 - 4 : 0) + 40 * 12 * 16);  // the new structure's
        rig.air.set_parameters(setup.air);
        rig.air.set_multi_scatter_passes_per_frame(0);
        CHECK(rig.air.table_bytes() == before);
        CHECK(cpu->device().live() == live);
    }
}
