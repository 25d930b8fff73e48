#include "app/commands.h"
#include "app/plan_needs.h"
#include "app/speed.h"
#include "io/csv.h"
#include "io/file.h"

#include <aureole/envelope.h>
#include <aureole/plan.h>
#include <aureole/presets.h>
#include <aureole/rhi/log.h>

#include <spdlog/logger.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

namespace aureole::app {
namespace {

using nlohmann::json;

constexpr std::uint32_t measured_rounds = 10;

struct PlanCommand {
    std::string scene, tolerance, sun, altitude, size, visibility;
    std::vector<std::string> budgets;
    std::optional<double> geometry_km, rebuilds;
    std::optional<std::uint32_t> suns, views;
    bool shadows = false, no_light = false, wavelengths = false, calibrate = false, measure = false, list = false;
    std::filesystem::path json_file;
    BackendOptions backend{.name = "auto"};
};

/// The number that a text begins with, and what follows it.
std::pair<double, std::string> number_and_unit(const std::string& option, const std::string& text, const char* allowed) {
    std::size_t used = 0;
    try {
        const double value = std::stod(text, &used);
        if (!std::isfinite(value)) throw std::invalid_argument(text);
        std::string unit = text.substr(used);
        unit.erase(0, unit.find_first_not_of(' ') == std::string::npos ? unit.size() : unit.find_first_not_of(' '));
        return {value, unit};
    } catch (const std::exception&) {
        throw Error(ErrorCode::invalid_argument, option, "\"" + text + "\"", allowed);
    }
}

double parse_tolerance(const std::string& text) {
    constexpr const char* allowed = "a share up to 1 as 0.02, or a percentage as 2%";
    const auto [value, unit] = number_and_unit("--tolerance", text, allowed);
    const bool share = unit.empty() && value <= 1;  // 2 is more likely to be meant as 2 %
    if (!share && unit != "%") throw Error(ErrorCode::invalid_argument, "--tolerance", "\"" + text + "\"", allowed);
    return unit.empty() ? value : value / 100;
}

void parse_budget(const std::string& text, PlanRequirements& needs) {
    constexpr const char* allowed = "milliseconds of a frame as 1ms, or memory as 2MiB";
    const auto [value, unit] = number_and_unit("--budget", text, allowed);
    if (unit != "ms" && unit != "MiB") throw Error(ErrorCode::invalid_argument, "--budget", "\"" + text + "\"", allowed);
    std::optional<double>& budget = unit == "ms" ? needs.budget_ms : needs.budget_mib;
    if (budget) throw Error(ErrorCode::invalid_argument, "--budget", "a second one in " + unit, "one in ms, and one in MiB");
    budget = value;
}

/// Metres.
double parse_visibility(const std::string& text) {
    constexpr const char* allowed = "a distance with its unit, as 10km or 5000m";
    const auto [value, unit] = number_and_unit("--visibility", text, allowed);
    if (unit != "km" && unit != "m") throw Error(ErrorCode::invalid_argument, "--visibility", "\"" + text + "\"", allowed);
    return unit == "km" ? 1000 * value : value;
}

/// "-6:60", or one number.
PlanRange parse_range(const std::string& option, const std::string& text) {
    constexpr const char* allowed = "a number, or two as LEAST:MOST";
    const auto [least, rest] = number_and_unit(option, text, allowed);
    if (rest.empty()) return {least, least};
    if (rest.front() != ':') throw Error(ErrorCode::invalid_argument, option, "\"" + text + "\"", allowed);
    const auto [most, more] = number_and_unit(option, rest.substr(1), allowed);
    if (!more.empty()) throw Error(ErrorCode::invalid_argument, option, "\"" + text + "\"", allowed);
    return {least, most};
}

PlanRequirements requirements_of(const PlanCommand& command) {
    const auto presets = presets::names();
    PlanRequirements needs;
    if (std::ranges::find(presets, command.scene) != presets.end())
        needs.air = presets::by_name(command.scene);
    else
        needs = plan_needs(read_scene(command.scene));
    if (!command.visibility.empty()) {
        if (command.scene != "earth")
            throw Error(ErrorCode::invalid_argument, "--visibility", "of " + command.scene, "the preset earth, as SCENE");
        needs.air = presets::earth_with_visibility(parse_visibility(command.visibility));
    }
    if (!command.sun.empty()) needs.sun_elevation_deg = parse_range("--sun-elevation", command.sun);
    if (!command.altitude.empty()) needs.altitude_m = parse_range("--altitude", command.altitude);
    if (command.geometry_km) {
        if (!(*command.geometry_km >= 0) || !std::isfinite(*command.geometry_km))
            throw Error(ErrorCode::invalid_argument, "--geometry", print_number(*command.geometry_km), "kilometres, 0 or more");
        needs.geometry = *command.geometry_km > 0;
        if (needs.geometry) needs.geometry_range_m = *command.geometry_km * 1000;
    }
    if (!command.size.empty()) {
        const Size size = parse_size(command.size);
        needs.width = size.width;
        needs.height = size.height;
    }
    needs.suns = command.suns.value_or(needs.suns);
    needs.views = command.views.value_or(needs.views);
    needs.shadows |= command.shadows;
    needs.light = !command.no_light;
    needs.wavelengths |= command.wavelengths;
    needs.rebuilds_per_frame = command.rebuilds.value_or(needs.rebuilds_per_frame);
    if (!command.tolerance.empty()) needs.tolerance = parse_tolerance(command.tolerance);
    for (const std::string& budget : command.budgets) parse_budget(budget, needs);
    return needs;
}

json to_json(const Setting& s) {
    return {{"id", s.id()}, {"model", s.model}, {"quality", s.quality}, {"spectral", s.spectral}, {"without", s.without}};
}
json to_json(const PlanError& e) { return {{"median", e.median}, {"p95", e.p95}, {"light", e.light}, {"bound", e.bound}}; }
json to_json(const PlanCost& c) {
    return {{"frame_ms", c.frame_ms}, {"rebuild_ms", c.rebuild_ms}, {"charged_ms", c.charged_ms}, {"mebibytes", c.mebibytes}};
}

json to_json(const Plan& plan) {
    json out{{"setting", to_json(plan.setting)}, {"tolerable", plan.tolerable},     {"error", to_json(plan.error)},
             {"cost", to_json(plan.cost)},       {"nearest", plan.nearest},         {"distance", plan.distance},
             {"warnings", plan.warnings},        {"measured_on", plan.measured_on}, {"choices", json::array()},
             {"candidates", json::array()}};
    for (const PlanChoice& choice : plan.choices) {
        json one{{"what", choice.what}, {"chosen", choice.chosen}, {"reason", choice.reason}};
        if (choice.error_otherwise) one["error_otherwise"] = *choice.error_otherwise;
        if (choice.cost_otherwise_ms) one["cost_otherwise_ms"] = *choice.cost_otherwise_ms;
        out["choices"].push_back(std::move(one));
    }
    for (const PlanCandidate& candidate : plan.candidates) {
        json one{{"setting", candidate.setting.id()}};
        if (candidate.excluded.empty())
            one.update(
                {{"error", to_json(candidate.error)}, {"cost", to_json(candidate.cost)}, {"tolerable", candidate.tolerable}});
        else
            one["excluded"] = candidate.excluded;
        out["candidates"].push_back(std::move(one));
    }
    return out;
}

void print_candidates(const Plan& plan) {
    std::printf("%-52s %9s %9s %9s %9s %9s\n", "setting", "median_%", "p95_%", "below_%", "frame_ms", "rebuild_ms");
    for (const PlanCandidate& one : plan.candidates) {
        if (!one.excluded.empty())
            std::printf("%-52s %s\n", one.setting.id().c_str(), one.excluded.c_str());
        else
            std::printf("%-52s %9.3g %9.3g %9.3g %9.3g %9.3g%s\n", one.setting.id().c_str(), 100 * one.error.median,
                        100 * one.error.p95, 100 * one.error.bound, one.cost.frame_ms, one.cost.rebuild_ms,
                        one.tolerable ? "  meets the requirements" : "");
    }
}

/// "24.1 ms a frame (foretold 23.9 ms, -1 %)"
std::string beside(double measured_ms, const char* what, double foretold_ms) {
    char text[160];
    if (measured_ms > 0)
        (void)std::snprintf(text, sizeof text, "%.3g ms %s (foretold %.3g ms, %+.0f %%)", measured_ms, what, foretold_ms,
                            100 * (foretold_ms - measured_ms) / measured_ms);
    else
        (void)std::snprintf(text, sizeof text, "no time %s (foretold %.3g ms)", what, foretold_ms);
    return text;
}

void print_measured(const Plan& plan, const PlanCost& measured) {
    std::printf("measured here: %s, %s\n", beside(measured.frame_ms, "a frame", plan.cost.frame_ms).c_str(),
                beside(measured.rebuild_ms, "a rebuild", plan.cost.rebuild_ms).c_str());
}

/// Errors were measured of airs and places that float can tell: no plan knows of others.
void tell_outside(const PlanRequirements& needs) {
    const Planet& planet = needs.air.planet;
    const Camera highest = aureole::look(planet.bottom_radius_m, needs.altitude_m.most, 0, 0, 1, 1);
    for (const OutsideEnvelope& one : outside_envelope(needs.air)) log()->warn("{}", one.text());
    for (const OutsideEnvelope& one : outside_envelope(planet, highest, {})) log()->warn("{}", one.text());
}

void run_plan(const PlanCommand& command) {
    PlanRequirements needs = requirements_of(command);
    validate(needs);
    tell_outside(needs);
    const std::unique_ptr<Backend> backend = command.calibrate || command.measure ? open_backend(command.backend) : nullptr;
    if (command.calibrate) {
        needs.speed = measure_speed(*backend, 1);
        std::printf("%s: composites take %.3g, tables %.3g times what they took where costs were measured\n",
                    backend->describe().c_str(), needs.speed.composite, needs.speed.tables);
    }
    const Plan found = plan(needs);
    std::fputs(found.text().c_str(), stdout);
    if (command.list) print_candidates(found);
    json out = to_json(found);
    if (command.measure) {
        const PlanCost measured = measure_plan(*backend, needs, found, measured_rounds);
        print_measured(found, measured);
        out["measured"] = {{"frame_ms", measured.frame_ms}, {"rebuild_ms", measured.rebuild_ms}};
    }
    if (backend) backend->close();
    if (!command.json_file.empty()) write_text(command.json_file, out.dump(1) + "\n");
}

}  // namespace

void add_plan_command(CLI::App& program) {
    auto options = std::make_shared<PlanCommand>();
    CLI::App* command = program.add_subcommand(
        "plan",
        "The cheapest way to draw a scene's sky within an error, or the most accurate within a budget: model, quality, what is "
        "left out, and why, by what was measured (docs/trade.md)");
    command
        ->add_option("scene", options->scene,
                     "A scene file (its air, sun, camera, terrain), or one of the presets " +
                         CLI::detail::join(strings(presets::names()), ", "))
        ->required();
    command->add_option("--visibility", options->visibility,
                        "Of the preset earth: how far one sees, 1km to 220km (meteorological optical range), by its aerosol");
    command->add_option("--tolerance", options->tolerance,
                        "Error of radiance that 95 of 100 directions stay below: 2%, or 0.02");
    command->add_option("--budget", options->budgets, "Milliseconds of a frame as 1ms, memory of tables as 2MiB; or both")
        ->expected(1, 2);
    command->add_option("--sun-elevation", options->sun,
                        "Degrees, one number or LEAST:MOST: over all of which the plan holds. Default: the scene's, or 0:90");
    command->add_option("--altitude", options->altitude,
                        "Metres above the ground, one number or LEAST:MOST. Default: the scene's, or 2");
    command->add_option(
        "--geometry", options->geometry_km,
        "Geometry is seen through the air, up to so many km away; 0: none is. Default: if the scene has terrain");
    command->add_flag("--shadows", options->shadows, "Shadow maps darken the air. Default: if the scene's terrain does");
    command->add_flag("--no-light", options->no_light, "No sun colour and sky light for the host's own materials");
    command->add_option("--suns", options->suns, "Suns, 1 to 4. Default: the scene's, or 1")->check(whole_number(1, 4));
    command->add_option("--views", options->views, "Cameras that are drawn each frame, 1 to 64. Default: 1")
        ->check(whole_number(1, 64));
    command->add_option("--size", options->size, "WIDTHxHEIGHT of each, in pixels. Default: the scene's, or 1280x720");
    command->add_flag("--wavelengths", options->wavelengths,
                      "Colours must be those of wavelengths, as the eye sees them. Default: if the scene has `spectral`");
    command->add_option(
        "--rebuilds", options->rebuilds,
        "Share of frames in which the tables of the air are made anew, 0 to 1. Default: 1 in 3600, once a minute");
    command->add_flag("--calibrate", options->calibrate,
                      "Measure this device for a second first; else costs are those of the machine where all was measured");
    command->add_flag("--measure", options->measure,
                      "Also measure what the plan takes on this device, beside what was foretold (best with --calibrate)");
    command->add_flag("--list", options->list, "Also every setting that was thought of, from the cheapest on");
    command->add_option("--json", options->json_file, "Also write everything as JSON");
    add_backend_options(*command, options->backend);
    command->callback([options] { run_plan(*options); });
}

}  // namespace aureole::app
