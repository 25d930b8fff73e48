#include "measure/cost.h"
#include "measure/kept.h"
#include "measure/measure.h"

#include <aureole/rhi/error.h>

namespace aureole::app {
namespace {

using nlohmann::json;

json to_json(const Spread& s) { return {{"median", s.median}, {"p10", s.p10}, {"p90", s.p90}}; }
json to_json(const rhi::CpuCounts& c) {
    return {{"medium_evaluations", c.evaluations}, {"fetches", c.samples + c.fetches}, {"bytes_written", c.bytes}};
}

json to_json(const std::string& air, const std::string& setting, const Cost& cost) {
    return {{"air", air},
            {"setting", setting},
            {"per_frame_ms", to_json(cost.per_frame_ms)},
            {"rebuild_ms", to_json(cost.rebuild_ms)},
            {"composite_ms", to_json(cost.composite_ms)},
            {"composite_geometry_ms", to_json(cost.composite_geometry_ms)},
            {"aerial_perspective_ms", to_json(cost.aerial_perspective_ms)},
            {"light_ms", to_json(cost.light_ms)},
            {"bytes", cost.table_bytes},
            {"per_frame", to_json(cost.per_frame)},
            {"rebuild", to_json(cost.rebuild)}};
}

/// What is measured in one air: all at once, so that what else the machine does hits all alike.
std::vector<CostSubject> subjects_of(const Suite& suite, const SuiteAir& air) {
    std::vector<CostSubject> subjects;
    for (const Setting& setting : suite.settings) {
        if (setting.model == "reference" || !is_for(setting, air)) continue;
        Prepared prepared = prepare(setting, air.parameters).value();
        subjects.push_back({setting.id(), std::move(prepared.air), std::move(prepared.model)});
    }
    return subjects;
}

}  // namespace

json measure_costs(const Suite& suite, const MeasureOptions& options, Backend& run,
                   const std::function<void(std::size_t done, std::size_t rounds)>& after_round) {
    json all = json::array();
    const std::size_t rounds = options.cost_rounds + std::size_t{CostOptions{}.warm_up};
    for (std::size_t i = 0; i < suite.airs.size(); ++i) {
        const SuiteAir& air = suite.airs[i];
        const std::vector<CostSubject> subjects = subjects_of(suite, air);
        json key{{"air", print_parameters(truth_parameters(air))},
                 {"device", run.describe()},
                 {"rounds", options.cost_rounds},
                 {"build", build_stamp()}};
        for (const CostSubject& subject : subjects) key["settings"].push_back(subject.label);
        const json results = kept_or(options.out / "items" / air.name / "costs.json", key, [&] {
            std::size_t done = 0;
            const std::vector<Cost> measured = costs(run, subjects, {.rounds = options.cost_rounds},
                                                     [&] { after_round(i * rounds + ++done, suite.airs.size() * rounds); });
            json out = json::array();
            for (std::size_t k = 0; k < measured.size(); ++k) out.push_back(to_json(air.name, subjects[k].label, measured[k]));
            return out;
        });
        for (const json& one : results) all.push_back(one);
        after_round((i + 1) * rounds, suite.airs.size() * rounds);
    }
    return all;
}

}  // namespace aureole::app
