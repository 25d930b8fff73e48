#include <aureole/planned_sky.h>

#include <doctest/doctest.h>

#include "common/rejects.h"
#include "passes/dropped_list.h"
#include "passes/rig.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

using namespace aureole;
using namespace aureole::passes;
using detail::rejected_field;

namespace {

constexpr rhi::Extent extent{16, 9, 1};
constexpr std::uint32_t fade_frames = 5;

/// Day to dusk at the ground; tables anew each frame, so that no plan takes seconds.
PlanRequirements day_and_dusk(double tolerance) {
    PlanRequirements needs;
    needs.air = presets::earth();
    needs.sun_elevation_deg = {-6, 70};
    needs.altitude_m = {2, 2};
    needs.rebuilds_per_frame = 1;
    needs.tolerance = tolerance;
    return needs;
}

struct TwoHours {
    double tolerance = 0, first_deg = 0, then_deg = 0;
};

/// Two elevations of the sun that are planned for differently.
TwoHours two_hours() {
    for (const double tolerance : {0.03, 0.05, 0.1, 0.2, 0.5}) {
        PlanRequirements needs = day_and_dusk(tolerance);
        needs.sun_elevation_deg = {50, 50};
        const Setting by_day = plan(needs).setting;
        for (const double then : {5.0, 1.0, -2.0, -4.0}) {
            needs.sun_elevation_deg = {then, then};
            if (!(plan(needs).setting == by_day)) return {tolerance, 50, then};
        }
    }
    FAIL("every hour has the same plan");
    return {};
}

/// A planned sky, and a target to show it in.
struct Shown {
    Shown(Backend& backend_in, double tolerance, bool raster, std::uint32_t frames = fade_frames, int passes = 0,
          rhi::Format format = rhi::Format::rgba32_float, double exposure = 10)
        : backend(backend_in),
          state(raster ? rhi::State::color_attachment : rhi::State::storage_write),
          sky(backend.device(), day_and_dusk(tolerance), {.target_format = format, .raster = raster, .exposure = exposure},
              {.margin = 0.1, .fade_frames = frames, .passes_per_frame = passes}) {
        targets.extent = extent;
        targets.target = backend.make_target(format, extent, state);
    }
    PlanUpdate update(double sun_deg) {
        const Sun sun = sun_at(sun_deg);
        return sky.update(camera_at(presets::earth().planet, 2), {&sun, 1});
    }
    Image show() {
        backend.run([&](rhi::CommandList& commands) {
            sky.record(commands);
            sky.record_composite(commands, targets);
        });
        return backend.read(targets.target, state);
    }
    /// A fifth of the way.
    void begin_fade(const TwoHours& hours) {
        sky.prepare_composite(targets);
        for (const double hour : {hours.first_deg, hours.then_deg, hours.then_deg}) {
            (void)update(hour);
            (void)show();
        }
    }
    Backend& backend;
    rhi::State state;
    PlannedSky sky;
    CompositeTargets targets;
};

double greatest_step(const Image& a, const Image& b) {
    double greatest = 0;
    for (std::size_t i = 0; i < a.texels.size(); ++i)
        for (int c = 0; c < 4; ++c) greatest = std::max(greatest, std::abs(a.texels[i][c] - b.texels[i][c]));
    return greatest;
}

/// What the plan draws, by itself.
Image alone(Backend& backend, const Plan& plan, const CompositeSettings& composite, double sun_deg) {
    Setup setup;
    setup.air = plan.air;
    setup.model = plan.model;
    setup.view = plan.view;
    setup.composite = composite;
    Rig rig(backend, setup);
    rig.record_air();
    rig.record_view(camera_at(plan.air.planet, 2), sun_at(sun_deg));
    return rig.show(extent);
}

void check_fade(Backend& backend, bool raster) {
    const TwoHours hours = two_hours();
    Shown shown(backend, hours.tolerance, raster);
    const CompositeSettings composite{.target_format = rhi::Format::rgba32_float, .raster = raster, .exposure = 10};
    shown.sky.prepare_composite(shown.targets);
    PlanUpdate update = shown.update(hours.first_deg);
    CHECK(update.planned);
    CHECK(update.changes.empty());  // nothing was shown before
    CHECK(update.share == 1);
    const Plan by_day = shown.sky.plan();
    CHECK(shown.show() == alone(backend, by_day, composite, hours.first_deg));
    CHECK_FALSE(shown.update(hours.first_deg).planned);

    update = shown.update(hours.then_deg);
    REQUIRE(update.planned);
    REQUIRE_FALSE(update.changes.empty());
    CHECK(update.share == 0);
    const Plan after = shown.sky.plan();
    CHECK_FALSE(after.setting == by_day.setting);
    const Image old_sky = alone(backend, by_day, composite, hours.then_deg);
    const Image new_sky = alone(backend, after, composite, hours.then_deg);
    const double whole = greatest_step(old_sky, new_sky);
    REQUIRE(whole > 0);
    Image before = shown.show();
    CHECK(before == old_sky);
    for (std::uint32_t frame = 1; frame <= fade_frames; ++frame) {
        update = shown.update(hours.then_deg);
        CHECK_FALSE(update.planned);
        CHECK(update.share == doctest::Approx(double(frame) / fade_frames).epsilon(1e-12).scale(1e-300));
        const Image now = shown.show();
        CHECK(greatest_step(before, now) <= 1.01 * whole / fade_frames + 1e-6);
        CHECK(greatest_step(now, new_sky) <= (1 - update.share) * whole * 1.01 + 1e-6);
        before = now;
    }
    CHECK(before == new_sky);
    CHECK(shown.sky.plan().setting == after.setting);
}

}  // namespace

