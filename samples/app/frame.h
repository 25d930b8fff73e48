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
    bool linear = false;        ///< Scene-linear floats (for EXR), not what a display takes.
    bool raster = false;        ///< Composite with a full-screen draw instead of compute.
    std::uint32_t samples = 1;  ///< Pixels are averages of samples by samples, in [1, 4].
};

struct Frame {
    DisplayImage display;  ///< Unless FrameOptions::linear.
    LinearImage linear;    ///< Radiance, not exposed.
    double exposure = 1;
    std::vector<PassTime> times;
};

class FrameRenderer {
public:
    /// `backend` and `land` (null: none) must outlive the renderer. Throws Error(unsupported) naming --size and --samples if
    /// the device takes no picture of samples times the size. A model that takes no shadows in the air (fog, reference) goes
    /// without, and the log says so.
    FrameRenderer(Backend& backend, const Scene& scene, const Land* land, const FrameOptions& options);
    ~FrameRenderer();

    /// The scene under these suns. `number` counts frames; the dither pattern moves with it. Times are of passes that have run
    /// before, without what a driver does at a pipeline's first use; of air with tables of its own (TabulatedProfile,
    /// TabulatedPhase) transmittance and multi_scatter are the exception. `after_round` is called rounds() times.
    [[nodiscard]] Frame render(const std::vector<Sun>& suns, std::uint64_t number = 0,
                               const std::function<void()>& after_round = {});
    /// Rounds of a picture: 1 for all models but `reference` (rounds.h).
    [[nodiscard]] std::uint32_t rounds() const noexcept { return rounds_ ? rounds_->count : 1; }

private:
    struct Canvas;
    struct Target;
    struct Display;
    [[nodiscard]] bool averaged() const noexcept { return rounds_ && rounds_->averaged(); }
    void make_targets();
    void draw(Frame& frame, std::uint64_t number, const std::function<void()>& after_round);
    void warm_up(const Camera& camera, const std::vector<Sun>& suns);
    void record_air(std::vector<PassTime>& times);
    [[nodiscard]] double measure_exposure(const std::vector<Sun>& suns, const std::optional<TerrainLight>& light);

    Backend& backend_;
    const Scene& scene_;
    const Land* land_;
    FrameOptions options_;
    double camera_altitude_m_;
    std::optional<Rounds> rounds_;
    Atmosphere air_;                      ///< That of the meter and of the land's light, and of the picture as a rule.
    std::unique_ptr<Atmosphere> traced_;  ///< That of the picture, with rounds.
    std::unique_ptr<Target> target_, meter_;
    std::unique_ptr<Display> display_;  ///< Of a mean of composites.
    std::vector<PassTime> air_times_;   ///< Of a solution that the warm-up has made.
    bool warm_ = false;
};

/// Averages blocks of samples by samples. Sums of 8-bit values are rounded by an ordered pattern, so that averaging does not
/// undo the dither.
[[nodiscard]] DisplayImage downsample(std::span<const std::uint8_t> rgba, std::uint32_t width, std::uint32_t height,
                                      std::uint32_t samples);
[[nodiscard]] LinearImage downsample(std::span<const float> rgba, std::uint32_t width, std::uint32_t height,
                                     std::uint32_t samples);

}  // namespace aureole::app
