#include "scene/scene.h"

#include "io/test_files.h"

#include <aureole/presets.h>
#include <aureole/spectrum.h>

#include <doctest/doctest.h>
#include <cmath>
#include <numbers>

using namespace aureole;
using namespace aureole::app;

namespace {

Scene parse(const std::string& text) { return parse_scene(text, "t.toml"); }
std::string rejected(const std::string& text) {
    return complaint([&] { (void)parse(text); });
}

}  // namespace

TEST_CASE("parse_scene: an empty file is Earth by night") {
    const Scene scene = parse("");
    CHECK(scene.suns.empty());
    CHECK(scene.atmosphere.planet.top_radius_m == presets::earth().planet.top_radius_m);
    CHECK(scene.atmosphere.terms.size() == presets::earth().terms.size());
    CHECK(scene.model.name == "aureole");
    CHECK(scene.model.quality == "default");
    CHECK(scene.width == 1280);
    CHECK_FALSE(scene.exposure.factor);
    CHECK_FALSE(scene.terrain);
}

TEST_CASE("parse_scene: everything that can be said") {
    const Scene scene = parse(R"(
title = "All"
size = [320, 200]
exposure = 12.5
exposure_stops = -1
tone_map = "none"
sun_disk = false
model = "aureole"
quality = "high"
spectral = 12
aerial_perspective_distance_m = 5e4
[[sun]]
elevation_deg = 10
bearing_deg = 90
irradiance = [1, 2, 3]
angular_radius_deg = 1
limb_darkening = "none"
[[sun]]
[camera]
clearance_m = 3
bearing_deg = 45
elevation_deg = -5
vertical_fov_deg = 40
projection = "perspective"
[terrain]
heightmap = "hills.exr"
spacing_m = 30
meters_per_unit = 2
offset_m = -10
vertical_exaggeration = 1.5
camera_east_m = 100
camera_north_m = -200
range_m = 1e5
albedo = [0.1, 0.2, 0.3]
)");
    CHECK(scene.title == "All");
    CHECK(scene.width == 320);
    CHECK(scene.height == 200);
    CHECK(scene.exposure.factor == 12.5);
    CHECK(scene.exposure.stops == -1);
    CHECK(scene.tone_map == ToneMap::none);
    CHECK_FALSE(scene.sun_disk);
    CHECK(scene.model.name == "aureole");
    CHECK(scene.model.quality == "high");
    CHECK(scene.model.spectral == "12");
    CHECK(scene.aerial_perspective_distance_m == 5e4);
    REQUIRE(scene.suns.size() == 2);
    const std::vector<Sun> suns = suns_of(scene);
    CHECK(suns[0].irradiance == Rgb(1, 2, 3));
    CHECK(suns[0].angular_radius_rad == doctest::Approx(std::numbers::pi / 180));
    CHECK(suns[0].limb_darkening == LimbDarkening::none);
    CHECK(suns[1].limb_darkening == LimbDarkening::neckel94);
    CHECK(scene.camera.clearance_m == 3);
    CHECK(scene.camera.vertical_fov_deg == 40);
    REQUIRE(scene.terrain);
    CHECK(scene.terrain->height_map == "hills.exr");
    CHECK(scene.terrain->options.spacing_m == 30);
    CHECK(scene.terrain->options.meters_per_unit == 2);
    CHECK(scene.terrain->options.offset_m == -10);
    CHECK(scene.terrain->vertical_exaggeration == 1.5);
    CHECK(scene.terrain->camera_east_m == 100);
    CHECK(scene.terrain->camera_north_m == -200);
    CHECK(scene.terrain->range_m == 1e5);
    CHECK(scene.terrain->albedo == Rgb(0.1, 0.2, 0.3));
}

