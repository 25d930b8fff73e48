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

/// Without its range: that is in the other tables.
std::string median_cost(const Summary& of, const Figure& figure) {
    const auto found = of.costs.find(std::string(figure.key));
    return found == of.costs.end() ? std::string(not_measured) : in_unit(found->second, figure.unit);
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
            cells.push_back(costs == nullptr ? std::string(not_measured) : median_cost(*costs, cost_figures[i]));
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

/// Rows of the simplifications, with a cell for each class; none of a setting of which all are missing.
template <class CellOf>
std::string simplification_rows(const Measurements& all, const std::vector<ClassSummary>& classes, const CellOf& cell_of) {
    std::string rows;
    for (std::size_t setting = 0; setting < all.settings.size(); ++setting) {
        if (!all.settings[setting].baseline || all.settings[setting].without.empty()) continue;
        std::vector<std::string> cells{cell(join(all.settings[setting].without, ", ")),
                                       cell(all.settings[*all.settings[setting].baseline].id)};
        bool any = false;
        for (const ClassSummary& of : classes) {
            const Simplification* here = find(of.simplifications, setting);
            const std::string text = here == nullptr ? std::string() : cell_of(*here);
            any |= !text.empty();
            cells.push_back(text.empty() ? std::string(not_measured) : text);
        }
        if (any) rows += row(cells);
    }
    return rows;
}

std::string pair_of(const std::optional<double>& median, const std::optional<double>& p95) {
    return median || p95 ? signed_percent(median) + " / " + signed_percent(p95) : std::string();
}

std::string simplifications_at_a_glance(const Measurements& all, const std::vector<ClassSummary>& classes) {
    std::vector<std::string> titles{"Without", "of"};
    for (const ClassSummary& of : classes) titles.push_back(cell(of.name));
    std::string out;
    const auto add = [&](const std::string& title, const std::string& rows) {
        if (!rows.empty()) out += "\n" + title + ":\n\n" + header(titles) + rows;
    };
    add("What each simplification adds to the error of the sky, in percentage points, median / 95th percentile",
        simplification_rows(all, classes, [](const Simplification& one) { return pair_of(one.added_median, one.added_p95); }));
    add("The same of geometry at 1 to 100 km, seen through the air",
        simplification_rows(all, classes, [](const Simplification& one) {
            return pair_of(one.added_geometry_median, one.added_geometry_p95);
        }));
    const auto saved_both = [](std::string_view frame, std::string_view rebuild) {
        return [=](const Simplification& one) {
            return one.costs.empty() ? std::string() : saved(one, frame) + " / " + saved(one, rebuild);
        };
    };
    add("What it saves of the milliseconds of a frame / of a rebuild",
        simplification_rows(all, classes, saved_both("per_frame_ms", "rebuild_ms")));
    add("What it saves of the look-ups of a frame / of a rebuild",
        simplification_rows(all, classes, saved_both("per_frame_fetches", "rebuild_fetches")));
    add("What it saves of the tables' memory", simplification_rows(all, classes, [](const Simplification& one) {
            return one.costs.empty() ? std::string() : saved(one, "bytes");
        }));
    return out;
}

}  // namespace

std::string overview_tables(const Measurements& all, const std::vector<ClassSummary>& classes) {
    return "Suite `" + all.suite + "`, on " + (all.cost_device.empty() ? all.device : all.cost_device) +
           ". Median / 95th percentile of the error of radiance, in percent; costs in the airs of the first class that "
           "has them.\n\n" +
           settings_at_a_glance(all, classes) + simplifications_at_a_glance(all, classes);
}

}  // namespace aureole::app::report
