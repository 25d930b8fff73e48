// Planned sky: what hosts give it, and what devices refuse.
#include "planned_sky/test_sky.h"

#include "common/rejects.h"

#include <limits>
#include <optional>

using namespace aureole;
using namespace aureole::passes;
using detail::rejected_field;

TEST_CASE("planned sky: with as many targets as there may be, the sun moves on during a fade" * doctest::test_suite("long")) {
    const auto backend = open_cpu_float();
    const TwoHours hours = two_hours();
    Shown shown(*backend, hours.tolerance, false, 2);
    std::vector<CompositeTargets> all(PlannedSky::max_targets, shown.targets);
    for (CompositeTargets& one : all) {
        one.target = backend->make_target(rhi::Format::rgba32_float, extent, shown.state);
        shown.sky.prepare_composite(one);
    }
    const CompositeSettings composite{.target_format = rhi::Format::rgba32_float, .exposure = 10};
    double sun = hours.first_deg;
    std::size_t fades = 0;
    for (int frame = 0; frame < 24; ++frame) {
        if (frame % 6 == 1) sun = sun == hours.first_deg ? hours.then_deg : hours.first_deg;
        const PlanUpdate update = shown.update(sun);
        if (!update.changes.empty()) ++fades;
        for (const CompositeTargets& one : all) {
            shown.targets = one;
            const Image image = shown.show();
            if (update.share == 1 && frame % 6 == 5 && one.target == all.front().target)
                CHECK(image == alone(*backend, shown.sky.plan(), composite, sun));
        }
    }
    CHECK(fades >= 3);
}

TEST_CASE("planned sky: whatever the device refuses, an update changes nothing, and the next one makes up for it") {
    const auto backend = open_cpu_float();
    const TwoHours hours = two_hours();
    CountingDevice& device = backend->device();
    Shown shown(*backend, hours.tolerance, false, 2);
    shown.sky.prepare_composite(shown.targets);
    (void)shown.update(hours.first_deg);
    (void)shown.show();
    const Setting by_day = shown.sky.plan().setting;
    std::uint64_t refused = 0;
    for (std::uint64_t more = 0;; ++more) {
        const std::uint64_t live = device.live();
        device.fail_after(more);
        try {
            (void)shown.update(hours.then_deg);
            break;
        } catch (const Error& error) {
            CHECK(error.code() == ErrorCode::out_of_memory);
            ++refused;
        }
        CHECK(device.live() == live);
        CHECK(shown.sky.plan().setting == by_day);
        CHECK(shown.sky.light().share == 0);
    }
    device.fail_after(std::nullopt);
    CHECK(refused > 20);  // buffers, tables, pipelines, bindings of a sky
    CHECK_FALSE(shown.sky.plan().setting == by_day);
    for (int frame = 0; frame < 4; ++frame) {
        (void)shown.show();
        (void)shown.update(hours.then_deg);
    }
    const CompositeSettings composite{.target_format = rhi::Format::rgba32_float, .exposure = 10};
    CHECK(shown.show() == alone(*backend, shown.sky.plan(), composite, hours.then_deg));
}

