// From a scene to a picture, through the passes of the library.
#pragma once

#include "app/land.h"
#include "app/pass_times.h"
#include "app/rounds.h"
#include "io/image.h"

#include <aureole/atmosphere.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace aureole::app {

struct FrameOptions {
    std::uint32_t width = 1280, height = 720;
    bool linear = false;             ///< Scene-linear floats (for EXR), not what a display takes.
    bool raster = false;             ///< Composite with a full-screen draw instead of compute.
    std::uint32_t samples = 1;       ///< Pixels are averages of samples by samples, in [1, 4].
    ModelPtr model{};                ///< Instead of the scene's, none of rounds.h; null: the scene's.
    bool aerial_perspective = true;  ///< Of scenes with land: the air before it.
    bool warm_up = true;             ///< False: a driver's work at first use is part of the first picture's times.
};

struct Frame {
    DisplayImage display;  ///< Unless FrameOptions::linear.
    LinearImage linear;    ///< Radiance, not exposed.
    double exposure = 1;
    std::vector<PassTime> times;
    std::vector<PassReport> passes;  ///< Of the air, then of the view.
};

class FrameRenderer {
public:
    /// `backend`, `scene` and `land` (null: none) must outlive the renderer. Throws Error(unsupported) naming --size and
    /// --samples if the device takes no picture of samples times the size. A model that takes no shadows in the air (fog,
    /// reference) goes without, and the log says so.
    ///
    /// Between pictures the scene may change in its air, its camera (but for the projection), its suns (but for their number)
    /// and the value and stops of its exposure; the land follows it (Land::follow). All else takes a renderer of its own.
    FrameRenderer(Backend& backend, const Scene& scene, const Land* land, const FrameOptions& options);
    ~FrameRenderer();

    /// The scene under these suns. `number` counts frames; the dither pattern moves with it. Times are of passes that have run
    /// before, without what a driver does at a pipeline's first use; of air with tables of its own (TabulatedProfile,
    /// TabulatedPhase) transmittance and multi_scatter are the exception. `after_round` is called rounds() times.
    [[nodiscard]] Frame render(const std::vector<Sun>& suns, std::uint64_t number = 0,
                               const std::function<void()>& after_round = {});
    /// Rounds of a picture: 1 for all models but `reference` (rounds.h).
    [[nodiscard]] std::uint32_t rounds() const noexcept { return rounds_ ? rounds_->count : 1; }
    /// Of the picture, as they were last recorded: for tools that read tables back. And the air that meters.
    [[nodiscard]] const Atmosphere& air() const noexcept { return traced_ ? *traced_ : air_; }
    [[nodiscard]] Atmosphere& metering_air() noexcept { return air_; }
    [[nodiscard]] const View& view() const noexcept;

private:
    struct Canvas;
    struct Target;
    struct Display;
    [[nodiscard]] bool averaged() const noexcept { return rounds_ && rounds_->averaged(); }
    void make_targets();
    void draw(Frame& frame, std::uint64_t number, const std::function<void()>& after_round);
    void warm_up(const Camera& camera, const std::vector<Sun>& suns);
    void record_air(std::vector<PassTime>& times);
    void follow_air();
    [[nodiscard]] const TerrainLight& light_of_land(const std::vector<Sun>& suns);
    [[nodiscard]] double measure_exposure(const std::vector<Sun>& suns, const TerrainLight* light);
    [[nodiscard]] double camera_altitude_m() const { return land_ ? land_->camera_altitude_m() : scene_.camera.altitude_m; }

    Backend& backend_;
    const Scene& scene_;
    const Land* land_;
    FrameOptions options_;
    std::optional<Rounds> rounds_;
    Atmosphere air_;                      ///< That of the meter and of the land's light, and of the picture as a rule.
    std::unique_ptr<Atmosphere> traced_;  ///< That of the picture, with rounds.
    std::unique_ptr<Target> target_, meter_;
    std::unique_ptr<Display> display_;   ///< Of a mean of composites.
    std::vector<PassTime> air_times_;    ///< Of a solution that the warm-up has made.
    std::optional<TerrainLight> light_;  ///< Of `lit_by_`, in `lit_in_`.
    std::vector<Sun> lit_by_;
    AtmosphereParameters lit_in_;
    bool warm_ = false;
};

/// Exposure of a picture of this shape, stops included: the scene's own factor, or the meter's (meter.h), by a small picture on
/// the CPU backend: what FrameRenderer would expose it with.
[[nodiscard]] double exposure_of(const Scene& scene, std::uint32_t width, std::uint32_t height);

/// Averages blocks of samples by samples. Sums of 8-bit values are rounded by an ordered pattern, so that averaging does not
/// undo the dither.
[[nodiscard]] DisplayImage downsample(std::span<const std::uint8_t> rgba, std::uint32_t width, std::uint32_t height,
                                      std::uint32_t samples);
[[nodiscard]] LinearImage downsample(std::span<const float> rgba, std::uint32_t width, std::uint32_t height,
                                     std::uint32_t samples);

}  // namespace aureole::app
