// Errors of a model against a table of truth: every row of the table goes through Atmosphere, View and composite in float, as
// `aureole probe` sends it. The errors of rows, and quantiles of them, are those of `aureole score` (app/row_error.h,
// app/quantile.h).
#pragma once

#include "physics/sky.h"

#include <map>
#include <vector>

namespace aureole::physics {

struct Errors {
    std::vector<double> percent;
    [[nodiscard]] double quantile(double q);  ///< 0 for no rows.
};

/// By zenith angle of the sun, in degrees. `sky_alone`: cameras in the air and rays that end in the sky, as tables that others
/// measured have them.
[[nodiscard]] std::map<double, Errors> measure(const char* file, const AtmosphereParameters& air, const ModelPtr& model,
                                               bool sky_alone = false);

}  // namespace aureole::physics
