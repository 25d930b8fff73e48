// What `aureole measure` runs: scenes, and the settings of models to compare in them, as suite files state it
// (docs/measure.md).
#pragma once

#include <aureole/setting.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace aureole::app {

/// An atmosphere, and in which colours its truth is found.
struct SuiteAir {
    std::string name;  ///< Letters, digits, - and _: it names files.
    AtmosphereParameters parameters;
    std::string spectral = "rgb";  ///< Of the truth: "rgb", or a number of wavelengths.
    // As the suite says, where the air does not say otherwise.
    double truth_error = 0.003;        ///< Wanted standard error of each channel of the truth, relative. In [1e-4, 0.1].
    double truth_max_paths = 1 << 20;  ///< Of a direction (in wavelengths: for each three of them). In [4096, 1e12].
};

/// An air, a sun, a place.
struct SuiteScene {
    std::string scene_class;  ///< What reports gather: "Earth by day".
    std::size_t air = 0;      ///< Index of Suite::airs.
    double sun_elevation_deg = 0;
    double altitude_m = 0;
    bool aerial = false;                          ///< Also geometry, through the air.
    bool picture = false;                         ///< Also a picture of all that is around.
    double truth_error = 0, truth_max_paths = 0;  ///< Of the sky's directions: as the scenes say, else as the air.

    [[nodiscard]] double sun_zenith_deg() const { return 90 - sun_elevation_deg; }
    [[nodiscard]] double altitude_km() const { return altitude_m / 1000; }
};

struct Suite {
    std::string name;  ///< Of the file, without its extension.
    std::string title;
    std::filesystem::path truth_folder;  ///< Beside the suite: "truth".
    std::vector<SuiteAir> airs;
    std::vector<SuiteScene> scenes;
    std::vector<Setting> settings;

    /// "earth/sun30/2m"
    [[nodiscard]] std::string id(const SuiteScene& scene) const;
    /// Indices of the scenes with this air.
    [[nodiscard]] std::vector<std::size_t> scenes_of(std::size_t air) const;
};

/// Whether a setting is measured in this air: in colours of its truth, with nothing left out that the air does not have.
[[nodiscard]] bool is_for(const Setting& setting, const SuiteAir& air);

/// Reads a suite file; the truth is in a folder beside it. Throws Error: io; invalid_argument with file, line, key, value and
/// allowed range; also for keys that do not exist, scenes or settings that occur twice, and airs that no scene has.
[[nodiscard]] Suite read_suite(const std::filesystem::path& path);
/// The same for a text; `name` stands for the file in messages.
[[nodiscard]] Suite parse_suite(std::string_view text, const std::string& name);

}  // namespace aureole::app
