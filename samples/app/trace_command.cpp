#include "app/commands.h"
#include "app/trace_run.h"
#include "io/csv.h"
#include "io/file.h"
#include "scene/scene.h"

#include <aureole/presets.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <memory>

namespace aureole::app {
namespace {

constexpr int value_digits = 9, error_digits = 4;

struct TraceOptions {
    std::filesystem::path scene, directions, output, checkpoint;
    std::string preset, spectral, tracking = "quadrature", error = "0.5%";
    std::vector<double> sun_zenith, altitude, view_zenith, azimuth;
    bool resume = false;
    TraceSettings settings;
    BackendOptions backend{.name = "cpu-double"};
};

/// "0.2%" or "0.002".
double parse_error(const std::string& text) {
    const bool percent = text.ends_with('%');
    const char* end = text.data() + text.size() - (percent ? 1 : 0);
    double value = 0;
    const auto read = std::from_chars(text.data(), end, value);
    if (read.ec != std::errc() || read.ptr != end || !(value > 0))
        throw Error(ErrorCode::invalid_argument, "--error", "\"" + text + "\"", "a number such as 0.002, or 0.2%");
    return percent ? value / 100 : value;
}

std::vector<ProbeRow> grid(const TraceOptions& options) {
    const std::array<std::pair<const char*, const std::vector<double>*>, 4> axes{{{"--sun-zenith", &options.sun_zenith},
                                                                                  {"--altitude", &options.altitude},
                                                                                  {"--view-zenith", &options.view_zenith},
                                                                                  {"--azimuth", &options.azimuth}}};
    for (const auto& [name, values] : axes)
        if (values->empty()) throw Error(ErrorCode::invalid_argument, name, "nothing", "given, or --directions");
    std::vector<ProbeRow> rows;
    for (const double sun : options.sun_zenith)
        for (const double altitude : options.altitude)
            for (const double view : options.view_zenith)
                for (const double azimuth : options.azimuth) {
                    rows.push_back({sun, altitude, view, azimuth});
                    check_row(rows.back(), "the grid");
                }
    return rows;
}

std::vector<ProbeRow> rows_of(const TraceOptions& options) {
    return options.directions.empty() ? grid(options) : read_probe_rows(options.directions);
}

std::string print_result(const std::string& comment, const Tracer& tracer, int orders) {
    std::string text = "# " + comment + "\nsun_zenith_deg,altitude_km,view_zenith_deg,azimuth_deg";
    const auto header = [&](const std::string& name) {
        for (const char* channel : {"_r", "_g", "_b"}) text.append(",").append(name).append(channel).append("_per_sr");
    };
    for (const char* name : {"L", "stderr", "L1", "Lground1"}) header(name);
    text += ",paths";
    for (int order = 1; order <= orders; ++order) {
        header("order" + std::to_string(order));
        header("order" + std::to_string(order) + "_stderr");
    }
    text += "\n";
    const auto print = [&](const Rgb& value, int digits) {
        for (int c = 0; c < 3; ++c) text.append(",").append(print_number(value[c], digits));
    };
    for (std::size_t i = 0; i < tracer.rows().size(); ++i) {
        const ProbeRow& row = tracer.rows()[i];
        const TraceResult result = tracer.result(i);
        text.append(print_number(row.sun_zenith_deg)).append(",").append(print_number(row.altitude_km)).append(",");
        text.append(print_number(row.view_zenith_deg)).append(",").append(print_number(row.azimuth_deg));
        print(result.all.radiance, value_digits);
        print(result.all.error, error_digits);
        print(result.first_air, value_digits);
        print(result.first_ground, value_digits);
        text.append(",").append(std::to_string(result.paths));
        for (const Estimated& order : result.orders) {
            print(order.radiance, value_digits);
            print(order.error, error_digits);
        }
        text += "\n";
    }
    return text;
}

void print_summary(const TraceOptions& options, const Tracer& tracer, Backend& backend) {
    std::uint64_t paths = 0;
    std::size_t short_of = 0;
    double worst = 0;
    for (std::size_t i = 0; i < tracer.rows().size(); ++i) {
        const TraceResult result = tracer.result(i);
        paths += result.paths;
        worst = std::max(worst, relative_error(result.all));
        if (!tracer.reached(i)) ++short_of;
    }
    std::printf("%s  %zu directions, %llu paths, greatest standard error %.3g %%\n  %s\n", options.output.c_str(),
                tracer.rows().size(), static_cast<unsigned long long>(paths), 100 * worst, backend.describe().c_str());
    if (short_of > 0) std::printf("  %zu of them stopped at --max-paths before their error was as small as wanted\n", short_of);
}

void run_trace(TraceOptions options) {
    options.settings.error = parse_error(options.error);
    if (options.tracking == "ratio") options.settings.tracking = models::ReferenceSettings::Tracking::ratio;
    options.settings.validate();
    Scene scene;
    if (options.preset.empty())
        scene = read_scene(options.scene);
    else
        scene.atmosphere = presets::by_name(options.preset);
    options.settings.spectral = options.spectral.empty() ? scene.model.spectral : options.spectral;
    const std::vector<ProbeRow> rows = rows_of(options);
    if (!options.checkpoint.empty() &&
        std::filesystem::weakly_canonical(options.checkpoint) == std::filesystem::weakly_canonical(options.output))
        throw Error(ErrorCode::invalid_argument, "--checkpoint", options.checkpoint.string(), "another file than --output");
    { const NewFile writable(options.output); }
    if (!options.checkpoint.empty() && !options.resume && std::filesystem::exists(options.checkpoint))
        throw Error(ErrorCode::invalid_argument, "--checkpoint", options.checkpoint.string() + ", which is there",
                    "a new file, or --resume to go on from it");
    if (!options.checkpoint.empty()) {
        const NewFile writable(options.checkpoint);
    }
    const std::unique_ptr<Backend> backend = open_backend(options.backend);
    std::string comment;
    {
        const TraceParameters parameters = parameters_of(scene.atmosphere, options.settings, *backend);
        Tracer tracer(*backend, scene.atmosphere, rows, options.settings);
        if (options.resume) read_checkpoint(options.checkpoint, parameters, tracer);
        trace_all(tracer, parameters, options.checkpoint);
        backend->check();
        comment = "aureole trace: " + print_parameters(parameters) + " target_rel=" + print_number(options.settings.error) +
                  " max_paths=" + std::to_string(options.settings.max_paths) +
                  "; radiance and standard error in 1/sr per unit of solar irradiance (1 per channel at the top of the air), "
                  "point sun, its disk excluded; L1: scattered once by the air, Lground1: reflected once by the ground";
        write_text(options.output, print_result(comment, tracer, options.settings.orders));
        print_summary(options, tracer, *backend);
    }
    backend->close();
}

}  // namespace

void add_trace_command(CLI::App& program) {
    auto options = std::make_shared<TraceOptions>();
    CLI::App* command = program.add_subcommand(
        "trace",
        "True radiance of single directions: paths are traced until each direction's standard error is as small as wanted");
    CLI::Option* scene = command->add_option("SCENE", options->scene, "Scene file; its atmosphere and wavelengths are used");
    CLI::Option* preset =
        command->add_option("--preset", options->preset, "The air instead: a preset of scene files' [atmosphere]")
            ->check(CLI::IsMember(strings(presets::names())));
    scene->excludes(preset);
    CLI::Option* directions = command->add_option(
        "--directions", options->directions,
        "CSV with the columns sun_zenith_deg (0 to 180), altitude_km (-10 to 1e9), view_zenith_deg (0 is up, to 180), "
        "azimuth_deg (from the sun's, -360 to 360), as for probe");
    const auto axis = [&](const char* name, std::vector<double>& values, const char* text) {
        command->add_option(name, values, text)->delimiter(',')->excludes(directions);
    };
    axis("--sun-zenith", options->sun_zenith,
         "Instead of a file, every combination of these: zenith angles of the sun in degrees, 0 to 180, separated by commas");
    axis("--altitude", options->altitude, "... altitudes of the camera in km, -10 to 1e9");
    axis("--view-zenith", options->view_zenith, "... zenith angles of the view in degrees, 0 (up) to 180");
    axis("--azimuth", options->azimuth, "... azimuths of the view from the sun's in degrees, -360 to 360");
    command
        ->add_option("--error", options->error,
                     "Standard error wanted of each channel, relative to its radiance: 0.2% or 0.002; 0.0001% to 100%")
        ->capture_default_str();
    command
        ->add_option("--max-paths", options->settings.max_paths,
                     "Paths of a direction at most, 4096 to 1e12, in rounds of 2048; it then stops with a greater error")
        ->capture_default_str();
    command
        ->add_option("--orders", options->settings.orders,
                     "Radiance of each order of scattering from 1 to this, 0 to 64, with its standard error, too")
        ->capture_default_str();
    command
        ->add_option(
            "--tracking", options->tracking,
            "How transmittances are found: quadrature (quick; misses a little), or ratio (ratio tracking: no bias, more "
            "noise; the first order by paths, too; not with --orders)")
        ->check(CLI::IsMember({"quadrature", "ratio"}))
        ->capture_default_str();
    command->add_option("--seed", options->settings.seed, "Another seed, other paths: 0 to 4095")->capture_default_str();
    command
        ->add_option("--spectral", options->spectral,
                     "Colours, instead of the scene's: rgb, or a number of wavelengths (3, 4 and 6 are fitted, others evenly "
                     "spread), of which three are traced together")
        ->check(wavelengths());
    command
        ->add_option("-o,--output", options->output,
                     "CSV to write: radiance, its standard error, and the first order in 1/sr per unit of solar irradiance; "
                     "the number of paths; a comment line with every parameter")
        ->required();
    CLI::Option* checkpoint =
        command->add_option("--checkpoint", options->checkpoint,
                            "File that is written every half minute, when the work is done, and when the program is "
                            "interrupted (Ctrl-C)");
    command
        ->add_flag("--resume", options->resume,
                   "Go on from the checkpoint: the result is the same as without a break. A smaller --error or more "
                   "--max-paths go further; other parameters are refused")
        ->needs(checkpoint);
    add_backend_options(*command, options->backend);
    command->callback([options, scene, preset] {
        if (scene->count() + preset->count() == 0)
            throw Error(ErrorCode::invalid_argument, "SCENE", "nothing", "a scene file, or --preset");
        run_trace(*options);
    });
}

}  // namespace aureole::app
