// Aureole in OGRE: terrain, sky and air of a scene file, drawn by an engine that nobody here wrote. See ogre.md.
#include "app/commands.h"
#include "app/meter.h"
#include "compare.h"
#include "engine.h"
#include "io/image.h"
#include "land_mesh.h"
#include "sky.h"
#include "window.h"

#include <OgreCamera.h>
#include <OgreException.h>
#include <OgreSceneNode.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

namespace aureole::ogre {
namespace {

constexpr int failed = 2, no_display = 77;
constexpr double degree = std::numbers::pi / 180;
constexpr double least_clearance_m = 2;
constexpr std::uint32_t frames_a_metering = 16;

struct Options {
    std::filesystem::path scene, screenshot;
    std::string size = "1280x720";
    std::uint32_t frames = 0;
    bool compare = false, dive = false;
};

class Program {
public:
    Program(const Options& options, const app::Scene& scene)
        : options_(options),
          scene_(scene),
          size_(app::parse_size(options.size)),
          window_(size_.width, size_.height, options.frames == 0),
          axes_(scene.atmosphere.planet.bottom_radius_m),
          engine_(size_.width, size_.height),
          land_(make_land(engine_.scene(), scene, axes_)) {
        window_.listen();
        sky_.emplace(engine_, scene);
        const app::SceneCamera& camera = scene.camera;
        altitude_m_ = camera.clearance_m ? land_.land->ground_m() + *camera.clearance_m : camera.altitude_m;
        position_ = {0, altitude_m_, 0};
        pose_ = camera.pose;
        if (!scene_.suns.empty()) sun_ = scene_.suns.front().pose;
        stops_ = scene.exposure.stops;
        engine_.camera().setFOVy(Ogre::Degree(static_cast<float>(camera.vertical_fov_deg)));
        engine_.camera().setAspectRatio(static_cast<float>(size_.width) / static_cast<float>(size_.height));
        engine_.camera().setNearClipDistance(5);
        engine_.camera().setFarClipDistance(static_cast<float>(scene.terrain->range_m));
        eye().setFixedYawAxis(true);
        engine_.set_after_scene([this] { sky_->draw(); });
    }

    void run() {
        const std::uint32_t light_is_late = 1;  // of a frame: read back from the one before
        for (std::uint32_t frame = 0; options_.frames == 0 || frame < options_.frames + light_is_late; ++frame) {
            const Steering steering = window_.steer();
            if (steering.quit) break;
            steer(options_.dive ? down() : steering);
            // Reading a picture back makes the device wait: at a window seldom, but in each of a few frames without one.
            if (!scene_.exposure.factor && frame > 0 && (options_.frames != 0 || frame % frames_a_metering == 1)) meter();
            draw();
            const bool last = options_.frames != 0 && frame == options_.frames + light_is_late - 1;
            if (last && !options_.screenshot.empty())
                app::write_png(options_.screenshot, {size_.width, size_.height, engine_.read_window()});
            window_.swap();
            if (const std::string messages = window_.take_messages(); !messages.empty())
                throw Error(ErrorCode::internal, "OpenGL: " + messages);
        }
        std::printf("Aureole's part of the last frame: %.2f ms\n", sky_->milliseconds());
    }

    /// Camera and land, for who wants to know whether one is above the other.
    void check_clearance() const {
        const double above = clearance_m();
        std::printf("the camera is %.2f m above the land\n", above);
        if (!(above >= 0.99 * least_clearance_m)) throw Error(ErrorCode::internal, "the camera is inside the land");
    }

    void compare() const {
        const Comparison comparison = ogre::compare(engine_, scene_, altitude_m_);
        std::printf("%s\n", comparison.text().c_str());
        if (const std::string complaint = comparison.complaint(); !complaint.empty())
            throw Error(ErrorCode::internal, "the picture is not the CPU's: " + complaint);
    }

private:
    Ogre::SceneNode& eye() { return *engine_.camera().getParentSceneNode(); }

    /// Far ahead and down in every frame.
    static Steering down() {
        Steering steering;
        steering.forward_m = 900;
        steering.up_m = -500;
        return steering;
    }

    /// Height above the land below the camera, along the vertical of where it is, on a round planet.
    [[nodiscard]] double clearance_m() const {
        const glm::dvec3 place = axes_.to_scene(position_);
        return glm::length(place) - scene_.atmosphere.planet.bottom_radius_m - land_.land->ground_m(place);
    }

