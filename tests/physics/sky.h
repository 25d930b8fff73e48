// What the library shows, asked direction by direction: every radiance here has gone through Atmosphere, View and composite.
#pragma once

#include <aureole/atmosphere.h>
#include <aureole/models/aureole.h>
#include <aureole/presets.h>

#include "physics/machine.h"

#include <glm/vec3.hpp>
#include <numbers>

namespace aureole::physics {

inline constexpr double pi = std::numbers::pi;
inline constexpr double degree = pi / 180;

/// Unit vector of a zenith angle and an azimuth (from +x) where +z is up.
[[nodiscard]] glm::dvec3 direction(double zenith_rad, double azimuth_rad = 0);
/// A sun of irradiance 1 in the plane of +x and up, without limb darkening.
[[nodiscard]] Sun sun_at(double zenith_rad, double angular_radius_rad = 0);

/// Few tests are about the default tables' sizes: finer ones, for everything that must hold exactly.
[[nodiscard]] QualitySettings fine();

/// The same where a second scattering does not matter: next to nothing is spent on it.
[[nodiscard]] QualitySettings fine_single();

/// One term of air that fills the shell evenly: exponential with a scale height far beyond it.
[[nodiscard]] DensityTerm even_term(const Rgb& scattering_per_m, const Rgb& absorption_per_m, const PhaseFunction& phase);

struct SkyOptions {
    QualitySettings quality = fine();
    ModelPtr model = nullptr;  ///< Null: the model `aureole` with `quality`.
    bool sun_disk = false;
    double sun_lobe_g = 0;
    double beyond = 0;  ///< Radiance of what lies behind the air, in all directions.
    bool light = false;
    std::uint32_t suns = 1;
};

class Sky {
public:
    Sky(Machine& machine, const AtmosphereParameters& parameters, const SkyOptions& options = {});
    ~Sky();
    Sky(const Sky&) = delete;
    Sky& operator=(const Sky&) = delete;

    /// Camera above the +z pole.
    void stand(double altitude_m, const Sun& sun);
    void place(const glm::dvec3& position_m, std::span<const Sun> suns);

    [[nodiscard]] std::vector<Rgb> radiance(std::span<const glm::dvec3> directions);
    [[nodiscard]] Rgb radiance(const glm::dvec3& direction);
    /// Texels of the light table (needs options.light).
    [[nodiscard]] std::vector<glm::dvec4> light();

    [[nodiscard]] Atmosphere& air() { return air_; }
    [[nodiscard]] View& view() { return view_; }
    [[nodiscard]] Machine& machine() { return machine_; }
    /// Records and runs whatever is due.
    void update_tables();

private:
    void look_at(std::span<const glm::dvec3> directions);

    Machine& machine_;
    std::uint32_t suns_;
    Atmosphere air_;
    View view_;
    CompositeTargets targets_;
    rhi::State directions_state_ = rhi::State::undefined;
};

/// A picture of geometry at chosen distances, seen through the air.
class Picture {
public:
    static constexpr std::uint32_t width = 16, height = 12;

    Picture(Machine& machine, const AtmosphereParameters& parameters, const ModelPtr& model, double last_slice_m,
            std::uint32_t suns = 1);
    /// The model `aureole`.
    Picture(Machine& machine, const AtmosphereParameters& parameters, const QualitySettings& quality, double last_slice_m,
            std::uint32_t suns = 1)
        : Picture(machine, parameters, models::aureole(quality), last_slice_m, suns) {}
    ~Picture();
    Picture(const Picture&) = delete;
    Picture& operator=(const Picture&) = delete;

    void place(const Camera& camera, std::span<const Sun> suns);
    /// World direction of a pixel's centre, worked out from the camera alone.
    [[nodiscard]] glm::dvec3 direction(std::uint32_t x, std::uint32_t y) const;
    /// Row by row: geometry of this colour at this distance from the camera in every pixel.
    [[nodiscard]] std::vector<Rgb> render(double distance_m, const Rgb& color);
    /// The same, each pixel with its own: width x height of each.
    [[nodiscard]] std::vector<Rgb> render(std::span<const double> distances_m, std::span<const Rgb> colors);
    [[nodiscard]] Atmosphere& air() { return air_; }
    [[nodiscard]] View& view() { return view_; }

private:
    Machine& machine_;
    Atmosphere air_;
    View view_;
    CompositeTargets targets_;
    Camera camera_;
    bool filled_ = false;
};

[[nodiscard]] double sum(const Rgb& color);
/// Sum of |a - b| over the channels, relative to the sum of b; 0 if both are black.
[[nodiscard]] double apart(const Rgb& a, const Rgb& b);

}  // namespace aureole::physics
