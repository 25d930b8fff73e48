#include "measure/fit.h"
#include "measure/hold_out.h"

#include "io/test_files.h"
#include "plan/predict.h"

#include <aureole/presets.h>
#include <aureole/rhi/error.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

using namespace aureole;
using namespace aureole::app;
using detail::MeasuredError;
using detail::MeasuredSkies;
using detail::Situation;
using nlohmann::json;

namespace {

json figures(double median, double p95) { return {{"rows", 10}, {"median", median}, {"p95", p95}, {"max", p95}}; }
json spread(double ms) { return {{"median", ms}, {"p10", ms}, {"p90", ms}}; }

json scene(const std::string& id, const std::string& spectral, double sun) {
    Situation place{};
    place[0] = sun;
    return {{"id", id},        {"class", "Day"},     {"air", "earth"},      {"sun_elevation_deg", 5},
            {"altitude_m", 2}, {"situation", place}, {"spectral", spectral}};
}

json setting(const std::string& model, const std::string& spectral, const json& without) {
    return {{"id", Setting{model, "default", spectral, without}.id()},
            {"model", model},
            {"quality", "default"},
            {"spectral", spectral},
            {"without", without}};
}

json measured() {
    json out{{"cost_device", "a device"},
             {"cost_size", {detail::measured_width, detail::measured_height}},
             {"scenes", {scene("a", "rgb", 0), scene("b", "rgb", 1), scene("c", "40", 1)}},
             {"settings",
              {setting("fog", "rgb", json::array()), setting("aureole", "rgb", {"ozone"}),
               setting("aureole", "4", json::array()), setting("reference", "rgb", json::array())}}};
    const auto result = [&](const char* place, const char* what, json regions) {
        out["results"].push_back({{"scene", place}, {"setting", what}, {"regions", std::move(regions)}});
    };
    result("a", "fog default", {{"all", figures(0.5, 2)}, {"aerial", figures(0.1, 0.3)}});
    result("b", "fog default", {{"all", figures(0.4, 1)}});
    result("b", "aureole default, without ozone", {{"all", figures(0.01, 0.02)}, {"aerial", {{"rows", 0}}}});
    result("c", "aureole default 4", {{"all", figures(0.001, 0.002)}});
    result("a", "reference default", {{"all", figures(0, 0)}});
    out["costs"].push_back({{"air", "earth"},
                            {"setting", "fog default"},
                            {"work",
                             {{"rebuild", 2e6},
                              {"view", 15},
                              {"air_memory", 3},
                              {"view_memory", 2},
                              {"aerial_perspective_memory", 4},
                              {"composite", 5},
                              {"light", 6}}},
                            {"per_frame_ms", spread(10)},
                            {"composite_ms", spread(7)},
                            {"composite_geometry_ms", spread(9)},
                            {"aerial_perspective_ms", spread(1)},
                            {"light_ms", spread(0.5)},
                            {"composite_two_suns_ms", spread(11)},
                            {"shadows_ms", spread(3)},
                            {"composite_shadows_ms", spread(9.5)},
                            {"rebuild_ms", spread(8)},
                            {"shadow_bytes", 262144},
                            {"bytes", 3 * 1048576},
                            {"air_bytes", 1048576},
                            {"aerial_perspective_bytes", 524288}});
    return out;
}

/// A field that is known everywhere, at places drawn evenly.
MeasuredSkies invented(std::size_t scenes) {
    MeasuredSkies skies;
    skies.airs = {"air"};
    detail::MeasuredSetting& setting = skies.settings.emplace_back();
    setting.by_air.resize(1);
    std::uint32_t state = 1;
    const auto random = [&] {
        state = state * 1664525U + 1013904223U;
        return (state >> 8) / 16777216.0;
    };
    for (std::size_t i = 0; i < scenes; ++i) {
        detail::MeasuredScene& scene = skies.scenes.emplace_back();
        scene.id = "scene" + std::to_string(i);
        scene.situation[0] = 6 * random();
        scene.situation[3] = 3 * random();
        const double logarithm = std::sin(scene.situation[0]) + 0.5 * scene.situation[3] - 3;
        for (MeasuredError& bare : skies.bare) bare.by_scene.push_back(MeasuredError::pack(2 * std::exp(logarithm)));
        for (const auto error : detail::measured_errors)
            (setting.*error).by_scene.push_back(MeasuredError::pack(std::exp(logarithm)));
    }
    return skies;
}

}  // namespace

