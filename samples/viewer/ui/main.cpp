// aureole-viewer: see viewer.md.
#include "viewer/ui/app.h"

#include "app/commands.h"

#include <aureole/rhi/log.h>

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <cstdio>

namespace {

constexpr int failed = 2;
constexpr int no_window = 77;  ///< As tests say that they cannot run here.

int complain(const std::string& message, int code) {
    std::fprintf(stderr, "aureole-viewer: %s\n", message.c_str());
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    using namespace aureole;
    spdlog::set_default_logger(spdlog::stderr_logger_mt("aureole"));
    spdlog::set_pattern("aureole: %l: %v");
    spdlog::set_level(spdlog::level::warn);
    set_log(spdlog::default_logger());

    viewer::AppOptions options;
    std::string size;
    CLI::App program("Look at scenes from ground to orbit, and at models side by side.");
    program.add_option("SCENE", options.scene, "Scene file (TOML; docs/scenes.md); a morning on Earth without one");
    program.add_option("--script", options.script, "Commands in place of hands (samples/viewer/viewer.md)");
    program.add_option("--size", size, "WIDTHxHEIGHT of the window in pixels; 1280x760 without");
    program.add_option("--backend", options.backend, "What both panes begin with")
        ->check(CLI::IsMember({"vulkan", "cpu", "cpu-double"}))
        ->default_str(options.backend);
    program.add_flag("--validation", options.gpu.validation,
                     "Window and Vulkan panes under the validation layer; what it reports is a failure");
    program.add_flag("--srgb-surface", options.gpu.srgb_surface,
                     "A format of the window's surface that encodes sRGB by itself, as some systems have alone");
    program.footer("Exit code: 0; 77 where no window can be opened; else 2 with one line on stderr.");
    try {
        program.parse(argc, argv);
        if (!size.empty()) {
            const app::Size parsed = app::parse_size(size);
            options.width = parsed.width;
            options.height = parsed.height;
        }
        viewer::App(options).run();
        return 0;
    } catch (const CLI::Success& asked) {
        return program.exit(asked);
    } catch (const CLI::ParseError& problem) {
        return complain(problem.what(), failed);
    } catch (const Error& problem) {
        const bool window = std::string(problem.what()).starts_with("no window can be opened here");
        return complain(problem.what(), window ? no_window : failed);
    } catch (const std::exception& problem) {
        return complain(problem.what(), failed);
    }
}