TEST_CASE("bearings: clockwise from north, as the camera looks") {
    // +x is north and +y west, so east is -y.
    const glm::dvec3 east = direction_of({90, 0});
    CHECK(east.x == doctest::Approx(0));
    CHECK(east.y == doctest::Approx(-1));
    const Scene scene = parse("[camera]\nbearing_deg = 90\nelevation_deg = 20\n");
    const Camera camera = camera_of(scene, 5, 200, 100);
    const glm::dvec3 forward = -glm::dvec3(camera.view[0][2], camera.view[1][2], camera.view[2][2]);
    const glm::dvec3 expected = direction_of({90, 20});
    for (int i = 0; i < 3; ++i) CHECK(forward[i] == doctest::Approx(expected[i]).scale(1e-300).epsilon(1e-12));
    CHECK(camera.position_m.z == scene.atmosphere.planet.bottom_radius_m + 5);
    // A point to the right of a camera that looks east is south: -x.
    CHECK(camera.view[0][0] == doctest::Approx(-1));
}

TEST_CASE("parse_scene: atmospheres from presets and from nothing") {
    const AtmosphereParameters changed = parse(
                                             "[atmosphere]\npreset = \"mars\"\nground_albedo = 0.5\n"
                                             "[[atmosphere.term]]\nname = \"rayleigh\"\nscattering_per_m = 1e-6\n")
                                             .atmosphere;
    CHECK(changed.planet.bottom_radius_m == presets::mars().planet.bottom_radius_m);
    CHECK(changed.planet.ground_albedo == Rgb(0.5));
    REQUIRE(changed.terms.size() == presets::mars().terms.size());
    CHECK(changed.terms[0].scattering_per_m == Rgb(1e-6));
    CHECK(std::get<ExponentialProfile>(changed.terms[0].profile).scale_height_m == 11100);  // kept

    const AtmosphereParameters made = parse(R"(
[atmosphere]
preset = "none"
bottom_radius_m = 1e6
top_radius_m = 1.1e6
[[atmosphere.term]]
name = "a"
scattering_per_m = [1e-6, 2e-6, 3e-6]
absorption_per_m = 1e-7
profile = { kind = "tent", center_m = 1e4, half_width_m = 5e3 }
phase = { kind = "henyey_greenstein", g = 0.5 }
[[atmosphere.term]]
name = "b"
scattering_per_m = 1e-6
profile = { kind = "tabulated", altitude_m = [0, 1000], density = [1, 0] }
phase = { kind = "tabulated", angle_deg = [0, 180], value = [2, 1] }
[[atmosphere.term]]
name = "c"
scattering_per_m = 1e-6
phase = { kind = "henyey_greenstein_draine", g_hg = 0.1, g_draine = 0.2, alpha = 3, weight = 0.4 }
[[atmosphere.term]]
name = "d"
scattering_per_m = 1e-6
phase = { kind = "henyey_greenstein_draine", droplet_diameter_um = 10 }
)")
                                          .atmosphere;
    REQUIRE(made.terms.size() == 4);
    CHECK(made.planet.top_radius_m == 1.1e6);
    CHECK(made.terms[0].absorption_per_m == Rgb(1e-7));
    CHECK(std::get<TentProfile>(made.terms[0].profile).half_width_m == 5e3);
    CHECK(std::get<HenyeyGreensteinPhase>(made.terms[0].phase).g == 0.5);
    CHECK(std::get<TabulatedProfile>(made.terms[1].profile).altitude_m == std::vector<double>{0, 1000});
    CHECK(std::get<TabulatedPhase>(made.terms[1].phase).angle_rad[1] == doctest::Approx(std::numbers::pi));
    CHECK(std::get<HenyeyGreensteinDrainePhase>(made.terms[2].phase).alpha == 3);
    CHECK(std::get<HenyeyGreensteinDrainePhase>(made.terms[3].phase).g_hg ==
          HenyeyGreensteinDrainePhase::from_droplet_diameter(10).g_hg);
}

