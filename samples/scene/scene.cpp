#include "scene/scene.h"

#include "scene/scene_atmosphere.h"
#include "scene/section.h"

#include <aureole/models/spectral.h>

#include <array>
#include <cmath>
#include <numbers>

namespace aureole::app {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr Range bearing{-360, 360}, elevation{-90, 90};

SceneSun read_sun(Section section) {
    SceneSun sun;
    sun.pose.elevation_deg = section.number("elevation_deg", elevation).value_or(30);
    sun.pose.bearing_deg = section.number("bearing_deg", bearing).value_or(0);
    if (section.is_text("irradiance")) {
        (void)section.choice("irradiance", {"sun"});
        sun.irradiance.reset();
    } else if (const auto irradiance = section.rgb("irradiance", {0, 1e9})) {
        sun.irradiance = *irradiance;
    }
    sun.angular_radius_deg = section.number("angular_radius_deg", {0, 45}).value_or(sun.angular_radius_deg);
    const auto limb = section.choice("limb_darkening", {"none", "neckel94"});
    sun.limb_darkening = limb == std::size_t{0} ? LimbDarkening::none : LimbDarkening::neckel94;
    section.finish();
    return sun;
}

SceneCamera read_camera(Section section, double bottom_radius_m) {
    SceneCamera camera;
    camera.altitude_m = section.number("altitude_m", {-bottom_radius_m / 2, 1e12}).value_or(camera.altitude_m);
    camera.clearance_m = section.number("clearance_m", {0, 1e6});
    if (camera.clearance_m && section.has("altitude_m")) section.reject("clearance_m", "beside altitude_m", "one of the two");
    camera.pose.bearing_deg = section.number("bearing_deg", bearing).value_or(0);
    camera.pose.elevation_deg = section.number("elevation_deg", elevation).value_or(0);
    camera.vertical_fov_deg = section.number("vertical_fov_deg", {0.01, 170}).value_or(camera.vertical_fov_deg);
    switch (section.choice("projection", {"perspective", "fisheye", "panorama"}).value_or(0)) {
        case 1:
            camera.projection = Projection::fisheye;
            break;
        case 2:
            camera.projection = Projection::panorama;
            break;
        default:
            break;
    }
    section.finish();
    return camera;
}

SceneTerrain read_terrain(Section section, const std::filesystem::path& folder) {
    SceneTerrain terrain;
    const std::optional<std::string> map = section.text("heightmap");
    if (!map) section.reject("heightmap", "nothing", "\"jacksboro\", or a file that ends in .npz, .png or .exr");
    terrain.height_map_key = section.where("heightmap");
    terrain.height_map = *map == "jacksboro" ? std::filesystem::path(*map) : folder / *map;
    terrain.options.spacing_m = section.number("spacing_m", {0.01, 1e6});
    terrain.options.meters_per_unit = section.number("meters_per_unit", {1e-6, 1e6}).value_or(1);
    terrain.options.offset_m = section.number("offset_m", {-1e5, 1e5}).value_or(0);
    terrain.vertical_exaggeration = section.number("vertical_exaggeration", {0.01, 100}).value_or(1);
    terrain.camera_east_m = section.number("camera_east_m", {-1e6, 1e6}).value_or(0);
    terrain.camera_north_m = section.number("camera_north_m", {-1e6, 1e6}).value_or(0);
    terrain.range_m = section.number("range_m", {100, 1e6}).value_or(terrain.range_m);
    terrain.air_shadows_m = section.number("air_shadows_m", {0, 1e6}).value_or(0);
    if (const auto samples = section.number("air_shadow_samples", {1, 64})) {
        if (*samples != std::floor(*samples))
            section.reject("air_shadow_samples", section.printed("air_shadow_samples"), "a whole number in [1, 64]");
        terrain.air_shadow_samples = static_cast<std::uint32_t>(*samples);
    }
    terrain.albedo = section.rgb("albedo", {0, 1});
    section.finish();
    return terrain;
}

/// In the order of ToneMap.
constexpr std::array<std::string_view, 2> tone_map_names{"none", "aces_fitted"};

void read_exposure(Section& root, SceneExposure& exposure) {
    exposure.stops = root.number("exposure_stops", {-30, 30}).value_or(0);
    if (root.is_text("exposure"))
        (void)root.choice("exposure", {"auto"});
    else
        exposure.factor = root.number("exposure", {1e-9, 1e12});
}

void read_size(Section& root, Scene& scene) {
    const auto size = root.numbers("size", {1, 16384});
    if (!size) return;
    if (size->size() != 2 || (*size)[0] != std::floor((*size)[0]) || (*size)[1] != std::floor((*size)[1]))
        root.reject("size", root.printed("size"), "[width, height], whole numbers in [1, 16384]");
    scene.width = static_cast<std::uint32_t>((*size)[0]);
    scene.height = static_cast<std::uint32_t>((*size)[1]);
}

Rgb colour_of_the_sun(const SceneModel& model) {
    const Rgb of_rgb(0.77, 0.97, 1.0);  // at 680, 550 and 440 nm (docs/radiometry.md)
    if (model.in_rgb()) return of_rgb;
    const Rgb colour = models::solar_rec709(models::wavelengths_by_name(model.spectral));
    return colour * (spectrum::xyz_from_rec709(of_rgb).y / spectrum::xyz_from_rec709(colour).y);
}

Scene read_root(Section root, const std::filesystem::path& folder) {
    Scene scene;
    scene.title = root.text("title").value_or("");
    read_size(root, scene);
    read_exposure(root, scene.exposure);
    if (const auto map = root.choice("tone_map", tone_map_names)) scene.tone_map = static_cast<ToneMap>(*map);
    scene.sun_disk = root.boolean("sun_disk").value_or(true);
    scene.sun_lobe_g = root.number("sun_lobe_g", {0, 0.9999}).value_or(0);
    if (const auto model = root.choice("model", model_names())) scene.model.name = model_names()[*model];
    if (const auto quality = root.choice("quality", quality_names())) scene.model.quality = quality_names()[*quality];
    scene.model.spectral = read_spectral(root, "spectral").value_or(scene.model.spectral);
    scene.aerial_perspective_distance_m =
        root.number("aerial_perspective_distance_m", {1, 1e9}).value_or(scene.aerial_perspective_distance_m);

    std::optional<Section> air = root.section("atmosphere");
    scene.atmosphere = air ? read_atmosphere(*air) : read_atmosphere(TomlDocument("", "").root());
    const std::vector<Section> suns = root.sections("sun");
    if (suns.size() > 4) root.reject("sun", std::to_string(suns.size()) + " suns", "at most 4");
    for (const Section& sun : suns) scene.suns.push_back(read_sun(sun));
    if (const auto camera = root.section("camera"))
        scene.camera = read_camera(*camera, scene.atmosphere.planet.bottom_radius_m);
    if (const auto terrain = root.section("terrain")) {
        scene.terrain = read_terrain(*terrain, folder);
        if (scene.camera.projection != Projection::matrix)
            root.reject("terrain", "a camera with projection fisheye or panorama", "perspective: the others have no depth");
    } else if (scene.camera.clearance_m) {
        root.reject("camera", "clearance_m without [terrain]", "altitude_m");
    }
    root.finish();
    return scene;
}

}  // namespace

