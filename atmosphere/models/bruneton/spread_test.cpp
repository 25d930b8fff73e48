// The model bruneton with a budget, while the air changes: what is shown belongs to one air, whole.
#include "models/bruneton/small_test.h"

#include <aureole/models/spectral.h>

#include <doctest/doctest.h>

#include "passes/scene.h"

#include <numbers>
#include <vector>

using namespace aureole;
using namespace aureole::passes;
using namespace aureole::bruneton_test;
using models::BrunetonSettings;

namespace {

enum class Inside { alone, wavelengths };

Setup setup_of(const AtmosphereParameters& air, int slices, Inside inside = Inside::alone) {
    BrunetonSettings settings = small();
    settings.slices_per_frame = slices;
    Setup setup;
    setup.air = air;
    setup.model = models::bruneton(settings);
    if (inside == Inside::wavelengths) setup.model = models::spectral(setup.model);
    setup.composite.target_format = rhi::Format::rgba32_float;
    setup.composite.scene_color = setup.composite.scene_depth = true;
    setup.view.max_suns = 1;
    return setup;
}

/// All that a host may see: a picture with geometry from the air, one from space, the light, the table of transmittance.
struct Seen {
    Image air, space, light, transmittance;
    [[nodiscard]] bool operator==(const Seen&) const = default;
};

Seen look(Rig& rig) {
    constexpr rhi::Extent size{15, 10, 1};
    const SceneTextures scene = upload(rig.backend, size, patches, perspective_conventions(1.5)[0]);
    const CompositeTargets targets{.scene_color = scene.color, .scene_depth = scene.depth};
    const Planet& planet = rig.air.parameters().planet;
    Seen seen;
    rig.record_view(camera_at(planet, 3e5), sun_at(8));
    seen.space = rig.show(size, targets);
    rig.record_view(camera_at(planet, 700), sun_at(8));
    seen.air = rig.show(size, targets);
    seen.light = rig.light();
    seen.transmittance = rig.transmittance();
    return seen;
}

Seen at_once(Backend& backend, const AtmosphereParameters& air, Inside inside = Inside::alone) {
    Rig rig(backend, setup_of(air, 0, inside));
    rig.record_air();
    return look(rig);
}

/// Until the solution is complete; how many frames that took.
int finish(Rig& rig) {
    int frames = 0;
    while (rig.air.progress() < 1 && frames < 200) {
        rig.record_air();
        ++frames;
    }
    return frames;
}

/// The structure of `tables`, other numbers in all that a block or a table holds.
AtmosphereParameters earth_before(bool tables) {
    AtmosphereParameters air = presets::earth();
    if (!tables) return air;
    air.terms[1].profile = TabulatedProfile{{0, 3e3, 2e4}, {1, 0.2, 0}};
    air.terms[1].phase = TabulatedPhase{{0, 1, std::numbers::pi}, {4, 1, 1.5}};
    return air;
}

AtmosphereParameters earth_after(bool tables) {
    AtmosphereParameters air = presets::earth();
    air.planet.ground_albedo = Rgb(0.8, 0.4, 0.1);
    air.terms[0].profile = ExponentialProfile{6e3};
    air.terms[1].scattering_scale = 20;
    air.terms[1].phase = CornetteShanksPhase{0.3};
    if (!tables) return air;
    air.terms[1].profile = TabulatedProfile{{0, 5e3, 2e4}, {1, 0.6, 0}};
    air.terms[1].phase = TabulatedPhase{{0, 1, std::numbers::pi}, {9, 0.5, 1}};
    return air;
}

}  // namespace

TEST_CASE("bruneton: with a budget a change shows the old picture to the bit, and then the new one") {
    const auto check = [](Backend& backend, bool tables, int slices) {
        CAPTURE(tables);
        CAPTURE(slices);
        const Seen before = at_once(backend, earth_before(tables)), after = at_once(backend, earth_after(tables));
        REQUIRE(before != after);
        Rig rig(backend, setup_of(earth_before(tables), slices));
        const int frames = finish(rig);
        CHECK(look(rig) == before);
        rig.air.set_parameters(earth_after(tables));
        for (int frame = 1; frame < frames; ++frame) {
            rig.record_air();
            CHECK(look(rig) == before);
        }
        rig.record_air();
        CHECK(rig.air.progress() == 1);
        CHECK(look(rig) == after);
        CHECK(rig.record_air().dispatches == 0);
    };
    const auto cpu = open_cpu_float(), vulkan = open_vulkan();
    for (const bool tables : {false, true})
        for (const int slices : {7, 1000}) check(*cpu, tables, slices);
    if (vulkan) check(*vulkan, true, 13);
}

