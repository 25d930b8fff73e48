#include "report/numbers.h"
#include "report/overview.h"
#include "report/report.h"
#include "report/summary.h"
#include "report/table.h"

#include <algorithm>
#include <span>

namespace aureole::app {
namespace {

using namespace report;
/// Of cost_figures, those that the tables have room for.
constexpr std::array<std::string_view, 5> costs_shown{"per_frame_ms", "rebuild_ms", "per_frame_medium_evaluations",
                                                      "per_frame_fetches", "bytes"};

std::vector<Figure> shown_costs() {
    std::vector<Figure> shown;
    for (const Figure& figure : cost_figures)
        if (std::find(costs_shown.begin(), costs_shown.end(), figure.key) != costs_shown.end()) shown.push_back(figure);
    return shown;
}

std::string settings_table(const Measurements& all, const ClassSummary& of) {
    std::vector<std::string> titles{"Setting", "median, %", "p95, %", "max, %", "geometry median, %", "geometry p95, %"};
    for (const Figure& figure : scene_figures) titles.emplace_back(figure.title);
    for (const Figure& figure : shown_costs()) titles.emplace_back(figure.title);
    std::string out = header(titles);
    for (const Summary& summary : of.settings) {
        std::vector<std::string> cells{cell(all.settings[summary.setting].id)};
        if (summary.scenes < of.scenes) cells[0] += " (" + std::to_string(summary.scenes) + " scenes)";
        if (const auto found = summary.regions.find("all"); found != summary.regions.end())
            for (const double error : {found->second.median, found->second.p95, found->second.max})
                cells.push_back(in_unit(error, Unit::percent));
        else
            cells.insert(cells.end(), 3, std::string(not_measured));
        const auto geometry = summary.regions.find("aerial");
        for (double Spread::*const which : {&Spread::median, &Spread::p95})
            cells.push_back(geometry == summary.regions.end() ? std::string(not_measured)
                                                              : in_unit(geometry->second.*which, Unit::percent));
        for (const Figure& figure : scene_figures) cells.push_back(in_unit(summary.errors, figure));
        for (const Figure& figure : shown_costs()) cells.push_back(in_unit(summary.costs, figure));
        out += row(cells);
    }
    return out;
}

using SplitColumns = std::vector<std::pair<double Spread::*, const char*>>;

/// Columns of a setting's parts, of a region or figure.
void add_parts(std::vector<std::string>& cells, const Summary& summary, const std::string& of, std::string_view part,
               const SplitColumns& columns) {
    const auto region = summary.split.find(of);
    for (const auto& [which, title] : columns) {
        const bool there = region != summary.split.end() && region->second.contains(std::string(part));
        cells.push_back(there ? in_unit(region->second.at(std::string(part)).*which, Unit::percent)
                              : std::string(not_measured));
    }
}

std::string split_table(const Measurements& all, const ClassSummary& of) {
    const SplitColumns columns{{&Spread::median, " median"}, {&Spread::p95, " p95"}, {&Spread::max, " max"}};
    std::string rows;
    for (const Summary& summary : of.settings) {
        if (summary.split.empty()) continue;
        std::vector<std::string> cells{cell(all.settings[summary.setting].id)};
        for (const std::string_view part : part_names) add_parts(cells, summary, "all", part, columns);
        add_parts(cells, summary, "all", sum_name, {columns[1]});
        rows += row(cells);
    }
    if (rows.empty()) return "What the errors are made of was not measured.\n";
    std::vector<std::string> titles{"Setting"};
    for (const std::string_view part : part_names)
        for (const auto& [which, title] : columns) titles.push_back(std::string(part) + title + ", %");
    titles.emplace_back("together p95, %");
    return "What the errors are made of:\n\n" + header(titles) + rows;
}

/// Of geometry the 95th percentiles, of light the worst scene's.
std::string split_rest_table(const Measurements& all, const ClassSummary& of) {
    const std::array<std::pair<const char*, const char*>, 3> what{
        {{"aerial", "geometry p95"}, {"sky_illuminance", "illuminance"}, {"sun_colour", "sun colour"}}};
    std::vector<std::string> titles{"Setting"};
    for (const auto& [key, title] : what)
        for (const std::string_view part : part_names) titles.push_back(std::string(title) + ": " + std::string(part) + ", %");
    std::string rows;
    for (const Summary& summary : of.settings) {
        if (std::ranges::none_of(what, [&](const auto& one) { return summary.split.contains(one.first); })) continue;
        std::vector<std::string> cells{cell(all.settings[summary.setting].id)};
        for (const auto& [key, title] : what)
            for (const std::string_view part : part_names) add_parts(cells, summary, key, part, {{&Spread::p95, ""}});
        rows += row(cells);
    }
    if (rows.empty()) return "";
    return "\nThe same of geometry and light:\n\n" + header(titles) + rows;
}

std::string added(const std::optional<double>& error) {
    if (!error) return std::string(not_measured);
    return (*error > 0 ? "+" : "") + in_unit(*error, Unit::percent);
}

/// "0.12 (34 %)": of what the baseline costs.
std::string saved(const Simplification& of, const Figure& figure) {
    const auto found = of.saved.find(std::string(figure.key));
    if (found == of.saved.end()) return std::string(not_measured);
    const auto& [amount, share] = found->second;
    return in_unit(amount, figure.unit) + (share ? " (" + whole_percent(*share) + ")" : "");
}

std::string simplifications_table(const Measurements& all, const ClassSummary& of) {
    if (of.simplifications.empty()) return "What simplifications cost was not measured.\n";
    std::vector<std::string> titles{
        "Without", "of", "added median, %", "added p95, %", "geometry: added median, %", "geometry: added p95, %"};
    for (const Figure& figure : shown_costs()) titles.push_back("saved " + std::string(figure.title));
    std::string out = "What each simplification costs and saves:\n\n" + header(titles);
    for (const Simplification& one : of.simplifications) {
        std::vector<std::string> cells{cell(join(all.settings[one.setting].without, ", ")),
                                       cell(all.settings[one.baseline].id),
                                       added(one.added_median),
                                       added(one.added_p95),
                                       added(one.added_geometry_median),
                                       added(one.added_geometry_p95)};
        for (const Figure& figure : shown_costs()) cells.push_back(saved(one, figure));
        out += row(cells);
    }
    return out;
}

}  // namespace

std::string markdown_overview(const nlohmann::json& measurements, const std::string& source) {
    const Measurements all = read_measurements(measurements, source);
    return overview_tables(all, summarize(all));
}

std::string markdown_tables(const nlohmann::json& measurements, const std::string& source) {
    const Measurements all = read_measurements(measurements, source);
    std::string out = "Suite `" + all.suite + "`" + (all.library.empty() ? "" : ", Aureole " + all.library) +
                      ". Errors: " + all.device +
                      ". Costs: " + (all.costs.empty() || all.cost_device.empty() ? "not measured" : all.cost_device) + ".\n" +
                      std::string(aggregation_note) + " " + std::string(not_measured) + ": not measured.\n";
    const std::vector<ClassSummary> classes = summarize(all);
    out += "\n## At a glance\n\n" + overview_tables(all, classes);
    for (const ClassSummary& of : classes) {
        out += "\n## " + of.name + "\n\n" + std::to_string(of.scenes) + (of.scenes == 1 ? " scene.\n\n" : " scenes.\n\n");
        if (of.settings.empty()) {
            out += "Not measured.\n";
            continue;
        }
        out += settings_table(all, of) + "\n" + split_table(all, of) + split_rest_table(all, of) + "\n" +
               simplifications_table(all, of);
    }
    return out;
}

}  // namespace aureole::app
