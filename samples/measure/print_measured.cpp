#include "measure/fit.h"

#include <cstdio>
#include <span>

namespace aureole::app {
namespace {

using detail::MeasuredCost;
using detail::MeasuredError;
using detail::MeasuredSetting;
using detail::MeasuredSkies;

/// Four figures: what was measured is no more certain.
std::string rounded(double value) {
    char text[32];
    (void)std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

/// Seven figures: a measured scene is found again where it was.
std::string exact(double value) {
    char text[32];
    (void)std::snprintf(text, sizeof text, "%.7g", value);
    return text;
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) result += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    return result + "\"";
}

template <class List, class Print>
std::string braced(const List& list, const char* between, const Print& print) {
    std::string text = "{";
    bool first = true;
    for (const auto& one : list) {
        text += (first ? "" : between) + print(one);
        first = false;
    }
    return text + "}";
}

std::string print(const MeasuredError& error) {
    return "{" + rounded(error.spread) + ", " + braced(error.by_scene, ",", [](int value) { return std::to_string(value); }) +
           "}";
}

std::string print(const MeasuredCost& cost) {
    const double values[] = {cost.composite_ms,
                             cost.composite_geometry_ms,
                             cost.view_ms,
                             cost.aerial_perspective_ms,
                             cost.light_ms,
                             cost.rebuild_ms,
                             cost.air_mib,
                             cost.view_mib,
                             cost.aerial_perspective_mib,
                             cost.composite_sun_ms,
                             cost.shadows_ms,
                             cost.composite_shadows_ms,
                             cost.shadows_mib};
    const detail::TableWork& w = cost.work;
    const double work[] = {w.rebuild, w.view, w.air_memory, w.view_memory, w.aerial_perspective_memory, w.composite, w.light};
    std::string text = braced(values, ", ", rounded);
    text.pop_back();
    return text + ", " + braced(work, ", ", exact) + ", " + rounded(cost.composite_bare_ms) + "}";
}

std::string print(const MeasuredSetting& measured) {
    const Setting& s = measured.setting;
    std::string text = "// " + s.id() + "\n{{" + quoted(s.model) + ", " + quoted(s.quality) + ", " + quoted(s.spectral) + ", " +
                       braced(s.without, ", ", quoted) + "},\n ";
    for (const auto error :
         {&MeasuredSetting::sky_median, &MeasuredSetting::sky_p95, &MeasuredSetting::aerial_p95, &MeasuredSetting::light})
        text += print(measured.*error) + ",\n ";
    text += braced(measured.by_air, ", ", [](const MeasuredCost& cost) { return print(cost); });
    for (const auto error : {&MeasuredSetting::aerial_near_p95, &MeasuredSetting::aerial_far_p95})
        text += ",\n " + print(measured.*error);
    return text + "}";
}

}  // namespace

std::string print_initializer(const MeasuredSkies& skies) {
    std::string text = "// Written by `aureole fit` from measurements: see plan.md. Errors are logarithms in thousandths.\n{";
    text += quoted(skies.device) + ",\n" + braced(skies.lengths, ", ", rounded) + ", " + rounded(skies.margin) + ",\n" +
            braced(skies.airs, ", ", quoted) + ",\n";
    text += braced(skies.scenes, ",\n", [](const detail::MeasuredScene& scene) {
        return "{" + quoted(scene.id) + ", " + std::to_string(scene.air) + ", " + rounded(scene.sun_elevation_deg) + ", " +
               rounded(scene.altitude_m) + ", " + braced(scene.situation, ", ", exact) + "}";
    });
    text += ",\n" + braced(skies.settings, ",\n", [](const MeasuredSetting& setting) { return print(setting); });
    text += ",\n{" + braced(skies.bare, ",\n", [](const MeasuredError& error) { return print(error); }) + "}}\n";
    return text;
}

}  // namespace aureole::app
