// The scenes of one air under a model: what it shows of them, and how far that is from the truth, in parts.
#pragma once

#include "measure/light.h"
#include "measure/points.h"
#include "measure/truth.h"

#include <optional>
#include <string>
#include <vector>

namespace aureole::app {

/// A scene with all that is known of it.
struct Place {
    std::size_t scene = 0;  ///< Index of Suite::scenes.
    std::vector<Point> points;
    std::optional<AerialView> aerial;
    std::vector<std::size_t> pixels;  ///< Of the aerial view: those with geometry at aerial_nearest_km or farther.
    std::vector<double> pixels_km;    ///< How far away that is.
    std::vector<TrueValue> truth;     ///< Of the points, and after them of the pixels.
    std::vector<ProbeRow> scan;
    TrueValue sun, sky;   ///< Irradiance: of the sun, of the sky on a horizontal surface.
    double exposure = 1;  ///< For colours as shown.
};
/// Those of one air, in the order of the suite. Throws Error(invalid_argument) if a table lacks some, saying how it is
/// completed.
[[nodiscard]] std::vector<Place> places_of(const Suite& suite, std::size_t air, const AirTruth& truth);

/// A place, as a model shows it.
struct Seen {
    std::vector<Rgb> points, scan;  ///< As in Place: pixels of geometry follow the points.
    MeasuredLight light;
};
/// One for each place, in air that is solved (app/solution.h).
[[nodiscard]] std::vector<Seen> look(Backend& backend, Atmosphere& air, const Suite& suite, std::span<const Place> places);

/// Parts of an error.
struct ErrorParts {
    ErrorSummary rounding;        ///< As it runs, against the same in double with nothing rounded.
    ErrorSummary discretisation;  ///< That, against the same model as fine as it gets, in float at least.
    ErrorSummary model;           ///< That, against the truth.
    ErrorSummary sum;             ///< Of each direction's three: no quantile of it is less than that of the error.
};
/// The same of one figure.
struct FigureParts {
    double rounding = 0, discretisation = 0, model = 0;
};
/// Geometry up to detail::near_geometry_km, and beyond.
inline constexpr std::array<std::string_view, 2> aerial_names{"aerial near", "aerial far"};
struct SceneResult {
    std::size_t scene = 0;  ///< Index of Suite::scenes.
    ErrorSummary all;       ///< Of all directions; geometry is a region of its own, and in none of what follows `regions`.
    std::array<ErrorSummary, region_names.size()> regions;
    std::array<std::size_t, region_names.size()> asked{};  ///< Directions of each, also where the truth is too noisy.
    std::array<ErrorSummary, aerial_names.size()> aerial;  ///< Of Region::aerial, by distance.
    std::array<std::size_t, aerial_names.size()> aerial_asked{};
    std::optional<ErrorParts> parts;  ///< Of all directions.
    std::array<std::optional<ErrorParts>, region_names.size()> region_parts;
    std::array<std::optional<ErrorParts>, aerial_names.size()> aerial_parts;
    std::optional<FigureParts> sky_illuminance_parts, sun_colour_parts;
    std::optional<double> luminance_rmse;   ///< None where nothing is known, or black.
    std::optional<double> sky_illuminance;  ///< Error of luminance; none where the truth is unknown.
    std::optional<double> sun_colour;       ///< Error as of a radiance; none for a sun that has set.
    ErrorSummary delta_e;                   ///< CIEDE2000 of the points as shown.
    std::optional<double> banding;          ///< CIEDE2000; with parts, from within the air.
};

/// The same place seen thrice: as it runs; in double; in float or double, as fine as the model gets. The latter two, or none.
struct Looks {
    const Seen* run;
    const Seen* exact = nullptr;
    const Seen* converged = nullptr;
};
[[nodiscard]] SceneResult compare(const Place& place, const Looks& looks);

}  // namespace aureole::app
