#include "measure/cost.h"
#include "measure/kept.h"
#include "measure/measure.h"
#include "plan/work.h"

#include <aureole/rhi/error.h>

#include <algorithm>

namespace aureole::app {
namespace {

using nlohmann::json;

json to_json(const Spread& s) { return {{"median", s.median}, {"p10", s.p10}, {"p90", s.p90}}; }
json to_json(const rhi::CpuCounts& c) {
    return {{"medium_evaluations", c.evaluations}, {"fetches", c.samples + c.fetches}, {"bytes_written", c.bytes}};
}

json to_json(const detail::TableWork& w) {
    return {{"rebuild", w.rebuild},
            {"view", w.view},
            {"air_memory", w.air_memory},
            {"view_memory", w.view_memory},
            {"aerial_perspective_memory", w.aerial_perspective_memory},
            {"composite", w.composite},
            {"light", w.light}};
}

json to_json(const std::string& air, const CostSubject& subject, const Cost& cost) {
    return {{"air", air},
            {"setting", subject.label},
            {"work", to_json(detail::table_work(*subject.model, subject.air))},
            {"per_frame_ms", to_json(cost.per_frame_ms)},
            {"rebuild_ms", to_json(cost.rebuild_ms)},
            {"composite_ms", to_json(cost.composite_ms)},
            {"composite_geometry_ms", to_json(cost.composite_geometry_ms)},
            {"aerial_perspective_ms", to_json(cost.aerial_perspective_ms)},
            {"light_ms", to_json(cost.light_ms)},
            {"composite_two_suns_ms", to_json(cost.composite_two_suns_ms)},
            {"composite_bare_ms", to_json(cost.composite_bare_ms)},
            {"shadows_ms", to_json(cost.shadows_ms)},
            {"composite_shadows_ms", to_json(cost.composite_shadows_ms)},
            {"bytes", cost.table_bytes},
            {"air_bytes", cost.air_bytes},
            {"aerial_perspective_bytes", cost.aerial_perspective_bytes},
            {"shadow_bytes", cost.shadow_bytes},
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

/// Rounds of each subject that have been measured, and what has been counted, in a file that grows with each.
class KeptRounds {
public:
    KeptRounds(std::filesystem::path file, json key, std::size_t subjects) : file_(std::move(file)), key_(std::move(key)) {
        kept_ = std::filesystem::exists(file_) ? json::parse(read_text(file_), nullptr, false) : json();
        if (kept_.is_object() && kept_.value("key", json()) == key_ && kept_.value("rounds", json()).size() == subjects) return;
        kept_ = {{"key", key_}, {"rounds", json::array()}, {"counts", json::array()}};
        for (std::size_t i = 0; i < subjects; ++i) kept_["rounds"].push_back(json::array());
    }
    [[nodiscard]] std::vector<CostCounts> counts() const {
        std::vector<CostCounts> result;
        for (const json& subject : kept_.at("counts")) {
            CostCounts& known = result.emplace_back();
            for (const auto& [pass, c] : subject.items()) known[pass] = {c.at(0), c.at(1), c.at(2), c.at(3), c.at(4)};
        }
        return result;
    }
    void add(const CostCounts& counts) {
        json& subject = kept_["counts"].emplace_back(json::object());
        for (const auto& [pass, c] : counts) subject[pass] = {c.evaluations, c.samples, c.fetches, c.stores, c.bytes};
        write();
    }
    [[nodiscard]] std::vector<std::vector<CostRound>> rounds() const {
        std::vector<std::vector<CostRound>> result;
        for (const json& subject : kept_.at("rounds")) {
            std::vector<CostRound>& known = result.emplace_back();
            for (const json& round : subject) {
                CostRound& times = known.emplace_back();
                for (const json& time : round) times.push_back({time.at(0), time.at(1)});
            }
        }
        return result;
    }
    void add(std::size_t subject, const CostRound& times) {
        json& round = kept_["rounds"].at(subject).emplace_back(json::array());
        for (const PassTime& time : times) round.push_back({time.name, time.milliseconds});
        write();
    }
    void remove() { std::filesystem::remove(file_); }

private:
    void write() const {
        std::filesystem::create_directories(file_.parent_path());
        write_text(file_, kept_.dump() + "\n");
    }
    std::filesystem::path file_;
    json key_, kept_;
};

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
                 {"size", {options.cost_width, options.cost_height}},
                 {"rounds", options.cost_rounds},
                 {"validation", options.validation},
                 {"build", build_stamp()}};
        for (const CostSubject& subject : subjects) key["settings"].push_back(subject.label);
        const std::filesystem::path folder = options.out / "items" / air.name;
        const json results = kept_or(folder / "costs.json", key, [&] {
            KeptRounds kept(folder / "cost_rounds.json", key, subjects.size());
            CostOptions wanted{
                .width = options.cost_width, .height = options.cost_height, .rounds = options.cost_rounds, .features = true};
            wanted.known = kept.rounds();
            wanted.after_measured = [&](std::size_t subject, const CostRound& round) { kept.add(subject, round); };
            wanted.known_counts = kept.counts();
            wanted.after_counted = [&](const CostCounts& counts) { kept.add(counts); };
            std::size_t done = 0;
            for (const std::vector<CostRound>& known : wanted.known) done = std::max(done, known.size());
            const std::vector<Cost> measured = costs(
                run, subjects, wanted, [&] { after_round(i * rounds + std::min(++done, rounds), suite.airs.size() * rounds); });
            kept.remove();
            json out = json::array();
            for (std::size_t k = 0; k < measured.size(); ++k) out.push_back(to_json(air.name, subjects[k], measured[k]));
            return out;
        });
        for (const json& one : results) all.push_back(one);
        after_round((i + 1) * rounds, suite.airs.size() * rounds);
    }
    return all;
}

}  // namespace aureole::app
