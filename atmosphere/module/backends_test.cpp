// All passes one after the other on every backend: the named qualities as they are, and air of every kind.
#include <doctest/doctest.h>

#include <numbers>

#include "passes/trio.h"

using namespace aureole;
using namespace aureole::passes;

namespace {

/// All tables of a rig, and what it shows.
struct Parts {
    Precision air, view, picture;

    void compare(Trio<Rig>& trio, const std::string& where) {
        const QualitySettings& quality = trio.single.setup.quality;
        const Images transmittance = trio.read(&Rig::transmittance), moments = trio.read(&Rig::multi_scatter);
        const Images sky = trio.read(&Rig::sky_view), froxels = trio.read(&Rig::froxels);
        Images shown{trio.single.show({31, 17, 1}), trio.exact.show({31, 17, 1}), {}};
        if (trio.vulkan) shown.vulkan = trio.vulkan->show({31, 17, 1});
        for (const Images* images : std::initializer_list<const Images*>{&transmittance, &sky, &froxels, &shown})
            CHECK_MESSAGE(images->unsound() == "", where);
        CHECK_MESSAGE(moments.unsound(true) == "", where);

        // In half floats, a step is 1e-3 at most; those tables are compared with that.
        const bool half = quality.table_format == rhi::Format::rgba16_float;
        const bool half_froxels = quality.froxel_format == rhi::Format::rgba16_float;
        if (!half) air.compare(transmittance, {Measure::Kind::relative, 1e-3}, where + ", transmittance");
        if (!half) air.compare(moments, 0, quality.multi_scatter.height, {Measure::Kind::logarithm}, where + ", mean radiance");
        if (!half) view.compare(sky, {Measure::Kind::relative, 1e-20, 1e-3}, where + ", sky-view");
        if (!half && !half_froxels) view.compare(froxels, {Measure::Kind::relative, 1e-20, 1e-3}, where + ", froxels");
        if (!half)
            picture.compare(shown, {Measure::Kind::relative, 1e-20, 1e-3}, where + ", picture");
        else
            CHECK_MESSAGE(half_difference(shown) < 4e-3, where);
    }
    static double half_difference(const Images& shown) {
        Precision worst;
        worst.compare(shown, {Measure::Kind::relative, 1e-20, 1e-3}, "");
        return std::max(worst.vulkan.error(), worst.exact.error());
    }
    void check(const std::string& what, double vulkan_bound_of_air = 1e-4) const {
        air.check("all passes", what + ": tables of the air", vulkan_bound_of_air, 1e-3);
        view.check("all passes", what + ": tables of the view", 1e-4, 1e-3);
        picture.check("all passes", what + ": picture", 1e-4, 1e-3);
    }
};

void compare_at(Parts& parts, Trio<Rig>& trio, double altitude, double elevation, const std::string& name) {
    trio.each([&](Rig& rig) { rig.record_view(camera_at(rig.setup.air.planet, altitude), sun_at(elevation)); });
    parts.compare(trio, place_name(name, altitude, elevation));
}

/// A term of every profile, and more phase functions of every kind than one atmosphere may have.
DensityTerm term(const char* name, const Profile& profile, const Rgb& scattering, const PhaseFunction& phase) {
    return {.name = name, .profile = profile, .scattering_per_m = scattering, .absorption_per_m = Rgb(1e-7), .phase = phase};
}
const TabulatedProfile cloud{{0, 1e3, 1.5e3, 4e3, 8e3}, {0.1, 0.2, 1, 0.8, 0}};
const TabulatedPhase halo{{0, 0.2, 0.38, 0.4, 1.6, std::numbers::pi}, {20, 5, 4, 6, 1, 2}};

std::vector<AtmosphereParameters> kinds_of_air() {
    AtmosphereParameters first = presets::earth(), second = presets::earth(), third = presets::earth();
    first.terms = {term("molecules", ExponentialProfile{8e3}, {6e-6, 13e-6, 33e-6}, RayleighPhase{}),
                   term("haze", TentProfile{2e3, 3e3}, Rgb(8e-6), HenyeyGreensteinPhase{0.7}),
                   term("cloud", cloud, Rgb(4e-5), HenyeyGreensteinDrainePhase{}),
                   term("ice", TentProfile{9e3, 2e3}, Rgb(3e-6), halo)};
    second.terms = {term("dust", cloud, {3e-5, 2e-5, 1e-5}, CornetteShanksPhase{-0.4}),
                    term("fog", ExponentialProfile{100}, Rgb(1e-4), HenyeyGreensteinDrainePhase::from_droplet_diameter(10))};
    third.terms.clear();
    for (int i = 0; i < 16; ++i)
        third.terms.push_back(
            term("layer", TentProfile{2e3 * i, 3e3}, Rgb(1e-6 * (i + 1)), HenyeyGreensteinPhase{0.2 * (i % 4)}));
    AtmosphereParameters fourth = presets::earth();  // more terms than kernels take: they become tables
    for (int i = 0; i < 30; ++i)
        fourth.terms.push_back(term("layer", TentProfile{1e3 * i, 2e3}, Rgb(1e-6 * (i + 1)), HenyeyGreensteinPhase{0.2}));
    return {first, second, third, fourth};
}

}  // namespace

TEST_CASE("all passes: every quality setting, every backend") {
    Backends backends;
    Parts parts;
    for (const char* name : {"low", "default", "high"}) {
        Setup setup;
        setup.quality = QualitySettings::by_name(name);
        setup.composite.target_format = rhi::Format::rgba32_float;
        Trio<Rig> trio(backends, setup);
        trio.record_air();
        compare_at(parts, trio, 200, 8, name);
        compare_at(parts, trio, 4e5, 40, name);
    }
    parts.check("named qualities");
}

TEST_CASE("all passes: air of every kind, every backend") {
    Backends backends;
    Parts parts;
    int number = 0;
    for (const AtmosphereParameters& air : kinds_of_air()) {
        Setup setup;
        setup.air = air;
        setup.view.max_suns = 2;
        setup.composite.target_format = rhi::Format::rgba32_float;
        Trio<Rig> trio(backends, setup);
        trio.record_air();
        const std::string name = "air " + std::to_string(++number);
        for (const auto& [altitude, elevation] : {std::pair(0.0, 30.0), {3e3, -2.0}, {2e5, 10.0}})
            compare_at(parts, trio, altitude, elevation, name);
    }
    // Their nights are e^-65 of the sun's light, through depths as large: floats are 1e-4 of that logarithm off double, too.
    parts.check("air of every kind", 2e-4);
}
