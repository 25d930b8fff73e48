#include "io/csv.h"
#include "report/report.h"
#include "report/summary.h"

#include <functional>

namespace aureole::app {
namespace {

using namespace report;
/// A text as a cell, in quotes where it must be.
std::string in_cell(const std::string& text) {
    if (text.find_first_of(",\"\r\n#") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out.append(c == '"' ? "\"\"" : std::string(1, c));
    return out + "\"";
}

struct Row {
    const MeasuredScene& scene;
    const MeasuredSetting& setting;
    const MeasuredResult& result;
    const MeasuredCost* cost;
};

struct Column {
    std::string name;
    std::function<std::string(const Row&)> cell;
};

std::string cell(const std::map<std::string, double>& figures, const std::string& key) {
    const auto found = figures.find(key);
    return found == figures.end() ? "" : print_number(found->second);
}

void add_spread(std::vector<Column>& columns, const std::string& prefix, std::function<const Spread*(const Row&)> find) {
    const auto add = [&](const char* name, double Spread::*which) {
        columns.push_back({prefix + name, [=](const Row& row) {
                               const Spread* spread = find(row);
                               return spread ? print_number(spread->*which) : std::string();
                           }});
    };
    add("_median", &Spread::median);
    add("_p95", &Spread::p95);
    add("_max", &Spread::max);
}

const Spread* find(const std::map<std::string, Spread>& spreads, const std::string& name) {
    const auto found = spreads.find(name);
    return found == spreads.end() ? nullptr : &found->second;
}

std::vector<Column> identity_columns(const Measurements& all) {
    const auto without = [](const Row& row) {
        std::string text;
        for (const std::string& part : row.setting.without) text.append(text.empty() ? "" : " ").append(part);
        return in_cell(text);
    };
    const auto baseline = [&all](const Row& row) {
        return row.setting.baseline ? in_cell(all.settings[*row.setting.baseline].id) : std::string();
    };
    std::vector<Column> columns;
    const auto add = [&](const char* name, std::function<std::string(const Row&)> text) {
        columns.push_back({name, std::move(text)});
    };
    add("scene", [](const Row& row) { return in_cell(row.scene.id); });
    add("class", [](const Row& row) { return in_cell(row.scene.scene_class); });
    add("air", [](const Row& row) { return in_cell(row.scene.air); });
    add("sun_elevation_deg", [](const Row& row) { return print_number(row.scene.sun_elevation_deg); });
    add("altitude_m", [](const Row& row) { return print_number(row.scene.altitude_m); });
    add("setting", [](const Row& row) { return in_cell(row.setting.id); });
    add("model", [](const Row& row) { return in_cell(row.setting.model); });
    add("quality", [](const Row& row) { return in_cell(row.setting.quality); });
    add("spectral", [](const Row& row) { return in_cell(row.setting.spectral); });
    add("without", without);
    add("baseline", baseline);
    return columns;
}

std::vector<Column> columns_of(const Measurements& all) {
    std::vector<Column> columns = identity_columns(all);
    for (const std::string_view view : region_names) {
        const std::string name(view);
        columns.push_back({name + "_rows", [=](const Row& row) {
                               const auto found = row.result.rows.find(name);
                               return found == row.result.rows.end() ? "0" : std::to_string(found->second);
                           }});
        add_spread(columns, name, [=](const Row& row) { return find(row.result.regions, name); });
    }
    std::vector<std::string> split(region_names.begin(), region_names.end()), parts(part_names.begin(), part_names.end());
    split.insert(split.end(), split_figures.begin(), split_figures.end());
    parts.emplace_back(sum_name);
    for (const std::string& what : split)
        for (const std::string& part : parts)
            add_spread(columns, what == "all" ? part : std::string(what).append("_").append(part), [=](const Row& row) {
                const auto found = row.result.split.find(what);
                return found == row.result.split.end() ? nullptr : find(found->second, part);
            });
    add_spread(columns, "delta_e", [](const Row& row) { return row.result.delta_e ? &*row.result.delta_e : nullptr; });
    for (const Figure& figure : scene_figures)
        if (const std::string key(figure.key); key != "delta_e_p95")  // is among the spread's
            columns.push_back({key, [=](const Row& row) { return cell(row.result.figures, key); }});
    for (const Figure& figure : cost_figures) {
        const std::vector<const char*> ends =
            figure.unit == Unit::milliseconds ? std::vector{"", "_p10", "_p90"} : std::vector{""};
        for (const char* end : ends) {
            const std::string key = std::string(figure.key) + end;
            columns.push_back({key, [=](const Row& row) { return row.cost ? cell(row.cost->figures, key) : std::string(); }});
        }
    }
    return columns;
}

const MeasuredCost* cost_of(const Measurements& all, const MeasuredResult& result) {
    for (const MeasuredCost& cost : all.costs)
        if (cost.setting == result.setting && cost.air == all.scenes[result.scene].air) return &cost;
    return nullptr;
}

}  // namespace

std::string csv_lines(const nlohmann::json& measurements, const std::string& source) {
    const Measurements all = read_measurements(measurements, source);
    const std::vector<Column> columns = columns_of(all);
    std::string out;
    for (const Column& column : columns) out.append(out.empty() ? "" : ",").append(column.name);
    out += "\n";
    for (const MeasuredResult& result : all.results) {
        const Row row{all.scenes[result.scene], all.settings[result.setting], result, cost_of(all, result)};
        for (const Column& column : columns) out.append(&column == &columns.front() ? "" : ",").append(column.cell(row));
        out += "\n";
    }
    return out;
}

}  // namespace aureole::app
