#include "app/bench.h"
#include "app/commands.h"
#include "app/progress.h"
#include "io/file.h"

#include <aureole/presets.h>

#include <unistd.h>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

namespace aureole::app {
namespace {

struct BenchCommand {
    BackendOptions backend;
    std::string size = "1280x720";
    std::vector<std::string> models{"aureole", "hillaire"}, qualities = strings(quality_names());
    std::string spectral = "rgb";
    std::filesystem::path json;
    BenchOptions options;
};

double ratio(double a, double b) { return b > 0 ? a / b : 0; }

void print_result(const BenchResult& result) {
    std::printf("\n%s: tables of %.2f MiB\n", result.label().c_str(), static_cast<double>(result.table_bytes) / (1 << 20));
    std::printf("  %-20s %10s %21s %12s %12s %12s\n", "pass", "median_ms", "p10_ms .. p90_ms", "evaluations", "look-ups",
                "bytes");
    const auto line = [](const char* name, const Spread& s) {
        std::printf("  %-20s %10.3f %9.3f .. %8.3f", name, s.median, s.p10, s.p90);
    };
    for (const PassCost& pass : result.passes) {
        line(pass.name.c_str(), pass.milliseconds);
        std::printf(" %12llu %12llu %12llu\n", static_cast<unsigned long long>(pass.counts.evaluations),
                    static_cast<unsigned long long>(pass.counts.samples) + pass.counts.fetches,
                    static_cast<unsigned long long>(pass.counts.bytes));
    }
    const auto names = [&](std::size_t first, std::size_t count) {
        std::string text;
        for (std::size_t i = first; i < first + count; ++i)
            text.append(text.empty() ? "" : " + ").append(result.passes[i].name);
        return text;
    };
    line("per frame", result.per_frame);
    std::printf("   %s\n", names(result.air_passes, result.view_passes).c_str());
    line("full rebuild", result.rebuild);
    std::printf("   %s%sper frame\n", names(0, result.air_passes).c_str(), result.air_passes > 0 ? " + " : "");
}

/// Costs are told relative to the published technique where it was measured too, else to the last.
const BenchResult& yardstick(const std::vector<BenchResult>& results) {
    const auto found = std::ranges::find(results, "hillaire default", &BenchResult::label);
    return found == results.end() ? results.back() : *found;
}

void print_ratios(const std::vector<BenchResult>& results) {
    const BenchResult& unit = yardstick(results);
    std::printf("\ncost relative to %s:\n  %-16s %10s %12s %10s %20s\n", unit.label().c_str(), "", "per frame", "full rebuild",
                "composite", "composite, geometry");
    for (const BenchResult& r : results) {
        const auto pass = [&](const char* name) {
            return ratio(r.pass(name).milliseconds.median, unit.pass(name).milliseconds.median);
        };
        std::printf("  %-16s %10.3f %12.3f %10.3f %20.3f\n", r.label().c_str(),
                    ratio(r.per_frame.median, unit.per_frame.median), ratio(r.rebuild.median, unit.rebuild.median),
                    pass("composite"), pass("composite_geometry"));
    }
}

nlohmann::json to_json(const Spread& s) { return {{"median_ms", s.median}, {"p10_ms", s.p10}, {"p90_ms", s.p90}}; }

nlohmann::json to_json(const BenchResult& result, const BenchResult& unit) {
    nlohmann::json passes = nlohmann::json::array();
    for (const PassCost& pass : result.passes) {
        nlohmann::json out = to_json(pass.milliseconds);
        out["pass"] = pass.name;
        out["invocations"] = pass.invocations;
        out["medium_evaluations"] = pass.counts.evaluations;
        out["filtered_look_ups"] = pass.counts.samples;
        out["texel_fetches"] = pass.counts.fetches;
        out["bytes_written"] = pass.counts.bytes;
        passes.push_back(out);
    }
    return {{"model", result.model.name},
            {"quality", result.model.quality},
            {"spectral", result.model.spectral},
            {"table_bytes", result.table_bytes},
            {"passes", passes},
            {"per_frame", to_json(result.per_frame)},
            {"full_rebuild", to_json(result.rebuild)},
            {"ratio",
             {{"to", unit.label()},
              {"per_frame", ratio(result.per_frame.median, unit.per_frame.median)},
              {"full_rebuild", ratio(result.rebuild.median, unit.rebuild.median)}}}};
}

/// Each model in each quality, once, in the order that they were asked for.
std::vector<SceneModel> chosen(const BenchCommand& command) {
    std::vector<std::string> names = command.models;
    if (std::ranges::find(names, "all") != names.end()) names = strings(model_names());
    std::vector<SceneModel> models;
    for (const std::string& name : names)
        for (const std::string& quality : command.qualities) {
            const auto same = [&](const SceneModel& m) { return m.name == name && m.quality == quality; };
            if (std::ranges::none_of(models, same)) models.push_back({name, quality, command.spectral});
        }
    return models;
}

void run_bench(const BenchCommand& command) {
    BenchOptions options = command.options;
    const Size size = parse_size(command.size);
    options.width = size.width;
    options.height = size.height;
    options.models = chosen(command);
    if (!command.json.empty()) {
        const NewFile writable(command.json);
    }
    const std::unique_ptr<Backend> backend = open_backend(command.backend);
    std::printf("%s, %s, %ux%u, %u rounds\n", backend->describe().c_str(), options.preset.c_str(), options.width,
                options.height, options.frames);
    std::fflush(stdout);

    Progress progress(options.frames + options.warm_up, stderr, isatty(STDERR_FILENO) == 1);
    const std::vector<BenchResult> results = bench(*backend, options, [&] { progress.step(); });
    const rhi::Capabilities c = backend->device().capabilities();
    backend->close();
    for (const BenchResult& result : results) print_result(result);
    print_ratios(results);
    if (command.json.empty()) return;

    nlohmann::json out{{"backend", backend->name()}, {"device", c.device},       {"driver", c.driver},
                       {"threads", c.threads},       {"width", options.width},   {"height", options.height},
                       {"rounds", options.frames},   {"preset", options.preset}, {"raster", options.raster},
                       {"linear", options.linear}};
    for (const BenchResult& result : results) out["models"].push_back(to_json(result, yardstick(results)));
    write_text(command.json, out.dump(2) + "\n");
}

}  // namespace

void add_bench_command(CLI::App& program) {
    auto options = std::make_shared<BenchCommand>();
    CLI::App* command = program.add_subcommand(
        "bench",
        "What each pass of each model costs in ms, measured in turn in one run; with counts of work, memory of the tables in "
        "MiB, and costs relative to hillaire in its default quality (the last one listed, where that is not measured)");
    add_backend_options(*command, options->backend);
    std::vector<std::string> known = strings(model_names());
    known.emplace_back("all");
    command->add_option("--model", options->models, "Models to measure, separated by commas, or all")
        ->check(CLI::IsMember(known))
        ->delimiter(',')
        ->default_str("aureole,hillaire");
    command->add_option("--quality", options->qualities, "Qualities to measure of each, separated by commas")
        ->check(CLI::IsMember(strings(quality_names())))
        ->delimiter(',')
        ->default_str("low,default,high");
    command
        ->add_option("--spectral", options->spectral,
                     "Colours of all of them: rgb, or a number of wavelengths, for models and qualities that have them")
        ->check(wavelengths())
        ->default_str("rgb");
    command->footer("Models:\n" + list_models("  "));
    const std::vector<std::string> presets = strings(presets::names());
    command->add_option("--preset", options->options.preset, "The air: " + CLI::detail::join(presets, ", "))
        ->check(CLI::IsMember(presets))
        ->default_str("earth");
    command->add_option("--size", options->size, "WIDTHxHEIGHT of the composite, in pixels")->default_str("1280x720");
    command->add_option("--frames", options->options.frames, "Rounds to measure, 1 to 100000; two more are thrown away")
        ->check(whole_number(1, 100000))
        ->default_str("20");
    command->add_flag("--raster", options->options.raster, "Composite with a full-screen draw instead of a compute pass");
    command->add_flag("--linear", options->options.linear,
                      "Composite into half floats as they are, without exposure, tone map, sRGB curve and dither");
    command->add_option("--json", options->json, "Also write everything as JSON");
    command->callback([options] { run_bench(*options); });
}

}  // namespace aureole::app
