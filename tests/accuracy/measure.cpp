#include "accuracy/measure.h"

#include "app/quantile.h"
#include "app/row_error.h"
#include "physics/truth.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace aureole::physics {
namespace {

app::Channels channels(const std::map<std::string, std::string>& row, const std::string& what) {
    return {number(row, what + "_r_per_sr"), number(row, what + "_g_per_sr"), number(row, what + "_b_per_sr")};
}

bool from_air_to_sky(const std::map<std::string, std::string>& row, const Planet& planet) {
    const double altitude = 1000 * number(row, "altitude_km"),
                 ratio = planet.bottom_radius_m / (planet.bottom_radius_m + altitude);
    const double horizon = -std::sqrt((1 - ratio) * (1 + ratio));
    return altitude < planet.top_radius_m - planet.bottom_radius_m &&
           std::cos(number(row, "view_zenith_deg") * degree) > horizon;
}

}  // namespace

double Errors::quantile(double q) {
    std::sort(percent.begin(), percent.end());
    return app::quantile(percent, q);
}

std::map<double, Errors> measure(const char* file, const AtmosphereParameters& air, const ModelPtr& model, bool sky_alone) {
    const TruthTable table = read_truth(file);
    std::map<std::pair<double, double>, std::vector<std::map<std::string, std::string>>> groups;
    for (const auto& row : table.rows)
        if (!sky_alone || from_air_to_sky(row, air.planet))
            groups[{number(row, "sun_zenith_deg"), number(row, "altitude_km")}].push_back(row);

    SkyOptions options;
    options.model = model;
    Sky sky(cpu_float(), air, options);
    std::map<double, Errors> errors;
    for (const auto& [place, rows] : groups) {
        sky.stand(place.second * 1000, sun_at(place.first * degree));
        std::vector<glm::dvec3> directions;
        for (const auto& row : rows)
            directions.push_back(direction(number(row, "view_zenith_deg") * degree, number(row, "azimuth_deg") * degree));
        const std::vector<Rgb> seen = sky.radiance(directions);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const auto error =
                app::row_error({seen[i].r, seen[i].g, seen[i].b}, channels(rows[i], "L"), channels(rows[i], "stderr"));
            if (error) errors[place.first].percent.push_back(100 * *error);
        }
    }
    return errors;
}

}  // namespace aureole::physics
