#include "viewer/core/studio.h"

#include "viewer/core/fields.h"

#include "io/test_files.h"

#include <doctest/doctest.h>
#include <algorithm>
#include <chrono>
#include <cmath>

using namespace aureole;
using namespace aureole::viewer;

namespace {

constexpr std::uint32_t width = 48, height = 32;

State small(const std::string& text) {
    return state_of(app::parse_scene("model = \"single\"\nquality = \"low\"\n" + text, "t.toml"), "cpu");
}

/// What the application makes of the same scene.
app::DisplayImage rendered(const State& state, int pane) {
    app::Scene scene = state.scene;
    scene.model = state.panes[static_cast<std::size_t>(pane)].model;
    scene.width = width;
    scene.height = height;
    const auto backend = app::open_backend({.name = state.panes[static_cast<std::size_t>(pane)].backend});
    std::unique_ptr<app::Land> land;
    if (scene.terrain) land = std::make_unique<app::Land>(scene, scene.terrain->height_map);
    app::FrameOptions options;
    options.width = width;
    options.height = height;
    return app::FrameRenderer(*backend, scene, land.get(), options).render(app::suns_of(scene)).display;
}

}  // namespace

TEST_CASE("difference: by luminance, by A, and in false colour") {
    const app::LinearImage a{2, 2, {1, 1, 1, 2, 2, 2, 1, 1, 1, 0, 0, 0}};
    app::LinearImage b = a;
    Difference none = difference(a, b);
    CHECK(none.greatest == 0);
    CHECK(false_colours(none, 0.1).rgb == std::vector<std::uint8_t>(12, 0));
    b.rgb[3] = b.rgb[4] = b.rgb[5] = 3;     // half as bright again
    b.rgb[6] = b.rgb[7] = b.rgb[8] = 0.9F;  // a tenth darker
    const Difference some = difference(a, b);
    CHECK(some.relative[0] == 0);
    CHECK(some.relative[1] == doctest::Approx(0.5));
    CHECK(some.relative[2] == doctest::Approx(-0.1));
    CHECK(some.relative[3] == 0);
    CHECK(some.greatest == doctest::Approx(0.5));
    CHECK(false_colour(0.5, 0.5) == std::array<std::uint8_t, 3>{255, 255, 255});
    CHECK(false_colour(7, 0.5) == std::array<std::uint8_t, 3>{255, 255, 255});
    const auto brighter = false_colour(0.01, 0.5), darker = false_colour(-0.01, 0.5);
    CHECK(brighter[0] > 0);
    CHECK(brighter[2] == 0);
    CHECK(darker[2] == brighter[0]);
    CHECK(darker[0] == 0);
    CHECK_THROWS_AS((void)difference(a, app::LinearImage{1, 1, {0, 0, 0}}), Error);
}

TEST_CASE("split: A, a line, B") {
    const app::DisplayImage a{4, 1, std::vector<std::uint8_t>(12, 10)}, b{4, 1, std::vector<std::uint8_t>(12, 20)};
    const std::vector<std::uint8_t> expected{10, 10, 10, 10, 10, 10, 255, 255, 255, 20, 20, 20};
    CHECK(split(a, b, 0.5).rgb == expected);
    CHECK(split(a, b, 0).rgb == b.rgb);
    CHECK(split(a, b, 1).rgb == a.rgb);
}

TEST_CASE("studio: a pane is what the application renders, after any number of changes") {
    Studio studio;
    State state = small("[[sun]]\nelevation_deg = 12\nbearing_deg = 20\n[camera]\naltitude_m = 300\nelevation_deg = 10\n");
    const auto same = [&] {
        const Shown shown = studio.draw(state, width, height, 1);
        CHECK(shown.problem.empty());
        REQUIRE(shown.panes[0]);
        CHECK(shown.panes[0]->display.rgb == rendered(state, 0).rgb);
        CHECK(shown.panes[0]->exposure > 0);
    };
    same();
    state.scene.suns[0].pose = {-30, 2};  // follows
    same();
    state.scene.camera.altitude_m = 30e3;
    set_field(state, "term.mie.scattering_per_m.g", "2e-5");
    same();
    set_field(state, "suns", "2");  // another renderer
    set_field(state, "camera.projection", "fisheye");
    same();
    state.panes[0].model.name = "fog";
    same();
}

TEST_CASE("studio: over land the camera flies and is what the application renders there" * doctest::test_suite("long")) {
    Studio studio;
    State state = small(
        "[[sun]]\nelevation_deg = 30\nbearing_deg = 200\n[camera]\nclearance_m = 300\nbearing_deg = 225\nelevation_deg = "
        "-8\n[terrain]\nheightmap = \"jacksboro\"\n");
    state.panes[0].model.name = "fog";
    (void)studio.draw(state, width, height, 1);
    state.scene.terrain->camera_east_m += 2000;
    state.scene.suns[0].pose.elevation_deg = 20;
    const Shown shown = studio.draw(state, width, height, 2);
    REQUIRE(shown.panes[0]);
    CHECK(shown.panes[0]->display.rgb == rendered(state, 0).rgb);
    CHECK(shown.panes[0]->altitude_m == doctest::Approx(shown.panes[0]->ground_m + 300));
    // Inside the land: told, and the next picture is there again.
    set_field(state, "camera.altitude_m", "0");
    CHECK(app::contains(studio.draw(state, width, height, 3).problem, "camera.altitude_m: 0 is not allowed"));
    set_field(state, "camera.altitude_m", "3000");
    CHECK(studio.draw(state, width, height, 4).problem.empty());
}

