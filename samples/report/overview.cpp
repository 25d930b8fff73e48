#include "report/overview.h"

#include "report/numbers.h"
#include "report/table.h"

#include <algorithm>
#include <cmath>

namespace aureole::app::report {
namespace {

/// Of the classes that have it: the setting's own line in each, or none.
template <class One>
const One* find(const std::vector<One>& list, std::size_t setting) {
    const auto found = std::ranges::find(list, setting, &One::setting);
    return found == list.end() ? nullptr : &*found;
}

std::string signed_percent(const std::optional<double>& error) {
    if (!error) return std::string(not_measured);
    return (*error > 0 ? "+" : "") + in_unit(*error, Unit::percent);
}

std::string settings_at_a_glance(const Measurements& all, const std::vector<ClassSummary>& classes) {
    std::vector<std::string> titles{"Setting"};
    for (const ClassSummary& of : classes) titles.push_back(cell(of.name));
    for (const std::size_t i : {0UL, 1UL}) titles.emplace_back(cost_figures[i].title);
    std::string rows;
    for (std::size_t setting = 0; setting < all.settings.size(); ++setting) {
        if (!all.settings[setting].without.empty()) continue;
        std::vector<std::string> cells{cell(all.settings[setting].id)};
        const Summary* costs = nullptr;
        bool measured = false;
        for (const ClassSummary& of : classes) {
            const Summary* here = find(of.settings, setting);
            const auto region = here == nullptr ? decltype(here->regions.end()){} : here->regions.find("all");
            const bool known = here != nullptr && region != here->regions.end();
            measured |= known;
            cells.push_back(known ? in_unit(region->second.median, Unit::percent) + " / " +
                                        in_unit(region->second.p95, Unit::percent)
                                  : std::string(not_measured));
            if (costs == nullptr && here != nullptr && !here->costs.empty()) costs = here;
        }
        if (!measured) continue;  // for colours of other airs
        for (const std::size_t i : {0UL, 1UL})
            cells.push_back(costs == nullptr ? std::string(not_measured) : in_unit(costs->costs, cost_figures[i]));
        rows += row(cells);
    }
    return header(titles) + rows;
}

/// In percent of what the baseline costs.
std::string saved(const Simplification& of, std::string_view key) {
    const auto found = of.costs.find(std::string(key));
    if (found == of.costs.end() || found->second.first == 0) return std::string(not_measured);
    const auto [before, after] = found->second;
    return std::to_string(std::lround(100 * (before - after) / before)) + " %";
}

std::string simplifications_at_a_glance(const Measurements& all, const std::vector<ClassSummary>& classes) {
    constexpr std::array<std::string_view, 5> keys{"per_frame_ms", "rebuild_ms", "per_frame_fetches", "rebuild_fetches",
                                                   "bytes"};
    std::vector<std::string> titles{"Without", "of"};
    for (const ClassSummary& of : classes) titles.push_back(cell(of.name));
    for (const char* title :
         {"saved of a frame's ms", "of a rebuild's ms", "of a frame's fetches", "of a rebuild's fetches", "of memory"})
        titles.emplace_back(title);
    std::string rows;
    for (std::size_t setting = 0; setting < all.settings.size(); ++setting) {
        std::vector<std::string> errors;
        const Simplification* first = nullptr;
        for (const ClassSummary& of : classes) {
            const Simplification* here = find(of.simplifications, setting);
            errors.push_back(here == nullptr ? std::string(not_measured)
                                             : signed_percent(here->added_median) + " / " + signed_percent(here->added_p95));
            if (first == nullptr && here != nullptr) first = here;
        }
        if (first == nullptr) continue;
        std::vector<std::string> cells{cell(join(all.settings[setting].without, ", ")), cell(all.settings[first->baseline].id)};
        cells.insert(cells.end(), errors.begin(), errors.end());
        for (const std::string_view key : keys) cells.push_back(saved(*first, key));
        rows += row(cells);
    }
    if (rows.empty()) return "";
    return "\nWhat each simplification adds, in percentage points, and what it saves:\n\n" + header(titles) + rows;
}

}  // namespace

std::string overview_tables(const Measurements& all, const std::vector<ClassSummary>& classes) {
    return "Suite `" + all.suite + "`, on " + (all.cost_device.empty() ? all.device : all.cost_device) +
           ". Median / 95th percentile of the error of radiance, in percent; costs and savings in the airs of the first class "
           "that "
           "has them.\n\n" +
           settings_at_a_glance(all, classes) + simplifications_at_a_glance(all, classes);
}

}  // namespace aureole::app::report
