#include "app/commands.h"
#include "app/progress.h"
#include "app/suites.h"
#include "io/csv.h"
#include "io/file.h"
#include "measure/measure.h"
#include "report/report.h"

#include <unistd.h>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>

namespace aureole::app {
namespace {

struct MeasureCommand {
    std::string suite = "small";
    std::vector<std::string> models, airs;
    std::filesystem::path out = "measured";
    bool no_parts = false, no_costs = false, no_pictures = false, no_html = false;
    std::uint32_t rounds = 5;
    std::string cost_size = std::to_string(detail::measured_width) + "x" + std::to_string(detail::measured_height);
    BackendOptions backend;
};

void keep_models(Suite& suite, const std::vector<std::string>& models) {
    if (models.empty()) return;
    std::erase_if(suite.settings,
                  [&](const Setting& setting) { return std::ranges::find(models, setting.model) == models.end(); });
    if (suite.settings.empty())
        throw Error(ErrorCode::invalid_argument, "--models", models.front(), "a model of which the suite has a setting");
}

/// A line a setting and class: the median of the scenes' medians, and the worst of their 95th percentiles.
void print_summary(const nlohmann::json& measured) {
    std::printf("%-52s %-24s %9s %9s %9s\n", "setting", "class", "median_%", "p95_%", "max_%");
    std::map<std::string, std::string> class_of;
    for (const auto& scene : measured.at("scenes")) class_of[scene.at("id")] = scene.at("class");
    std::map<std::pair<std::string, std::string>, std::array<std::vector<double>, 3>> groups;
    std::vector<std::pair<std::string, std::string>> order;
    for (const auto& result : measured.at("results")) {
        const auto& all = result.at("regions").at("all");
        if (all.at("rows") == 0) continue;
        const std::pair<std::string, std::string> key{result.at("setting"), class_of.at(result.at("scene"))};
        if (!groups.contains(key)) order.push_back(key);
        auto& group = groups[key];
        for (std::size_t i = 0; i < 3; ++i) group[i].push_back(all.at(std::array{"median", "p95", "max"}[i]));
    }
    for (const auto& key : order) {
        const auto& [medians, p95, worst] = groups.at(key);
        std::printf("%-52s %-24s %9.3f %9.3f %9.3f\n", key.first.c_str(), key.second.c_str(), 100 * summarize(medians).median,
                    100 * *std::ranges::max_element(p95), 100 * *std::ranges::max_element(worst));
    }
}

void write_all(const nlohmann::json& measured, const MeasureCommand& command) {
    const auto write = [&](const char* name, const std::string& text) {
        write_text(command.out / name, text);
        std::printf("%s\n", (command.out / name).c_str());
    };
    write("measurements.json", measured.dump(1) + "\n");
    write("results.csv", csv_lines(measured));
    write("tables.md", markdown_tables(measured));
    if (command.no_html) return;
    write_report(measured, command.out / "report.html");
    std::printf("%s\n", (command.out / "report.html").c_str());
}

void run_measure(const MeasureCommand& command) {
    const auto started = std::chrono::steady_clock::now();
    Suite suite = read_suite(find_suite(command.suite));
    keep_models(suite, command.models);
    keep_airs(suite, command.airs);
    std::filesystem::create_directories(command.out);
    const std::unique_ptr<Backend> run = open_backend(command.backend);
    const std::unique_ptr<Backend> exact = open_backend({.name = "cpu-double"});
    std::printf("suite %s: %zu scenes, %zu settings, on %s\n", suite.name.c_str(), suite.scenes.size(), suite.settings.size(),
                run->describe().c_str());
    std::fflush(stdout);
    const Size size = parse_size(command.cost_size, "--cost-size");
    const MeasureOptions options{.out = command.out,
                                 .parts = !command.no_parts,
                                 .cost_rounds = command.rounds,
                                 .cost_width = size.width,
                                 .cost_height = size.height,
                                 .validation = command.backend.validation};
    Progress progress(suite.airs.size() * suite.settings.size(), stderr, isatty(STDERR_FILENO) == 1);
    nlohmann::json measured =
        measure(suite, options, *run, *exact, [&](std::size_t done, std::size_t) { progress.reach(done); });
    measured["library"] = AUREOLE_VERSION;
    if (!command.no_pictures) {
        std::fprintf(stderr, "pictures:\n");
        Progress pictures(suite.airs.size() * suite.settings.size(), stderr, isatty(STDERR_FILENO) == 1);
        measured["pictures"] =
            measure_pictures(suite, options, *run, [&](std::size_t done, std::size_t) { pictures.reach(done); });
    }
    print_summary(measured);
    if (!command.no_costs) {
        write_text(command.out / "measurements.json", measured.dump(1) + "\n");  // whatever becomes of the costs
        std::fprintf(stderr, "costs, in rounds:\n");
        std::optional<Progress> rounds;
        measured["costs"] = measure_costs(suite, options, *run, [&](std::size_t done, std::size_t all) {
            if (!rounds) rounds.emplace(all, stderr, isatty(STDERR_FILENO) == 1);
            rounds->reach(done);
        });
        measured["cost_device"] = run->describe();
        measured["cost_size"] = {options.cost_width, options.cost_height};
    }
    run->check();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    measured["seconds"] = seconds;  // of this run
    write_all(measured, command);
    std::printf("measured in %.0f s\n", seconds);
    run->close();
    exact->close();
}

}  // namespace

void add_measure_command(CLI::App& program) {
    auto options = std::make_shared<MeasureCommand>();
    CLI::App* command = program.add_subcommand(
        "measure",
        "How far models are from the truth in the scenes of a suite, in parts (rounding, discretisation, model). Goes on from "
        "what an interrupted run has finished");
    command
        ->add_option(
            "--suite", options->suite,
            "One of the program's own suites by its name, or a file (TOML); its truth is in the folder truth beside it")
        ->capture_default_str();
    command->add_option("--models", options->models, "Only the suite's settings of these models, separated by commas")
        ->delimiter(',')
        ->check(CLI::IsMember(strings(model_names())));
    command->add_option("--airs", options->airs, "Only these airs of the suite, by name, separated by commas")->delimiter(',');
    command->add_option("-o,--out", options->out, "Folder for results; made if need be")->capture_default_str();
    command->add_flag("--no-parts", options->no_parts, "Total errors alone: a third of the time");
    command->add_option("--rounds", options->rounds, "Measured rounds of the costs")
        ->check(whole_number(1, 100000))
        ->capture_default_str();
    command->add_option("--cost-size", options->cost_size, "WIDTHxHEIGHT of the pictures whose costs are measured")
        ->capture_default_str();
    command->add_flag("--no-costs", options->no_costs, "No costs");
    command->add_flag("--no-pictures", options->no_pictures, "No pictures of scenes that have `picture`");
    command->add_flag("--no-html", options->no_html, "Leave out the page, which a program built without npm does not have");
    add_backend_options(*command, options->backend);
    command->callback([options] { run_measure(*options); });
}

}  // namespace aureole::app
