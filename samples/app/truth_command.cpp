#include "app/commands.h"
#include "app/suites.h"
#include "app/trace_run.h"
#include "measure/truth.h"

#include <cstdio>
#include <memory>

namespace aureole::app {
namespace {

struct TruthOptions {
    std::string suite = "small";
    BackendOptions backend{.name = "cpu-double"};
};

/// What is missing of one air's table; a checkpoint beside the table keeps what an interrupted run has done.
void complete(const Suite& suite, std::size_t index, Backend& backend) {
    const SuiteAir& air = suite.airs[index];
    const std::filesystem::path file = truth_file(suite, air), checkpoint = file.string() + ".checkpoint";
    const TraceParameters parameters = truth_parameters(air);
    TruthTable table = TruthTable::read(file, parameters);
    const std::vector<ProbeRow> rows = table.missing(truth_rows(suite, index));
    if (rows.empty()) {
        std::printf("%s  complete: %zu directions\n", file.c_str(), table.size());
        return;
    }
    std::printf("%s  %zu directions of %zu are missing\n", file.c_str(), rows.size(), table.size() + rows.size());
    std::fflush(stdout);
    const TraceSettings settings{
        .error = suite.truth_error, .max_paths = static_cast<std::uint64_t>(suite.truth_max_paths), .spectral = air.spectral};
    Tracer tracer(backend, air.parameters, rows, settings);
    const TraceParameters traced = parameters_of(air.parameters, settings, backend);
    if (std::filesystem::exists(checkpoint)) read_checkpoint(checkpoint, traced, tracer);
    trace_all(tracer, traced, checkpoint);
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

void run_truth(const TruthOptions& options) {
    const Suite suite = read_suite(find_suite(options.suite));
    std::filesystem::create_directories(suite.truth_folder);
    const std::unique_ptr<Backend> backend = open_backend(options.backend);
    for (std::size_t i = 0; i < suite.airs.size(); ++i) complete(suite, i, *backend);
    backend->close();
}

}  // namespace

void add_truth_command(CLI::App& program) {
    auto options = std::make_shared<TruthOptions>();
    CLI::App* command = program.add_subcommand(
        "truth",
        "True radiances of a suite's scenes, for `aureole measure`: traces what is missing in the tables of the folder truth "
        "beside the suite, one for each air, until the suite's truth_error is reached. May be interrupted (Ctrl-C) and run "
        "again: it goes on from a checkpoint that is written every half minute");
    command
        ->add_option("SUITE", options->suite,
                     "One of the program's own suites by its name, or a file (TOML); tables are written to the folder truth "
                     "beside it")
        ->required();
    add_backend_options(*command, options->backend);
    command->callback([options] { run_truth(*options); });
}

}  // namespace aureole::app