TEST_CASE("parse_scene: faults of the atmosphere point to their lines") {
    CHECK(contains(rejected("[atmosphere]\n\ntop_radius_m = 1"),
                   "t.toml:3: atmosphere.top_radius_m: 1 (top_radius_m) is not allowed"));
    CHECK(contains(rejected("[atmosphere]\nground_albedo = [0, 1.5, 0]"),
                   "t.toml:2: atmosphere.ground_albedo: 1.5 (ground_albedo.g)"));
    const std::string term = "[[atmosphere.term]]\nname = \"mie\"\n";
    CHECK(contains(rejected(term + "scattering_per_m = -1"), "t.toml:3: atmosphere.term[0].scattering_per_m: -1"));
    CHECK(
        contains(rejected(term + "phase = { kind = \"cornette_shanks\", g = 1 }"), "t.toml:3: atmosphere.term[0].phase.g: 1"));
    CHECK(contains(rejected(term + "profile = { kind = \"exponential\", scale_height_m = 0 }"),
                   "t.toml:3: atmosphere.term[0].profile.scale_height_m: 0"));
    CHECK(contains(rejected(term + "profile = { kind = \"tabulated\", altitude_m = [0, 1, 1], density = [1, 1, 1] }"),
                   "t.toml:3: atmosphere.term[0].profile.altitude_m: 1 (altitude_m[2])"));
    CHECK(contains(rejected(term + "profile = { kind = \"tabulated\" }"), "t.toml:3: atmosphere.term[0].profile"));
    CHECK(contains(rejected(term + "profile = { scale_height_m = 1 }"), "profile.kind: nothing is not allowed"));
    CHECK(contains(rejected(term + "phase = { kind = \"mie\" }"), "phase.kind: \"mie\" is not allowed; allowed: \"rayleigh\""));
    const auto tabulated = [&](const std::string& angles) {
        return rejected(term + "phase = { kind = \"tabulated\", value = [1, 1, 1], angle_deg = " + angles + " }");
    };
    CHECK(tabulated("[0, 90, 170]") ==
          "t.toml:3: atmosphere.term[0].phase.angle_deg: 170 as element 2 is not allowed; allowed: 180, the last angle");
    CHECK(contains(tabulated("[5, 90, 180]"), "phase.angle_deg: 5 as element 0 is not allowed; allowed: 0"));
    CHECK(contains(tabulated("[0, 90, 90, 180]"), "phase.angle_deg: 90 as element 2 is not allowed; allowed: greater than 90"));
    CHECK(
        contains(tabulated("[0, 90, 181]"), "phase.angle_deg: 181 as element 2 is not allowed; allowed: 180, the last angle"));
    CHECK(contains(tabulated("[0]"), "phase.angle_deg: 1 angles is not allowed; allowed: 2 to 4096"));
    CHECK(contains(tabulated("[0, 180]"), "phase.value: 3 entries"));
    CHECK(contains(rejected(term + "phase = { kind = \"rayleigh\", g = 0.5 }"),
                   "phase.g: this key is not allowed; allowed: kind"));
    CHECK(contains(rejected(term + "phase = { kind = \"henyey_greenstein_draine\", droplet_diameter_um = 4 }"),
                   "droplet_diameter_um: 4"));
    CHECK(contains(rejected("[[atmosphere.term]]\n"), "atmosphere.term[0].name: nothing is not allowed"));
    CHECK(contains(rejected("[atmosphere]\npreset = \"venus\""), "t.toml:2: atmosphere.preset: \"venus\""));
    CHECK(contains(rejected("[atmosphere]\nradius = 1"),
                   "t.toml:2: atmosphere.radius: this key is not allowed; allowed: bottom_radius_m"));
}

