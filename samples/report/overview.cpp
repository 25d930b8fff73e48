#include "report/overview.h"

#include "plan/measured.h"
#include "report/numbers.h"
#include "report/table.h"

#include <algorithm>
#include <cmath>
#include <set>

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
    const auto found = of.saved.find(std::string(key));
    if (found == of.saved.end() || !found->second.share) return std::string(not_measured);
    return whole_percent(*found->second.share);
}

/// Simplifications by class: a column a class, a cell what `cell_of` says; empty: not measured.
struct ByClass {
    std::vector<std::string> titles;
    std::vector<std::vector<std::string>> rows;
};
template <class CellOf>
ByClass by_class(const Measurements& all, const std::vector<ClassSummary>& classes, const CellOf& cell_of) {
    ByClass table{{"Without", "of"}, {}};
    for (const ClassSummary& of : classes) table.titles.push_back(cell(of.name));
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
        if (any) table.rows.push_back(std::move(cells));
    }
    return table;
}

/// Without the columns that say the same as one before: of classes in the same air.
ByClass distinct(const ByClass& table) {
    ByClass less{{}, std::vector<std::vector<std::string>>(table.rows.size())};
    std::vector<std::vector<std::string>> seen;
    for (std::size_t i = 0; i < table.titles.size(); ++i) {
        std::vector<std::string> column;
        for (const auto& cells : table.rows) column.push_back(cells[i]);
        if (i > 1 && std::ranges::find(seen, column) != seen.end()) continue;
        less.titles.push_back(table.titles[i]);
        for (std::size_t k = 0; k < column.size(); ++k) less.rows[k].push_back(column[k]);
        seen.push_back(std::move(column));
    }
    return less;
}

std::string print(const char* title, const ByClass& table) {
    if (table.rows.empty()) return "";
    std::string out = std::string("\n") + title + ":\n\n" + header(table.titles);
    for (const auto& cells : table.rows) out += row(cells);
    return out;
}

std::string pair_of(const std::optional<double>& median, const std::optional<double>& p95) {
    return median || p95 ? signed_percent(median) + " / " + signed_percent(p95) : std::string();
}

std::string simplifications_at_a_glance(const Measurements& all, const std::vector<ClassSummary>& classes) {
    const auto both = [](std::string_view frame, std::string_view rebuild) {
        return [=](const Simplification& one) {
            return one.saved.empty() ? std::string() : saved(one, frame) + " / " + saved(one, rebuild);
        };
    };
    const auto sky = [](const Simplification& one) { return pair_of(one.added_median, one.added_p95); };
    const auto geometry = [](const Simplification& one) { return pair_of(one.added_geometry_median, one.added_geometry_p95); };
    const auto memory = [](const Simplification& one) { return one.saved.empty() ? std::string() : saved(one, "bytes"); };
    return print("What each simplification adds to the error of the sky, in percentage points, median / 95th percentile",
                 by_class(all, classes, sky)) +
           print("The same of geometry at 1 to 100 km, seen through the air", by_class(all, classes, geometry)) +
           print("What it saves of the milliseconds of a frame / of a rebuild, in the air of the first class that has it",
                 distinct(by_class(all, classes, both("per_frame_ms", "rebuild_ms")))) +
           print("Of the look-ups of a frame / of a rebuild",
                 distinct(by_class(all, classes, both("per_frame_fetches", "rebuild_fetches")))) +
           print("Of the tables' memory", distinct(by_class(all, classes, memory)));
}

/// 95th percentiles of every setting, near and far.
std::string geometry_by_distance(const Measurements& all, const std::vector<ClassSummary>& classes) {
    ByClass table{{"Setting"}, {}};
    for (const ClassSummary& of : classes) table.titles.push_back(cell(of.name));
    for (std::size_t setting = 0; setting < all.settings.size(); ++setting) {
        std::vector<std::string> cells{cell(all.settings[setting].id)};
        bool any = false;
        for (const ClassSummary& of : classes) {
            const Summary* here = find(of.settings, setting);
            const auto p95 = [&](const char* region) {
                const bool known = here != nullptr && here->regions.contains(region);
                any |= known;
                return known ? in_unit(here->regions.at(region).p95, Unit::percent) : std::string(not_measured);
            };
            std::string cell = p95("aerial near");
            if (const std::string far = p95("aerial far"); far != cell) cell.append(" / ").append(far);
            cells.push_back(std::move(cell));
        }
        if (any) table.rows.push_back(std::move(cells));
    }
    return print("Error of geometry at 1 to 10 km / at 10 to 100 km, 95th percentile in percent", table);
}

/// Of what was not measured there, but brought from elsewhere: it is good for no more.
double to_two_figures(double value) {
    if (!(value > 0) || !std::isfinite(value)) return value;
    const double step = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return std::round(value / step) * step;
}

constexpr const char* brought_nearer_note =
    "\n† Not measured there: brought nearer from the pixels at 1 to 3 km, along the same rays, by how much of the light the "
    "air takes.\n";

/// A line a distance. No pixel shows geometry nearer than nearest_geometry_km.
std::string air_left_out(const std::vector<ClassSummary>& classes) {
    ByClass table{{"Geometry as far as, km"}, {}};
    std::set<double> distances;
    for (const ClassSummary& of : classes) {
        table.titles.push_back(cell(of.name));
        for (const auto& [km, error] : of.bare) distances.insert(km);
    }
    bool any_brought = false;
    for (const double km : distances) {
        const bool brought = km < detail::nearest_geometry_km;
        any_brought |= brought;
        const auto figure = [&](double error) { return in_unit(brought ? to_two_figures(error) : error, Unit::percent); };
        std::vector<std::string>& cells = table.rows.emplace_back(std::vector{short_number(km) + (brought ? " †" : "")});
        for (const ClassSummary& of : classes) {
            const auto found = of.bare.find(km);
            cells.push_back(found == of.bare.end() ? std::string(not_measured)
                                                   : figure(found->second.median) + " / " + figure(found->second.p95));
        }
    }
    const char* const title =
        "Aerial perspective left out (under every model the same): error of geometry by its distance, median / 95th "
        "percentile in percent";
    return print(title, table) + (any_brought ? brought_nearer_note : "");
}

/// In the air of the first class that has it.
std::string air_left_out_saves(const Measurements& all, const std::vector<ClassSummary>& classes) {
    std::string rows;
    for (std::size_t setting = 0; setting < all.settings.size(); ++setting)
        for (const ClassSummary& of : classes) {
            const Summary* here = find(of.settings, setting);
            if (here == nullptr || !here->without_air) continue;
            const Saving& saved = *here->without_air;
            rows += row({cell(all.settings[setting].id), in_unit(saved.amount, Unit::milliseconds),
                         saved.share ? whole_percent(*saved.share) : std::string(not_measured)});
            break;
        }
    if (rows.empty()) return "";
    return "\nWhat leaving it out saves of a frame with geometry:\n\n" + header({"Setting", "ms", "of the frame"}) + rows;
}

}  // namespace

std::string overview_tables(const Measurements& all, const std::vector<ClassSummary>& classes) {
    return "Suite `" + all.suite + "`, on " + (all.cost_device.empty() ? all.device : all.cost_device) +
           ". Median / 95th percentile of the error of radiance, in percent; costs in the airs of the first class that "
           "has them.\n\n" +
           settings_at_a_glance(all, classes) + simplifications_at_a_glance(all, classes) + geometry_by_distance(all, classes) +
           air_left_out(classes) + air_left_out_saves(all, classes);
}

}  // namespace aureole::app::report
