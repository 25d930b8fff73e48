// The commands of the application; each file <name>_command.cpp holds one.
#pragma once

#include "app/backend.h"

#include <CLI/CLI.hpp>

namespace aureole::app {

// Each adds itself with its options to `program`; the work is done in the callback, which throws aureole::Error.
void add_render_command(CLI::App& program);
void add_probe_command(CLI::App& program);
void add_score_command(CLI::App& program);
void add_bench_command(CLI::App& program);
void add_devices_command(CLI::App& program);

/// --backend, --device, --validation, --threads.
void add_backend_options(CLI::App& command, BackendOptions& options);
/// --quality with the four names; empty means what the scene says.
void add_quality_option(CLI::App& command, std::string& quality, const std::string& help);

/// Checks an option's text; messages tell what is no number from what is out of range.
[[nodiscard]] CLI::Validator whole_number(std::uint32_t low, std::uint32_t high);

struct Size {
    std::uint32_t width, height;
};
/// "1280x720". Throws Error(invalid_argument) outside 1x1 to 16384x16384.
[[nodiscard]] Size parse_size(const std::string& text);

}  // namespace aureole::app
