// The envelope of stability, axis by axis: one number of a scene goes from one extreme to the other, and each model shows it on
// a device in float and in double.
#pragma once

#include "physics/sky.h"
#include "stability/rungs.h"

#include <aureole/parameters.h>

#include <array>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace aureole::stability {

/// All that a sky depends on.
struct Scene {
    AtmosphereParameters air{};
    double altitude_m = 2;
    double sun_elevation_deg = 50;
    double sun_radius_deg = 0.27;
    bool sun_disk = false;
    double irradiance = 1;
    std::uint32_t suns = 1;
    std::uint32_t finer = 1;  ///< Tables, along every side.

    [[nodiscard]] double shell_m() const { return air.planet.top_radius_m - air.planet.bottom_radius_m; }
    [[nodiscard]] std::vector<Sun> all_suns() const;
    /// Of views, the camera being above the z axis: over all angles, and where things happen: horizon, limb, sun, zenith,
    /// nadir.
    [[nodiscard]] std::vector<glm::dvec3> views() const;
};

/// What the others are varied about.
struct Base {
    const char* name;
    AtmosphereParameters air;
};
[[nodiscard]] std::span<const Base> bases();

/// One axis.
struct Sweep {
    const char* name;
    const char* unit;
    std::vector<double> values;
    void (*set)(Scene&, double value);

    /// The value in a base, at a few altitudes and hours where the axis is not one of these.
    [[nodiscard]] std::vector<Scene> scenes(const Base& base, double value) const;
};
[[nodiscard]] std::span<const Sweep> sweeps();
[[nodiscard]] const Sweep& sweep(std::string_view name);

/// What of a scene is looked at.
enum class Subject : std::uint8_t {
    sky,       ///< And bare ground, in the scene's views.
    geometry,  ///< Through the air: black and grey, 10 m to 50 km away, or from beyond the air as far above the ground.
};

/// One model on one device. Keeps what it has made for as long as scenes are of the same kind.
class Observer {
public:
    Observer(physics::Machine& machine, ModelPtr model) : machine_(machine), model_(std::move(model)) {}
    /// Radiance of the scene's views, or of a picture's pixels. Throws what the library does, and where one is not finite.
    [[nodiscard]] std::vector<Rgb> look(const Scene& scene, Subject subject = Subject::sky) {
        return subject == Subject::sky ? sky(scene) : geometry(scene);
    }
    /// Geometry so many steps of a float farther away, by a camera tilted by so many.
    [[nodiscard]] std::vector<Rgb> geometry(const Scene& scene, int farther = 0, int tilted = 0);
    /// Of the last geometry.
    [[nodiscard]] const std::vector<double>& distances_m() const { return distances_; }

private:
    [[nodiscard]] std::vector<Rgb> sky(const Scene& scene);

    physics::Machine& machine_;
    ModelPtr model_;
    std::unique_ptr<physics::Sky> sky_;
    std::unique_ptr<physics::Picture> picture_;
    std::vector<double> distances_;
    std::uint32_t suns_ = 0, suns_of_picture_ = 0;
    bool sun_disk_ = false;
};

/// What a model in float is compared with. Of geometry all that it may be by a distance and by directions in float: from two
/// steps of the distance in kilometres nearer to two steps farther, of 62.5 m at 10^6 km (the depth buffer's own, and that of
/// what is worked out from it), and from a step (1.2e-7 rad, less than a thousandth of a pixel) lower to a step higher.
struct Exact {
    std::vector<Rgb> here, least, most;
    /// Errors are relative to `here`, or to this where there is less, in each channel.
    Rgb least_light{0};
    /// The same of black geometry beside its own light.
    double faintest = 0;
    /// Pixels of black geometry that is a metre away at least: the distance axis of froxels up to 96 km has steps of
    /// millimetres.
    std::vector<std::size_t> black;
};

/// By the model in double. Less light than this is not looked at closely, of the sky: a thousandth of its mean away from the
/// sun, ten stops below what an exposure is made for. Of geometry: what coal sends, of reflectance 0.04, in that sky and in the
/// beam of the sun, in each channel. Of all: a thousandth of a night without a moon (1e-9 of the sun's); and with tables of
/// half floats a hundred of their smallest steps (6e-8 of the sun's), of which one is a per cent.
[[nodiscard]] Exact exact_look(Observer& in_double, const Scene& scene, Subject subject, bool half_tables);
/// Of each view, in the channel where it is largest.
[[nodiscard]] std::vector<double> relative_errors(std::span<const Rgb> seen, const Exact& exact);
/// Of each pixel of `Exact::black`, beside what the air before it sends, however little.
[[nodiscard]] std::vector<double> errors_of_black(std::span<const Rgb> seen, const Exact& exact);

}  // namespace aureole::stability
