#include "planned_sky/test_sky.h"

#include "common/rejects.h"
#include "passes/dropped_list.h"

#include <cmath>

using namespace aureole;
using namespace aureole::passes;
using detail::rejected_field;

namespace {

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

TEST_CASE("planned sky: tables that take seconds are made behind the old sky, which is shown until they are complete" *
          doctest::test_suite("long")) {
    const auto backend = open_vulkan();
    if (!backend) return;
    // Where tables are never made anew, those of bruneton are the cheapest to look up; at dusk they are not good enough. Those
    // of its quality high are, and take minutes here: there is no room for them.
    PlanRequirements needs = day_and_dusk(0.15);
    needs.air = presets::hazy_earth();
    needs.rebuilds_per_frame = 0;
    needs.budget_mib = 28;
    const auto model_at = [&](double tolerance, double sun) {
        PlanRequirements here = needs;
        here.tolerance = tolerance;
        here.sun_elevation_deg = {sun, sun};
        return plan(here).setting.model;
    };
    TwoHours hours;
    for (const double tolerance : {0.08, 0.1, 0.12, 0.15, 0.2})
        for (const double from : {-4.0, -2.0, 1.0, 5.0})
            if (hours.tolerance == 0 && model_at(tolerance, 40) == "bruneton" && model_at(tolerance, from) != "bruneton")
                hours = {tolerance, from, 40};
    REQUIRE(hours.tolerance > 0);
    needs.tolerance = hours.tolerance;
    const CompositeSettings composite{.target_format = rhi::Format::rgba32_float, .exposure = 10};
    Shown shown(*backend, needs, composite, {.margin = 0.1, .fade_frames = 2, .passes_per_frame = 2});
    shown.sky.prepare_composite(shown.targets);
    (void)shown.update(hours.first_deg);
    (void)shown.show();
    const Plan before = shown.sky.plan();
    (void)shown.update(hours.then_deg);
    REQUIRE(shown.sky.plan().setting.model == "bruneton");
    const Image old_sky = alone(*backend, before, composite, hours.then_deg);
    int frames = 0;
    for (; frames < 100; ++frames) {
        const Image now = shown.show();
        CHECK(now == old_sky);
        if (shown.sky.light().after) break;
        CHECK(shown.update(hours.then_deg).share == 0);
    }
    CHECK(frames >= 2);
    CHECK(frames < 100);
    for (int i = 0; i < 3; ++i) {
        (void)shown.update(hours.then_deg);
        (void)shown.show();
    }
    CHECK(shown.sky.light().share == 0);
    CHECK(shown.show() == alone(*backend, shown.sky.plan(), composite, hours.then_deg));
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

namespace {

/// Geometry that is so near that by day the air before it can be left out, and not at dusk.
PlanRequirements with_near_geometry() {
    for (const double tolerance : {0.05, 0.1, 0.2, 0.5})
        for (double range_m = 1; range_m < 1e5; range_m *= 1.5) {
            PlanRequirements needs = day_and_dusk(tolerance);
            needs.geometry = true;
            needs.geometry_range_m = range_m;
            const auto drawn_at = [&](double sun_deg, double around) {
                needs.sun_elevation_deg = {sun_deg - around, sun_deg + around};
                return plan(needs).view.aerial_perspective;
            };
            const bool by_day = drawn_at(50, 15), at_dusk = drawn_at(1, 0);
            needs.sun_elevation_deg = {-6, 70};
            if (!by_day && at_dusk) return needs;
        }
    FAIL("at every hour it is the same");
    return {};
}

}  // namespace

TEST_CASE("planned sky: the air before near geometry comes where the hour calls for it, and goes again") {
    const auto backend = open_cpu_float();
    Shown shown(*backend, with_near_geometry(), {.target_format = rhi::Format::rgba32_float},
                {.margin = 0.1, .fade_frames = 2});
    shown.sky.prepare_composite(shown.targets);
    const auto go_to = [&](double sun_deg) {
        PlanUpdate update = shown.update(sun_deg);
        for (int frame = 0; frame < 4; ++frame) {
            (void)shown.show();
            (void)shown.update(sun_deg);
        }
        return update;
    };
    // A sky that is made bit by bit keeps a little more; froxels are the larger part.
    const auto unlike = [&](const Plan& plan, bool aerial_perspective) {
        ViewSettings settings = plan.view;
        settings.aerial_perspective = aerial_perspective;
        Atmosphere air(backend->device(), plan.air, plan.model);
        const View view(air, settings, {.target_format = rhi::Format::rgba32_float});
        return std::abs(double(shown.sky.table_bytes()) - double(air.table_bytes() + view.table_bytes()));
    };
    for (const auto& hour : {std::pair{50.0, false}, {1.0, true}, {50.0, false}}) {
        const auto& sun_deg = hour.first;
        const auto& drawn = hour.second;
        CAPTURE(sun_deg);
        const PlanUpdate update = go_to(sun_deg);
        CHECK(update.planned);
        CHECK(shown.sky.plan().view.aerial_perspective == drawn);
        CHECK(unlike(shown.sky.plan(), drawn) < unlike(shown.sky.plan(), !drawn));  // the view is the plan's
    }
}