TEST_CASE("bruneton: so it is in wavelengths, whose sums are shown together") {
    const auto cpu = open_cpu_float();
    const Seen before = at_once(*cpu, earth_before(false), Inside::wavelengths);
    const Seen after = at_once(*cpu, earth_after(false), Inside::wavelengths);
    REQUIRE(before != after);
    Rig rig(*cpu, setup_of(earth_before(false), 9, Inside::wavelengths));
    const int frames = finish(rig);
    CHECK(look(rig) == before);
    rig.air.set_parameters(earth_after(false));
    for (int frame = 1; frame < frames; ++frame) {
        rig.record_air();
        CHECK(look(rig) == before);
    }
    rig.record_air();
    CHECK(look(rig) == after);
}

TEST_CASE("bruneton: air that changes in every frame is followed, each solution whole for the air in which it began") {
    const auto cpu = open_cpu_float();
    const auto air_of = [](int frame) {
        AtmosphereParameters air = presets::earth();
        air.terms[1].scattering_scale = 1 + 0.5 * frame;
        return air;
    };
    for (const bool hosts_budget : {false, true}) {
        CAPTURE(hosts_budget);
        Rig rig(*cpu, setup_of(air_of(0), hosts_budget ? 0 : 7));
        if (hosts_budget) rig.air.set_multi_scatter_passes_per_frame(2);
        (void)finish(rig);
        const int units = small().altitude_nodes * (2 * small().orders - 1) + small().orders - 1;
        const int budget = hosts_budget ? 2 * small().altitude_nodes : 7, length = (units + budget - 1) / budget;
        Seen shown = at_once(*cpu, air_of(0));
        for (int frame = 1; frame <= 3 * length; ++frame) {
            CAPTURE(frame);
            rig.air.set_parameters(air_of(frame));
            rig.record_air();
            CHECK(rig.air.progress() < 1);
            if (frame % length == 0) shown = at_once(*cpu, air_of(frame - length + 1));
            CHECK(look(rig) == shown);
        }
        CHECK(finish(rig) == length);
        CHECK(look(rig) == at_once(*cpu, air_of(3 * length)));
    }
}

TEST_CASE("bruneton: work on an air is given up where it cannot be shown, or is not wanted in parts") {
    const auto cpu = open_cpu_float();
    const AtmosphereParameters before = earth_before(true), after = earth_after(true);
    const Seen expected = at_once(*cpu, after);
    Rig rig(*cpu, setup_of(before, 0));
    rig.air.set_multi_scatter_passes_per_frame(1);
    rig.record_air();

    SUBCASE("the rest at once") {
        rig.air.set_parameters(after);
        rig.record_air();
        rig.air.set_multi_scatter_passes_per_frame(0);
        rig.record_air();
        CHECK(look(rig) == expected);
    }
    SUBCASE("from the start, in parts again") {
        rig.air.set_parameters(after);
        rig.record_air();
        rig.air.set_multi_scatter_passes_per_frame(0);
        rig.air.set_multi_scatter_passes_per_frame(1);
        CHECK(look(rig) == at_once(*cpu, before));
        CHECK(finish(rig) > 3);
        CHECK(look(rig) == expected);
    }
    SUBCASE("other radii") {
        AtmosphereParameters taller = before;
        taller.planet.top_radius_m += 1e3;
        rig.air.set_parameters(after);
        rig.record_air();
        rig.air.set_parameters(taller);
        rig.record_air();
        CHECK(rig.air.progress() == 1);
        CHECK(look(rig) == at_once(*cpu, taller));
    }
    SUBCASE("a dropped list") {
        rig.air.set_parameters(after);
        rig.record_air();
        rig.air.invalidate();
        rig.record_air();
        CHECK(look(rig) == expected);
    }
    CHECK(rig.air.progress() == 1);
    CHECK(rig.record_air().dispatches == 0);
}
