#include "scene/write_scene.h"

#include "io/test_files.h"

#include <doctest/doctest.h>

using namespace aureole;
using namespace aureole::app;

namespace {

/// As it is read again, with what is no part of the file's meaning as it was.
Scene read_again(const Scene& scene) {
    Scene again = parse_scene(print_scene(scene), "again.toml");
    if (again.terrain && scene.terrain) again.terrain->height_map_key = scene.terrain->height_map_key;
    // A file states one of the two.
    if (scene.camera.clearance_m) again.camera.altitude_m = scene.camera.altitude_m;
    return again;
}

}  // namespace

TEST_CASE("write_scene: the scenes that come with the application are read back bit for bit") {
    int scenes = 0;
    for (const auto& file : std::filesystem::directory_iterator(AUREOLE_SCENES)) {
        if (file.path().extension() != ".toml") continue;
        CAPTURE(file.path().string());
        const Scene scene = read_scene(file.path());
        CHECK(read_again(scene) == scene);
        ++scenes;
    }
    CHECK(scenes >= 11);
}

TEST_CASE("write_scene: everything that a scene can hold") {
    const Scene scene = parse_scene(R"(
title = 'a "quoted" \ title'
size = [321, 123]
exposure = 0.1
exposure_stops = -1.7
tone_map = "none"
sun_disk = false
sun_lobe_g = 0.123456789
model = "hillaire"
quality = "low"
spectral = 7
aerial_perspective_distance_m = 12345.678
[atmosphere]
preset = "mars"
ground_albedo = [0.1, 0.2, 0.3]
[[atmosphere.term]]
name = "tent"
scattering_per_m = [1e-6, 2e-6, 3.3e-6]
absorption_scale = 0.5
profile = { kind = "tent", center_m = 1e4, half_width_m = 5e3 }
phase = { kind = "henyey_greenstein", g = 0.51 }
[[atmosphere.term]]
name = "table"
absorption_per_m = 1e-6
scattering_per_m = 1e-7
profile = { kind = "tabulated", altitude_m = [0, 333.3, 1000], density = [1, 0.7, 0] }
phase = { kind = "tabulated", angle_deg = [0, 0.1, 7.3, 33.3, 61.7, 89.99, 123.456, 180], value = [9, 8, 7, 6, 5, 4, 3, 2] }
[[sun]]
elevation_deg = 10.1
bearing_deg = -90.3
irradiance = [1, 2, 3]
angular_radius_deg = 1.5
limb_darkening = "none"
[[sun]]
irradiance = "sun"
[camera]
altitude_m = 1234.5
bearing_deg = 45.25
elevation_deg = -5.125
vertical_fov_deg = 40.5
projection = "panorama"
)",
                                    "t.toml");
    REQUIRE(scene.atmosphere.terms.size() == 4);
    CHECK(read_again(scene) == scene);
    for (const Projection projection : {Projection::fisheye, Projection::matrix}) {
        Scene other = scene;
        other.camera.projection = projection;
        CHECK(read_again(other) == other);
    }
    Scene droplets = parse_scene(
        "[[atmosphere.term]]\nname = \"fog\"\nscattering_per_m = 1e-3\n"
        "phase = { kind = \"henyey_greenstein_draine\", droplet_diameter_um = 10.7 }\n",
        "t.toml");
    CHECK(read_again(droplets) == droplets);
    // That equality tells.
    droplets.atmosphere.terms.back().scattering_per_m.g *= 1 + 1e-15;
    CHECK_FALSE(read_again(droplets) == read_again(scene));
}

TEST_CASE("write_scene: a height map is named from the file's folder") {
    std::filesystem::create_directories("maps");
    std::filesystem::create_directories("saved/deep");
    put("hills.toml", "[terrain]\nheightmap = \"maps/hills.png\"\nspacing_m = 30\nalbedo = 0.25\ncamera_east_m = 10\n");
    const Scene scene = read_scene("hills.toml");
    write_scene("saved/deep/hills.toml", scene);
    const Scene again = read_scene("saved/deep/hills.toml");
    CHECK(weakly_canonical(again.terrain->height_map) == weakly_canonical(scene.terrain->height_map));
    CHECK(again.terrain->albedo == Rgb(0.25));
    CHECK(again.terrain->options == scene.terrain->options);
}

TEST_CASE("write_scene: what no file can state") {
    Scene scene = parse_scene("", "t.toml");
    scene.atmosphere.terms.push_back(scene.atmosphere.terms.front());
    CHECK(contains(complaint([&] { (void)print_scene(scene); }), "\"rayleigh\" twice is not allowed"));
    CHECK(complaint([&] { write_scene("no/such/folder.toml", parse_scene("", "t.toml")); }) != "nothing");
}
