#include "app/commands.h"
#include "app/score.h"
#include "io/csv.h"
#include "io/file.h"

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

namespace aureole::app {
namespace {

struct ScoreCommand {
    std::filesystem::path result, truth, json;
    ScoreOptions options;
};

void print_line(const ScoreLine& line, const ScoreOptions& options) {
    std::printf("%7s", print_number(line.sun_zenith_deg).c_str());
    if (options.by_altitude) std::printf("  %8s", print_number(line.altitude_km).c_str());
    if (options.by_ray) std::printf("  %-6s", line.ray.c_str());
    std::printf("  %6zu  %7zu  %8.3f  %8.3f  %8.3f  %6d\n", line.rows, line.skipped, 100 * line.median, 100 * line.p95,
                100 * line.worst, line.worst_line);
}

nlohmann::json to_json(const ScoreLine& line, const ScoreOptions& options) {
    nlohmann::json out{{"sun_zenith_deg", line.sun_zenith_deg},
                       {"rows", line.rows},
                       {"skipped", line.skipped},
                       {"median", line.median},
                       {"p95", line.p95},
                       {"max", line.worst},
                       {"worst_line", line.worst_line}};
    if (options.by_altitude) out["altitude_km"] = line.altitude_km;
    if (options.by_ray) out["ray"] = line.ray;
    return out;
}

void run_score(const ScoreCommand& command) {
    const std::vector<ScoreLine> lines = score(command.result, command.truth, command.options);
    std::printf("sun_deg");
    if (command.options.by_altitude) std::printf("    alt_km");
    if (command.options.by_ray) std::printf("  ray   ");
    std::printf("    rows  skipped  median_%%     p95_%%     max_%%    line\n");
    nlohmann::json json = nlohmann::json::array();
    for (const ScoreLine& line : lines) {
        print_line(line, command.options);
        json.push_back(to_json(line, command.options));
    }
    if (!command.json.empty()) write_text(command.json, json.dump(2) + "\n");
}

}  // namespace

void add_score_command(CLI::App& program) {
    auto options = std::make_shared<ScoreCommand>();
    CLI::App* command = program.add_subcommand(
        "score",
        "How far a probe's result is from a table of truth: sum |dL| / sum L over red, green, blue, in %, for each "
        "zenith angle of the sun in degrees. Rows of the truth with a standard error above 2 % in a channel are skipped, and "
        "rays that meet nothing");
    command->add_option("RESULT.csv", options->result, "What `aureole probe` wrote")->required();
    command->add_option("TRUTH.csv", options->truth, "Columns L_r_per_sr .. and stderr_r_per_sr .., in 1/sr")->required();
    command->add_flag("--by-altitude", options->options.by_altitude, "Split by altitude (km)");
    CLI::Option* by_ray = command->add_flag("--by-ray", options->options.by_ray,
                                            "Split into rays that end in the sky and rays that meet the ground");
    command
        ->add_option("--bottom-radius-km", options->options.bottom_radius_km,
                     "Radius of the ground for --by-ray, in km (default: as the truth's comment line says)")
        ->check(CLI::Range(1.0, 1e9))
        ->needs(by_ray);
    command->add_option("--json", options->json, "Also write the lines as JSON (errors as fractions, not %)");
    command->callback([options] { run_score(*options); });
}

}  // namespace aureole::app