TEST_CASE("parse_scene: faults elsewhere") {
    CHECK(contains(rejected("colour = 1"), "t.toml:1: colour: this key is not allowed; allowed: "));
    CHECK(contains(rejected("size = [0, 100]"), "t.toml:1: size"));
    CHECK(contains(rejected("size = [100]"), "size: [100] is not allowed; allowed: [width, height]"));
    CHECK(contains(rejected("size = [640.5, 360]"), "size: [640.5, 360] is not allowed; allowed: [width, height], whole"));
    CHECK(contains(rejected("exposure = 0"), "t.toml:1: exposure: 0"));
    CHECK(contains(rejected("exposure = \"automatic\""), "allowed: \"auto\""));
    CHECK(contains(rejected("exposure_stops = 100"), "t.toml:1: exposure_stops: 100"));
    CHECK(contains(rejected("[terrain]\nheightmap = \"jacksboro\"\nair_shadow_samples = 2.5"),
                   "allowed: a whole number in [1, 64]"));
    CHECK(contains(rejected("tone_map = \"filmic\""),
                   "t.toml:1: tone_map: \"filmic\" is not allowed; allowed: \"none\", \"aces_fitted\""));
    CHECK(contains(rejected("quality = \"ultra\""), "allowed: \"low\", \"default\", \"high\""));
    CHECK(contains(rejected("model = \"preetham\""), "t.toml:1: model: \"preetham\" is not allowed; allowed: \""));
    CHECK(contains(rejected("model = 1"), "t.toml:1: model: 1 is not allowed; allowed: \""));
    for (const char* value : {"\"4\"", "2", "43", "4.5"})
        CHECK(contains(rejected(std::string("spectral = ") + value), "allowed: \"rgb\", or a whole number in [3, 42]"));
    CHECK(contains(rejected("[[sun]]\nirradiance = \"moon\""), "t.toml:2: sun[0].irradiance: \"moon\""));
    CHECK(contains(rejected("aerial_perspective_distance_m = 0"), "aerial_perspective_distance_m: 0"));
    CHECK(contains(rejected("[sun]\n"), "sun: a table is not allowed; allowed: an array of tables"));
    CHECK(
        contains(rejected("[[sun]]\n[[sun]]\n[[sun]]\n[[sun]]\n[[sun]]\n"), "sun: 5 suns is not allowed; allowed: at most 4"));
    CHECK(contains(rejected("[[sun]]\nelevation_deg = 91"), "t.toml:2: sun[0].elevation_deg: 91"));
    CHECK(contains(rejected("[[sun]]\nirradiance = -1"), "sun[0].irradiance: -1"));
    CHECK(contains(rejected("[[sun]]\nangular_radius_deg = 46"), "sun[0].angular_radius_deg: 46"));
    CHECK(contains(rejected("[camera]\naltitude_m = nan"), "t.toml:2: camera.altitude_m: nan"));
    CHECK(contains(rejected("[camera]\nvertical_fov_deg = 180"), "camera.vertical_fov_deg: 180"));
    CHECK(contains(rejected("[camera]\nclearance_m = 1"), "clearance_m without [terrain]"));
    CHECK(contains(rejected("[camera]\nclearance_m = 1\naltitude_m = 1"), "camera.clearance_m: beside altitude_m"));
    CHECK(contains(rejected("[terrain]\n"), "terrain.heightmap: nothing is not allowed"));
    CHECK(contains(rejected("[terrain]\nheightmap = \"jacksboro\"\n[camera]\nprojection = \"fisheye\""),
                   "the others have no depth"));
}

TEST_CASE("read_scene: the height map is named from the scene's folder") {
    std::filesystem::create_directory("scenes");
    put("scenes/hills.toml", "[terrain]\nheightmap = \"maps/hills.png\"\n");
    CHECK(read_scene("scenes/hills.toml").terrain->height_map == "scenes/maps/hills.png");
    put("scenes/sample.toml", "[terrain]\nheightmap = \"jacksboro\"\n");
    CHECK(read_scene("scenes/sample.toml").terrain->height_map == "jacksboro");
    CHECK(complaint([] { (void)read_scene("scenes/none.toml"); }) == "scenes/none.toml: there is no such file");
}

TEST_CASE("the scenes that come with the application") {
    const std::filesystem::path folder = AUREOLE_SCENES;
    for (const char* name : {"noon", "golden_hour", "twilight", "altitude_10km", "low_orbit", "mars", "methane", "terrain_near",
                             "terrain_far", "terrain_shafts", "moonlight"}) {
        CAPTURE(name);
        CHECK(complaint([&] { (void)read_scene(folder / (std::string(name) + ".toml")); }) == "nothing");
    }
    CHECK(read_scene(folder / "twilight.toml").suns.at(0).pose.elevation_deg == -4);
    const DensityTerm methane = read_scene(folder / "methane.toml").atmosphere.terms.at(1);
    CHECK(methane.scattering_per_m == Rgb(0));
    CHECK(methane.absorption_per_m.r > methane.absorption_per_m.g);
    CHECK(methane.absorption_per_m.g > methane.absorption_per_m.b);
}

