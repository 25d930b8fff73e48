#include "measure/suite.h"

#include "io/csv.h"
#include "scene/scene.h"
#include "scene/scene_atmosphere.h"
#include "scene/section.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace aureole::app {
namespace {

constexpr std::size_t most_items = 100000;

bool names_a_file(const std::string& name) {
    return !name.empty() &&
           name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_") == std::string::npos;
}

/// Of a suite, an air or a scene: as it is where the section says nothing.
template <class Of>
void read_precision(Section& section, Of& of) {
    of.truth_error = section.number("truth_error", {1e-4, 0.1}).value_or(of.truth_error);
    of.truth_max_paths = section.number("truth_max_paths", {4096, 1e12}).value_or(of.truth_max_paths);
}

SuiteAir read_air(Section section, const SuiteAir& as_suite_says) {
    SuiteAir air = as_suite_says;
    read_precision(section, air);
    air.name = section.text("name").value_or("");
    if (!names_a_file(air.name)) section.reject("name", "\"" + air.name + "\"", "a name of letters, digits, - and _");
    air.spectral = read_spectral(section, "truth_spectral").value_or("rgb");
    const std::optional<Section> atmosphere = section.section("atmosphere");
    air.parameters = atmosphere ? read_atmosphere(*atmosphere) : read_atmosphere(TomlDocument("", "").root());
    section.finish();
    return air;
}

std::vector<double> required_numbers(Section& section, std::string_view key, Range range) {
    const std::optional<std::vector<double>> values = section.numbers(key, range);
    if (!values || values->empty()) section.reject(key, "nothing", "one number or more");
    return *values;
}

/// Before room is made for them: short lists have long products.
struct Items {
    std::size_t known, a, b, c;
};
void check_product(Section& section, const char* what, const Items& items) {
    const double count = static_cast<double>(items.known) +
                         static_cast<double>(items.a) * static_cast<double>(items.b) * static_cast<double>(items.c);
    if (count > static_cast<double>(most_items))
        section.reject("", print_number(count) + " " + what, "at most " + std::to_string(most_items) + " in the suite");
}

void read_scenes(Section section, Suite& suite) {
    const std::string scene_class = section.text("class").value_or("");
    if (scene_class.empty()) section.reject("class", "nothing", "a text");
    std::vector<std::size_t> airs;
    for (const std::string& name : section.texts("air").value_or(std::vector<std::string>{})) {
        const auto found = std::ranges::find(suite.airs, name, &SuiteAir::name);
        if (found == suite.airs.end()) section.reject("air", "\"" + name + "\"", "the name of an [[air]] above");
        airs.push_back(static_cast<std::size_t>(found - suite.airs.begin()));
    }
    if (airs.empty()) section.reject("air", "nothing", "the name of an [[air]] above, or an array of names");
    const std::vector<double> elevations = required_numbers(section, "sun_elevation_deg", {-90, 90});
    const std::vector<double> altitudes = required_numbers(section, "altitude_m", {0, 1e12});
    check_product(section, "scenes", {suite.scenes.size(), airs.size(), elevations.size(), altitudes.size()});
    const bool aerial = section.boolean("aerial").value_or(false), picture = section.boolean("picture").value_or(false);
    for (const std::size_t air : airs) {
        SuiteScene scene{scene_class, air, 0, 0, aerial, picture, suite.airs[air].truth_error, suite.airs[air].truth_max_paths};
        read_precision(section, scene);
        for (const double elevation : elevations)
            for (const double altitude : altitudes) {
                scene.sun_elevation_deg = elevation;
                scene.altitude_m = altitude;
                suite.scenes.push_back(scene);
            }
    }
    section.finish();
}

void read_settings(Section section, Suite& suite) {
    const std::vector<std::string> models = section.texts("model").value_or(std::vector<std::string>{});
    if (models.empty()) section.reject("model", "nothing", "the name of a model, or an array of names");
    const std::vector<std::string> qualities = section.texts("quality").value_or(std::vector<std::string>{"default"});
    const std::string spectral = read_spectral(section, "spectral").value_or("rgb");
    const std::vector<std::string> without = section.texts("without").value_or(std::vector<std::string>{});
    check_product(section, "settings", {suite.settings.size(), models.size(), qualities.size(), 1});
    for (const std::string& model : models)
        for (const std::string& quality : qualities) {
            suite.settings.push_back({model, quality, spectral, without});
            try {
                validate(suite.settings.back());
            } catch (const Error& error) {
                section.reject(section.has(error.field()) ? error.field() : "", error.value(), error.allowed());
            }
        }
    section.finish();
}

void check_whole(const Suite& suite, Section& root) {
    std::set<std::string> seen;
    for (const SuiteScene& scene : suite.scenes)
        if (!seen.insert(suite.id(scene)).second) root.reject("scenes", suite.id(scene) + " twice", "each once");
    for (const Setting& setting : suite.settings)
        if (!seen.insert(setting.id()).second) root.reject("setting", setting.id() + " twice", "each once");
    for (std::size_t i = 0; i < suite.airs.size(); ++i)
        if (suite.scenes_of(i).empty())
            root.reject("air", suite.airs[i].name + ", which no [[scenes]] has", "an air of a scene");
    for (const Setting& setting : suite.settings)
        if (!setting.baseline().empty() && !seen.contains(setting.baseline()))
            root.reject("setting", setting.id() + " without its baseline", "beside a setting " + setting.baseline());
    if (suite.scenes.size() * suite.settings.size() > most_items)
        root.reject("scenes",
                    std::to_string(suite.scenes.size()) + " scenes x " + std::to_string(suite.settings.size()) + " settings",
                    "at most " + std::to_string(most_items) + " together");
}

Suite read_root(Section root, const std::filesystem::path& path) {
    Suite suite;
    suite.name = path.stem().string();
    suite.truth_folder = path.parent_path() / "truth";
    suite.title = root.text("title").value_or(suite.name);
    SuiteAir any;
    read_precision(root, any);
    for (const Section& section : root.sections("air")) {
        suite.airs.push_back(read_air(section, any));
        if (std::ranges::count(suite.airs, suite.airs.back().name, &SuiteAir::name) > 1)
            root.reject("air", "\"" + suite.airs.back().name + "\" twice", "each name once");
    }
    for (const Section& section : root.sections("scenes")) read_scenes(section, suite);
    for (const Section& section : root.sections("setting")) read_settings(section, suite);
    if (suite.scenes.empty()) root.reject("scenes", "nothing", "one [[scenes]] or more");
    if (suite.settings.empty()) root.reject("setting", "nothing", "one [[setting]] or more");
    check_whole(suite, root);
    root.finish();
    return suite;
}

}  // namespace

bool is_for(const Setting& setting, const SuiteAir& air) {
    return setting.in_rgb() == (air.spectral == "rgb") && prepare(setting, air.parameters).has_value();
}

std::string Suite::id(const SuiteScene& scene) const {
    const std::string altitude =
        scene.altitude_m < 1000 ? print_number(scene.altitude_m) + "m" : print_number(scene.altitude_km()) + "km";
    return airs[scene.air].name + "/sun" + print_number(scene.sun_elevation_deg) + "/" + altitude;
}

std::vector<std::size_t> Suite::scenes_of(std::size_t air) const {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < scenes.size(); ++i)
        if (scenes[i].air == air) result.push_back(i);
    return result;
}

Suite read_suite(const std::filesystem::path& path) {
    const TomlDocument document(path);
    return read_root(document.root(), path);
}

Suite parse_suite(std::string_view text, const std::string& name) {
    const TomlDocument document(text, name);
    return read_root(document.root(), name);
}

}  // namespace aureole::app
