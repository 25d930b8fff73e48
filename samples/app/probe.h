// Radiance of single directions, through the very passes that make a picture.
#pragma once

#include "app/backend.h"

#include <aureole/atmosphere.h>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace aureole::app {

/// Where the sun stands and where one looks. Azimuth is measured from the sun's.
struct ProbeRow {
    double sun_zenith_deg = 0;   ///< In [0, 180].
    double altitude_km = 0;      ///< Above the ground; in [-10, 1e9]. Below 0: as from the ground.
    double view_zenith_deg = 0;  ///< 0 is up; in [0, 180].
    double azimuth_deg = 0;      ///< In [-360, 360].
};

/// Throws Error(invalid_argument) for a value outside its range; `place` says where the row stands: "in.csv:12".
void check_row(const ProbeRow& row, const std::string& place);

/// Rows of a file with the columns sun_zenith_deg, altitude_km, view_zenith_deg, azimuth_deg. Throws Error: io,
/// invalid_argument with file and line.
[[nodiscard]] std::vector<ProbeRow> read_probe_rows(const std::filesystem::path& path);
/// Unit vector where +z is up and the sun's azimuth is that of +x.
[[nodiscard]] glm::dvec3 probe_direction(double zenith_deg, double azimuth_deg);

/// Radiance of each row per unit of solar irradiance, in 1/sr, without the sun's disk; light reflected by the ground is part of
/// it. Rows of the same sun and altitude share one update of the view. Throws Error(invalid_argument) naming the row (from 1).
[[nodiscard]] std::vector<Rgb> probe(Backend& backend, const AtmosphereParameters& parameters, const ModelPtr& model,
                                     std::span<const ProbeRow> rows);
/// The same of an atmosphere whose tables have been recorded (solution.h).
[[nodiscard]] std::vector<Rgb> probe(Backend& backend, Atmosphere& air, std::span<const ProbeRow> rows);

/// As a CSV file, with a comment line.
[[nodiscard]] std::string print_rows(const std::string& comment, std::span<const ProbeRow> rows, std::span<const Rgb> radiance);

}  // namespace aureole::app
