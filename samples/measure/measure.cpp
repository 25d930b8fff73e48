#include "measure/measure.h"

#include "app/solution.h"
#include "measure/bare.h"
#include "measure/kept.h"
#include "plan/situation.h"

#include <map>
#include <numeric>

namespace aureole::app {
namespace {

using nlohmann::json;

json to_json(const ErrorSummary& e) {
    return e.rows == 0 ? json{{"rows", 0}} : json{{"rows", e.rows}, {"median", e.median}, {"p95", e.p95}, {"max", e.worst}};
}

/// With how many directions there are, known or not.
json to_json(const ErrorSummary& e, std::size_t asked) {
    json out = to_json(e);
    out["asked"] = asked;
    return out;
}

json to_json(const ErrorParts& parts) {
    return {{"rounding", to_json(parts.rounding)},
            {"discretisation", to_json(parts.discretisation)},
            {"model", to_json(parts.model)},
            {"sum", to_json(parts.sum)}};
}
json to_json(const FigureParts& parts) {
    return {{"rounding", parts.rounding}, {"discretisation", parts.discretisation}, {"model", parts.model}};
}

json to_json(const Suite& suite, const Setting& setting, const SceneResult& result) {
    const std::size_t in_sky = std::accumulate(result.asked.begin(), result.asked.end(), std::size_t{0}) -
                               result.asked[static_cast<std::size_t>(Region::aerial)];
    json out{{"scene", suite.id(suite.scenes[result.scene])},
             {"setting", setting.id()},
             {"regions", {{"all", to_json(result.all, in_sky)}}},
             {"delta_e", to_json(result.delta_e)}};
    for (std::size_t i = 0; i < region_names.size(); ++i) {
        const std::string name(region_names[i]);
        if (result.asked[i] > 0) out["regions"][name] = to_json(result.regions[i], result.asked[i]);
        if (result.region_parts[i]) out["split"][name] = to_json(*result.region_parts[i]);
    }
    for (std::size_t i = 0; i < aerial_names.size(); ++i) {
        const std::string name(aerial_names[i]);
        if (result.aerial_asked[i] > 0) out["regions"][name] = to_json(result.aerial[i], result.aerial_asked[i]);
        if (result.aerial_parts[i]) out["split"][name] = to_json(*result.aerial_parts[i]);
    }
    if (result.parts) out["split"]["all"] = to_json(*result.parts);
    if (result.sky_illuminance_parts) out["figure_split"]["sky_illuminance"] = to_json(*result.sky_illuminance_parts);
    if (result.sun_colour_parts) out["figure_split"]["sun_colour"] = to_json(*result.sun_colour_parts);
    if (result.luminance_rmse) out["luminance_rmse"] = *result.luminance_rmse;
    if (result.sky_illuminance) out["sky_illuminance"] = *result.sky_illuminance;
    if (result.sun_colour) out["sun_colour"] = *result.sun_colour;
    if (result.banding) out["banding_delta_e"] = *result.banding;
    return out;
}

json to_json(const Rgb& c) { return {c.r, c.g, c.b}; }
Rgb rgb_in(const json& c) { return {c.at(0).get<double>(), c.at(1).get<double>(), c.at(2).get<double>()}; }

json to_json(const std::vector<Seen>& looks) {
    const auto list = [](const std::vector<Rgb>& colours) {
        json out = json::array();
        for (const Rgb& c : colours) out.push_back(to_json(c));
        return out;
    };
    json out = json::array();
    for (const Seen& seen : looks)
        out.push_back({{"points", list(seen.points)},
                       {"scan", list(seen.scan)},
                       {"sun", to_json(seen.light.sun_irradiance)},
                       {"sky", to_json(seen.light.sky_irradiance_up)}});
    return out;
}

std::vector<Seen> seen_in(const json& looks) {
    const auto list = [](const json& colours) {
        std::vector<Rgb> out;
        for (const json& c : colours) out.push_back(rgb_in(c));
        return out;
    };
    std::vector<Seen> out;
    for (const json& seen : looks)
        out.push_back({list(seen.at("points")), list(seen.at("scan")), {rgb_in(seen.at("sun")), rgb_in(seen.at("sky"))}});
    return out;
}

/// Else tables that ask for floats may be half floats.
bool filters_floats(Backend& backend) {
    return backend.device().format_support(rhi::Format::rgba32_float, rhi::Dimension::d2).linear_filter &&
           backend.device().format_support(rhi::Format::rgba32_float, rhi::Dimension::d3).linear_filter;
}

/// Few enough for less than a minute, and so many that a device's pipelines are not made for each.
constexpr std::size_t places_kept_together = 16;

/// Settings of one air.
class AirMeasurement {
public:
    AirMeasurement(const Suite& suite, std::size_t air, const MeasureOptions& options, Backend& run, Backend& exact)
        : suite_(suite),
          air_(suite.airs[air]),
          options_(options),
          run_(run),
          exact_(exact),
          fine_(filters_floats(run) ? run : exact) {
        places_ = places_of(suite, air, read_truth(suite, air));
        for (const Place& place : places_)
            scenes_ += suite.id(suite.scenes[place.scene]) + " " + std::to_string(fingerprint(place.truth)) + " ";
    }

    /// An empty array if the setting is none for this air.
    json item(const Setting& setting) {
        if (!is_for(setting, air_)) return json::array();
        const std::filesystem::path file = options_.out / "items" / air_.name / file_name(setting.id());
        json results = kept_or(file, key_of(setting), [&] { return measured(setting); });
        for (const char* as : {"run", "exact"}) std::filesystem::remove(part_file(setting, as));
        return results;
    }

