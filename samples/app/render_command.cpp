#include "app/commands.h"
#include "app/frame.h"
#include "app/progress.h"
#include "app/sequence.h"
#include "io/csv.h"
#include "io/file.h"

#include <unistd.h>
#include <cstdio>
#include <memory>
#include <new>

namespace aureole::app {
namespace {

struct RenderOptions {
    std::filesystem::path scene, output, height_map;
    BackendOptions backend;
    ModelOptions model;
    std::string size, projection, sun_elevation;
    std::uint32_t frames = 1, samples = 2;
    bool raster = false;
};

Scene load_scene(const RenderOptions& options) {
    Scene scene = read_scene(options.scene);
    scene.model = options.model.of(scene.model);
    if (options.projection == "perspective") scene.camera.projection = Projection::matrix;
    if (options.projection == "fisheye") scene.camera.projection = Projection::fisheye;
    if (options.projection == "panorama") scene.camera.projection = Projection::panorama;
    if (scene.terrain && scene.camera.projection != Projection::matrix)
        throw Error(ErrorCode::invalid_argument, "--projection", options.projection, "perspective, for a scene with terrain");
    if (!options.height_map.empty() && !scene.terrain)
        throw Error(ErrorCode::invalid_argument, "--heightmap", options.height_map.string(),
                    "a scene with a [terrain] section");
    if (!options.size.empty()) {
        const Size size = parse_size(options.size);
        scene.width = size.width;
        scene.height = size.height;
    }
    return scene;
}

bool is_linear(const std::filesystem::path& output) {
    const std::string extension = output.extension().string();
    if (extension != ".png" && extension != ".exr")
        throw Error(ErrorCode::invalid_argument, "--output", output.string(), "a name that ends in .png or .exr");
    return extension == ".exr";
}

void write_frame(const std::filesystem::path& path, const Frame& frame) {
    if (frame.linear.width > 0)
        write_exr(path, frame.linear);
    else
        write_png(path, frame.display);
}

void report(const std::filesystem::path& path, const FrameOptions& options, const Frame& frame) {
    std::printf("%s  %ux%u", path.c_str(), options.width, options.height);
    if (options.samples > 1)
        std::printf(", composite at %ux%u", options.width * options.samples, options.height * options.samples);
    if (!options.linear) std::printf(", exposure %.4g", frame.exposure);
    std::printf("\n  passes: %s\n", print_times(frame.times).c_str());
}

/// What the pictures of a sequence that are there already are called, for whoever reads that the next one failed.
std::string written_so_far(const RenderOptions& options, std::uint32_t count) {
    if (count == 0) return "no picture was written";
    const std::string first = numbered(options.output, 1).string(), last = numbered(options.output, count).string();
    const std::string names = count == 1 ? first : first + " .. " + last;
    return std::to_string(count) + " of " + std::to_string(options.frames) + " pictures were written: " + names;
}

void render_sequence(const RenderOptions& options, Scene& scene, FrameRenderer& renderer) {
    const SunPath path = parse_sun_path(options.sun_elevation, options.frames);
    if (scene.suns.empty())
        throw Error(ErrorCode::invalid_argument, "--sun-elevation", options.sun_elevation, "a scene with a [[sun]]");
    const std::uint32_t rounds = renderer.rounds();
    Progress progress(std::size_t{options.frames} * rounds, stderr, isatty(STDERR_FILENO) == 1);
    const auto after_round = [&, round = 0U]() mutable {
        if (++round % rounds != 0) progress.step();  // the last of a picture: once it is written
    };
    std::vector<PassTime> times;
    for (std::uint32_t i = 0; i < options.frames; ++i) {
        scene.suns.front().pose.elevation_deg = path.elevation_deg(i);
        try {
            const Frame frame = renderer.render(suns_of(scene), i, after_round);
            write_frame(numbered(options.output, i + 1), frame);
            times = frame.times;
        } catch (const Error& problem) {
            throw Error(problem.code(), problem.what() + ("; " + written_so_far(options, i)));
        } catch (const std::bad_alloc&) {
            throw Error(ErrorCode::out_of_memory, "out of memory; " + written_so_far(options, i));
        }
        progress.step();
    }
    std::printf("%s .. %s  %u pictures of %ux%u\n  passes of the last: %s\n", numbered(options.output, 1).c_str(),
                numbered(options.output, options.frames).c_str(), options.frames, scene.width, scene.height,
                print_times(times).c_str());
}

/// A bar for what is drawn in rounds.
Frame render_with_progress(FrameRenderer& renderer, const Scene& scene) {
    if (renderer.rounds() == 1) return renderer.render(suns_of(scene));
    Progress progress(renderer.rounds(), stderr, isatty(STDERR_FILENO) == 1);
    return renderer.render(suns_of(scene), 0, [&] { progress.step(); });
}

void render(const RenderOptions& options) {
    Scene scene = load_scene(options);
    FrameOptions frame_options;
    frame_options.width = scene.width;
    frame_options.height = scene.height;
    frame_options.linear = is_linear(options.output);
    frame_options.raster = options.raster;
    frame_options.samples = options.samples;
    const bool sequence = !options.sun_elevation.empty();
    // Said before the work, not after it.
    { const NewFile writable(sequence ? numbered(options.output, 1) : options.output); }

    std::unique_ptr<Land> land;
    if (scene.terrain)
        land = std::make_unique<Land>(scene, options.height_map.empty() ? scene.terrain->height_map : options.height_map);
    const std::unique_ptr<Backend> backend = open_backend(options.backend);
    std::printf("%s: %s, %s\n", options.scene.c_str(), backend->describe().c_str(), scene.model.describe().c_str());
    std::fflush(stdout);
    auto renderer = std::make_unique<FrameRenderer>(*backend, scene, land.get(), frame_options);
    if (sequence) {
        render_sequence(options, scene, *renderer);
        renderer.reset();
        backend->close();
        return;
    }
    const Frame frame = render_with_progress(*renderer, scene);
    renderer.reset();
    backend->close();
    write_frame(options.output, frame);
    report(options.output, frame_options, frame);
}

}  // namespace

void add_render_command(CLI::App& program) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App* command = program.add_subcommand("render", "Render a scene file into a picture, or into a sequence of them");
    command->add_option("SCENE", options->scene, "Scene file (TOML; docs/scenes.md)")->required();
    command
        ->add_option(
            "-o,--output", options->output,
            "Picture to write. .png: exposed, tone-mapped (ACES, fitted), sRGB, dithered to 8 bits; .exr: scene-linear "
            "Rec.709 radiance in 32-bit floats, in the unit of the sun's irradiance per steradian")
        ->required();
    add_backend_options(*command, options->backend);
    add_model_options(*command, options->model);
    command->get_option("--quality")
        ->description(
            "How finely the model works, instead of the scene's; of reference: 16, 64 or 256 paths a pixel of the picture, "
            "shared out "
            "over its --samples, in rounds with a progress bar");
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels, instead of the scene's");
    command->add_option("--projection", options->projection, "Instead of the scene's")
        ->check(CLI::IsMember({"perspective", "fisheye", "panorama"}));
    command->add_flag("--raster", options->raster, "Composite with a full-screen draw instead of a compute pass");
    command
        ->add_option("--samples", options->samples,
                     "Composite N by N times as many pixels and average them, 1 to 4: smooth edges of sun, horizon and land")
        ->check(whole_number(1, 4))
        ->default_str("2");
    command->add_option("--heightmap", options->height_map,
                        "Height map of a scene with terrain, instead of the scene's: jacksboro, or an .npz, .png or .exr file");
    CLI::Option* elevations = command->add_option(
        "--sun-elevation", options->sun_elevation,
        "FROM:TO in degrees above the horizon, each in [-90, 90]: a sequence in which the first sun moves evenly between them");
    CLI::Option* frames =
        command
            ->add_option(
                "--frames", options->frames,
                "Pictures in the sequence, 2 to 9999, written with their number: a %04d in the output's name, or -0001 "
                "before its extension")
            ->check(whole_number(2, 9999));
    elevations->needs(frames);
    frames->needs(elevations);
    command->callback([options] { render(*options); });
}

}  // namespace aureole::app
