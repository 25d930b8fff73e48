#include "report/page.h"

#include "io/file.h"
#include "report/report.h"
#include "report/summary.h"

#include <aureole/rhi/error.h>

#include <nlohmann/json.hpp>

namespace aureole::app {
namespace {

using namespace report;
using nlohmann::json;

json to_json(const Spread& spread) { return {{"median", spread.median}, {"p95", spread.p95}, {"max", spread.max}}; }

json to_json(const std::map<std::string, Spread>& spreads) {
    json out = json::object();
    for (const auto& [name, spread] : spreads) out[name] = to_json(spread);
    return out;
}

json to_json(const Summary& of, const Measurements& all) {
    json split = json::object();
    for (const auto& [name, parts] : of.split) split[name] = to_json(parts);
    return {{"setting", all.settings[of.setting].id},
            {"scenes", of.scenes},
            {"regions", to_json(of.regions)},
            {"split", std::move(split)},
            {"errors", of.errors},
            {"costs", of.costs}};
}

json to_json(const Simplification& of, const Measurements& all) {
    const auto number = [](const std::optional<double>& value) { return value ? json(*value) : json(); };
    json saved = json::object();
    for (const auto& [key, saving] : of.saved) saved[key] = {{"amount", saving.amount}, {"share", number(saving.share)}};
    return {{"setting", all.settings[of.setting].id},
            {"without", all.settings[of.setting].without},
            {"baseline", all.settings[of.baseline].id},
            {"scenes", of.scenes},
            {"added_median", number(of.added_median)},
            {"added_p95", number(of.added_p95)},
            {"added_geometry_median", number(of.added_geometry_median)},
            {"added_geometry_p95", number(of.added_geometry_p95)},
            {"saved", std::move(saved)}};
}

json to_json(const ClassSummary& of, const Measurements& all) {
    json out{{"name", of.name},
             {"scenes", of.scenes},
             {"settings", json::array()},
             {"by_sun", json::array()},
             {"simplifications", json::array()}};
    for (const Summary& summary : of.settings) out["settings"].push_back(to_json(summary, all));
    for (const auto& [elevation, summaries] : of.by_sun)
        for (const Summary& summary : summaries) {
            json point = to_json(summary, all);
            point["sun_elevation_deg"] = elevation;
            out["by_sun"].push_back(std::move(point));
        }
    for (const Simplification& one : of.simplifications) out["simplifications"].push_back(to_json(one, all));
    return out;
}

template <std::size_t n>
json to_json(const std::array<Figure, n>& figures) {
    constexpr std::array<const char*, 5> units{"percent", "delta_e", "milliseconds", "count", "bytes"};
    json out = json::array();
    for (const Figure& figure : figures)
        out.push_back({{"key", figure.key}, {"title", figure.title}, {"unit", units[static_cast<std::size_t>(figure.unit)]}});
    return out;
}

json settings_of(const Measurements& all) {
    json out = json::array();
    for (const MeasuredSetting& setting : all.settings)
        out.push_back({{"id", setting.id},
                       {"model", setting.model},
                       {"quality", setting.quality},
                       {"spectral", setting.spectral},
                       {"without", setting.without}});
    return out;
}

json pictures_of(const Measurements& all) {
    json out = json::array();
    for (const MeasuredPicture& picture : all.pictures)
        out.push_back({{"scene", picture.scene},
                       {"setting", picture.setting},
                       {"png", picture.png},
                       {"difference_png", picture.difference}});
    return out;
}

/// What the page's scripts read: they draw; what scenes become together is worked out here, once for page and tables.
json page_data(const Measurements& all) {
    json out{{"suite", all.suite},
             {"library", all.library},
             {"device", all.device},
             {"cost_device", all.cost_device},
             {"scenes", all.scenes.size()},
             {"settings", settings_of(all)},
             {"pictures", pictures_of(all)},
             {"regions", region_names},
             {"parts", part_names},
             {"split_figures", split_figures},
             {"note", aggregation_note},
             {"scene_figures", to_json(scene_figures)},
             {"cost_figures", to_json(cost_figures)},
             {"results", all.results.size()},
             {"classes", json::array()}};
    for (const ClassSummary& of : summarize(all)) out["classes"].push_back(to_json(of, all));
    return out;
}

/// As text inside of a <script>: nothing in it can end that element or open another.
std::string inside_script(const json& data) {
    std::string out;
    for (const char c : data.dump(-1, ' ', true, json::error_handler_t::replace))
        if (c == '<')
            out += "\\u003c";
        else
            out += c;
    return out;
}

}  // namespace

std::string html_page(const json& measurements, const std::string& source) {
    const Measurements all = read_measurements(measurements, source);
    if (page_before_data.empty())
        throw Error(ErrorCode::unsupported,
                    "this aureole was built without the report's HTML page (npm was not found, or reached no registry)");
    std::string page(page_before_data);
    page += inside_script(page_data(all));
    page += page_after_data;
    return page;
}

void write_report(const json& measurements, const std::filesystem::path& html, const std::string& source) {
    write_text(html, html_page(measurements, source));
}

}  // namespace aureole::app