    /// Into the scenes of this air: what geometry without the air before it errs by.
    void add_bare_errors(json& scenes) const {
        for (const Place& place : places_) {
            if (!place.aerial) continue;
            json& list = scenes[place.scene]["bare"];
            const BareErrors errors = bare_errors(air_.parameters, place);
            for (std::size_t i = 0; i < errors.size(); ++i) {
                json one = to_json(errors[i].error, errors[i].asked);
                one["distance_km"] = detail::bare_distances_km[i];
                list.push_back(std::move(one));
            }
        }
    }

private:
    [[nodiscard]] json key_of(const Setting& setting) const {
        return {{"air", print_parameters(truth_parameters(air_))},
                {"scenes", scenes_},
                {"setting", setting.id()},
                {"device", run_.describe()},
                {"parts", options_.parts},
                {"build", build_stamp()}};
    }
    json measured(const Setting& setting) {
        const std::vector<Seen> run = looked(run_, setting, "run");
        const bool parts = options_.parts && setting.model != "reference";  // whose error is noise
        const std::vector<Seen> exact = parts ? looked(exact_, setting, "exact") : std::vector<Seen>();
        const std::vector<Seen>* fine = parts ? &converged_look(setting) : nullptr;
        json results = json::array();
        for (std::size_t i = 0; i < places_.size(); ++i) {
            Looks looks{&run[i]};
            if (parts) looks = {&run[i], &exact[i], &(*fine)[i]};
            results.push_back(to_json(suite_, setting, compare(places_[i], looks)));
        }
        return results;
    }

    [[nodiscard]] std::filesystem::path part_file(const Setting& setting, const std::string& as) const {
        return options_.out / "items" / air_.name / ("part_" + as + "_" + file_name(setting.id()));
    }
    /// All places, kept after every few: the tables of a long look are made anew by the next run, not what was seen by them.
    std::vector<Seen> looked(Backend& backend, const Setting& setting, const std::string& as) {
        json key = key_of(setting);
        key["device"] = backend.describe();
        const std::filesystem::path file = part_file(setting, as);
        std::vector<Seen> seen;
        if (std::optional<json> kept = kept_under(file, key)) seen = seen_in(*kept);
        std::unique_ptr<Atmosphere> air;
        while (seen.size() < places_.size()) {
            const Prepared prepared = prepare(setting, air_.parameters).value();
            if (!air) air = solved(backend, prepared.air, prepared.model);
            const std::size_t count = std::min(places_kept_together, places_.size() - seen.size());
            for (Seen& one : look(backend, *air, suite_, std::span(places_).subspan(seen.size(), count)))
                seen.push_back(std::move(one));
            keep(file, key, to_json(seen));
        }
        return seen;
    }

    const std::vector<Seen>& converged_look(const Setting& setting) {
        const Setting fine = converged(setting);
        const auto [at, is_new] = converged_.try_emplace(fine.id());
        if (!is_new) return at->second;
        json key = key_of(fine);
        key["device"] = fine_.describe();
        const std::filesystem::path file = options_.out / "items" / air_.name / ("look_" + file_name(fine.id()));
        at->second = seen_in(kept_or(file, key, [&] { return to_json(looked(fine_, fine, "converged")); }));
        std::filesystem::remove(part_file(fine, "converged"));
        return at->second;
    }

    const Suite& suite_;
    const SuiteAir& air_;
    const MeasureOptions& options_;
    Backend &run_, &exact_;
    Backend& fine_;  // for what is converged: rounded to float it is as good, and on a GPU many times faster
    std::vector<Place> places_;
    std::string scenes_;
    std::map<std::string, std::vector<Seen>> converged_;
};

json scenes_json(const Suite& suite) {
    json out = json::array();
    std::vector<detail::AirCoordinates> airs;
    for (const SuiteAir& air : suite.airs) airs.emplace_back(air.parameters);
    for (const SuiteScene& scene : suite.scenes) {
        const detail::Situation place = airs[scene.air].at(scene.sun_elevation_deg, scene.altitude_m);
        const double densest = detail::densest_extinction_per_m(suite.airs[scene.air].parameters);
        out.push_back({{"id", suite.id(scene)},
                       {"situation", place},
                       {"extinction_per_km", 1000 * detail::extinction_per_m(densest, place)},
                       {"spectral", suite.airs[scene.air].spectral},
                       {"class", scene.scene_class},
                       {"air", suite.airs[scene.air].name},
                       {"sun_elevation_deg", scene.sun_elevation_deg},
                       {"altitude_m", scene.altitude_m}});
    }
    return out;
}

json settings_json(const Suite& suite) {
    json out = json::array();
    for (const Setting& setting : suite.settings)
        out.push_back({{"id", setting.id()},
                       {"model", setting.model},
                       {"quality", setting.quality},
                       {"spectral", setting.spectral},
                       {"without", setting.without},
                       {"baseline", setting.baseline()}});
    return out;
}

}  // namespace

json measure(const Suite& suite, const MeasureOptions& options, Backend& run, Backend& exact,
             const std::function<void(std::size_t done, std::size_t items)>& after_item) {
    json results = json::array(), scenes = scenes_json(suite);
    const std::size_t items = suite.airs.size() * suite.settings.size();
    std::size_t done = 0;
    for (std::size_t air = 0; air < suite.airs.size(); ++air) {
        AirMeasurement of_air(suite, air, options, run, exact);
        of_air.add_bare_errors(scenes);
        for (const Setting& setting : suite.settings) {
            for (json& result : of_air.item(setting)) results.push_back(std::move(result));
            after_item(++done, items);
        }
    }
    return {{"version", 1},
            {"suite", suite.name},
            {"device", run.describe()},
            {"scenes", std::move(scenes)},
            {"settings", settings_json(suite)},
            {"results", std::move(results)}};
}

}  // namespace aureole::app
