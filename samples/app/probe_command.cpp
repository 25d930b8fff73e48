#include "app/commands.h"
#include "app/probe.h"
#include "io/csv.h"
#include "io/file.h"
#include "scene/scene.h"

#include <cstdio>
#include <memory>

namespace aureole::app {
namespace {

struct ProbeOptions {
    std::filesystem::path scene, directions, output;
    ModelOptions model;
    BackendOptions backend;
};

void run_probe(const ProbeOptions& options) {
    const Scene scene = read_scene(options.scene);
    const SceneModel model = options.model.of(scene.model);
    const std::vector<ProbeRow> rows = read_probe_rows(options.directions);
    { const NewFile writable(options.output); }
    const std::unique_ptr<Backend> backend = open_backend(options.backend);
    const std::vector<Rgb> radiance = probe(*backend, scene.atmosphere, model.make(), rows);
    const std::string what = options.scene.filename().string() + ", " + backend->describe() + ", " + model.describe();
    backend->close();
    write_text(options.output,
               print_rows("radiance per unit of solar irradiance in 1/sr, without the sun's disk; " + what, rows, radiance));
    std::printf("%s  %zu directions\n  %s\n", options.output.c_str(), rows.size(), what.c_str());
}

}  // namespace

void add_probe_command(CLI::App& program) {
    auto options = std::make_shared<ProbeOptions>();
    CLI::App* command = program.add_subcommand("probe", "Radiance of single directions, through the same passes as a picture");
    command->add_option("--scene", options->scene, "Scene file; its atmosphere, model and quality are used")->required();
    command
        ->add_option(
            "--directions", options->directions,
            "CSV with a header line and the columns sun_zenith_deg (0 to 180), altitude_km (-10 to 1e9), view_zenith_deg "
            "(0 is up, to 180), azimuth_deg (from the sun's, -360 to 360); # starts a comment line, other columns are "
            "ignored")
        ->required();
    command
        ->add_option("-o,--output", options->output,
                     "CSV to write: the four columns and r, g, b, the radiance per unit of solar irradiance in 1/sr")
        ->required();
    add_backend_options(*command, options->backend);
    add_model_options(*command, options->model);
    command->callback([options] { run_probe(*options); });
}

}  // namespace aureole::app