TEST_CASE("planned sky: where the hour calls for another plan, the old sky gives way to the new one without a jump" *
          doctest::test_suite("long")) {
    for (const auto& backend : {open_cpu_float(), open_vulkan()}) {
        if (!backend) continue;
        INFO(backend->name());
        for (const bool raster : {false, true}) check_fade(*backend, raster);
    }
}

TEST_CASE("planned sky: nothing is left of the old sky once it is gone, nor of targets that are released") {
    const auto backend = open_cpu_float();
    const TwoHours hours = two_hours();
    Shown shown(*backend, hours.tolerance, false, 1);
    shown.sky.prepare_composite(shown.targets);
    (void)shown.update(hours.first_deg);
    (void)shown.show();
    const std::uint64_t one = shown.sky.table_bytes();
    (void)shown.update(hours.then_deg);
    CHECK(shown.sky.table_bytes() > one);
    (void)shown.show();
    (void)shown.update(hours.then_deg);
    (void)shown.show();
    PlanRequirements needs = day_and_dusk(hours.tolerance);
    Atmosphere air(backend->device(), shown.sky.plan().air, shown.sky.plan().model);
    View view(air, shown.sky.plan().view, {.target_format = rhi::Format::rgba32_float});
    CHECK(shown.sky.table_bytes() == air.table_bytes() + view.table_bytes());
    CHECK(shown.sky.light().before);
    CHECK_FALSE(shown.sky.light().after);
    const Image kept = shown.show();
    shown.sky.release_composite(shown.targets);
    shown.sky.release_composite(shown.targets);  // unknown by now
    CHECK(backend->run([&](rhi::CommandList& commands) { shown.sky.record_composite(commands, shown.targets); }).total() == 0);
    shown.sky.prepare_composite(shown.targets);
    CHECK(shown.show() == kept);
}

TEST_CASE("planned sky: targets come and go during a fade") {
    const auto backend = open_cpu_float();
    const TwoHours hours = two_hours();
    Shown shown(*backend, hours.tolerance, false);
    shown.begin_fade(hours);
    const PlannedLight light = shown.sky.light();
    CHECK(light.after);
    CHECK(light.share == doctest::Approx(0.2).epsilon(1e-12).scale(1e-300));
    const Image wanted = shown.show();
    CompositeTargets late = shown.targets;
    late.target = backend->make_target(rhi::Format::rgba32_float, extent, shown.state);
    CHECK(backend->run([&](rhi::CommandList& commands) { shown.sky.record_composite(commands, late); }).total() == 0);
    shown.sky.prepare_composite(late);
    backend->run([&](rhi::CommandList& commands) { shown.sky.record_composite(commands, late); });
    CHECK(backend->read(late.target, shown.state) == wanted);
    shown.sky.release_composite(shown.targets);
    shown.targets = late;
    shown.sky.set_exposure(20);
    for (int frame = 0; frame < 6; ++frame) {
        (void)shown.update(hours.then_deg);
        (void)shown.show();
    }
    CHECK(shown.sky.light().share == 0);
    const CompositeSettings composite{.target_format = rhi::Format::rgba32_float, .exposure = 20};
    CHECK(shown.show() == alone(*backend, shown.sky.plan(), composite, hours.then_deg));
    std::vector<CompositeTargets> many;
    while (many.size() + 1 < PlannedSky::max_targets) {
        many.push_back(late);
        many.back().target = backend->make_target(rhi::Format::rgba32_float, extent, shown.state);
        shown.sky.prepare_composite(many.back());
    }
    CompositeTargets one_more = late;
    one_more.target = backend->make_target(rhi::Format::rgba32_float, extent, shown.state);
    CHECK(rejected_field([&] { shown.sky.prepare_composite(one_more); }) == "targets");
    CompositeTargets small = many.back();
    shown.sky.release_composite(small);
    small.extent = {3, 3, 1};
    CHECK(rejected_field([&] { shown.sky.prepare_composite(small); }) == "targets.extent");
    shown.sky.prepare_composite(many.back());  // and nothing of that is left
}

