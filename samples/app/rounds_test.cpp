#include "app/rounds.h"

#include "app/frame.h"
#include "io/test_files.h"

#include <doctest/doctest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>
#include <cmath>
#include <sstream>

using namespace aureole;
using namespace aureole::app;

namespace {

Scene scene_of(const std::string& model, const std::string& more) {
    return parse_scene("size = [12, 10]\nsun_disk = false\nexposure = 10\nmodel = \"" + model + "\"\nquality = \"low\"\n" +
                           "[[sun]]\nelevation_deg = 40\nbearing_deg = 120\n" + more,
                       "t.toml");
}

FrameOptions options_of(const Scene& scene, bool linear) { return {scene.width, scene.height, linear, false, 1}; }

/// What the library shows of a scene in one composite of a model.
std::vector<float> composite_of(Backend& backend, const Scene& scene, const ModelPtr& model) {
    Atmosphere air(backend.device(), scene.atmosphere, model);
    View view(air, {.light = false}, {.target_format = rhi::Format::rgba32_float, .sun_disk = false});
    DeviceTextures textures(backend);
    CompositeTargets targets;
    targets.extent = {scene.width, scene.height, 1};
    targets.target =
        textures.create("picture", rhi::Format::rgba32_float, targets.extent, rhi::Usage::storage | rhi::Usage::copy_source);
    textures.make_ready(targets.target, rhi::State::storage_write);
    view.prepare_composite(targets);
    view.update(camera_of(scene, scene.camera.altitude_m, scene.width, scene.height), suns_of(scene));
    backend.run([&](rhi::CommandList& commands) {
        air.record(commands);
        view.record(commands);
        view.record_composite(commands, targets);
    });
    return textures.read_floats(targets.target, std::size_t{4} * scene.width * scene.height, rhi::State::storage_write);
}

/// Mean of the rows from `first` to before `last`, all channels.
template <class Value>
double mean(const std::vector<Value>& rgb, std::size_t row, std::size_t first, std::size_t last) {
    double sum = 0;
    for (std::size_t i = first * row; i < last * row; ++i) sum += rgb[i];
    return sum / static_cast<double>((last - first) * row);
}

constexpr const char* land_text =
    "[camera]\nclearance_m = 30\nelevation_deg = 0\n"
    "[terrain]\nheightmap = \"level.exr\"\nspacing_m = 100\nair_shadows_m = 5000\nalbedo = 0.3\n";

/// Level ground at 100 m.
void put_land() { write_exr("level.exr", {20, 20, std::vector<float>(3 * 20 * 20, 100)}); }

}  // namespace

TEST_CASE("rounds_of: paths of a pixel of the picture by quality, whatever its samples") {
    struct Case {
        const char* quality;
        std::uint32_t samples;
        int paths;  // of a pixel of the composite
    };
    for (const Case& c : {Case{"low", 1, 16},
                          {"low", 2, 4},
                          {"low", 4, 1},
                          {"default", 1, 64},
                          {"default", 2, 16},
                          {"default", 3, 8},
                          {"high", 2, 64}}) {
        CAPTURE(c.quality);
        CAPTURE(c.samples);
        const auto sky = rounds_of({"reference", c.quality, "rgb"}, 30, 20, c.samples, false);
        REQUIRE(sky);
        CHECK(sky->settings.film_width == 30 * c.samples);
        CHECK(sky->settings.film_height == 20 * c.samples);
        CHECK(sky->settings.paths_per_frame == 1);
        CHECK(sky->settings.max_paths == c.paths);
        CHECK(sky->count == static_cast<std::uint32_t>(c.paths));
        CHECK_FALSE(sky->averaged());
        const auto land = rounds_of({"reference", c.quality, "rgb"}, 30, 20, c.samples, true);
        REQUIRE(land);
        CHECK(land->settings.paths_per_frame <= 4);
        CHECK(land->settings.paths_per_frame * static_cast<int>(land->count) == c.paths);
        CHECK(land->averaged());
    }
    CHECK_FALSE(rounds_of({"aureole", "low", "rgb"}, 30, 20, 1, false));
}

