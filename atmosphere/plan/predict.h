// How far a setting will be from the truth, and what it will cost, where nobody has measured it: from where somebody has.
#pragma once

#include "plan/kriging.h"
#include "plan/measured.h"

#include <map>
#include <memory>
#include <optional>
#include <span>

namespace aureole::detail {

/// Relative errors of radiance.
struct PredictedError {
    double likely = 0;  ///< Middle of what is to be expected.
    double bound = 0;   ///< Upper bound, in 95 cases of 100 or more.
};

class Predictor {
public:
    /// `skies` outlives this object. `scenes`: those to go by, as indices; empty: all.
    explicit Predictor(const MeasuredSkies& skies, std::vector<std::size_t> scenes = {});

    /// None where the setting was measured in no scene.
    [[nodiscard]] std::optional<PredictedError> predict(const MeasuredError& error, const Situation& place);
    /// In an air as that of `place`; none where the setting was measured in no air.
    [[nodiscard]] std::optional<MeasuredCost> cost(const MeasuredSetting& setting, const Situation& place);
    /// Scenes that count most for a place, the first most, and how far the nearest is, in units of Kriging's lengths.
    struct Nearest {
        std::vector<std::size_t> scenes;
        double distance = 0;
    };
    [[nodiscard]] Nearest nearest(const Situation& place, std::size_t most) const;

private:
    struct Known {
        std::vector<std::size_t> points;
        Kriging kriging;
        Situation place{};  // of the weights
        std::optional<Kriging::Weights> weights;
    };
    /// Made once for every set of points, and the weights once for every place in a row.
    Known& known(std::vector<std::size_t> points, bool airs, const Situation& place);

    const MeasuredSkies& skies_;
    std::vector<std::size_t> scenes_;
    std::vector<Situation> airs_;  // sun and camera at rest: by index of MeasuredSkies::airs
    std::map<std::pair<bool, std::vector<std::size_t>>, Known> known_;
};

}  // namespace aureole::detail