TEST_CASE("planned sky: frames that are not drawn do not fade, and what is too bright for the format stays bright") {
    const auto backend = open_cpu_float();
    const TwoHours hours = two_hours();
    Shown shown(*backend, hours.tolerance, false, fade_frames, 0, rhi::Format::rgba16_float, 1e9);
    shown.sky.prepare_composite(shown.targets);
    for (const double hour : {hours.first_deg, hours.then_deg, hours.then_deg}) {
        (void)shown.update(hour);
        const Image image = shown.show();
        for (const glm::dvec4& texel : image.texels)
            for (int c = 0; c < 3; ++c) CHECK_FALSE(std::isnan(texel[c]));
    }
    const double share = shown.sky.light().share;
    CHECK(share > 0);
    for (int i = 0; i < 20; ++i) CHECK(shown.update(hours.then_deg).share <= share + 1.01 / fade_frames);
}

TEST_CASE("planned sky: with tables spread over frames the new sky comes, and follows the sun afterwards") {
    const auto backend = open_cpu_float();
    const TwoHours hours = two_hours();
    Shown shown(*backend, hours.tolerance, false, 1, 1);
    shown.sky.prepare_composite(shown.targets);
    (void)shown.update(hours.first_deg);
    (void)shown.show();
    const Setting by_day = shown.sky.plan().setting;
    CHECK_FALSE(shown.update(hours.then_deg).changes.empty());
    int frames = 0;
    for (; frames < 100; ++frames) {
        (void)shown.show();
        if (shown.sky.light().after) break;
        (void)shown.update(hours.then_deg);
    }
    CHECK(frames < 100);
    for (int i = 0; i < 4; ++i) {
        (void)shown.show();
        (void)shown.update(hours.then_deg);
    }
    CHECK_FALSE(shown.sky.plan().setting == by_day);
    const double later = hours.then_deg - 0.1;
    (void)shown.update(later);
    const CompositeSettings composite{.target_format = rhi::Format::rgba32_float, .exposure = 10};
    CHECK(shown.show() == alone(*backend, shown.sky.plan(), composite, later));
}

TEST_CASE("planned sky: without frames to fade over the new sky is shown as soon as it is ready") {
    const auto backend = open_cpu_float();
    const TwoHours hours = two_hours();
    Shown shown(*backend, hours.tolerance, false, 0);
    shown.sky.prepare_composite(shown.targets);
    (void)shown.update(hours.first_deg);
    (void)shown.show();
    CHECK_FALSE(shown.update(hours.then_deg).changes.empty());
    (void)shown.show();  // the new one's tables
    (void)shown.update(hours.then_deg);
    const CompositeSettings composite{.target_format = rhi::Format::rgba32_float, .exposure = 10};
    CHECK(shown.show() == alone(*backend, shown.sky.plan(), composite, hours.then_deg));
}

TEST_CASE("planned sky: a recording that is dropped is made up for, also during a fade") {
    const auto backend = open_cpu_float();
    const TwoHours hours = two_hours();
    Shown shown(*backend, hours.tolerance, false);
    shown.begin_fade(hours);
    CHECK(shown.sky.light().after);
    const double later = hours.then_deg - 0.1;
    (void)shown.update(later);
    DroppedList list;
    shown.sky.record(list);
    CHECK(list.commands > 0);
    shown.sky.invalidate();
    CHECK_FALSE(shown.sky.light().before);
    CHECK(shown.update(later).share == 0);  // it fades in anew
    const CompositeSettings composite{.target_format = rhi::Format::rgba32_float, .exposure = 10};
    Image last = shown.show();
    for (std::uint32_t frame = 0; frame <= fade_frames; ++frame) {
        (void)shown.update(later);
        last = shown.show();
    }
    CHECK(last == alone(*backend, shown.sky.plan(), composite, later));
}

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
    const TwoHours hours = two_hours();
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

TEST_CASE("planned sky: other air is planned for, and shown") {
    const auto backend = open_cpu_float();
    Shown shown(*backend, 0.2, false, 0);
    shown.sky.prepare_composite(shown.targets);
    (void)shown.update(40);
    (void)shown.show();
    AtmosphereParameters air = presets::earth();
    air.planet.ground_albedo = Rgb(0.7);
    shown.sky.set_air(air);
    CHECK(shown.update(40).planned);
    (void)shown.show();
    (void)shown.update(40);
    CHECK(shown.sky.plan().air.planet.ground_albedo == Rgb(0.7));
    const CompositeSettings composite{.target_format = rhi::Format::rgba32_float, .exposure = 10};
    CHECK(shown.show() == alone(*backend, shown.sky.plan(), composite, 40));
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
