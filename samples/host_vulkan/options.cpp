#include "host_vulkan/options.h"

#include "app/commands.h"

namespace host_vulkan {

std::optional<Options> parse(int argc, char** argv, int& code) {
    using aureole::app::whole_number;
    Options options;
    std::string size, async = "off";
    CLI::App program("A small renderer with a Vulkan device of its own, and Aureole as its guest.");
    program.add_option("--scene", options.scene, "Scene file (docs/scenes.md)")->required();
    program.add_option("--size", size, "WIDTHxHEIGHT of the window, in pixels")->default_str("1280x720");
    program.add_option("--frames", options.frames, "End after so many frames; without it when the window is closed (Escape)")
        ->check(whole_number(1, 1000000));
    program.add_option("--resize-every", options.resize_every, "Give the window another size after each N frames")
        ->check(whole_number(1, 1000000));
    program.add_option("--frames-in-flight", options.frames_in_flight, "Frames that the host is ahead of the device")
        ->check(whole_number(1, 4))
        ->default_str("2");
    program.add_option("--async-compute", async, "Aureole's tables on a second queue, between semaphores")
        ->check(CLI::IsMember({"on", "off"}))
        ->default_str("off");
    program
        .add_option("--sway", options.sway_deg,
                    "With --frames: camera and suns swing by DEG, back to where they were at the end")
        ->check(CLI::Range(-180.0, 180.0));
    program.add_option("--spheres", options.spheres, "Glass balls before the camera")
        ->check(whole_number(0, 8))
        ->default_str("5");
    program.add_option("--exposure", options.exposure, "In place of the scene's")->check(CLI::Range(1e-30, 1e30));
    program.add_option("--screenshot", options.screenshot, "With --frames: the last of them, as a PNG")->needs("--frames");
    program.add_flag("--validate", options.validate,
                     "Under the validation layer, with synchronization checks; messages fail the run");
    try {
        program.parse(argc, argv);
        if (!size.empty()) {
            const aureole::app::Size wanted = aureole::app::parse_size(size);
            options.size = {wanted.width, wanted.height};
        }
    } catch (const CLI::ParseError& problem) {
        code = program.exit(problem) == 0 ? 0 : 2;
        return {};
    }
    options.async_compute = async == "on";
    return options;
}

}  // namespace host_vulkan