glm::dvec3 direction_of(const ScenePose& pose) {
    const double b = pose.bearing_deg * degree, e = pose.elevation_deg * degree;
    return {std::cos(e) * std::cos(b), -std::cos(e) * std::sin(b), std::sin(e)};
}

std::optional<std::string> read_spectral(Section& section, std::string_view key) {
    const auto reject = [&] { section.reject(key, section.printed(key), "\"rgb\", or a whole number in [3, 42]"); };
    if (section.is_text(key)) {
        std::optional<std::string> text = section.text(key);
        if (text != "rgb") reject();
        return text;
    }
    const std::optional<double> count = section.number(key, {-1e300, 1e300});
    if (!count) return {};
    if (!(*count >= 3 && *count <= 42 && *count == std::floor(*count))) reject();
    return std::to_string(static_cast<int>(*count));
}

Scene read_scene(const std::filesystem::path& path) {
    const TomlDocument document(path);
    return read_root(document.root(), path.parent_path());
}

Scene parse_scene(std::string_view text, const std::string& name) {
    const TomlDocument document(text, name);
    return read_root(document.root(), {});
}

ModelPtr SceneModel::make() const { return in_its_colours(model_by_name(name, quality)); }

ModelPtr SceneModel::in_its_colours(ModelPtr model) const {
    return in_rgb() ? std::move(model) : models::spectral(model, {models::wavelengths_by_name(spectral)});
}

std::string SceneModel::describe() const {
    return "model " + name + ", quality " + quality + (in_rgb() ? "" : ", " + spectral + " wavelengths");
}

std::vector<Sun> suns_of(const Scene& scene) {
    std::vector<Sun> suns;
    for (const SceneSun& s : scene.suns) {
        Sun& sun = suns.emplace_back();
        sun.direction = direction_of(s.pose);
        sun.irradiance = s.irradiance ? *s.irradiance : colour_of_the_sun(scene.model);
        sun.angular_radius_rad = s.angular_radius_deg * degree;
        sun.limb_darkening = s.limb_darkening;
    }
    return suns;
}

Camera camera_of(const Scene& scene, double altitude_m, std::uint32_t width, std::uint32_t height) {
    const SceneCamera& c = scene.camera;
    Camera camera =
        look(scene.atmosphere.planet.bottom_radius_m, altitude_m, -c.pose.bearing_deg * degree, c.pose.elevation_deg * degree,
             c.vertical_fov_deg * degree, static_cast<double>(width) / static_cast<double>(height));
    camera.kind = c.projection;
    return camera;
}

}  // namespace aureole::app
