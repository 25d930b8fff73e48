// The model bruneton on every backend: the same tables, at once and spread over frames.
#include "models/bruneton/small_test.h"

#include <doctest/doctest.h>

#include "passes/scene.h"
#include "passes/trio.h"

using namespace aureole;
using namespace aureole::passes;
using models::BrunetonSampling;
using models::BrunetonSettings;
using namespace aureole::bruneton_test;

namespace {

template <class R, class Read>
Images read_all(Trio<R>& trio, const Read& read) {
    Images images{read(trio.single), read(trio.exact), {}};
    if (trio.vulkan) images.vulkan = read(*trio.vulkan);
    return images;
}

/// Relative, but for what is a hundred-thousandth of the brightest.
constexpr Measure light{Measure::Kind::relative, 0, 1e-5};

}  // namespace

TEST_CASE("bruneton: every backend makes the same tables") {
    Backends backends;
    Precision scattered, irradiated;
    for (const char* preset : preset_names())
        for (const bool combined : {false, true})
            for (const auto sampling : {BrunetonSampling::gauss, BrunetonSampling::published}) {
                BrunetonSettings settings = small();
                settings.combined = combined;
                settings.sampling = sampling;
                if (sampling == BrunetonSampling::published) settings.altitude_nodes = 3, settings.orders = 2;
                const std::string where = std::string(preset) + (combined ? ", combined" : "") +
                                          (sampling == BrunetonSampling::published ? ", published" : "");
                CAPTURE(where);
                Trio<AirRig> trio(backends, setup_of(preset, settings));
                trio.record_air();
                const Images tables = read_all(trio, scattering), skies = read_all(trio, irradiance);
                CHECK(tables.unsound() == "");
                CHECK(skies.unsound() == "");
                scattered.compare(tables, light, where);
                irradiated.compare(skies, light, where);
            }
    scattered.check("bruneton", "scattering", 1e-4, 3e-3);
    irradiated.check("bruneton", "irradiance", 1e-4, 3e-4);
}

TEST_CASE("bruneton: pictures of every place and hour are sound, the same on every backend") {
    Backends backends;
    Precision pictures;
    for (const char* preset : {"earth", "mars", "airless"}) {
        Setup setup = setup_of(preset, small());
        setup.composite.target_format = rhi::Format::rgba32_float;
        setup.composite.sun_disk = false;
        Trio<Rig> trio(backends, setup);
        trio.record_air();
        const Image table = scattering(trio.single), sky = irradiance(trio.single), depth = trio.single.transmittance();
        trio.each([&](Rig& rig) {
            rig.backend.write(model_of(rig).scattering().handle, table);
            rig.backend.write(model_of(rig).irradiance().handle, sky);
            rig.backend.write(rig.air.transmittance_table(), depth);
        });
        for (const double altitude : {0.0, 2.0, 1e4, 3e5})
            for (const double elevation : {90.0, 5.0, 0.0, -4.0}) {
                const Planet& planet = trio.single.setup.air.planet;
                trio.each([&](Rig& rig) { rig.record_view(camera_at(planet, altitude), sun_at(elevation)); });
                const std::string where = place_name(preset, altitude, elevation);
                CAPTURE(where);
                const Images shown = read_all(trio, [](Rig& rig) { return rig.show({13, 9, 1}); });
                CHECK(shown.unsound() == "");
                pictures.compare(shown, {Measure::Kind::relative, 0, 1e-4}, where);
                CHECK(read_all(trio, [](Rig& rig) { return rig.light(); }).unsound(true) == "");
            }
    }
    pictures.check("bruneton", "composite", 1e-4, 1e-3);
}

TEST_CASE("bruneton: the view table of a camera in the air shows what the 4D table shows a camera in space a step away") {
    const auto cpu = open_cpu_float();
    for (const char* preset : {"earth", "mars"})
        for (const bool combined : {false, true}) {
            BrunetonSettings settings = small();
            settings.view_nodes = 64;
            settings.nu_nodes = 8;
            settings.combined = combined;
            Setup setup = setup_of(preset, settings);
            setup.composite.target_format = rhi::Format::rgba32_float;
            setup.composite.sun_disk = false;
            Rig rig(*cpu, setup);
            rig.record_air();
            const Planet& planet = rig.setup.air.planet;
            const double top = planet.top_radius_m - planet.bottom_radius_m;
            for (const double elevation : {60.0, 5.0, -4.0}) {
                rig.record_view(camera_at(planet, top - 0.5), sun_at(elevation));
                const Image inside = rig.show({13, 9, 1});
                rig.record_view(camera_at(planet, top + 0.5), sun_at(elevation));
                const Image outside = rig.show({13, 9, 1});
                double most = 0, worst = 0;
                for (const glm::dvec4& texel : outside.texels) most = std::max(most, texel.y);
                for (std::size_t i = 0; i < outside.texels.size(); ++i)
                    for (int c = 0; c < 3; ++c)
                        worst = std::max(worst, std::abs(inside.texels[i][c] - outside.texels[i][c]) /
                                                    std::max(outside.texels[i][c], 0.01 * most));
                CAPTURE(place_name(preset, top, elevation));
                CAPTURE(combined);
                CHECK(most > 0);
                CHECK(worst < 0.005);
            }
        }
}

