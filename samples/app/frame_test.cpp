#include "app/frame.h"

#include "app/probe.h"
#include "io/test_files.h"

#include <aureole/presets.h>

#include <doctest/doctest.h>
#include <png.h>
#include <cmath>
#include <numbers>

using namespace aureole;
using namespace aureole::app;

namespace {

Scene parse(const std::string& text) { return parse_scene("size = [48, 32]\nquality = \"low\"\n" + text, "t.toml"); }

FrameOptions options_of(const Scene& scene, bool linear) {
    FrameOptions options;
    options.width = scene.width;
    options.height = scene.height;
    options.linear = linear;
    return options;
}

Rgb pixel(const LinearImage& image, std::uint32_t x, std::uint32_t y) {
    const std::size_t i = 3 * (std::size_t{y} * image.width + x);
    return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

}  // namespace

TEST_CASE("downsample: averages of blocks") {
    const std::vector<float> linear{1, 2, 3, 1, 3, 2, 1, 1, 5, 2, 0, 1, 7, 2, 0, 1};
    const LinearImage average = downsample(std::span<const float>(linear), 2, 2, 2);
    CHECK(average.width == 1);
    CHECK(average.rgb == std::vector<float>{4, 2, 1});

    // 8 bits: sums that are whole stay what they are; others are rounded up and down so that the mean is kept.
    std::vector<std::uint8_t> display(4 * 16 * 16);
    for (std::size_t i = 0; i < display.size(); ++i)
        display[i] = i % 4 == 0 ? 200 : i % 4 == 1 ? (i / 4 % 2 == 0 ? 100 : 101) : 0;
    const DisplayImage image = downsample(std::span<const std::uint8_t>(display), 16, 16, 2);
    CHECK(image.width == 8);
    double green = 0;
    for (std::size_t i = 0; i < 64; ++i) {
        CHECK(image.rgb[3 * i] == 200);
        CHECK(image.rgb[3 * i + 2] == 0);
        green += image.rgb[3 * i + 1] / 64.0;
    }
    CHECK(green == doctest::Approx(100.5));
    // One sample: untouched.
    const DisplayImage same = downsample(std::span<const std::uint8_t>(display), 16, 16, 1);
    CHECK(same.rgb[0] == 200);
    CHECK(same.rgb[1] == 100);
    CHECK(same.rgb[4] == 101);
}

TEST_CASE("a picture's pixels are what a probe of their directions gives") {
    const Scene scene = parse(
        "sun_disk = false\n[[sun]]\nelevation_deg = 35\nbearing_deg = 40\nirradiance = 2\n[camera]\n"
        "altitude_m = 1500\nbearing_deg = 10\nelevation_deg = 5\nvertical_fov_deg = 70\n");
    const auto backend = open_backend({.name = "cpu"});
    const Frame frame = FrameRenderer(*backend, scene, nullptr, options_of(scene, true)).render(suns_of(scene));
    REQUIRE(frame.linear.rgb.size() == 3 * 48 * 32);

    const Camera camera = camera_of(scene, 1500, 48, 32);
    std::vector<ProbeRow> rows;
    const std::array<std::pair<std::uint32_t, std::uint32_t>, 4> places{{{3, 2}, {40, 5}, {20, 20}, {30, 30}}};
    for (const auto& [x, y] : places) {
        const glm::dvec3 view((2 * (x + 0.5) / 48 - 1) / camera.projection[0][0],
                              (1 - 2 * (y + 0.5) / 32) / camera.projection[1][1], -1);
        const glm::dvec3 d = glm::normalize(glm::transpose(glm::dmat3(camera.view)) * view);
        const glm::dvec3 s = direction_of(scene.suns[0].pose);
        const double degrees = 180 / std::numbers::pi;
        rows.push_back({55, 1.5, std::acos(d.z) * degrees, (std::atan2(d.y, d.x) - std::atan2(s.y, s.x)) * degrees});
    }
    const std::vector<Rgb> probed = probe(*backend, scene.atmosphere, scene.model.make(), rows);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Rgb shown = pixel(frame.linear, places[i].first, places[i].second);
        for (int c = 0; c < 3; ++c) {
            CAPTURE(i);
            CHECK(shown[c] == doctest::Approx(2 * probed[i][c]).scale(1e-300).epsilon(1e-3));
            CHECK(probed[i][c] > 0);
        }
    }
}

