// The command-line application `aureole`.
#include "app/commands.h"

#include <aureole/rhi/error.h>
#include <aureole/rhi/log.h>

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <cstdio>
#include <new>

namespace {

constexpr int failed = 2;

/// One line, whatever the message holds.
int complain(std::string message) {
    for (char& c : message)
        if (c == '\n') c = ' ';
    std::fprintf(stderr, "aureole: %s\n", message.c_str());
    return failed;
}

}  // namespace

int main(int argc, char** argv) {
    spdlog::set_default_logger(spdlog::stderr_logger_mt("aureole"));
    spdlog::set_pattern("aureole: %l: %v");
    spdlog::set_level(spdlog::level::warn);
    aureole::set_log(spdlog::default_logger());

    CLI::App program("Real-time planetary atmospheres: render scenes, probe radiances, measure costs.");
    program.footer(
        "Exit code: 0, or 2 with one line on stderr. Files appear complete or not at all.\n"
        "Run `aureole COMMAND --help` for a command's options.");
    program.require_subcommand(1);
    program.add_flag_callback(
        "--verbose", [] { spdlog::set_level(spdlog::level::debug); }, "Show the library's own messages");
    aureole::app::add_render_command(program);
    aureole::app::add_probe_command(program);
    aureole::app::add_score_command(program);
    aureole::app::add_bench_command(program);
    aureole::app::add_devices_command(program);
    try {
        program.parse(argc, argv);
        return 0;
    } catch (const CLI::CallForHelp& help) {
        return program.exit(help);
    } catch (const CLI::CallForAllHelp& help) {
        return program.exit(help);
    } catch (const CLI::ParseError& problem) {
        return complain(problem.what() + std::string(" (see aureole --help)"));
    } catch (const aureole::Error& problem) {
        return complain(problem.what());
    } catch (const std::bad_alloc&) {
        return complain("out of memory");
    } catch (const std::exception& problem) {
        return complain(problem.what());
    }
}