TEST_CASE("bruneton: geometry in the air is sound, and fades from itself into the sky") {
    const auto cpu = open_cpu_float();
    Setup setup = setup_of("earth", small());
    setup.composite.target_format = rhi::Format::rgba32_float;
    setup.composite.scene_color = setup.composite.scene_depth = true;
    for (const bool combined : {false, true}) {
        BrunetonSettings settings = small();
        settings.combined = combined;
        setup.model = models::bruneton(settings);
        Rig rig(*cpu, setup);
        rig.record_air();
        const DepthConvention convention = perspective_conventions(1.5)[0];
        for (const double altitude : {2.0, 1e4, 3e5})
            for (const double elevation : {60.0, 0.0, -4.0}) {
                rig.record_view(camera_at(rig.setup.air.planet, altitude), sun_at(elevation));
                const SceneTextures scene = upload(*cpu, {15, 10, 1}, patches, convention);
                CHECK(unsound(rig.show({15, 10, 1}, {.scene_color = scene.color, .scene_depth = scene.depth})) == "");
            }
    }
}

TEST_CASE("bruneton: spread over frames it makes the same tables, and shows them when they are complete") {
    const auto cpu = open_cpu_float();
    const Setup setup = setup_of("earth", small());
    AirRig at_once(*cpu, setup);
    at_once.record_air();
    CHECK(at_once.air.progress() == 1);
    const Image expected = scattering(at_once), expected_sky = irradiance(at_once);

    for (const int slices : {1, 3, 1000}) {
        CAPTURE(slices);
        BrunetonSettings settings = small();
        settings.slices_per_frame = slices;
        AirRig rig(*cpu, setup_of("earth", settings));
        int frames = 0;
        double before = -1;
        while (rig.air.progress() < 1 && frames < 200) {
            CHECK_FALSE(model_of(rig).ready());
            rig.record_air();
            CHECK(rig.air.progress() > before);
            before = rig.air.progress();
            ++frames;
        }
        const int units = settings.altitude_nodes * (2 * settings.orders - 1) + settings.orders - 1;
        CHECK(frames >= (units + slices - 1) / slices);
        CHECK(model_of(rig).ready());
        CHECK(scattering(rig) == expected);
        CHECK(irradiance(rig) == expected_sky);
        CHECK(rig.air.table_bytes() > at_once.air.table_bytes());

        // Another air: the tables in use stay as they are until the new ones are complete.
        AtmosphereParameters brighter = setup.air;
        brighter.planet.ground_albedo = Rgb(0.9);
        rig.air.set_parameters(brighter);
        at_once.air.set_parameters(brighter);
        at_once.record_air();
        for (int frame = 0; frame < frames; ++frame) {
            CHECK(scattering(rig) == expected);
            rig.record_air();
        }
        CHECK(rig.air.progress() == 1);
        CHECK(scattering(rig) == scattering(at_once));
        CHECK(irradiance(rig) == irradiance(at_once));
        CHECK(rig.record_air().dispatches == 0);
        at_once.air.set_parameters(setup.air);
        at_once.record_air();
    }
}

TEST_CASE("bruneton: a host's own budget for the first solution, too") {
    const auto cpu = open_cpu_float();
    AirRig whole(*cpu, setup_of("earth", small()));
    whole.record_air();
    AirRig rig(*cpu, setup_of("earth", small()));
    rig.air.set_multi_scatter_passes_per_frame(1, true);
    CHECK(rig.air.progress() == 0);
    double before = 0;
    int frames = 0;
    while (rig.air.progress() < 1 && frames < 100) {
        rig.record_air();
        CHECK(rig.air.progress() > before);
        before = rig.air.progress();
        ++frames;
    }
    CHECK(frames > 3);
    CHECK(scattering(rig) == scattering(whole));
}

TEST_CASE("bruneton: a host's own budget, a dropped list, other radii") {
    const auto cpu = open_cpu_float();
    AirRig rig(*cpu, setup_of("earth", small()));
    rig.air.set_multi_scatter_passes_per_frame(1);
    rig.record_air();  // the first solution at once
    CHECK(rig.air.progress() == 1);
    AtmosphereParameters other = rig.setup.air;
    other.planet.ground_albedo = Rgb(0);
    rig.air.set_parameters(other);
    rig.record_air();
    CHECK(rig.air.progress() < 1);
    const Image kept = scattering(rig);
    rig.air.set_multi_scatter_passes_per_frame(0);  // what is left is made at once
    CHECK(scattering(rig) == kept);
    rig.record_air();
    CHECK(rig.air.progress() == 1);
    CHECK_FALSE(scattering(rig) == kept);

    rig.air.set_multi_scatter_passes_per_frame(1);
    other.planet.top_radius_m += 1e3;
    rig.air.set_parameters(other);
    rig.record_air();  // the old tables' axes are others: at once
    CHECK(rig.air.progress() == 1);
    const Image taller = scattering(rig);
    rig.air.invalidate();
    CHECK(rig.air.progress() == 0);
    rig.record_air();
    CHECK(scattering(rig) == taller);
}