TEST_CASE("exposure, stops and automatic exposure") {
    const auto backend = open_backend({.name = "cpu"});
    const auto exposure = [&](const std::string& text) {
        const Scene scene = parse(text + "\n[[sun]]\nelevation_deg = 35\n");
        return FrameRenderer(*backend, scene, nullptr, options_of(scene, false)).render(suns_of(scene)).exposure;
    };
    CHECK(exposure("exposure = 3") == 3);
    CHECK(exposure("exposure = 3\nexposure_stops = 2") == 12);
    const double automatic = exposure("");
    CHECK(automatic > 1);
    CHECK(automatic < 100);
    CHECK(exposure("exposure_stops = -1") == doctest::Approx(automatic / 2));
}

TEST_CASE("exposure_of: what a picture of that shape is exposed with, by whichever program") {
    const auto backend = open_backend({.name = "cpu"});
    Scene scene = read_scene(std::filesystem::path(AUREOLE_SCENES) / "golden_hour.toml");
    scene.model.quality = "low";
    scene.exposure = {std::nullopt, 0.5};
    FrameOptions options;
    options.width = 320;
    options.height = 180;
    const double drawn = FrameRenderer(*backend, scene, nullptr, options).render(suns_of(scene)).exposure;
    CHECK(exposure_of(scene, 320, 180) == doctest::Approx(drawn).scale(1e-300).epsilon(1e-6));
    scene.exposure = {8, -1};
    CHECK(exposure_of(scene, 320, 180) == 4);
}

TEST_CASE("sizes: long pictures are metered like others, and a composite that is too large is named by its options") {
    const auto backend = open_backend({.name = "cpu"});
    const auto exposure = [&](std::uint32_t width, std::uint32_t height, std::uint32_t samples) {
        const Scene scene = parse("[[sun]]\nelevation_deg = 35\n[camera]\nvertical_fov_deg = 1\nelevation_deg = 40\n");
        FrameOptions options = options_of(scene, false);
        options.width = width;
        options.height = height;
        options.samples = samples;
        return FrameRenderer(*backend, scene, nullptr, options).render(suns_of(scene)).exposure;
    };
    const double square = exposure(4, 4, 1);
    CHECK(exposure(3, 2900, 1) == doctest::Approx(square).scale(1e-300).epsilon(0.01));  // the same degree of the same sky
    CHECK(exposure(999, 1, 1) > 0);
    CHECK(complaint([&] { (void)exposure(1000, 1, 1); }) ==
          "--size: 1000x1 is not allowed; allowed: one side less than 1000 times as long as the other");
    CHECK(complaint([&] { (void)exposure(16384, 20, 2); }) ==
          "--size 16384x20 with --samples 2: a composite of 32768x40 is not allowed; allowed: at most 16384 pixels a side on "
          "this device; fewer samples or a smaller size");
}

TEST_CASE("probe: altitudes and suns in any order, below the ground as on it") {
    const auto backend = open_backend({.name = "cpu"});
    const AtmosphereParameters earth = presets::earth();
    const ModelPtr low = model_by_name("aureole", "low");
    const std::vector<ProbeRow> rows{{30, 0, 20, 90}, {80, 10, 70, 45}, {30, 0, 60, 0}, {30, -0.01, 20, 90}, {30, 300, 20, 90}};
    const std::vector<Rgb> radiance = probe(*backend, earth, low, rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Rgb alone = probe(*backend, earth, low, {&rows[i], 1}).at(0);
        for (int c = 0; c < 3; ++c) CHECK(radiance[i][c] == alone[c]);
    }
    CHECK(radiance[0].b > 0.01);
    CHECK(radiance[3].b == radiance[0].b);
    CHECK(radiance[4] == Rgb(0));  // from space into space
    CHECK(probe(*backend, earth, low, {}).empty());
}

