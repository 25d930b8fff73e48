// What this room decides: how many moments, directions and nodes an air gets, and which passes are due. The passes themselves
// are tested in their rooms.
#include <aureole/models/aureole.h>

#include "multi_scatter/order_ratio.h"
#include "passes/rig.h"

#include <doctest/doctest.h>
#include <algorithm>

using namespace aureole;
using namespace aureole::passes;

namespace {

constexpr rhi::Extent panorama{24, 12, 1};

/// Small tables that leave the order to the air, `most` at most.
QualitySettings as_needed(int most) {
    QualitySettings quality = small_quality();
    quality.angular_order = most;
    quality.angular_order_as_needed = true;
    return quality;
}

/// Earth's molecules, so few of them that next to nothing is scattered twice.
AtmosphereParameters thin_air() {
    AtmosphereParameters air = presets::earth();
    std::erase_if(air.terms, [](const DensityTerm& term) { return term.name == "mie"; });
    for (DensityTerm& term : air.terms) term.scattering_per_m *= 0.01;
    return air;
}

/// An even layer 1 km deep that absorbs nothing.
AtmosphereParameters cloud(double optical_depth) {
    AtmosphereParameters air = presets::earth();
    air.planet.top_radius_m = air.planet.bottom_radius_m + 1000;
    air.terms = {{.name = "cloud",
                  .profile = ExponentialProfile{1e9},
                  .scattering_per_m = Rgb(optical_depth / 1000),
                  .phase = HenyeyGreensteinPhase{0.6}}};
    return air;
}

Image picture(const AtmosphereParameters& air, const QualitySettings& quality) {
    const auto cpu = open_cpu_float();
    Setup setup;
    setup.air = air;
    setup.quality = quality;
    setup.view.projection = Projection::panorama;
    setup.composite.target_format = rhi::Format::rgba32_float;
    Rig rig(*cpu, setup);
    rig.record_air();
    Camera camera = camera_at(air.planet, 200);
    camera.kind = Projection::panorama;
    rig.record_view(camera, sun_at(5));
    return rig.show(panorama);
}

}  // namespace

TEST_CASE("aureole: as many moments as an air can make use of, where the quality leaves it open") {
    const ModelPtr high = models::aureole(QualitySettings::high());
    CHECK(high->quality().angular_order == 8);
    CHECK(high->quality_for(presets::earth()).angular_order == 4);
    CHECK(high->quality_for(presets::hazy_earth()).angular_order == 8);
    CHECK(high->quality_for(presets::mars()).angular_order == 8);
    CHECK(high->quality_for(presets::airless()).angular_order == 0);
    CHECK(high->quality_for(presets::mars()).multi_scatter_azimuth == 10);
    AtmosphereParameters clean = presets::earth();
    std::erase_if(clean.terms, [](const DensityTerm& term) { return term.name == "mie"; });
    CHECK(high->quality_for(clean).angular_order == 2);
    for (DensityTerm& term : clean.terms) term.scattering_per_m *= 0.01;
    CHECK(high->quality_for(clean).angular_order == 0);  // next to nothing is scattered twice
    CHECK(models::aureole()->quality_for(presets::earth()).angular_order == 2);
    CHECK(models::aureole()->quality_for(presets::mars()).angular_order == 4);
}

TEST_CASE("aureole: more moments come with the directions that tell them apart, if the order is left to the air") {
    for (const AtmosphereParameters& air : {thin_air(), presets::earth(), presets::hazy_earth(), presets::mars()}) {
        for (const QualitySettings& asked : {as_needed(0), as_needed(2), as_needed(8), QualitySettings::high()}) {
            const QualitySettings given = models::aureole(asked)->quality_for(air);
            CAPTURE(given.angular_order);
            CHECK(given.angular_order <= asked.angular_order);
            CHECK(given.multi_scatter_zenith == std::max(asked.multi_scatter_zenith, given.angular_order + 2));
            CHECK(given.multi_scatter_azimuth == std::max(asked.multi_scatter_azimuth, given.angular_order + 2));
        }
        QualitySettings fixed = QualitySettings::high();
        fixed.angular_order_as_needed = false;
        fixed.multi_scatter_later_nodes = fixed.multi_scatter_nodes;
        CHECK(models::aureole(fixed)->quality_for(air) == fixed);
    }
}

