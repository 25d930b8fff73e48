#include "app/commands.h"
#include "app/progress.h"
#include "app/suites.h"
#include "app/trace_run.h"
#include "measure/light.h"
#include "measure/pictures.h"
#include "measure/truth.h"

#include <unistd.h>
#include <algorithm>
#include <cstdio>
#include <memory>

namespace aureole::app {
namespace {

constexpr std::size_t progress_steps = 1000;
// Less would not be seen; and light of dusk takes minutes for each scene.
constexpr double picture_error = 0.02, light_error = 0.005;
constexpr std::uint64_t light_max_paths = 16384;

struct TruthOptions {
    std::string suite = "small";
    std::vector<std::string> airs;
    BackendOptions backend{.name = "cpu-double"};
};

TraceSettings settings_of(const SuiteAir& air) {
    return {.error = air.truth_error, .max_paths = static_cast<std::uint64_t>(air.truth_max_paths), .spectral = air.spectral};
}

void print_state(const std::filesystem::path& file, std::size_t missing, std::size_t known, const char* what) {
    if (missing == 0)
        std::printf("%s  complete: %zu %s\n", file.c_str(), known, what);
    else
        std::printf("%s  %zu %s are missing\n", file.c_str(), missing, what);
    std::fflush(stdout);
}

/// What is missing of directions; a checkpoint beside the table keeps what an interrupted run has done.
void complete_rows(const Suite& suite, const SuiteAir& air, TruthKind kind, std::span<const ProbeRow> wanted,
                   const TraceSettings& settings, Backend& backend) {
    if (wanted.empty()) return;
    const std::filesystem::path file = truth_file(suite, air, kind), checkpoint = file.string() + ".checkpoint";
    const TraceParameters parameters = truth_parameters(air);
    TruthTable table = TruthTable::read(file, parameters, kind);
    const std::vector<ProbeRow> rows = table.missing(wanted, {settings.error, settings.max_paths});
    print_state(file, rows.size(), table.size(), "directions");
    if (rows.empty()) return;
    table.check_may_grow(file);
    Tracer tracer(backend, air.parameters, rows, settings);
    const TraceParameters traced = parameters_of(air.parameters, settings, backend);
    if (std::filesystem::exists(checkpoint)) read_checkpoint(checkpoint, traced, tracer);
    trace_all(tracer, traced, checkpoint, "the same command goes on from it");
    double worst = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const TraceResult result = tracer.result(i);
        table.set(rows[i], {{result.all.radiance, result.all.error}, result.paths});
        worst = std::max(worst, relative_error(result.all));
    }
    table.write(file, parameters);
    std::filesystem::remove(checkpoint);
    std::printf("%s  complete: %zu directions, greatest standard error of the new ones %.3g %%\n", file.c_str(), table.size(),
                100 * worst);
}

void complete_pictures(const Suite& suite, std::size_t index, Backend& backend) {
    std::vector<ProbeRow> rows;
    for (const std::size_t i : suite.scenes_of(index))
        if (suite.scenes[i].picture)
            for (const ProbeRow& row : picture_rows(suite.scenes[i])) rows.push_back(row);
    TraceSettings settings = settings_of(suite.airs[index]);
    settings.error = std::max(settings.error, picture_error);
    complete_rows(suite, suite.airs[index], TruthKind::picture, rows, settings, backend);
}

/// Scenes of an air that a table lacks, each traced and kept in turn.
class SceneByScene {
public:
    /// `wanted`: how well values must be known.
    SceneByScene(const Suite& suite, std::size_t air, TruthKind kind, const TruthTable::Wanted& wanted)
        : air_(suite.airs[air]),
          wanted_(wanted),
          file_(truth_file(suite, air_, kind)),
          parameters_(truth_parameters(air_)),
          table_(TruthTable::read(file_, parameters_, kind)) {}

