#include "app/commands.h"

#include <algorithm>
#include <charconv>

namespace aureole::app {

void add_backend_options(CLI::App& command, BackendOptions& options) {
    command
        .add_option("--backend", options.name,
                    "Where to run: vulkan; cpu (float, as a GPU); cpu-double (the reference); auto: vulkan where there is a "
                    "device, else cpu")
        ->check(CLI::IsMember({"auto", "vulkan", "cpu", "cpu-double"}))
        ->default_str(options.name);
    command.add_option("--device", options.device, "Vulkan: part of the device's name, as `aureole devices` shows it");
    command.add_flag("--validation", options.validation,
                     "Vulkan: run under the validation layer; what it reports makes the command fail");
    command.add_option("--threads", options.threads, "CPU backends: number of threads, 0 for one a processor core")
        ->check(whole_number(0, 1024))
        ->default_str("0");
}

std::vector<std::string> strings(std::span<const std::string_view> names) { return {names.begin(), names.end()}; }

SceneModel ModelOptions::of(const SceneModel& scene) const {
    return {model.empty() ? scene.name : model, quality.empty() ? scene.quality : quality,
            spectral.empty() ? scene.spectral : spectral};
}

void add_model_options(CLI::App& command, ModelOptions& options) {
    command.add_option("--model", options.model, "What makes the sky, instead of the scene's: a model below")
        ->check(CLI::IsMember(strings(model_names())));
    command.add_option("--quality", options.quality, "How finely the model works, instead of the scene's")
        ->check(CLI::IsMember(strings(quality_names())));
    command
        .add_option(
            "--spectral", options.spectral,
            "Colours, instead of the scene's: rgb, or a number of wavelengths (3, 4 and 6 are fitted, others evenly spread)")
        ->check(wavelengths());
    command.footer("Models:\n" + list_models("  "));
}

CLI::Validator wavelengths() {
    const std::string range = "rgb, or 3 to 42";
    return {[=](std::string& text) -> std::string {
                std::string number = text;
                return text == "rgb" || whole_number(3, 42)(number).empty() ? "" : text + " is not allowed; allowed: " + range;
            },
            range};
}

std::string list_models(const std::string& indent) {
    std::string text;
    for (const std::string_view name : model_names()) {
        std::string column(name);
        column.resize(std::max<std::size_t>(column.size(), 12), ' ');
        text.append(text.empty() ? "" : "\n").append(indent).append(column).append(model_summary(name));
    }
    return text;
}

CLI::Validator whole_number(std::uint32_t low, std::uint32_t high) {
    const std::string range = std::to_string(low) + " to " + std::to_string(high);
    return {[=](std::string& text) -> std::string {
                const char* end = text.data() + text.size();
                std::uint32_t value = 0;
                const auto read = std::from_chars(text.data(), end, value);
                const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
                if (read.ptr != end || !digits) return "\"" + text + "\" is not a whole number; allowed: " + range;
                if (read.ec != std::errc() || value < low || value > high) return text + " is not allowed; allowed: " + range;
                return {};
            },
            range};
}

Size parse_size(const std::string& text, const std::string& option) {
    Size size{};
    const char* end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width);
    const bool cross = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
    const auto height = cross ? std::from_chars(width.ptr + 1, end, size.height)
                              : std::from_chars_result{text.data(), std::errc::invalid_argument};
    const auto inside = [](std::uint32_t n) { return n >= 1 && n <= 16384; };
    if (height.ec != std::errc() || height.ptr != end || !inside(size.width) || !inside(size.height))
        throw Error(ErrorCode::invalid_argument, option, "\"" + text + "\"", "WIDTHxHEIGHT in pixels, each in [1, 16384]");
    return size;
}

}  // namespace aureole::app