    void steer(const Steering& steering) {
        pose_.bearing_deg += steering.turn_right / degree;
        pose_.elevation_deg = std::clamp(pose_.elevation_deg + steering.turn_up / degree, -89.0, 89.0);
        const glm::dvec3 forward = Axes::direction(app::direction_of(pose_));
        const glm::dvec3 right = Axes::direction(app::direction_of({pose_.bearing_deg + 90, 0}));
        position_ += steering.forward_m * forward + steering.right_m * right + glm::dvec3(0, steering.up_m, 0);
        stay_above_land();
        sun_.elevation_deg = std::clamp(sun_.elevation_deg + steering.sun_higher_deg, -90.0, 90.0);
        sun_.bearing_deg += steering.sun_clockwise_deg;
        stops_ += steering.stops;
        eye().setPosition(to_ogre(position_));
        eye().setDirection(to_ogre(forward), Ogre::Node::TS_WORLD);
    }

    void stay_above_land() {
        const double above = clearance_m();
        if (above < least_clearance_m)
            position_ += (least_clearance_m - above) * Axes::direction(glm::normalize(axes_.to_scene(position_)));
    }

    /// What the meter (app/meter.h) says of the picture of the frame before: every fourth pixel of every fourth row.
    void meter() {
        const app::Thinned some = app::thinned(Engine::read(engine_.picture()), size_.width, size_.height, 4);
        const Camera camera = app::camera_of(scene_, altitude_m_, some.width, some.height);
        metered_ = app::automatic_exposure(some.rgba, app::solid_angles(camera, some.width, some.height));
    }

    void draw() {
        std::vector<Sun> suns = app::suns_of(scene_);
        for (Sun& sun : suns) sun.direction = Axes::direction(sun.direction);
        if (!suns.empty()) suns.front().direction = Axes::direction(app::direction_of(sun_));
        sky_->update(camera_of(engine_.camera(), axes_), suns);
        engine_.set_exposure(static_cast<float>(scene_.exposure.factor.value_or(metered_) * std::exp2(stops_)));
        engine_.draw_frame();
    }

    const Options& options_;
    const app::Scene& scene_;
    app::Size size_;
    Window window_;
    Axes axes_;
    Engine engine_;
    LandMesh land_;
    std::optional<Sky> sky_;
    double altitude_m_ = 0, stops_ = 0, metered_ = 1;
    glm::dvec3 position_{};  // along OGRE's axes
    app::ScenePose pose_, sun_;
};

void run(const Options& options) {
    const app::Scene scene = app::read_scene(options.scene);
    if (!scene.terrain || scene.camera.projection != Projection::matrix)
        throw Error(ErrorCode::invalid_argument, "SCENE", options.scene.string(), "a scene with a [terrain] section");
    Program program(options, scene);
    program.run();
    if (options.compare) program.compare();
    if (options.dive) program.check_clearance();
}

int main(int argc, char** argv) {
    Options options;
    CLI::App app(
        "A scene with terrain in OGRE, its sky and air by Aureole. W A S D Q E and the left mouse button fly (Shift: fast), "
        "arrow keys move the sun, comma and period change the exposure, Escape ends.");
    app.add_option("SCENE", options.scene, "Scene file with a [terrain] section (docs/scenes.md)")->required();
    app.add_option("--size", options.size, "WIDTHxHEIGHT in pixels")->default_str(options.size);
    CLI::Option* frames = app.add_option("--frames", options.frames, "Draw so many frames without a window, and end")
                              ->check(app::whole_number(1, 100000));
    app.add_option("--screenshot", options.screenshot, "PNG file of the last frame")->needs(frames);
    app.add_flag("--compare", options.compare,
                 "Compare the last frame with the CPU backend's; a difference makes the program fail")
        ->needs(frames);
    app.add_flag("--dive", options.dive, "Fly ahead and down into the land; a camera inside it makes the program fail")
        ->needs(frames);
    CLI11_PARSE(app, argc, argv);
    try {
        run(options);
        return 0;
    } catch (const Error& error) {
        std::fprintf(stderr, "aureole_ogre: %s\n", error.what());
        return error.code() == ErrorCode::unsupported ? no_display : failed;
    } catch (const Ogre::Exception& error) {
        std::fprintf(stderr, "aureole_ogre: %s\n", error.getFullDescription().c_str());
        return failed;
    }
}

}  // namespace
}  // namespace aureole::ogre

int main(int argc, char** argv) { return aureole::ogre::main(argc, argv); }
