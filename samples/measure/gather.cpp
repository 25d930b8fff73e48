#include "measure/fit.h"

#include <aureole/rhi/error.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

namespace aureole::app {
namespace {

using detail::MeasuredCost;
using detail::MeasuredError;
using detail::MeasuredScene;
using detail::MeasuredSetting;
using detail::MeasuredSkies;
using nlohmann::json;

constexpr double least_known = 0.5;   // share of the directions: a quantile of fewer is not one of the scene
constexpr double least_light = 1e-3;  // the truth is known no better; a sum of errors of either sign may come to less by chance
constexpr double least_mib = 1e-6;    // of a model without tables: 0 says that it was not measured

/// Index of the one that is called `name`, which is added if there is none.
template <class Named, class Name>
std::size_t index_of(std::vector<Named>& list, const std::string& name, const Name& name_of, Named fresh) {
    const auto found = std::ranges::find_if(list, [&](const Named& one) { return name_of(one) == name; });
    if (found != list.end()) return static_cast<std::size_t>(found - list.begin());
    list.push_back(std::move(fresh));
    return list.size() - 1;
}

/// At least so many, the new ones unknown.
void grow(MeasuredError& error, std::size_t scenes) {
    if (error.by_scene.size() < scenes) error.by_scene.resize(scenes, MeasuredError::unknown);
}

class Gathering {
public:
    Gathering(bool wavelengths, const std::map<std::string, AtmosphereParameters>& airs)
        : wavelengths_(wavelengths), airs_(airs) {}

    void add(const json& measured) {
        scenes_.clear();
        std::map<std::string, json> settings;
        for (const json& setting : measured.at("settings")) settings[setting.at("id")] = setting;
        for (const json& scene : measured.at("scenes")) add_scene(scene);
        for (const json& result : measured.at("results"))
            if (scenes_.contains(result.at("scene"))) add_result(result, settings.at(result.at("setting")));
        if (measured.contains("costs")) add_costs(measured);
    }

    MeasuredSkies finish() {
        if (skies_.device.empty())
            throw Error(ErrorCode::invalid_argument, "measurements", "measured without costs",
                        "at least one measured with them");
        for (MeasuredSetting& setting : skies_.settings) {
            for (const auto error : detail::measured_errors) grow(setting.*error, skies_.scenes.size());
            setting.by_air.resize(skies_.airs.size());
            if (!told_apart_.contains(setting.setting.id())) setting.aerial_near_p95 = setting.aerial_far_p95 = {};
        }
        for (MeasuredError& error : skies_.bare) grow(error, skies_.scenes.size());
        return std::move(skies_);
    }

private:
    void add_scene(const json& scene) {
        if ((scene.at("spectral") != "rgb") != wavelengths_) return;
        const std::string id = scene.at("id");
        const std::size_t air = index_of(
            skies_.airs, scene.at("air").get<std::string>(), [](const std::string& name) { return name; },
            scene.at("air").get<std::string>());
        scenes_[id] = index_of(
            skies_.scenes, id, [](const MeasuredScene& one) { return one.id; },
            MeasuredScene{id, air, scene.at("sun_elevation_deg").get<double>(), scene.at("altitude_m").get<double>(),
                          scene.at("situation").get<detail::Situation>()});
        if (scene.contains("bare"))
            for (const json& error : scene.at("bare"))
                keep_bare(scenes_.at(id), scene.at("extinction_per_km").get<double>() / 1000, error);
    }

    void keep_bare(std::size_t scene, double extinction_per_m, const json& error) {
        const auto at = std::ranges::find(detail::bare_distances_km, error.at("distance_km").get<double>());
        if (at == detail::bare_distances_km.end() || !is_known(error)) return;
        const double share = detail::bare_share(extinction_per_m, *at);
        if (!(share > 0)) return;
        MeasuredError& kept = skies_.bare[static_cast<std::size_t>(at - detail::bare_distances_km.begin())];
        grow(kept, scene + 1);
        kept.by_scene[scene] = MeasuredError::pack(error.at("p95").get<double>() / share);
    }

    MeasuredSetting& setting_of(const json& described) {
        Setting setting{described.at("model"), described.at("quality"), described.at("spectral"), described.at("without")};
        const std::string id = setting.id();
        const std::size_t i = index_of(
            skies_.settings, id, [](const MeasuredSetting& one) { return one.setting.id(); },
            MeasuredSetting{std::move(setting), {}, {}, {}, {}, {}, {}, {}});
        return skies_.settings[i];
    }

    void add_result(const json& result, const json& described) {
        if (described.at("model") == "reference") return;
        MeasuredSetting& setting = setting_of(described);
        const std::size_t scene = scenes_.at(result.at("scene"));
        const json& regions = result.at("regions");
        const auto keep = [&](MeasuredError& error, const char* region, const char* quantile) {
            if (!regions.contains(region) || !is_known(regions.at(region))) return;
            grow(error, scene + 1);
            const json& value = regions.at(region).at(quantile);  // null: infinite
            error.by_scene[scene] = MeasuredError::pack(value.is_null() ? HUGE_VAL : value.get<double>());
        };
        keep(setting.sky_median, "all", "median");
        keep(setting.sky_p95, "all", "p95");
        keep(setting.aerial_p95, "aerial", "p95");
        // Older measurements do not tell geometry apart by its distance: of both what they know of all.
        const bool apart = regions.contains("aerial near") || regions.contains("aerial far");
        if (apart) told_apart_.insert(setting.setting.id());
        keep(setting.aerial_near_p95, apart ? "aerial near" : "aerial", "p95");
        keep(setting.aerial_far_p95, apart ? "aerial far" : "aerial", "p95");
        keep_light(setting.light, scene, result);
    }

