// The command line as a whole: every command, and what becomes of errors.
#include "app/commands.h"
#include "app/run_program.h"

#include <aureole/rhi/error.h>
#include <aureole/rhi/log.h>

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <new>
#include <string>

namespace aureole::app {
namespace {

constexpr int failed = 2;

/// One line, whatever the message holds.
int complain(std::string message) {
    for (char& c : message)
        if (c == '\n') c = ' ';
    std::fprintf(stderr, "aureole: %s\n", message.c_str());
    return failed;
}

/// Said here because CLI11 only says that a command is missing.
void name_unknown_command(const CLI::App& program, int argc, char** argv) {
    const auto is_word = [](const char* argument) { return argument[0] != '-'; };
    char** const word = std::find_if(argv + 1, argv + argc, is_word);
    if (word == argv + argc) return;
    std::string known;
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
        if (command->get_name() == *word) return;
        known.append(known.empty() ? "" : ", ").append(command->get_name());
    }
    throw Error(ErrorCode::invalid_argument, "COMMAND", '"' + std::string(*word) + '"', known);
}

}  // namespace

int run_program(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the limit (ulimit -f) is told like a full disk
    spdlog::set_default_logger(spdlog::stderr_logger_mt("aureole"));
    spdlog::set_pattern("aureole: %l: %v");
    spdlog::set_level(spdlog::level::warn);
    set_log(spdlog::default_logger());

    CLI::App program("Real-time planetary atmospheres: render scenes, probe radiances, trace the truth, measure costs.");
    program.footer("Models (--model of render, probe and bench):\n" + list_models("  ") +
                   "\n\nExit code: 0, or 2 with one line on stderr. Files appear complete or not at all.\n"
                   "Run `aureole COMMAND --help` for a command's options.");
    program.require_subcommand(1);
    program.set_version_flag("--version", "aureole " AUREOLE_VERSION, "Print the version and exit");
    program.add_flag_callback(
        "--verbose", [] { spdlog::set_level(spdlog::level::debug); }, "Show the library's own messages");
    add_render_command(program);
    add_probe_command(program);
    add_score_command(program);
    add_trace_command(program);
    add_truth_command(program);
    add_measure_command(program);
    add_fit_command(program);
    add_plan_command(program);
    add_bench_command(program);
    add_report_command(program);
    add_devices_command(program);
    add_completion_command(program);
    add_man_command(program);
    try {
        name_unknown_command(program, argc, argv);
        program.parse(argc, argv);
        return 0;
    } catch (const CLI::Success& asked) {  // for help or for the version
        return program.exit(asked);
    } catch (const CLI::ParseError& problem) {
        return complain(problem.what() + std::string(" (see aureole --help)"));
    } catch (const Error& problem) {
        return complain(problem.what());
    } catch (const std::bad_alloc&) {
        return complain("out of memory");
    } catch (const std::exception& problem) {
        return complain(problem.what());
    }
}

}  // namespace aureole::app
