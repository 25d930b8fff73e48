// What each model costs in each of its qualities, all of them measured in one run.
#pragma once

#include "app/pass_costs.h"
#include "scene/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace aureole::app {

struct BenchOptions : PassCostOptions {
    std::vector<SceneModel> models;  ///< What is measured, in this order.
    std::string preset = "earth";    ///< The air: one of presets::names().
};

struct BenchResult : PassCosts {
    SceneModel model;

    /// "hillaire default", "aureole default 4"
    [[nodiscard]] std::string label() const;
};

/// For each of the models, as pass_costs measures them, which says what it throws.
[[nodiscard]] std::vector<BenchResult> bench(Backend& backend, const BenchOptions& options,
                                             const std::function<void()>& after_round);

}  // namespace aureole::app