TEST_CASE("aureole: air in which orders fade slowly takes as many nodes in later passes as in the first") {
    int slow = 0, quick = 0;
    for (const double depth : {0.1, 0.5, 1.0, 2.0, 5.0, 20.0}) {
        const AtmosphereParameters air = cloud(depth);
        CAPTURE(depth);
        for (const QualitySettings& asked : {QualitySettings::low(), QualitySettings::standard(), QualitySettings::high()}) {
            const QualitySettings given = models::aureole(asked)->quality_for(air);
            const bool is_slow = detail::order_ratio(air) > 0.7;
            CHECK(given.multi_scatter_nodes == asked.multi_scatter_nodes);
            CHECK(given.multi_scatter_later_nodes == (is_slow ? asked.multi_scatter_nodes : asked.multi_scatter_later_nodes));
            ++(is_slow ? slow : quick);
        }
    }
    CHECK(slow > 0);
    CHECK(quick > 0);
}

TEST_CASE("aureole: an order left to the air is, to the bit, the same order asked for") {
    struct Case {
        AtmosphereParameters air;
        int most, least;
    };
    for (const Case& c : {Case{thin_air(), 4, 0},
                          {presets::earth(), 4, 2},
                          {presets::earth(), 8, 4},
                          {presets::mars(), 4, 4},
                          {presets::mars(), 2, 2}}) {
        CAPTURE(c.least);
        QualitySettings asked = as_needed(c.most);
        const QualitySettings given = models::aureole(asked)->quality_for(c.air);
        REQUIRE(given.angular_order == c.least);
        QualitySettings fixed = asked;
        fixed.angular_order_as_needed = false;
        fixed.angular_order = c.least;
        fixed.multi_scatter_zenith = std::max(asked.multi_scatter_zenith, c.least + 2);
        fixed.multi_scatter_azimuth = std::max(asked.multi_scatter_azimuth, c.least + 2);
        const Image left_open = picture(c.air, asked);
        CHECK(left_open == picture(c.air, fixed));
        // Whatever is as dark as that would be equal too.
        CHECK(left_open.at(panorama.width / 2, panorama.height / 4).x > 0);
        fixed.angular_order = c.least == 0 ? 2 : 0;
        CHECK(left_open != picture(c.air, fixed));
    }
}

TEST_CASE("aureole: a table of the air with a layer for each moment") {
    const auto cpu = open_cpu_float();
    for (const int order : {0, 2, 4, 6, 8}) {
        Setup setup;
        setup.quality.angular_order = order;
        AirRig rig(*cpu, setup);
        rig.record_air();
        const rhi::Extent extent = rig.multi_scatter().extent;
        const auto moments = static_cast<std::uint32_t>((order + 1) * (order + 2) / 2);
        CHECK(extent == rhi::Extent{setup.quality.multi_scatter.width, setup.quality.multi_scatter.height * moments + 1, 1});
    }
}

TEST_CASE("aureole: what has changed decides which tables are made anew") {
    const auto cpu = open_cpu_float();
    Rig rig(*cpu, Setup{});
    const auto recorded = [](std::span<const PassReport> reports) {
        std::string names;
        for (const PassReport& report : reports)
            if (report.recorded) names.append(report.name).append(" ");
        return names;
    };
    rig.record_air();
    CHECK(recorded(rig.air.reports()) == "transmittance multi_scatter ");
    Camera camera = camera_at(rig.setup.air.planet, 200);
    rig.record_view(camera, sun_at(10));
    CHECK(recorded(rig.view.reports()) == "sky_view aerial_perspective light ");
    camera = look(rig.setup.air.planet.bottom_radius_m, 200, 1, 0.3, 1, 1.5);
    rig.record_air();
    rig.record_view(camera, sun_at(10));
    CHECK(recorded(rig.air.reports()) == "");
    CHECK(recorded(rig.view.reports()) == "aerial_perspective ");  // the sky view is of directions, not of pixels
    rig.record_view(camera, sun_at(11));
    CHECK(recorded(rig.view.reports()) == "sky_view aerial_perspective light ");
    AtmosphereParameters other = rig.setup.air;
    other.planet.ground_albedo = Rgb(0.7);
    rig.air.set_parameters(other);
    rig.record_air();
    rig.record_view(camera, sun_at(11));
    CHECK(recorded(rig.air.reports()) == "transmittance multi_scatter ");
    CHECK(recorded(rig.view.reports()) == "sky_view aerial_perspective light ");
}