TEST_CASE("the scenes of the truth tables hold the tables' parameters") {
    // Numbers as in the tables' comment lines, there per kilometre.
    const auto check = [](const char* name, double bottom_km, double top_km, double albedo, Rgb rayleigh, double rayleigh_km,
                          Rgb aerosol, Rgb aerosol_absorption, double aerosol_km, double g, Rgb absorber) {
        CAPTURE(name);
        const AtmosphereParameters air = read_scene(std::filesystem::path(AUREOLE_SCENES) / name).atmosphere;
        CHECK(air.planet.bottom_radius_m == bottom_km * 1000);
        CHECK(air.planet.top_radius_m == top_km * 1000);
        CHECK(air.planet.ground_albedo == Rgb(albedo));
        const auto same = [](const Rgb& per_m, const Rgb& per_km) {
            for (int c = 0; c < 3; ++c) CHECK(per_m[c] * 1000 == doctest::Approx(per_km[c]).scale(1e-300).epsilon(1e-12));
        };
        REQUIRE(air.terms.size() >= 2);
        same(air.terms[0].scattering_per_m, rayleigh);
        same(air.terms[0].absorption_per_m, Rgb(0));
        CHECK(std::get<ExponentialProfile>(air.terms[0].profile).scale_height_m == doctest::Approx(rayleigh_km * 1000));
        CHECK(std::holds_alternative<RayleighPhase>(air.terms[0].phase));
        same(air.terms[1].scattering_per_m, aerosol);
        same(air.terms[1].absorption_per_m, aerosol_absorption);
        CHECK(std::get<ExponentialProfile>(air.terms[1].profile).scale_height_m == doctest::Approx(aerosol_km * 1000));
        CHECK(std::get<CornetteShanksPhase>(air.terms[1].phase).g == g);
        REQUIRE(air.terms.size() == (absorber == Rgb(0) ? 2 : 3));
        if (absorber == Rgb(0)) return;
        same(air.terms[2].absorption_per_m, absorber);
        CHECK(air.terms[2].scattering_per_m == Rgb(0));
        CHECK(std::get<TentProfile>(air.terms[2].profile).center_m == 25e3);
        CHECK(std::get<TentProfile>(air.terms[2].profile).half_width_m == 15e3);
    };
    const Rgb air(0.005802, 0.013558, 0.0331), ozone(0.00065, 0.001881, 8.5e-05);
    check("truth_earth.toml", 6360, 6460, 0.3, air, 8, Rgb(0.003996), Rgb(0.000444), 1.2, 0.8, ozone);
    check("truth_hazy.toml", 6360, 6460, 0.1, air, 8, Rgb(0.03996), Rgb(0.00444), 1.2, 0.76, ozone);
    check("truth_mars.toml", 3389.5, 3509.5, 0.25, Rgb(0.019918, 0.01357, 0.00575), 11.1, Rgb(0.00966),
          Rgb(0.0005, 0.0013, 0.0038), 11.1, 0.76, Rgb(0));
}

TEST_CASE("scene: the sun's own colour is that of the channels") {
    Scene scene = parse_scene("[[sun]]\nirradiance = \"sun\"", "t.toml");
    CHECK(suns_of(scene)[0].irradiance == Rgb(0.77, 0.97, 1));
    CHECK(scene.model.describe() == "model aureole, quality default");
    const double luminance = spectrum::xyz_from_rec709(suns_of(scene)[0].irradiance).y;
    scene.model.spectral = "40";
    const Rgb of_forty = suns_of(scene)[0].irradiance;
    CHECK(of_forty.r > of_forty.g);  // a sun of 5800 K is redder than white of 6500 K
    CHECK(of_forty.g > of_forty.b);
    CHECK(spectrum::xyz_from_rec709(of_forty).y == doctest::Approx(luminance));
    CHECK(scene.model.describe() == "model aureole, quality default, 40 wavelengths");
    for (const std::string_view name : model_names()) {
        scene.model.name = name;
        CHECK(scene.model.make()->name() == name);
    }
}