TEST_CASE("gather: scenes by their colours, settings with what is known of them, costs by their parts") {
    const json one = measured();
    const MeasuredSkies rgb = gather({&one, 1}, false), wavelengths = gather({&one, 1}, true);
    CHECK(rgb.device == "a device");
    REQUIRE(rgb.scenes.size() == 2);
    CHECK(rgb.scenes[1].situation[0] == 1);
    REQUIRE(rgb.settings.size() == 2);  // reference is no choice
    CHECK(rgb.settings[0].setting == Setting{"fog", "default", "rgb", {}});
    CHECK(rgb.settings[0].sky_p95.by_scene == std::vector<std::int16_t>{MeasuredError::pack(2), 0});
    CHECK(rgb.settings[0].aerial_p95.by_scene == std::vector{MeasuredError::pack(0.3), MeasuredError::unknown});
    CHECK(rgb.settings[0].aerial_near_p95.by_scene.empty());  // an older measurement
    CHECK(rgb.bare[0].by_scene == std::vector{MeasuredError::unknown, MeasuredError::unknown});
    CHECK(rgb.settings[0].by_air.at(0).composite_bare_ms == 9);  // not measured: no cheaper
    CHECK(rgb.settings[1].setting.without == std::vector<std::string>{"ozone"});
    CHECK(rgb.settings[1].sky_median.by_scene == std::vector{MeasuredError::unknown, MeasuredError::pack(0.01)});
    CHECK(rgb.settings[1].by_air.at(0).air_mib == 0);
    const detail::MeasuredCost& cost = rgb.settings[0].by_air.at(0);
    CHECK(cost.composite_ms == 7);
    CHECK(cost.composite_geometry_ms == 9);
    CHECK(cost.view_ms == 1.5);
    CHECK(cost.rebuild_ms == 5);
    CHECK(cost.air_mib == 1);
    CHECK(cost.aerial_perspective_mib == 0.5);
    CHECK(cost.view_mib == 1.5);
    CHECK(cost.composite_sun_ms == 4);
    CHECK(cost.shadows_ms == 3);
    CHECK(cost.composite_shadows_ms == 0.5);
    CHECK(cost.shadows_mib == 0.25);
    CHECK(cost.work == detail::TableWork{2e6, 15, 3, 2, 4, 5, 6});
    const AtmosphereParameters mars = presets::mars();  // what was known of it then does not count
    CHECK(gather({&one, 1}, false, {{"earth", mars}}).settings[0].by_air.at(0).work ==
          detail::table_work(*model_by_name("fog"), mars));
    CHECK(gather({&one, 1}, false, {{"venus", mars}}).settings[0].by_air.at(0).work == cost.work);
    REQUIRE(wavelengths.scenes.size() == 1);
    REQUIRE(wavelengths.settings.size() == 1);
    CHECK(wavelengths.settings[0].setting.spectral == "4");
}

TEST_CASE("gather: of what was measured twice the later counts; what is incomplete is refused") {
    const json before = measured();
    json after = measured();
    after["results"][0]["regions"]["all"]["p95"] = 3;
    const std::vector<json> both{before, after};
    CHECK(gather(both, false).settings[0].sky_p95.by_scene[0] == MeasuredError::pack(3));
    json elsewhere = measured();
    elsewhere["cost_device"] = "another";
    CHECK(contains(complaint([&] { (void)gather(std::vector<json>{before, elsewhere}, false); }), "those of one device"));
    json smaller = measured();
    smaller["cost_size"][0] = detail::measured_width / 2;
    const detail::MeasuredCost doubled = gather({&smaller, 1}, false).settings[0].by_air.at(0);
    CHECK(doubled.composite_ms == 14);
    CHECK(doubled.composite_sun_ms == 8);
    CHECK(doubled.view_ms == 1.5);
    json infinite = measured();
    infinite["results"][0]["regions"]["all"]["p95"] = nullptr;
    CHECK(gather({&infinite, 1}, false).settings[0].sky_p95.by_scene[0] == MeasuredError::pack(1e9));
    json without_costs = measured();
    without_costs.erase("costs");
    CHECK(contains(complaint([&] { (void)gather({&without_costs, 1}, false); }), "measured without costs"));
    CHECK(gather(std::vector<json>{before, without_costs}, false).settings[0].by_air.at(0).composite_ms == 7);
    json broken = measured();
    broken["results"][0].erase("regions");
    CHECK(contains(complaint([&] { (void)gather({&broken, 1}, false); }), "what `aureole measure` writes"));
    json unknown = measured();
    unknown["results"][0]["setting"] = "nobody";
    CHECK(contains(complaint([&] { (void)gather({&unknown, 1}, false); }), "a setting that it does not list"));
}

