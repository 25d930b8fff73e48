// A small renderer with a Vulkan device of its own, and Aureole as its guest: host_vulkan.md.
#include "app/frame.h"
#include "host_vulkan/calls.h"
#include "host_vulkan/renderer.h"
#include "host_vulkan/script.h"
#include "recording/allocations.h"

#include <aureole/rhi/log.h>

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <algorithm>
#include <chrono>
#include <cstdio>

namespace {

using namespace host_vulkan;
using Clock = std::chrono::steady_clock;

/// What is told at the end. Frames count where nothing was resized, once each of those in flight has been used.
struct Tally {
    std::vector<double> frame_ms;
    std::uint32_t frames = 0, resizes = 0;
    int heap_allocations = 0;
    std::uint64_t vulkan_objects = 0;
};

void tell(const Options& options, const Device& device, const Tally& tally) {
    std::vector<double> ms = tally.frame_ms;
    std::ranges::sort(ms);
    const auto at = [&](double share) {
        return ms.empty() ? 0 : ms[static_cast<std::size_t>(share * static_cast<double>(ms.size() - 1))];
    };
    std::printf("%s, %ux%u, %u frames in flight\n", device.name.c_str(), options.size.width, options.size.height,
                options.frames_in_flight);
    std::printf("async compute: %s\n", options.async_compute ? device.describe_compute_queue() : "off");
    std::printf("frames: %u, resizes: %u\n", tally.frames, tally.resizes);
    std::printf("frame time: median %.2f ms, 95 %% %.2f ms\n", at(0.5), at(0.95));
    if (options.validate)
        std::printf("heap allocations: not counted, for the validation layer makes its own in the same calls\n");
    else
        std::printf("heap allocations in these frames: %d\n", tally.heap_allocations);
    std::printf("Vulkan objects and memory made in these frames: %llu\n",
                static_cast<unsigned long long>(tally.vulkan_objects));
    if (options.validate) std::printf("validation messages: %d\n", device.messages());
}

/// One frame, at whatever size the window has by then. True if nothing had to be made for it.
bool draw(Window& window, Renderer& renderer, Script& script, std::uint32_t frame, Tally& tally) {
    bool steady = true, stale = false;
    for (int attempt = 0; attempt < 4; ++attempt) {
        VkExtent2D size = window.size();
        while (size.width == 0 || size.height == 0) {  // minimized
            if (!window.poll()) return false;
            size = window.size();
        }
        const VkExtent2D now = renderer.extent();
        if (stale || size.width != now.width || size.height != now.height) {
            renderer.resize(size);
            ++tally.resizes;
            steady = false;
        }
        if (renderer.draw(script.camera(frame, renderer.extent()), script.suns(frame))) return steady;
        stale = true;
    }
    return false;
}

void run_frames(const Options& options, Window& window, Renderer& renderer, Script& script, Tally& tally) {
    const std::uint32_t warm_up = options.frames_in_flight + 2;
    Clock::time_point before = Clock::now();
    for (std::uint32_t frame = 0; window.poll() && (options.frames == 0 || frame < options.frames); ++frame) {
        const bool last = frame + 1 == options.frames;
        if (options.resize_every > 0) window.resize(script.size(frame));
        if (last && !options.screenshot.empty()) renderer.start_capture();
        const std::uint64_t made = vulkan_objects_made();
        aureole::recording::begin_counting_allocations();  // of the host's part and of Aureole's
        const bool steady = draw(window, renderer, script, frame, tally);
        const int heap_allocations = aureole::recording::end_counting_allocations();
        const Clock::time_point now = Clock::now();
        const double seconds = std::chrono::duration<double>(now - before).count();
        before = now;
        if (options.frames == 0) script.turn(window.turn(seconds));
        if (!steady || frame < warm_up) continue;
        ++tally.frames;
        tally.frame_ms.push_back(1e3 * seconds);
        tally.heap_allocations += heap_allocations;
        tally.vulkan_objects += vulkan_objects_made() - made;
    }
}

int run(const Options& options) {
    const aureole::app::Scene scene = aureole::app::read_scene(options.scene);
    if (scene.suns.size() > most_suns || scene.camera.projection != aureole::Projection::matrix)
        throw std::runtime_error("--scene: at most 4 suns, and a camera in perspective");
    const TerrainMesh mesh = make_terrain(scene);
    const double exposure =
        options.exposure ? *options.exposure : aureole::app::exposure_of(scene, options.size.width, options.size.height);
    Script script(scene, options, mesh.camera_altitude_m, exposure);
    RendererSettings settings;
    settings.frames_in_flight = options.frames_in_flight;
    settings.async_compute = options.async_compute;
    settings.spheres = place_spheres(scene, mesh, options.spheres);
    if (scene.terrain && scene.terrain->air_shadows_m > 0) settings.shadow_reach_m = scene.terrain->air_shadows_m;

    Window window("Aureole as a guest", options.size);
    Device device(window, options.validate);
    Tally tally;
    {
        Renderer renderer(device, window.size(), scene, mesh, settings);
        run_frames(options, window, renderer, script, tally);
        if (!options.screenshot.empty()) write_png(options.screenshot, renderer.take_capture());
    }
    tell(options, device, tally);
    return options.validate && device.messages() > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
    spdlog::set_default_logger(spdlog::stderr_logger_mt("host_vulkan"));
    spdlog::set_level(spdlog::level::warn);
    aureole::set_log(spdlog::default_logger());
    try {
        int code = 0;
        const std::optional<Options> options = parse(argc, argv, code);
        return options ? run(*options) : code;
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "host_vulkan: %s\n", problem.what());
        return 2;
    }
}
