// What a picture is made of, as scene files state it (docs/scenes.md).
#pragma once

#include <aureole/atmosphere.h>
#include <aureole/camera.h>
#include <aureole/model.h>
#include <aureole/parameters.h>

#include "io/height_map.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aureole::app {

/// World axes of every scene: the camera stands on the +z axis; +x is north, +y is west.
struct ScenePose {
    double bearing_deg = 0;    ///< Clockwise from north, seen from above.
    double elevation_deg = 0;  ///< Above the horizontal, in [-90, 90].
    [[nodiscard]] bool operator==(const ScenePose&) const = default;
};
/// Unit vector of a pose.
[[nodiscard]] glm::dvec3 direction_of(const ScenePose& pose);

struct SceneSun {
    ScenePose pose;
    std::optional<Rgb> irradiance = Rgb(1);  ///< None: of the real sun's colour (suns_of).
    double angular_radius_deg = 0.2678;
    LimbDarkening limb_darkening = LimbDarkening::neckel94;
    [[nodiscard]] bool operator==(const SceneSun&) const = default;
};

struct SceneCamera {
    double altitude_m = 2;              ///< Above the planet's ground radius.
    std::optional<double> clearance_m;  ///< Instead: above the terrain.
    ScenePose pose;
    double vertical_fov_deg = 60;
    Projection projection = Projection::matrix;
    [[nodiscard]] bool operator==(const SceneCamera&) const = default;
};

struct SceneTerrain {
    std::filesystem::path height_map;  ///< Or "jacksboro".
    std::string height_map_key;        ///< Where the scene names it, for messages: "hills.toml:12: terrain.heightmap".
    HeightMapOptions options;
    double vertical_exaggeration = 1;
    double camera_east_m = 0, camera_north_m = 0;  ///< Of the camera, from the middle of the map.
    double range_m = 250e3;                        ///< How far from the camera terrain is looked for.
    double air_shadows_m = 0;                      ///< How far from the camera the land shadows the air; 0: not at all.
    std::uint32_t air_shadow_samples = ShadowSettings{}.samples;
    std::optional<Rgb> albedo;  ///< None: fields, forest and rock by slope and altitude.
    [[nodiscard]] bool operator==(const SceneTerrain&) const = default;
};

struct SceneExposure {
    std::optional<double> factor;  ///< Multiplies radiance. None: automatic.
    double stops = 0;              ///< Added to either, in powers of two.
    [[nodiscard]] bool operator==(const SceneExposure&) const = default;
};

/// Which model makes the sky, and how finely.
struct SceneModel {
    std::string name = "aureole";     ///< One of model_names().
    std::string quality = "default";  ///< One of quality_names().
    std::string spectral = "rgb";     ///< "rgb", or a number of wavelengths as models::wavelengths_by_name takes it.

    [[nodiscard]] bool in_rgb() const { return spectral == "rgb"; }
    /// Throws Error(invalid_argument) for a name that there is not, and for a number of wavelengths out of range.
    [[nodiscard]] ModelPtr make() const;
    /// That model in these colours: as it is, or in the wavelengths. Throws Error(invalid_argument) for their number.
    [[nodiscard]] ModelPtr in_its_colours(ModelPtr model) const;
    /// "model aureole, quality default", and ", 4 wavelengths" where it is not in RGB.
    [[nodiscard]] std::string describe() const;
    [[nodiscard]] bool operator==(const SceneModel&) const = default;
};

struct Scene {
    std::string title;
    AtmosphereParameters atmosphere;
    std::vector<SceneSun> suns;
    SceneCamera camera;
    SceneExposure exposure;
    ToneMap tone_map = ToneMap::aces_fitted;  ///< Of pictures of eight bits.
    bool sun_disk = true;
    double sun_lobe_g = 0;  ///< CompositeSettings::sun_lobe_g
    SceneModel model;
    double aerial_perspective_distance_m = 96000;
    std::uint32_t width = 1280, height = 720;
    std::optional<SceneTerrain> terrain;
    [[nodiscard]] bool operator==(const Scene&) const = default;
};

class Section;
/// "rgb" or a number of wavelengths, in [3, 42]; none if there is no such key. Throws as Section's functions do.
[[nodiscard]] std::optional<std::string> read_spectral(Section& section, std::string_view key);

/// Reads a scene file. A height map is named relative to the file's folder; it is not opened here. Throws Error: io,
/// invalid_argument with file, line, key, value and allowed range; also for keys that do not exist.
[[nodiscard]] Scene read_scene(const std::filesystem::path& path);
/// The same for a text; `name` stands for the file in messages.
[[nodiscard]] Scene parse_scene(std::string_view text, const std::string& name);

/// The suns as the library takes them. The real sun's colour depends on what red, green and blue stand for: three wavelengths,
/// or with SceneModel::spectral the primaries of Rec.709; its luminance is that of 0.93 times white either way.
[[nodiscard]] std::vector<Sun> suns_of(const Scene& scene);
/// The camera as the library takes it, `altitude_m` above the ground radius, for a picture of the given shape.
[[nodiscard]] Camera camera_of(const Scene& scene, double altitude_m, std::uint32_t width, std::uint32_t height);

}  // namespace aureole::app