    /// `keys`: where a scene's values stand; `trace` puts all of them into the table.
    template <class Keys, class Trace>
    void complete(const std::vector<const SuiteScene*>& scenes, const Keys& keys, const Trace& trace) {
        std::vector<const SuiteScene*> missing;
        for (const SuiteScene* scene : scenes)
            if (!table_.missing(keys(*scene), wanted_).empty()) missing.push_back(scene);
        print_state(file_, missing.size(), scenes.size(), "scenes");
        if (missing.empty()) return;
        table_.check_may_grow(file_);
        Progress progress(missing.size() * progress_steps, stderr, isatty(STDERR_FILENO) == 1);
        for (std::size_t i = 0; i < missing.size(); ++i) {
            trace(*missing[i], [&](double share) {
                progress.reach(i * progress_steps + static_cast<std::size_t>(share * (progress_steps - 1)));
            });
            table_.write(file_, parameters_);
            progress.reach((i + 1) * progress_steps);
        }
    }
    [[nodiscard]] TruthTable& table() { return table_; }

private:
    const SuiteAir& air_;
    TruthTable::Wanted wanted_;
    std::filesystem::path file_;
    TraceParameters parameters_;
    TruthTable table_;
};

void complete_aerial(const Suite& suite, std::size_t index, Backend& backend) {
    const SuiteAir& air = suite.airs[index];
    std::vector<const SuiteScene*> scenes;
    for (const std::size_t i : suite.scenes_of(index))
        if (suite.scenes[i].aerial) scenes.push_back(&suite.scenes[i]);
    if (scenes.empty()) return;
    const TraceSettings settings = settings_of(air);
    SceneByScene work(suite, index, TruthKind::aerial, {settings.error, settings.max_paths});
    work.complete(
        scenes,
        [](const SuiteScene& scene) {
            std::vector<ProbeRow> rows;
            for (std::size_t i = 0; i < aerial_pixels; ++i) rows.push_back(aerial_row(aerial_view(scene), i));
            return rows;
        },
        [&](const SuiteScene& scene, const std::function<void(double)>& progress) {
            const AerialView view = aerial_view(scene);
            const AerialTruth truth = trace_aerial(backend, air.parameters, view, settings, progress).value();
            for (std::size_t i = 0; i < aerial_pixels; ++i)
                work.table().set(aerial_row(view, i), {{truth.pixels[i].radiance, truth.pixels[i].error}, truth.paths[i]});
        });
}

void complete_light(const Suite& suite, std::size_t index, Backend& backend) {
    const SuiteAir& air = suite.airs[index];
    std::vector<const SuiteScene*> scenes;
    for (const std::size_t i : suite.scenes_of(index)) scenes.push_back(&suite.scenes[i]);
    TraceSettings settings = settings_of(air);
    settings.error = std::max(settings.error, light_error);
    settings.max_paths = std::min(settings.max_paths, light_max_paths);
    SceneByScene work(suite, index, TruthKind::light, {settings.error, settings.max_paths});
    work.complete(
        scenes,
        [](const SuiteScene& scene) {
            return std::vector{light_row(scene, LightPart::sky), light_row(scene, LightPart::sun)};
        },
        [&](const SuiteScene& scene, const std::function<void(double)>& progress) {
            const LightPlace place{scene.sun_zenith_deg(), scene.altitude_km()};
            const LightTruth truth = trace_light(backend, air.parameters, place, settings, progress).value();
            const Estimated& sky = truth.sky_irradiance_up;
            work.table().set(light_row(scene, LightPart::sky), {{sky.radiance, sky.error}, truth.paths});
            work.table().set(light_row(scene, LightPart::sun), {{truth.sun_irradiance, Rgb(0)}, 0});
        });
}

void run_truth(const TruthOptions& options) {
    Suite suite = read_suite(find_suite(options.suite));
    keep_airs(suite, options.airs);
    std::filesystem::create_directories(suite.truth_folder);
    const std::unique_ptr<Backend> backend = open_backend(options.backend);
    for (std::size_t i = 0; i < suite.airs.size(); ++i) {
        for (const TruthRows& sky : truth_rows(suite, i)) {
            TraceSettings settings = settings_of(suite.airs[i]);
            settings.error = sky.error;
            settings.max_paths = static_cast<std::uint64_t>(sky.max_paths);
            complete_rows(suite, suite.airs[i], TruthKind::sky, sky.rows, settings, *backend);
        }
        complete_aerial(suite, i, *backend);
        complete_light(suite, i, *backend);
        complete_pictures(suite, i, *backend);
    }
    backend->close();
}

}  // namespace

void add_truth_command(CLI::App& program) {
    auto options = std::make_shared<TruthOptions>();
    CLI::App* command = program.add_subcommand(
        "truth",
        "The truth of a suite's scenes, for `aureole measure`: traces what is missing in the tables of the folder truth beside "
        "the suite (radiance of the sky, of geometry through the air, light), until the suite's truth_error is reached. May be "
        "interrupted (Ctrl-C) and run again: it goes on from what is kept every half minute, or after each scene");
    command
        ->add_option("SUITE", options->suite,
                     "One of the program's own suites by its name, or a file (TOML); tables are written to the folder truth "
                     "beside it")
        ->required();
    command->add_option("--airs", options->airs, "Only these airs of the suite, by name, separated by commas")->delimiter(',');
    add_backend_options(*command, options->backend);
    command->callback([options] { run_truth(*options); });
}

}  // namespace aureole::app
