// How far a setting will be from the truth, and what it will cost, where nobody has measured it: from where somebody has.
#pragma once

#include "plan/kriging.h"
#include "plan/measured.h"

#include <map>
#include <memory>
#include <optional>
#include <span>

namespace aureole::detail {

/// An error that is known in fewer scenes is not predicted.
inline constexpr std::size_t fewest_scenes = 4;

/// Relative errors of radiance.
struct PredictedError {
    double likely = 0;  ///< Middle of what is to be expected.
    double bound = 0;   ///< Upper bound, in 95 cases of 100 or more.
};

class Predictor {
public:
    /// `skies` outlives this object. `scenes`: those to go by, as indices; empty: all.
    explicit Predictor(const MeasuredSkies& skies, std::vector<std::size_t> scenes = {});

    /// None where the error is known in too few scenes.
    [[nodiscard]] std::optional<PredictedError> predict(const MeasuredError& error, const Situation& place);
    /// In an air as that of `place`, where the setting has so much to do; none where it was measured in no air. What is
    /// interpolated is cost by work.
    [[nodiscard]] std::optional<MeasuredCost> cost(const MeasuredSetting& setting, const Situation& place,
                                                   const TableWork& work);
    /// The scenes that are most like a place, most of all the first; and how far it is from all of them: 0 at a scene, 1 as
    /// far as the loneliest scene is from the others, by the deviation that Kriging expects.
    struct Nearest {
        std::vector<std::size_t> scenes;
        double distance = 0;
    };
    [[nodiscard]] Nearest nearest(const Situation& place, std::size_t most);

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
    double loneliest_ = 0;         // variance of the scene that is least like the others; 0: not found yet
    std::vector<Situation> airs_;  // sun and camera at rest: by index of MeasuredSkies::airs
    std::map<std::pair<bool, std::vector<std::size_t>>, Known> known_;
};

}  // namespace aureole::detail