    /// The truth of enough directions. Older measurements do not say how many were asked for.
    static bool is_known(const json& region) {
        const double rows = region.at("rows").get<double>();
        return rows > 0 && rows >= least_known * (region.contains("asked") ? region.at("asked").get<double>() : rows);
    }

    /// Unknown where the truth of the sky's is: above the air there is none. Of a sun that has set there is none, either.
    static void keep_light(MeasuredError& light, std::size_t scene, const json& result) {
        if (!result.contains("sky_illuminance")) return;
        const auto error = [&](const char* name) {  // null: infinite
            if (!result.contains(name)) return 0.0;
            return result.at(name).is_null() ? HUGE_VAL : result.at(name).get<double>();
        };
        grow(light, scene + 1);
        light.by_scene[scene] = MeasuredError::pack(std::max({error("sky_illuminance"), error("sun_colour"), least_light}));
    }

    void add_costs(const json& measured) {
        const std::string device = measured.at("cost_device");
        if (!skies_.device.empty() && device != skies_.device)
            throw Error(ErrorCode::invalid_argument, "measurements", "costs of " + device,
                        "those of one device, " + skies_.device);
        skies_.device = device;
        const double pixels = measured.at("cost_size").at(0).get<double>() * measured.at("cost_size").at(1).get<double>();
        if (!(pixels >= 1)) throw Error(ErrorCode::invalid_argument, "measurements", "cost_size", "at least 1x1");
        for (const json& cost : measured.at("costs")) add_cost(cost, detail::measured_width * detail::measured_height / pixels);
    }

    /// `larger`: so many times more pixels has the picture that costs are stated for.
    void add_cost(const json& cost, double larger) {
        const auto air = std::ranges::find(skies_.airs, cost.at("air").get<std::string>());
        const auto setting = std::ranges::find_if(
            skies_.settings, [&](const MeasuredSetting& one) { return one.setting.id() == cost.at("setting"); });
        if (air == skies_.airs.end() || setting == skies_.settings.end()) return;
        const auto i = static_cast<std::size_t>(air - skies_.airs.begin());
        if (setting->by_air.size() <= i) setting->by_air.resize(i + 1);
        const auto median = [&](const char* name) { return cost.at(name).at("median").get<double>(); };
        // A difference of two medians, and where pictures take a second that of their noise: but no less than what was timed
        // alone.
        const double views =
            std::max(median("per_frame_ms") - median("composite_ms"), median("aerial_perspective_ms") + median("light_ms"));
        MeasuredCost& kept = setting->by_air[i];
        kept.work = work_of(cost, setting->setting);
        kept.composite_ms = larger * median("composite_ms");
        kept.composite_geometry_ms = larger * median("composite_geometry_ms");
        kept.aerial_perspective_ms = median("aerial_perspective_ms");
        kept.light_ms = median("light_ms");
        kept.view_ms = std::max(views - kept.aerial_perspective_ms - kept.light_ms, 0.0);
        kept.rebuild_ms = std::max(median("rebuild_ms") - views, 0.0);
        const auto more = [&](const char* name, const char* than) {
            return larger * std::max(median(name) - median(than), 0.0);
        };
        kept.composite_sun_ms = more("composite_two_suns_ms", "composite_ms");
        kept.composite_bare_ms =  // older measurements do not have it: no cheaper, then
            cost.contains("composite_bare_ms") ? larger * median("composite_bare_ms") : kept.composite_geometry_ms;
        kept.shadows_ms = median("shadows_ms");
        kept.composite_shadows_ms = more("composite_shadows_ms", "composite_geometry_ms");
        const auto mebibytes = [&](const char* name) { return cost.at(name).get<double>() / 1048576; };
        kept.air_mib = std::max(mebibytes("air_bytes"), least_mib);
        kept.aerial_perspective_mib = mebibytes("aerial_perspective_bytes");
        kept.shadows_mib = mebibytes("shadow_bytes");
        kept.view_mib = std::max(mebibytes("bytes") - mebibytes("air_bytes") - kept.aerial_perspective_mib, 0.0);
    }

    [[nodiscard]] detail::TableWork work_of(const json& cost, const Setting& setting) const {
        const json& then = cost.at("work");
        if (const auto air = airs_.find(cost.at("air")); air != airs_.end())
            if (const std::optional<Prepared> prepared = prepare(setting, air->second))
                return detail::table_work(*prepared->model, prepared->air);
        const auto work = [&](const char* name) { return then.at(name).get<double>(); };
        return {work("rebuild"),   work("view"), work("air_memory"), work("view_memory"), work("aerial_perspective_memory"),
                work("composite"), work("light")};
    }

    bool wavelengths_;
    const std::map<std::string, AtmosphereParameters>& airs_;
    MeasuredSkies skies_;
    std::map<std::string, std::size_t> scenes_;
    std::set<std::string> told_apart_;  // settings whose geometry is
};

}  // namespace

MeasuredSkies gather(std::span<const json> measurements, bool wavelengths,
                     const std::map<std::string, AtmosphereParameters>& airs) {
    Gathering gathering(wavelengths, airs);
    try {
        for (const json& measured : measurements) gathering.add(measured);
    } catch (const json::exception& error) {
        throw Error(ErrorCode::invalid_argument, "measurements", error.what(), "what `aureole measure` writes");
    } catch (const std::out_of_range&) {
        throw Error(ErrorCode::invalid_argument, "measurements", "a result of a setting that it does not list",
                    "what `aureole measure` writes");
    }
    return gathering.finish();
}

}  // namespace aureole::app
