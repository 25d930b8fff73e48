// How far a setting will be from the truth, and what it will cost, where nobody has measured it: from where somebody has.
#pragma once

#include "plan/kriging.h"
#include "plan/measured.h"

#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

namespace aureole::detail {

/// An error that is known in fewer scenes is not predicted.
inline constexpr std::size_t fewest_scenes = 4;

/// Relative errors.
struct PredictedError {
    double likely = 0;  ///< Middle of what is to be expected.
    double bound = 0;   ///< Upper bound, in 95 cases of 100 or more.
};

/// Whatever takes the cube of the number of scenes is done when it is made. From then on it does not change, and may be asked
/// from any number of threads.
class Predictor {
public:
    /// `skies` outlives this object, and stays as it is. `scenes`: those to go by, as indices; empty: all. Costs are known of
    /// the airs of those scenes alone.
    explicit Predictor(const MeasuredSkies& skies, std::vector<std::size_t> scenes = {});

    [[nodiscard]] const MeasuredSkies& skies() const { return skies_; }
    /// Whether there are errors of light at all.
    [[nodiscard]] bool knows_light() const { return knows_light_; }

    /// All about one place. What scenes weigh there is found once, and only for those that are asked about.
    class Here {
    public:
        /// `error` is one of the skies'. None where it is known in too few scenes.
        [[nodiscard]] std::optional<PredictedError> predict(const MeasuredError& error);
        /// Of geometry up to `range_m` away that is shown without the air before it. The bound is that of the next distance
        /// that is known, whatever the air along a ray is like: what is farther errs by no less. Likely is what lies between
        /// the two, evenly over their logarithms. None where that was not measured, above the air, and beyond the farthest
        /// distance. `densest`: densest_extinction_per_m of the air.
        [[nodiscard]] std::optional<PredictedError> bare(double range_m, double densest);
        [[nodiscard]] const Predictor& predictor() const { return from_; }
        [[nodiscard]] bool above_air() const { return place_[axis_of_space] > 0; }
        /// How far the place is from all scenes: 0 at a scene. 1 where the deviation that Kriging expects is that of a scene
        /// which is lonelier among the others than nine of ten, or the air is one unit of its coordinates away from any that
        /// was measured, whatever Kriging makes of it: along the axes of the air its lengths are those of few airs.
        [[nodiscard]] double distance();
        /// Indices of the scenes that are most like it, most of all the first.
        [[nodiscard]] std::vector<std::size_t> nearest(std::size_t most) const;

    private:
        friend class Predictor;
        Here(const Predictor& from, const Situation& place) : from_(from), place_(place), weights_(from.families_.size()) {}
        const Kriging::Weights& weights(std::size_t family);

        const Predictor& from_;
        Situation place_;
        std::vector<std::optional<Kriging::Weights>> weights_;  // by family
    };
    [[nodiscard]] Here at(const Situation& place) const { return {*this, place}; }

    /// In an air as that of `place`, where the setting has so much to do; none where it was measured in no air. What is
    /// interpolated is cost by work.
    [[nodiscard]] std::optional<MeasuredCost> cost(const MeasuredSetting& setting, const Situation& place,
                                                   const TableWork& work) const;

private:
    /// What is known in the same scenes, or airs.
    struct Family {
        std::vector<std::size_t> points;
        Kriging kriging;
    };
    struct Known {
        std::size_t family = 0;
        std::vector<double> logarithms;  // by its points
    };
    /// Families by whether they are of airs, and points.
    using Index = std::map<std::pair<bool, std::vector<std::size_t>>, std::size_t>;
    std::size_t family_of(Index& index, std::vector<std::size_t> points, bool airs);
    void learn(Index& index, const MeasuredError& error);
    void learn(Index& index, const MeasuredSetting& setting);

    const MeasuredSkies& skies_;
    std::vector<std::size_t> scenes_;
    std::vector<std::optional<Situation>> airs_;  // of those scenes, sun and camera at rest: by index of MeasuredSkies::airs
    std::vector<Family> families_;
    std::size_t all_ = 0;  // the family of all scenes
    bool knows_light_ = false;
    double lonely_ = 1;  // variance that nine of ten scenes have less of, left out
    std::unordered_map<const MeasuredError*, Known> errors_;
    std::unordered_map<const MeasuredSetting*, std::size_t> costs_;  // families of airs
};

}  // namespace aureole::detail
