#include "report/measurements.h"

#include "io/json_file.h"

#include <aureole/rhi/error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

namespace aureole::app::report {
namespace {

using nlohmann::json;

/// A value with its place in the file, for messages: "measurements.json: results[3].regions.all".
class Field {
public:
    Field(const json& value, std::string file, std::string place = "")
        : value_(&value), file_(std::move(file)), place_(std::move(place)) {}

    [[noreturn]] void reject(const std::string& allowed) const {
        throw Error(ErrorCode::invalid_argument, name(), show_json(*value_), allowed);
    }

    [[nodiscard]] bool has(const std::string& key) const { return object().contains(key); }
    [[nodiscard]] Field at(const std::string& key) const {
        Field member(object().contains(key) ? object()[key] : nothing(), file_, place_.empty() ? key : place_ + "." + key);
        if (!object().contains(key)) throw Error(ErrorCode::invalid_argument, member.name() + ": is missing");
        return member;
    }
    /// The elements of an array; none where the array itself may be missing and is.
    [[nodiscard]] std::vector<Field> list(const std::string& key, bool may_be_missing = false) const {
        std::vector<Field> elements;
        if (may_be_missing && (!has(key) || object()[key].is_null())) return elements;
        const Field array = at(key);
        if (!array.value_->is_array()) array.reject("an array");
        for (std::size_t i = 0; i < array.value_->size(); ++i)
            elements.emplace_back((*array.value_)[i], file_, array.place_ + "[" + std::to_string(i) + "]");
        return elements;
    }
    [[nodiscard]] std::string text() const {
        if (!value_->is_string()) reject("a text");
        return value_->get<std::string>();
    }
    [[nodiscard]] double number(double low, double high, const std::string& allowed) const {
        const double value = value_->is_number() ? value_->get<double>() : std::nan("");
        if (!(value >= low && value <= high)) reject(allowed);
        return value;
    }
    /// JSON has no infinity: its writers say null.
    [[nodiscard]] double error() const {
        if (value_->is_null()) return std::numeric_limits<double>::infinity();
        return number(0, std::numeric_limits<double>::infinity(), "a number, >= 0; null for an infinite one");
    }
    [[nodiscard]] double amount() const { return number(0, std::numeric_limits<double>::max(), "a finite number, >= 0"); }

private:
    [[nodiscard]] const json& object() const {
        if (!value_->is_object()) reject("an object");
        return *value_;
    }
    static const json& nothing() {
        static const json none;
        return none;
    }
    [[nodiscard]] std::string name() const { return file_ + ": " + (place_.empty() ? "the whole" : place_); }