TEST_CASE("an absorber takes its colours out of the light: methane's air looks blue from above, and nothing gets brighter") {
    const auto backend = open_backend({.name = "cpu"});
    AtmosphereParameters air = read_scene(std::filesystem::path(AUREOLE_SCENES) / "methane.toml").atmosphere;
    const std::vector<ProbeRow> rows{{30, 300, 180, 0}, {60, 300, 150, 90}, {30, 0, 40, 90}};  // clouds below, and sky
    const std::vector<Rgb> with = probe(*backend, air, model_by_name("aureole", "low"), rows);
    REQUIRE(air.terms.at(1).name == "methane");
    air.terms.pop_back();
    const std::vector<Rgb> without = probe(*backend, air, model_by_name("aureole", "low"), rows);
    // Straight down: twice through the column, 27.7 km of the coefficient at the bottom, and the sun's way slanted.
    const double red = 7.1e-6 * 27.7e3 * (1 + 1 / std::cos(30 * std::numbers::pi / 180));
    CHECK(with[0].r / without[0].r == doctest::Approx(std::exp(-red)).scale(1e-300).epsilon(0.1));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Rgb kept = with[i] / without[i];
        CAPTURE(i);
        CHECK(kept.r < kept.g);
        CHECK(kept.g < kept.b);
        CHECK(kept.b <= 1);
    }
}

TEST_CASE("probe: what is rejected") {
    const auto backend = open_backend({.name = "cpu"});
    const auto rejected = [&](const ProbeRow& row) {
        const std::vector<ProbeRow> rows{{30, 0, 20, 90}, row};
        return complaint([&] { (void)probe(*backend, presets::earth(), model_by_name("aureole", "low"), rows); });
    };
    CHECK(rejected({181, 0, 0, 0}) == "row 2: sun_zenith_deg: 181 is not allowed; allowed: in [0, 180]");
    CHECK(contains(rejected({0, -11, 0, 0}), "row 2: altitude_km: -11"));
    CHECK(contains(rejected({0, 0, NAN, 0}), "row 2: view_zenith_deg: nan"));
    CHECK(contains(rejected({0, 0, 0, 400}), "row 2: azimuth_deg: 400"));
}

TEST_CASE("land: near ground hides the sky, and the air in front of far ground shines") {
    // Level land at 100 m in a 16-bit map, seen from 30 m above it; black, so that only the air in front of it is bright.
    const std::vector<std::uint16_t> heights(20 * 20, 1000);
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = image.height = 20;
    image.format = PNG_FORMAT_LINEAR_Y;
    REQUIRE(png_image_write_to_file(&image, "level.png", 0, heights.data(), 0, nullptr));
    Scene scene = parse(
        "[[sun]]\nelevation_deg = 40\nbearing_deg = 180\n[camera]\nclearance_m = 30\nelevation_deg = 0\n"
        "[terrain]\nheightmap = \"level.png\"\nspacing_m = 100\nmeters_per_unit = 0.1\nalbedo = 0\n");
    const Land land(scene, scene.terrain->height_map);
    CHECK(land.camera_altitude_m() == doctest::Approx(130));
    const auto backend = open_backend({.name = "cpu"});
    const Frame frame = FrameRenderer(*backend, scene, &land, options_of(scene, true)).render(suns_of(scene));
    const Rgb near_land = pixel(frame.linear, 24, 31), far_land = pixel(frame.linear, 24, 16), sky = pixel(frame.linear, 24, 0);
    CHECK(near_land.b > 0);
    CHECK(near_land.b < 0.05 * sky.b);    // 30 m / sin(29 degrees): 60 m of air
    CHECK(far_land.b > 3 * near_land.b);  // 30 m / sin(1 degree): 1.7 km

    // White land in the sun is brighter than black land by albedo / pi times its irradiance, about 0.6 + sky.
    scene.terrain->albedo = Rgb(1);
    const Land white(scene, scene.terrain->height_map);
    const Frame bright = FrameRenderer(*backend, scene, &white, options_of(scene, true)).render(suns_of(scene));
    CHECK(pixel(bright.linear, 24, 31).g == doctest::Approx(0.62 / std::numbers::pi).scale(1e-300).epsilon(0.2));

    scene.camera.clearance_m.reset();
    scene.camera.altitude_m = 99;
    CHECK(complaint([&] { Land(scene, scene.terrain->height_map); }) ==
          "camera.altitude_m: 99 is not allowed; allowed: at least 100, the height of the land there");
}