TEST_CASE("gather: where the truth of most directions is not known nothing is") {
    const auto sky_of = [](const json& asked) {
        json one = measured();  // ten rows
        one["results"][0]["regions"]["all"].update(asked);
        const detail::MeasuredSetting setting = gather({&one, 1}, false).settings[0];
        CHECK(setting.aerial_p95.by_scene.at(0) == MeasuredError::pack(0.3));  // each region by itself
        CHECK((setting.sky_median.by_scene.at(0) == MeasuredError::unknown) ==
              (setting.sky_p95.by_scene.at(0) == MeasuredError::unknown));
        return setting.sky_p95.by_scene.at(0);
    };
    CHECK(sky_of(json::object()) == MeasuredError::pack(2));
    CHECK(sky_of({{"asked", 10}}) == MeasuredError::pack(2));
    CHECK(sky_of({{"asked", 20}}) == MeasuredError::pack(2));
    CHECK(sky_of({{"asked", 21}}) == MeasuredError::unknown);
    CHECK(sky_of({{"asked", 45}}) == MeasuredError::unknown);
}

TEST_CASE("gather: geometry near and far, and without the air before it, over the share of light that is lost") {
    json one = measured();
    one["results"][0]["regions"]["aerial near"] = figures(0.05, 0.1);
    one["results"][0]["regions"]["aerial far"] = figures(0.1, 0.4);
    one["scenes"][0]["extinction_per_km"] = 0.1;
    json known = figures(0.2, 0.25), unknown = figures(0.2, 0.25);
    known.update({{"distance_km", 1.0}, {"asked", 12}});
    unknown.update({{"distance_km", 10.0}, {"asked", 25}});
    one["scenes"][0]["bare"] = {known, unknown};
    one["costs"][0]["composite_bare_ms"] = spread(8);
    const MeasuredSkies skies = gather({&one, 1}, false);
    CHECK(skies.settings[0].aerial_near_p95.by_scene == std::vector{MeasuredError::pack(0.1), MeasuredError::unknown});
    CHECK(skies.settings[0].aerial_far_p95.by_scene == std::vector{MeasuredError::pack(0.4), MeasuredError::unknown});
    CHECK(skies.settings[1].aerial_near_p95.by_scene.empty());
    CHECK(skies.settings[0].by_air.at(0).composite_bare_ms == 8);
    for (std::size_t i = 0; i < detail::bare_distances_km.size(); ++i) {
        const double km = detail::bare_distances_km[i];
        CHECK(skies.bare[i].by_scene.at(0) ==
              (km == 1 ? MeasuredError::pack(0.25 / (1 - std::exp(-0.1))) : MeasuredError::unknown));
        CHECK(skies.bare[i].by_scene.at(1) == MeasuredError::unknown);
    }
    // An older one after it, of the same scene: near and far are what it knows of all.
    const json both[] = {one, measured()};
    const MeasuredSkies later = gather(both, false);
    CHECK(later.settings[0].aerial_near_p95.by_scene.at(0) == MeasuredError::pack(0.3));
    CHECK(later.settings[0].aerial_far_p95.by_scene.at(0) == MeasuredError::pack(0.3));
    CHECK(later.bare[4].by_scene.at(0) == skies.bare[4].by_scene.at(0));
}