TEST_CASE(
    "studio: two panes differ by nothing where they are the same, by rounding on another backend, by more by other models") {
    Studio studio;
    State state = small("[[sun]]\nelevation_deg = 12\n[camera]\nelevation_deg = 10\n");
    state.layout = Layout::difference;
    const auto apart = [&] {
        const Shown shown = studio.draw(state, width, height, 1);
        CHECK(shown.problem.empty());
        REQUIRE(shown.panes[1]);
        CHECK(shown.panes[1]->exposure == shown.panes[0]->exposure);
        const app::DisplayImage picture = picture_of(shown, state);
        Difference d = difference(shown.panes[0]->linear, shown.panes[1]->linear);
        CHECK(picture.rgb == false_colours(d, state.difference_range).rgb);
        return d;
    };
    CHECK(apart().greatest == 0);
    state.panes[1].backend = "cpu-double";
    const Difference rounded = apart();
    CHECK(rounded.greatest > 0);
    CHECK(rounded.p95 < 1e-3);  // float against double (docs/precision.md)
    state.panes[1].backend = "cpu";
    state.panes[1].model.name = "fog";
    CHECK(apart().median > 0.02);
}

TEST_CASE("studio: passes, counts, tables and curves of a picture") {
    Studio studio;
    State state = small("[[sun]]\nelevation_deg = 12\n");
    state.panes[0].model.name = "aureole";
    set_field(state, "view.table", "true");
    set_field(state, "view.curves", "true");
    set_field(state, "view.table_name", "sky_view");
    const Shown shown = studio.draw(state, width, height, 1);
    REQUIRE(shown.panes[0]);
    const PanePicture& pane = *shown.panes[0];
    const auto pass = [&](const std::string& name) -> const PassFigure& {
        return *std::ranges::find(pane.passes, name, &PassFigure::name);
    };
    CHECK(pass("sky_view").milliseconds > 0);
    CHECK(pass("composite").invocations == width * height);
    CHECK(pass("composite").bytes_written == width * height * 4);
    CHECK(std::ranges::any_of(pane.work, [](const cpu::PipelineWork& w) { return w.counts.evaluations > 0; }));
    CHECK(pane.table_bytes > 0);
    CHECK(std::ranges::find(pane.table_names, "transmittance") != pane.table_names.end());
    CHECK(std::ranges::find(pane.table_names, "aerial_perspective") == pane.table_names.end());  // there is no land
    REQUIRE(pane.table);
    CHECK(pane.table->name == "sky_view");
    CHECK(pane.table->greatest > 0);
    CHECK(pane.table->rgba.size() == std::size_t{4} * pane.table->width * pane.table->height);
    CHECK(app::complaint([&] { (void)pane.table->texel(pane.table->width, 0); }) != "nothing");

    REQUIRE(pane.curves);
    const Curves& curves = *pane.curves;
    CHECK(curves.extinction_per_m.front().b == doctest::Approx(sample_medium(state.scene.atmosphere, 0).extinction_per_m.b));
    // At the zenith: a column straight up; a set sun has none.
    const Rgb depth = vertical_optical_depth(state.scene.atmosphere);
    for (int c = 0; c < 3; ++c)
        CHECK(curves.transmittance.back()[c] == doctest::Approx(std::exp(-depth[c])).scale(1e-300).epsilon(5e-3));
    CHECK(curves.transmittance.front() == Rgb(0));

    // Nothing has changed: no table is made again.
    const Shown again = studio.draw(state, width, height, 2);
    REQUIRE(again.panes[0]);
    for (const PassFigure& figure : again.panes[0]->passes)
        if (figure.name == "sky_view" || figure.name == "transmittance") CHECK_FALSE(figure.recorded);
}

TEST_CASE("studio: the planner's choice for a tolerance") {
    Studio studio;
    State state = small("[[sun]]\nelevation_deg = 40\n");
    set_field(state, "a.planned", "true");
    set_field(state, "a.tolerance", "10");  // what costs least
    const Shown shown = studio.draw(state, width, height, 1);
    CHECK(shown.problem.empty());
    REQUIRE(shown.panes[0]);
    CHECK(shown.panes[0]->model.starts_with("plan: "));
    CHECK(shown.panes[0]->plan.size() > 100);
    CHECK(shown.panes[0]->display.width == width);
}

TEST_CASE("worker: the newest state is what is shown in the end") {
    Worker worker;
    State state = small("[[sun]]\nelevation_deg = 12\n");
    std::uint64_t last = 0;
    for (int i = 0; i < 20; ++i) {
        state.scene.suns[0].pose.elevation_deg = i;
        last = worker.submit(state, width, height);
    }
    std::optional<Shown> shown;
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!worker.idle() && std::chrono::steady_clock::now() < give_up) {
        if (auto taken = worker.take()) shown = std::move(taken);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    REQUIRE(shown);
    CHECK(shown->number == last);
    REQUIRE(shown->panes[0]);
    CHECK(shown->panes[0]->display.rgb == rendered(state, 0).rgb);
    // Paths are given up for something newer.
    state.panes[0].model = {"reference", "high", "rgb"};
    (void)worker.submit(state, 160, 120);
}