TEST_CASE("the path tracer's rounds add up to the paths asked for") {
    const auto backend = open_backend({.name = "cpu"});
    Scene scene = scene_of("reference", "");
    models::ReferenceSettings settings;
    settings.paths_per_frame = 16;
    std::vector<float> others;
    for (const char* colours : {"4", "rgb"}) {
        CAPTURE(colours);
        scene.model.spectral = colours;
        FrameRenderer renderer(*backend, scene, nullptr, options_of(scene, true));
        CHECK(renderer.rounds() == 16);
        int rounds = 0;
        const Frame frame = renderer.render(suns_of(scene), 0, [&] { ++rounds; });
        CHECK(rounds == 16);
        const std::vector<float> at_once =
            composite_of(*backend, scene, scene.model.in_its_colours(models::reference(settings)));
        double apart = 0, from_others = 0;
        for (std::size_t i = 0; i < frame.linear.rgb.size(); ++i) {
            const float whole = at_once[i / 3 * 4 + i % 3];
            apart = std::max(apart, std::abs(double{frame.linear.rgb[i]} / whole - 1));
            if (!others.empty()) from_others = std::max(from_others, std::abs(double{others[i]} / whole - 1));
        }
        CHECK(apart < 1e-4);
        CHECK((others.empty() || from_others > 0.05));
        others = frame.linear.rgb;
    }
    FrameRenderer renderer(*backend, scene, nullptr, options_of(scene, true));
    // The light of the next sun does not begin with the last one's.
    Scene later = scene;
    later.suns[0].pose.elevation_deg = 5;
    const Frame next = renderer.render(suns_of(later), 1);
    const Frame alone = FrameRenderer(*backend, later, nullptr, options_of(later, true)).render(suns_of(later));
    CHECK(next.linear.rgb == alone.linear.rgb);
}

TEST_CASE("the path tracer with land: a mean of composites, shown as one is" * doctest::test_suite("long")) {
    put_land();
    const auto backend = open_backend({.name = "cpu"});
    const auto render = [&](const char* model, bool linear) {
        const Scene scene = scene_of(model, land_text);
        const Land land(scene, scene.terrain->height_map);
        FrameRenderer renderer(*backend, scene, &land, options_of(scene, linear));
        std::uint32_t rounds = 0;
        Frame frame = renderer.render(suns_of(scene), 0, [&] { ++rounds; });
        CHECK(rounds == (model == std::string("reference") ? 4 : 1));
        return frame;
    };
    // Sky above, land below; noise of 16 paths a pixel, 48 pixels each.
    const Frame linear = render("reference", true), known = render("aureole", true);
    const Frame display = render("reference", false), known_display = render("aureole", false);
    for (const std::size_t first : {std::size_t{0}, std::size_t{6}}) {
        CAPTURE(first);
        CHECK(mean(linear.linear.rgb, 36, first, first + 4) ==
              doctest::Approx(mean(known.linear.rgb, 36, first, first + 4)).scale(1e-300).epsilon(0.05));
        CHECK(std::abs(mean(display.display.rgb, 36, first, first + 4) -
                       mean(known_display.display.rgb, 36, first, first + 4)) < 4);
    }
}

TEST_CASE("a model without shadows in the air shows a scene that has them, and says so") {
    put_land();
    const auto backend = open_backend({.name = "cpu"});
    std::ostringstream said;
    const auto before = spdlog::default_logger();
    spdlog::set_default_logger(
        std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(said)));
    for (const char* model : {"fog", "aureole"}) {
        const Scene scene = scene_of(model, land_text);
        const Land land(scene, scene.terrain->height_map);
        CHECK(FrameRenderer(*backend, scene, &land, options_of(scene, false)).render(suns_of(scene)).display.width == 12);
    }
    spdlog::set_default_logger(before);
    CHECK(contains(said.str(), "[terrain] air_shadows_m: the model fog takes no shadows"));
    CHECK_FALSE(contains(said.str(), "the model aureole"));
}