    const json* value_;
    std::string file_, place_;
};

using Places = std::map<std::string, std::size_t>;

/// The id of an element that is the next of its kind.
std::string new_id(const Field& element, Places& known) {
    std::string id = element.at("id").text();
    if (id.empty() || !known.emplace(id, known.size()).second) element.at("id").reject("a text of its own");
    return id;
}

std::size_t find(const Field& field, const Places& known, const std::string& what) {
    const auto found = known.find(field.text());
    if (found == known.end()) field.reject("the id of a " + what);
    return found->second;
}

/// Errors over no directions are none: such a scene has nothing to compare there.
bool is_empty(const Field& field) {
    return field.has("rows") && field.at("rows").number(0, 1e9, "a number of directions") == 0;
}

Spread read_spread(const Field& field) {
    const Spread spread{field.at("median").error(), field.at("p95").error(), field.at("max").error()};
    if (spread.median > spread.p95 || spread.p95 > spread.max) field.reject("median <= p95 <= max");
    return spread;
}

MeasuredScene read_scene(const Field& field, Places& known) {
    MeasuredScene scene;
    scene.id = new_id(field, known);
    scene.scene_class = field.at("class").text();
    scene.air = field.at("air").text();
    scene.sun_elevation_deg = field.at("sun_elevation_deg").number(-90, 90, "-90 to 90 degrees");
    scene.altitude_m = field.at("altitude_m").number(-1e12, 1e12, "a finite number of metres");
    for (const Field& bare : field.list("bare", true))
        if (!is_empty(bare)) scene.bare[bare.at("distance_km").number(0, 1e9, "a distance in km")] = read_spread(bare);
    return scene;
}

std::vector<MeasuredSetting> read_settings(const Field& root, Places& known) {
    const std::vector<Field> fields = root.list("settings");
    std::vector<MeasuredSetting> settings;
    for (const Field& field : fields) {
        MeasuredSetting setting;
        setting.id = new_id(field, known);
        setting.model = field.at("model").text();
        setting.quality = field.at("quality").text();
        setting.spectral = field.at("spectral").text();
        for (const Field& part : field.list("without", true)) setting.without.push_back(part.text());
        settings.push_back(std::move(setting));
    }
    // A baseline may come after what is compared with it.
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (!fields[i].has("baseline") || fields[i].at("baseline").text().empty()) continue;
        const auto found = known.find(fields[i].at("baseline").text());
        if (found == known.end()) continue;
        settings[i].baseline = found->second;
        if (*settings[i].baseline == i) fields[i].at("baseline").reject("the id of another setting, or empty");
    }
    return settings;
}

void read_split(const Field& field, MeasuredResult& result) {
    std::vector<std::string> parts(part_names.begin(), part_names.end());
    parts.emplace_back(sum_name);
    if (field.has("split"))
        for (const std::string_view view : region_names) {
            const std::string region(view);
            if (!field.at("split").has(region)) continue;
            const Field split = field.at("split").at(region);
            for (const std::string& part : parts)
                if (split.has(part) && !is_empty(split.at(part))) result.split[region][part] = read_spread(split.at(part));
        }
    if (!field.has("figure_split")) return;
    for (const std::string_view view : split_figures) {
        const std::string figure(view);
        if (!field.at("figure_split").has(figure)) continue;
        const Field split = field.at("figure_split").at(figure);
        for (const std::string_view part : part_names) {
            const double error = split.at(std::string(part)).error();
            result.split[figure][std::string(part)] = {error, error, error};
        }
    }
}

MeasuredResult read_result(const Field& field, const Places& scenes, const Places& settings) {
    MeasuredResult result;
    result.scene = find(field.at("scene"), scenes, "scene");
    result.setting = find(field.at("setting"), settings, "setting");
    const Field regions = field.at("regions");
    (void)regions.at("all");
    for (const std::string_view view : region_names) {
        const std::string name(view);
        if (!regions.has(name) || is_empty(regions.at(name))) continue;
        result.regions[name] = read_spread(regions.at(name));
        result.rows[name] = static_cast<std::size_t>(regions.at(name).at("rows").number(0, 1e9, "a number of directions"));
    }
    read_split(field, result);
    if (field.has("delta_e") && !is_empty(field.at("delta_e"))) {
        result.delta_e = read_spread(field.at("delta_e"));
        result.figures["delta_e_p95"] = result.delta_e->p95;
    }
    for (const Figure& figure : scene_figures)
        if (const std::string key(figure.key); key != "delta_e_p95" && field.has(key))
            result.figures[key] = field.at(key).error();
    return result;
}

MeasuredCost read_cost(const Field& field, const std::set<std::string>& airs, const Places& settings) {
    MeasuredCost cost{field.at("air").text(), find(field.at("setting"), settings, "setting"), {}};
    if (!airs.contains(cost.air)) field.at("air").reject("the air of a scene");
    for (const char* time :
         {"per_frame_ms", "rebuild_ms", "composite_ms", "composite_geometry_ms", "composite_bare_ms", "aerial_perspective_ms"})
        if (field.has(time)) {
            cost.figures[time] = field.at(time).at("median").amount();
            for (const std::string end : {"p10", "p90"})
                if (field.at(time).has(end)) cost.figures[time + ("_" + end)] = field.at(time).at(end).amount();
        }
    for (const std::string when : {"per_frame", "rebuild"})
        if (field.has(when))
            for (const std::string what : {"medium_evaluations", "fetches", "bytes_written"})
                cost.figures[std::string(when).append("_").append(what)] = field.at(when).at(what).amount();
    if (field.has("bytes")) cost.figures["bytes"] = field.at("bytes").amount();
    return cost;
}

std::string read_png(const Field& field) {
    std::string text = field.text();
    const bool base64 =
        text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/=") == std::string::npos;
    if (!base64 || !text.starts_with("iVBORw0KGg")) field.reject("a PNG file in base64");
    return text;
}

MeasuredPicture read_picture(const Field& field, const Places& scenes, const Places& settings) {
    MeasuredPicture picture{field.at("scene").text(), field.at("setting").text(), {}, {}};
    (void)find(field.at("scene"), scenes, "scene");
    if (picture.setting != "truth") (void)find(field.at("setting"), settings, "setting, or truth");
    if (field.has("png")) picture.png = read_png(field.at("png"));
    if (field.has("difference_png")) picture.difference = read_png(field.at("difference_png"));
    return picture;
}

}  // namespace

Measurements read_measurements(const json& document, const std::string& source) {
    const Field root(document, source);
    if (root.at("version").number(0, 1e9, "1") != 1) root.at("version").reject("1");
    Measurements all;
    all.suite = root.at("suite").text();
    if (root.has("library")) all.library = root.at("library").text();
    all.device = root.at("device").text();
    if (root.has("cost_device")) all.cost_device = root.at("cost_device").text();
    Places scenes, settings;
    std::set<std::string> airs;
    for (const Field& field : root.list("scenes")) {
        all.scenes.push_back(read_scene(field, scenes));
        airs.insert(all.scenes.back().air);
    }
    all.settings = read_settings(root, settings);
    std::set<std::pair<std::size_t, std::size_t>> measured;
    for (const Field& field : root.list("results")) {
        all.results.push_back(read_result(field, scenes, settings));
        if (!measured.emplace(all.results.back().scene, all.results.back().setting).second)
            field.reject("each setting once in each scene");
    }
    std::set<std::pair<std::string, std::size_t>> paid;
    for (const Field& field : root.list("costs", true)) {
        all.costs.push_back(read_cost(field, airs, settings));
        if (!paid.emplace(all.costs.back().air, all.costs.back().setting).second) field.reject("each setting once in each air");
    }
    for (const Field& field : root.list("pictures", true)) all.pictures.push_back(read_picture(field, scenes, settings));
    return all;
}

}  // namespace aureole::app::report
