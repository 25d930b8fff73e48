#include "app/bench.h"

#include <aureole/presets.h>

#include <utility>

namespace aureole::app {
namespace {

std::string label_of(const SceneModel& model) {
    return model.name + " " + model.quality + (model.in_rgb() ? "" : " " + model.spectral);
}

}  // namespace

std::string BenchResult::label() const { return label_of(model); }

std::vector<BenchResult> bench(Backend& backend, const BenchOptions& options, const std::function<void()>& after_round) {
    std::vector<CostSubject> subjects;
    for (const SceneModel& model : options.models)
        subjects.push_back({label_of(model), presets::by_name(options.preset), model.make()});
    std::vector<PassCosts> costs = pass_costs(backend, subjects, options, after_round);
    std::vector<BenchResult> results;
    for (std::size_t i = 0; i < costs.size(); ++i) results.push_back({std::move(costs[i]), options.models[i]});
    return results;
}

}  // namespace aureole::app
