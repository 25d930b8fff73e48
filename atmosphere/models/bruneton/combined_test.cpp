// Combined textures of the model bruneton: which air has them, and what the device must hold.
#include "models/bruneton/small_test.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

using namespace aureole;
using namespace aureole::passes;
using namespace aureole::bruneton_test;
using models::BrunetonSettings;

namespace {

BrunetonSettings combined() {
    BrunetonSettings s = small();
    s.combined = true;
    return s;
}

Setup setup_of(const AtmosphereParameters& air, const BrunetonSettings& settings) {
    Setup setup;
    setup.air = air;
    setup.model = models::bruneton(settings);
    setup.composite.target_format = rhi::Format::rgba32_float;
    setup.composite.sun_disk = false;
    return setup;
}

std::uint32_t layers(AirRig& rig, const BrunetonSettings& settings) {
    return model_of(rig).scattering().extent.depth / static_cast<std::uint32_t>(settings.altitude_nodes);
}

Image picture(Rig& rig) {
    rig.record_air();
    rig.record_view(camera_at(rig.setup.air.planet, 500), sun_at(20));
    return rig.show({13, 9, 1});
}

AtmosphereParameters with_smoke() {
    AtmosphereParameters air = presets::earth();
    DensityTerm smoke = air.terms[1];
    smoke.name = "smoke";
    smoke.phase = HenyeyGreensteinPhase{0.4};
    air.terms.push_back(smoke);
    return air;
}

std::string failure(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& error) {
        return std::string(to_string(error.code())) + ": " + error.what();
    }
    return "nothing";
}

}  // namespace

TEST_CASE("bruneton: the aerosol may be listed before the molecules") {
    const auto cpu = open_cpu_float();
    Rig usual(*cpu, setup_of(presets::earth(), combined()));
    AtmosphereParameters turned = presets::earth();
    std::swap(turned.terms[0], turned.terms[1]);
    Rig other(*cpu, setup_of(turned, combined()));
    CHECK(layers(usual, combined()) == 1);
    CHECK(layers(other, combined()) == 1);
    const Image expected = picture(usual), shown = picture(other);
    for (std::size_t i = 0; i < expected.texels.size(); ++i)
        for (int c = 0; c < 3; ++c) CHECK(std::abs(shown.texels[i][c] - expected.texels[i][c]) <= 1e-4 * expected.texels[i][c]);

    AtmosphereParameters smoky = with_smoke();
    CHECK(layers(*std::make_unique<AirRig>(*cpu, setup_of(smoky, combined())), combined()) == 3);
    std::erase_if(smoky.terms, [](const DensityTerm& term) { return term.name == "rayleigh"; });
    for (DensityTerm& term : smoky.terms)
        if (term.name == "ozone") term.phase = smoky.terms[0].phase;
    CHECK(layers(*std::make_unique<AirRig>(*cpu, setup_of(smoky, combined())), combined()) == 3);  // no molecules
}

TEST_CASE("bruneton: textures are combined where aerosols leave the colours of scattered light as they are") {
    const auto cpu = open_cpu_float();
    struct Case {
        const char* preset;
        std::uint32_t layers;
    };
    for (const Case& c : {Case{"earth", 1}, {"us_standard_1976", 1}, {"hazy_earth", 2}, {"mars", 2}, {"titan", 2}}) {
        CAPTURE(c.preset);
        BrunetonSettings settings = combined();
        settings.nu_nodes = 8;
        settings.sun_nodes = 16;
        Rig rig(*cpu, setup_of(presets::by_name(c.preset), settings));
        CHECK(layers(rig, settings) == c.layers);
        settings.combined = false;
        Rig apart(*cpu, setup_of(presets::by_name(c.preset), settings));
        const Image shown = picture(rig), expected = picture(apart);
        if (c.layers > 1) {
            CHECK(shown == expected);
            continue;
        }
        double off = 0, all = 0;
        for (std::size_t i = 0; i < shown.texels.size(); ++i)
            for (int k = 0; k < 3; ++k) {
                off += std::abs(shown.texels[i][k] - expected.texels[i][k]);
                all += expected.texels[i][k];
            }
        CHECK(off > 0);
        CHECK(off < 0.005 * all);
    }

    // One air grows hazy: other textures, the same as if it had been so from the start.
    AtmosphereParameters air = presets::earth();
    Rig rig(*cpu, setup_of(air, combined()));
    (void)picture(rig);
    air.terms[1].scattering_scale = 1.1;
    rig.air.set_parameters(air);
    CHECK(layers(rig, combined()) == 1);
    air.terms[1].scattering_scale = 1.4;
    rig.air.set_parameters(air);
    CHECK(layers(rig, combined()) == 2);
    Rig fresh(*cpu, setup_of(air, combined()));
    CHECK(picture(rig) == picture(fresh));
}

TEST_CASE("bruneton: a device whose 3D textures are too small for an air's layers is told so, also by a later air") {
    const auto cpu = open_cpu_float();
    CountingDevice& device = cpu->device();
    rhi::Capabilities less = device.capabilities();
    less.max_texture_3d = 100;
    device.pretend(less);
    BrunetonSettings settings = combined();
    settings.altitude_nodes = 60;
    const std::string told = "unsupported: device.max_texture_3d: 100";
    const auto make = [&](const AtmosphereParameters& air) { Atmosphere(device, air, models::bruneton(settings)); };
    CHECK(failure([&] { make(with_smoke()); }).starts_with(told));
    {
        Atmosphere fits(device, presets::earth(), models::bruneton(settings));
        CHECK(failure([&] { fits.set_parameters(with_smoke()); }).starts_with(told));
        CHECK(fits.parameters() == presets::earth());
    }
    settings.altitude_nodes = 50;
    settings.combined = false;
    CHECK(failure([&] { make(presets::earth()); }) == "nothing");
    settings.altitude_nodes = 51;
    CHECK(failure([&] { make(presets::earth()); }).starts_with(told));
    CHECK(device.live() == 0);
}
