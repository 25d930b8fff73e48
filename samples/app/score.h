// How far a table of radiances is from a table of true ones.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace aureole::app {

struct ScoreOptions {
    bool by_altitude = false;     ///< A line for each altitude, too.
    bool by_ray = false;          ///< A line each for rays to the sky and to the ground, too.
    double bottom_radius_km = 0;  ///< For by_ray; 0: as the truth's comment line says (bottom_radius_km=...).
};

/// One line of the result: rows that share the sun's zenith angle (and altitude, and kind of ray).
struct ScoreLine {
    double sun_zenith_deg = 0;
    double altitude_km = 0;                 ///< With by_altitude.
    std::string ray;                        ///< "sky" or "ground" with by_ray.
    std::size_t rows = 0;                   ///< Compared.
    std::size_t skipped = 0;                ///< What row_error leaves out: the truth too noisy, or black as the result.
    double median = 0, p95 = 0, worst = 0;  ///< Of sum |dL| / sum L over the channels; 0 if no row is left.
    int worst_line = 0;                     ///< Of the truth file.
};

/// `result` has the columns r, g, b; `truth` L_r_per_sr .. and stderr_r_per_sr ..; both the four columns of a probe. Every row
/// of the truth must be in the result. Throws Error: io, invalid_argument.
[[nodiscard]] std::vector<ScoreLine> score(const std::filesystem::path& result, const std::filesystem::path& truth,
                                           const ScoreOptions& options);

}  // namespace aureole::app