TEST_CASE("gather: light errs by the worse of sky and sun, and is unknown where the truth of the sky's is") {
    const auto light_of = [](const json& light) {
        json one = measured();
        one["results"][0].update(light);  // of scene "a"
        return gather({&one, 1}, false).settings[0].light.by_scene.at(0);
    };
    CHECK(light_of({{"sky_illuminance", 0.2}, {"sun_colour", 0.03}}) == MeasuredError::pack(0.2));
    CHECK(light_of({{"sky_illuminance", 0.02}, {"sun_colour", 0.3}}) == MeasuredError::pack(0.3));
    CHECK(light_of({{"sky_illuminance", 0.2}}) == MeasuredError::pack(0.2));  // the sun has set
    CHECK(light_of({{"sun_colour", 0.2}}) == MeasuredError::unknown);         // noise, or above the air
    CHECK(light_of(json::object()) == MeasuredError::unknown);
    CHECK(light_of({{"sky_illuminance", 1e-7}}) == MeasuredError::pack(1e-3));
    CHECK(light_of({{"sky_illuminance", nullptr}}) == MeasuredError::pack(HUGE_VAL));
}

TEST_CASE("fit: finds along which axes a field changes, and bounds that hold") {
    MeasuredSkies skies = invented(60);
    fit(skies);
    CHECK(skies.lengths[0] < 20);
    CHECK(skies.lengths[3] > skies.lengths[0]);  // a line is smoother than a sine
    CHECK(skies.margin > 0.5);
    CHECK(skies.margin < 6);
    const Coverage found = coverage(skies, drawn_third(skies, 3));
    CHECK(found.radiance.predictions == 60);  // 20 scenes: sky, near and far geometry
    CHECK(found.bare.predictions == 20 * detail::bare_distances_km.size());
    CHECK(found.bare.below_bound >= 0.9);
    CHECK(found.light.predictions == 20);
    CHECK(found.radiance.below_bound >= 0.9);
    CHECK(found.radiance.median_excess < 1.5);
    CHECK(found.radiance.median_off < 0.1);
}

TEST_CASE("fit: choices that leave the air before geometry out where it matters count as broken") {
    MeasuredSkies skies = invented(60);
    skies.settings[0].by_air[0].air_mib = 1;
    for (detail::MeasuredScene& scene : skies.scenes) {
        scene.altitude_m = 2;
        scene.situation[detail::axis_of_altitude] = 2.0 / 8000;
    }
    const std::vector<std::size_t> held_out = drawn_third(skies, 3);
    const Coverage right = coverage(skies, held_out);
    REQUIRE(right.choices > 50);
    CHECK(right.choices_kept >= 0.9);
    for (MeasuredError& bare : skies.bare)
        for (const std::size_t scene : held_out) bare.by_scene[scene] = MeasuredError::pack(1e3);  // foretold to be little
    const Coverage wrong = coverage(skies, held_out);
    CHECK(wrong.choices == right.choices);
    CHECK(wrong.choices_kept < right.choices_kept - 0.2);  // geometry is near in three of five, and left bare in most of these
}

TEST_CASE("fit: a third is drawn by seed and name alone") {
    MeasuredSkies skies = invented(60);
    const std::vector<std::size_t> first = drawn_third(skies, 1);
    CHECK(first.size() == 20);
    CHECK(std::ranges::is_sorted(first));
    CHECK(std::ranges::adjacent_find(first) == first.end());
    CHECK(first == drawn_third(skies, 1));
    CHECK(first != drawn_third(skies, 2));
}

TEST_CASE("fit: an air that is left out is foretold from the others, its costs by their work") {
    MeasuredSkies skies = invented(60);
    skies.airs = {"thin", "thick"};
    for (std::size_t i = 0; i < skies.scenes.size(); ++i) skies.scenes[i].air = i % 2;
    detail::MeasuredCost thin, thick;
    thin.air_mib = thick.air_mib = 1;
    thin.composite_ms = 10;
    thick.composite_ms = 40;
    thick.work.composite = 4;
    thin.rebuild_ms = 5;
    thick.rebuild_ms = 100;
    thick.work.rebuild = 10;  // so half of it is foretold
    skies.settings[0].by_air = {thin, thick};
    const std::vector<AirLeftOut> found = without_each_air(skies);
    REQUIRE(found.size() == 2);
    CHECK(found[0].air == "thin");
    CHECK(found[1].air == "thick");
    for (const AirLeftOut& one : found) {
        CHECK(one.errors.radiance.predictions == 90);  // 30 scenes
        REQUIRE(one.costs.size() == 3);
        for (const ForetoldCost& cost : one.costs) {
            const bool rebuild = cost.what == "rebuild";
            CHECK(cost.off() == doctest::Approx(!rebuild ? 0 : one.air == "thin" ? 1 : -0.5).epsilon(1e-6).scale(1));
            CHECK(cost.within(cost_tolerance) == !rebuild);
        }
    }
    CHECK(ForetoldCost{"", "", "rebuild", 0.05, 0.03}.within(0.3));  // too little to tell
    CHECK_FALSE(ForetoldCost{"", "", "rebuild", 0.5, 0.03}.within(0.3));
    CHECK(without_each_air(invented(60)).empty());  // nothing is left to go by
}

