#include "app/commands.h"
#include "app/suites.h"
#include "io/file.h"
#include "io/json_file.h"
#include "measure/fit.h"
#include "measure/hold_out.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <vector>

namespace aureole::app {
namespace {

struct FitCommand {
    std::vector<std::filesystem::path> measurements;
    std::filesystem::path out;
    std::uint32_t seed = 1;
};

void print_coverage(const char* name, const detail::MeasuredSkies& skies, std::uint32_t seed) {
    const std::vector<std::size_t> held_out = drawn_third(skies, seed);
    const Coverage found = coverage(skies, held_out);
    std::printf(
        "%s: %zu scenes, %zu settings; fitted without %zu scenes (seed %u), of %zu errors there %.1f %% are at or below "
        "their bound (of sky %.1f %%, of geometry %.1f %%, of light %.1f %%); bound / measured %.2f (%.2f, %.2f, %.2f), "
        "|likely / measured| off by %.0f %% (medians); of %zu choices %.1f %% keep their tolerance; of %zu errors of geometry "
        "without the air before it %.1f %% are below their bound, bound / measured %.2f\n",
        name, skies.scenes.size(), skies.settings.size(), held_out.size(), seed, found.radiance.predictions,
        100 * found.radiance.below_bound, 100 * found.sky.below_bound, 100 * found.geometry.below_bound,
        100 * found.light.below_bound, found.radiance.median_excess, found.sky.median_excess, found.geometry.median_excess,
        found.light.median_excess, 100 * (std::exp(found.radiance.median_off) - 1), found.choices, 100 * found.choices_kept,
        found.bare.predictions, 100 * found.bare.below_bound, found.bare.median_excess);
}

/// "frame 1 of 44 (worst: aureole low +35 %)"
std::string far_off(const std::vector<ForetoldCost>& costs, std::string_view what) {
    std::size_t count = 0, off = 0;
    const ForetoldCost* worst = nullptr;
    for (const ForetoldCost& cost : costs) {
        if (cost.what != what) continue;
        ++count;
        if (cost.within(cost_tolerance)) continue;
        ++off;
        if (worst == nullptr || std::abs(cost.off()) > std::abs(worst->off())) worst = &cost;
    }
    std::string text = std::string(what) + " " + std::to_string(off) + " of " + std::to_string(count);
    if (worst == nullptr) return text;
    char share[32];
    (void)std::snprintf(share, sizeof share, " %+.0f %%", 100 * worst->off());
    return text + " (worst: " + worst->setting + share + ")";
}

void print_airs_left_out(const char* name, const detail::MeasuredSkies& skies) {
    for (const AirLeftOut& one : without_each_air(skies)) {
        std::printf("%s: fitted without %s (distance %.2f), of %zu errors there %.1f %% are at or below their bound", name,
                    one.air.c_str(), one.errors.distance, one.errors.radiance.predictions,
                    100 * one.errors.radiance.below_bound);
        if (one.errors.bare.predictions > 0)
            std::printf(", of geometry without air before it %.1f %%", 100 * one.errors.bare.below_bound);
        if (one.costs.empty())
            std::printf("; no costs\n");
        else
            std::printf("; costs more than %.0f %% off: %s, %s, %s\n", 100 * cost_tolerance,
                        far_off(one.costs, "frame").c_str(), far_off(one.costs, "rebuild").c_str(),
                        far_off(one.costs, "composite").c_str());
    }
}

/// Of the suites that the measurements name, where they are the program's own.
std::map<std::string, AtmosphereParameters> airs_of(const std::vector<nlohmann::json>& measurements) {
    std::map<std::string, AtmosphereParameters> airs;
    const std::vector<std::string> own = own_suites();
    for (const nlohmann::json& measured : measurements) {
        const std::string suite = measured.value("suite", "");
        if (std::ranges::find(own, suite) == own.end()) continue;
        for (const SuiteAir& air : read_suite(find_suite(suite)).airs) airs[air.name] = air.parameters;
    }
    return airs;
}

void run_fit(const FitCommand& command) {
    std::vector<nlohmann::json> measurements;
    for (const std::filesystem::path& path : command.measurements) measurements.push_back(read_json(path));
    const std::map<std::string, AtmosphereParameters> airs = airs_of(measurements);
    for (const bool wavelengths : {false, true}) {
        detail::MeasuredSkies skies = gather(measurements, wavelengths, airs);
        const char* name = wavelengths ? "wavelengths" : "rgb";
        if (skies.scenes.empty()) {
            std::printf("%s: no scenes\n", name);
            continue;
        }
        print_coverage(name, skies, command.seed);
        print_airs_left_out(name, skies);
        fit(skies);
        std::printf("%s: fitted to all; margin %.2f standard deviations; lengths", name, skies.margin);
        for (std::size_t i = 0; i < skies.lengths.size(); ++i)
            std::printf("%s %s %.3g", i == 0 ? "" : ",", std::string(detail::situation_axes[i]).c_str(), skies.lengths[i]);
        std::printf("\n");
        if (command.out.empty()) continue;
        const std::filesystem::path file = command.out / (std::string("measured_") + name + ".inc");
        write_text(file, print_initializer(skies));
        std::printf("%s\n", file.c_str());
    }
}

}  // namespace

void add_fit_command(CLI::App& program) {
    auto options = std::make_shared<FitCommand>();
    CLI::App* command = program.add_subcommand(
        "fit", "Makes the planner's table from measurements, and says how its predictions hold in scenes that it has not seen");
    command
        ->add_option(
            "measurements", options->measurements,
            "measurements.json of `aureole measure`, one or several; of what occurs twice the later counts. At least one with "
            "costs")
        ->required();
    command->add_option("-o,--out", options->out,
                        "Folder for measured_rgb.inc and measured_wavelengths.inc (the library's: atmosphere/plan); none: "
                        "nothing is written");
    command->add_option("--seed", options->seed, "Draws the third of the scenes that is held out")->capture_default_str();
    command->callback([options] { run_fit(*options); });
}

}  // namespace aureole::app
