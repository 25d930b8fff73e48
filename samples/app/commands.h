// The commands of the application; each file <name>_command.cpp holds one.
#pragma once

#include "app/backend.h"
#include "scene/scene.h"

#include <CLI/CLI.hpp>

namespace aureole::app {

// Each adds itself with its options to `program`; the work is done in the callback, which throws aureole::Error.
void add_render_command(CLI::App& program);
void add_probe_command(CLI::App& program);
void add_score_command(CLI::App& program);
void add_trace_command(CLI::App& program);
void add_truth_command(CLI::App& program);
void add_measure_command(CLI::App& program);
void add_fit_command(CLI::App& program);
void add_plan_command(CLI::App& program);
void add_bench_command(CLI::App& program);
void add_report_command(CLI::App& program);
void add_devices_command(CLI::App& program);
void add_completion_command(CLI::App& program);
void add_man_command(CLI::App& program);

/// --backend (by default what `options` holds), --device, --validation, --threads.
void add_backend_options(CLI::App& command, BackendOptions& options);
/// What the scene says is replaced by what was asked for.
struct ModelOptions {
    std::string model, quality, spectral;  ///< Empty: as the scene says.
    [[nodiscard]] SceneModel of(const SceneModel& scene) const;
};
/// Checks the text of --spectral.
[[nodiscard]] CLI::Validator wavelengths();
/// --model, --quality and --spectral.
void add_model_options(CLI::App& command, ModelOptions& options);
/// Every model with a line on what it is, for help texts and `aureole devices`: each line begins with `indent`.
[[nodiscard]] std::string list_models(const std::string& indent);
/// The names as CLI11 takes them.
[[nodiscard]] std::vector<std::string> strings(std::span<const std::string_view> names);

/// Checks an option's text; messages tell what is no number from what is out of range.
[[nodiscard]] CLI::Validator whole_number(std::uint32_t low, std::uint32_t high);

struct Size {
    std::uint32_t width, height;
};
/// "1280x720". Throws Error(invalid_argument) naming `option` outside 1x1 to 16384x16384.
[[nodiscard]] Size parse_size(const std::string& text, const std::string& option = "--size");

}  // namespace aureole::app