namespace {

/// Thirds held out in turn, together.
void check_shipped(const MeasuredSkies& skies, double least_below) {
    REQUIRE(skies.scenes.size() >= 12);
    double predictions = 0, below = 0, excess = 0, choices = 0, kept = 0, of_light = 0, light_below = 0;
    double of_bare = 0, bare_below = 0, bare_excess = 0;
    constexpr std::uint32_t seeds = 6;
    for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
        const Coverage found = coverage(skies, drawn_third(skies, seed));
        MESSAGE("seed ", seed, ": ", found.radiance.predictions, " predictions, ", found.radiance.below_bound,
                " below their bound, which is ", found.radiance.median_excess, " times what was measured; of ", found.choices,
                " choices ", found.choices_kept, " keep");
        CHECK(found.radiance.below_bound >= least_below);
        predictions += static_cast<double>(found.radiance.predictions);
        below += found.radiance.below_bound * static_cast<double>(found.radiance.predictions);
        excess += found.radiance.median_excess / seeds;
        of_light += static_cast<double>(found.light.predictions);
        light_below += found.light.below_bound * static_cast<double>(found.light.predictions);
        of_bare += static_cast<double>(found.bare.predictions);
        bare_below += found.bare.below_bound * static_cast<double>(found.bare.predictions);
        bare_excess += found.bare.median_excess / seeds;
        choices += static_cast<double>(found.choices);
        kept += found.choices_kept * static_cast<double>(found.choices);
    }
    CHECK(below / predictions >= 0.95);
    CHECK(excess <= 2);
    CHECK(kept / choices >= 0.85);
    // One number a scene: how wide its bounds are is only told. What n scenes say of one more, not even the widest of them has
    // seen of more than n in n + 1.
    const double fitted_to = std::ceil(static_cast<double>(skies.scenes.size()) * 2 / 3);
    CHECK(light_below >= std::min(0.95, fitted_to / (fitted_to + 1)) * of_light);
    CHECK(bare_below >= 0.95 * of_bare);  // none in older tables
    if (of_bare >= 1000) CHECK(bare_excess <= 2);
}

/// What an air costs that was left out, as the others foretell it.
void check_costs_elsewhere(const MeasuredSkies& skies) {
    std::size_t known = 0;
    for (const AirLeftOut& left_out : without_each_air(skies)) {
        MESSAGE(left_out.air, ", left out at a distance of ", left_out.errors.distance, ": ",
                left_out.errors.radiance.below_bound, " of ", left_out.errors.radiance.predictions,
                " errors below their bound");
        for (const ForetoldCost& cost : left_out.costs) {
            INFO(cost.air, ", ", cost.setting, ": ", cost.what, " of ", cost.measured_ms, " ms foretold as ", cost.foretold_ms);
            CHECK(cost.within(cost_tolerance));
            ++known;
        }
    }
    CHECK(known > 20);
}

}  // namespace

TEST_CASE("fit: what an air costs that was left out is foretold within 30 %") {
    check_costs_elsewhere(detail::measured_in_rgb());
    check_costs_elsewhere(detail::measured_in_wavelengths());
}

TEST_CASE("fit: what the library ships covers scenes that it was not fitted to") {
    check_shipped(detail::measured_in_rgb(), 0.9);
    check_shipped(detail::measured_in_wavelengths(), 0.8);  // of twenty scenes, six are held out at a time
}