TEST_CASE("planned sky: a shadow map darkens the old sky and the new one") {
    const auto backend = open_cpu_float();
    const TwoHours hours = two_hours(true);
    PlanRequirements needs = day_and_dusk(hours.tolerance);
    needs.shadows = true;
    const CompositeSettings composite{.target_format = rhi::Format::rgba32_float, .exposure = 10};
    const FollowSettings follow{.margin = 0.1, .fade_frames = 2, .passes_per_frame = 0, .shadows = {.cascades = 1}};
    PlannedSky sky(backend->device(), needs, composite, follow);
    CompositeTargets targets;
    targets.extent = extent;
    targets.target = backend->make_target(rhi::Format::rgba32_float, extent, rhi::State::storage_write);
    sky.prepare_composite(targets);
    ShadowMap map;  // all is behind it
    map.texture = backend->make("shadow map", rhi::Format::r32_float, Image{{1, 1, 1}, {glm::dvec4(0)}});
    map.world_to_map[0] = glm::dmat4(0);
    map.world_to_map[0][3] = {0.5, 0.5, 0.5, 1};
    sky.set_shadow_map(map);
    const auto shown = [&](double sun_deg) {
        const Sun sun = sun_at(sun_deg);
        (void)sky.update(camera_at(needs.air.planet, 2), {&sun, 1});
        backend->run([&](rhi::CommandList& commands) {
            sky.record(commands);
            sky.record_composite(commands, targets);
        });
        return backend->read(targets.target, rhi::State::storage_write);
    };
    const auto shadowed_alone = [&](double sun_deg, bool in_shadow) {
        Setup setup;
        setup.air = sky.plan().air;
        setup.model = sky.plan().model;
        setup.view = sky.plan().view;
        setup.view.shadows = follow.shadows;
        setup.composite = composite;
        Rig rig(*backend, setup);
        if (in_shadow) rig.view.set_shadow_map(map);
        rig.record_air();
        rig.record_view(camera_at(needs.air.planet, 2), sun_at(sun_deg));
        return rig.show(extent);
    };
    const Image by_first = shown(hours.first_deg);
    CHECK(by_first == shadowed_alone(hours.first_deg, true));
    CHECK_FALSE(by_first == shadowed_alone(hours.first_deg, false));
    const Setting by_day = sky.plan().setting;
    (void)shown(hours.then_deg);
    CHECK_FALSE(sky.plan().setting == by_day);
    (void)shown(hours.then_deg);
    sky.set_shadow_map({});  // of both
    (void)shown(hours.then_deg);
    CHECK(shown(hours.then_deg) == shadowed_alone(hours.then_deg, false));
    sky.set_shadow_map(map);
    CHECK(shown(hours.then_deg) == shadowed_alone(hours.then_deg, true));
}

TEST_CASE("planned sky: what it is given is checked, and nothing changes") {
    const auto backend = open_cpu_float();
    constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
    const auto with = [&](const FollowSettings& follow) {
        return rejected_field([&] { PlannedSky(backend->device(), day_and_dusk(0.1), {}, follow); });
    };
    CHECK(with({.margin = 0}) == "follow.margin");
    CHECK(with({.margin = not_a_number}) == "follow.margin");
    CHECK(with({.fade_frames = 100001}) == "follow.fade_frames");
    CHECK(with({.passes_per_frame = 65}) == "follow.passes_per_frame");
    PlannedSky sky(backend->device(), day_and_dusk(0.1));
    const Camera camera = camera_at(presets::earth().planet, 2);
    Sun bad = sun_at(20);
    bad.irradiance.r = not_a_number;
    CHECK(rejected_field([&] { (void)sky.update(camera, {&bad, 1}); }) == "sun.irradiance.r");
    const std::vector<Sun> many(2, sun_at(20));
    CHECK(rejected_field([&] { (void)sky.update(camera, many); }) == "suns");
    AtmosphereParameters air = presets::earth();
    air.planet.bottom_radius_m = 0;
    CHECK(rejected_field([&] { sky.set_air(air); }) == "planet.bottom_radius_m");
    CHECK(rejected_field([&] { sky.set_exposure(0); }) == "composite.exposure");
    Camera panorama = camera;
    panorama.kind = Projection::panorama;
    const Sun good = sun_at(20);
    CHECK(rejected_field([&] { (void)sky.update(panorama, {&good, 1}); }) == "camera.kind");
    CHECK(rejected_field([&] { sky.set_shadow_map({}); }) == "shadow_map");  // none is required
    PlanRequirements shadowed = day_and_dusk(0.1);
    shadowed.shadows = true;
    const auto shaded = [&](const ShadowSettings& shadows) {
        return rejected_field([&] { PlannedSky(backend->device(), shadowed, {}, {.shadows = shadows}); });
    };
    CHECK(shaded({}) == "follow.shadows.cascades");
    CHECK(shaded({.cascades = 5}) == "follow.shadows.cascades");
    CHECK(shaded({.cascades = 1, .samples = 0}) == "view.shadows.samples");
    PlanRequirements two_eyes = day_and_dusk(0.1);
    two_eyes.views = 2;
    CHECK(rejected_field([&] { PlannedSky(backend->device(), two_eyes); }) == "views");
    const auto composed = [&](const CompositeSettings& composite) {
        return rejected_field([&] { PlannedSky(backend->device(), day_and_dusk(0.1), composite); });
    };
    CHECK(composed({.exposure = 0}) == "composite.exposure");
    CHECK(composed({.scene_depth = true}) == "composite.scene_depth");
    CHECK(composed({.target_format = rhi::Format::d32_float}) == "composite.target_format");
    CHECK_NOTHROW((void)sky.update(camera, {}));  // night
    CHECK(sky.plan().air.planet == presets::earth().planet);
}
