// What `aureole measure` has written, read and checked.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aureole::app::report {

/// Where in a scene, in the order of tables: `all` is every direction.
/// The last two are parts of `aerial`: up to 10 km, and beyond.
inline constexpr std::array<std::string_view, 9> region_names{"all",   "zenith", "horizon",     "aureole",   "antisolar",
                                                              "nadir", "aerial", "aerial near", "aerial far"};
/// What an error is made of.
inline constexpr std::array<std::string_view, 3> part_names{"rounding", "discretisation", "model"};
/// Of each direction the three together: no quantile is less than that of the error.
inline constexpr std::string_view sum_name = "sum";
/// What is split beside regions: figures, of which all quantiles are the same.
inline constexpr std::array<std::string_view, 2> split_figures{"sky_illuminance", "sun_colour"};

/// An error over many directions, as a fraction; infinite where light is shown and there is none.
struct Spread {
    double median = 0, p95 = 0, max = 0;
};

struct MeasuredScene {
    std::string id, scene_class, air;
    double sun_elevation_deg = 0, altitude_m = 0;
    std::map<double, Spread> bare;  ///< Of geometry without the air before it, by its distance in km; where known.
};

struct MeasuredSetting {
    std::string id, model, quality, spectral;
    std::vector<std::string> without;     ///< What was left out; empty: nothing.
    std::optional<std::size_t> baseline;  ///< The setting that leaves nothing out; none: not measured.
};

/// One setting in one scene. Figures that were not measured are missing.
struct MeasuredResult {
    std::size_t scene = 0, setting = 0;
    std::map<std::string, Spread> regions;    ///< By region_names, where there are directions.
    std::map<std::string, std::size_t> rows;  ///< Directions in each of `regions`.
    /// By region_names or split_figures, and by part_names, sum_name among them (not of figures).
    std::map<std::string, std::map<std::string, Spread>> split;
    std::optional<Spread> delta_e;          ///< CIEDE2000.
    std::map<std::string, double> figures;  ///< By keys of scene_figures.
};

/// One setting in one air.
struct MeasuredCost {
    std::string air;
    std::size_t setting = 0;
    std::map<std::string, double> figures;  ///< By keys of cost_figures; of times also with "_p10" and "_p90" behind.
};

/// Texts of PNG files in base64.
struct MeasuredPicture {
    std::string scene, setting;   ///< The setting's id, or "truth".
    std::string png, difference;  ///< Empty: none.
};

struct Measurements {
    std::string suite, library, device, cost_device;
    std::vector<MeasuredScene> scenes;
    std::vector<MeasuredSetting> settings;
    std::vector<MeasuredResult> results;
    std::vector<MeasuredCost> costs;
    std::vector<MeasuredPicture> pictures;
};

/// How a figure is printed.
enum class Unit { percent, delta_e, milliseconds, count, bytes };

/// A figure in tables: its key in the data, its heading with the unit, and how it is printed.
struct Figure {
    std::string_view key, title;
    Unit unit;
};

/// Errors of a whole scene beside those of regions.
inline constexpr std::array<Figure, 5> scene_figures{{{"luminance_rmse", "luminance RMSE, %", Unit::percent},
                                                      {"delta_e_p95", "ΔE2000 p95", Unit::delta_e},
                                                      {"sky_illuminance", "illuminance, %", Unit::percent},
                                                      {"sun_colour", "sun colour, %", Unit::percent},
                                                      {"banding_delta_e", "banding, ΔE2000", Unit::delta_e}}};

/// What a setting costs; times are medians.
inline constexpr std::array<Figure, 10> cost_figures{{{"per_frame_ms", "per frame, ms", Unit::milliseconds},
                                                      {"rebuild_ms", "rebuild, ms", Unit::milliseconds},
                                                      {"composite_ms", "composite, ms", Unit::milliseconds},
                                                      {"per_frame_medium_evaluations", "evaluations per frame", Unit::count},
                                                      {"per_frame_fetches", "fetches per frame", Unit::count},
                                                      {"per_frame_bytes_written", "written per frame, MiB", Unit::bytes},
                                                      {"rebuild_medium_evaluations", "evaluations of a rebuild", Unit::count},
                                                      {"rebuild_fetches", "fetches of a rebuild", Unit::count},
                                                      {"rebuild_bytes_written", "written by a rebuild, MiB", Unit::bytes},
                                                      {"bytes", "tables, MiB", Unit::bytes}}};

/// `source` is the file's name, for messages. Throws Error(invalid_argument) that names file, field, value and what is allowed:
/// another version, a member that is missing or of another kind, a number out of range, an id that is doubled or unknown.
[[nodiscard]] Measurements read_measurements(const nlohmann::json& document, const std::string& source);

}  // namespace aureole::app::report
