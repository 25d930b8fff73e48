// The atmosphere module: owns its tables and records the passes that fill and use them into a host's command list.
//
//     Atmosphere air(device, presets::earth());  // tables of the planet: transmittance, multi-scatter
//     View view(air, {}, {.target_format = rhi::Format::rgba16_float});  // tables of a camera, and the composite
//     view.prepare_composite(targets);           // once for each set of textures
//     while (next_frame()) {
//         view.update(camera, suns);
//         air.record(commands);                  // nothing, unless the air has changed
//         view.record(commands);                 // nothing, unless camera, suns or air have changed
//         view.record_composite(commands, targets);
//     }
//
// Recording never allocates, submits, waits or throws. Constructors and set_* may allocate and throw aureole::Error, leaving
// everything as it was. One thread at a time may use an Atmosphere and its views.
#pragma once

#include <aureole/camera.h>
#include <aureole/parameters.h>
#include <aureole/quality.h>
#include <aureole/rhi/device.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aureole {

/// What one pass did in the latest recording: for benchmarks and for hosts that show their costs.
struct PassReport {
    std::string_view name{};  ///< "transmittance", "multi_scatter", "sky_view", "aerial_perspective", "light", "composite".
    bool recorded = false;    ///< False when nothing that it depends on had changed.
    std::uint64_t invocations = 0;  ///< Shader invocations.
    std::uint64_t bytes_written = 0;
};

/// Optional timestamps: pass i writes slots first_slot + 2 i and first_slot + 2 i + 1, in the order of the reports.
struct TimestampSlots {
    bool enabled = false;
    std::uint32_t first = 0;
};

class Atmosphere {
public:
    /// Creates pipelines and tables on `device`, which must outlive this object. Validates both arguments; throws
    /// Error(unsupported) naming what the device lacks.
    Atmosphere(rhi::Device& device, const AtmosphereParameters& parameters,
               const QualitySettings& quality = QualitySettings::standard());
    ~Atmosphere();
    Atmosphere(const Atmosphere&) = delete;
    Atmosphere& operator=(const Atmosphere&) = delete;

    /// New air or ground. Tables are rebuilt by the next record(), unless all is as it was. Throws and changes nothing if a
    /// value is rejected.
    void set_parameters(const AtmosphereParameters& parameters);
    [[nodiscard]] const AtmosphereParameters& parameters() const noexcept;
    [[nodiscard]] const QualitySettings& quality() const noexcept;

    /// Passes of the multi-scatter fixed point recorded by each record() after a change: 0 solves at once (default), n spreads
    /// the solution over frames, n passes each; the tables in use stay complete meanwhile.
    void set_multi_scatter_passes_per_frame(int passes);

    /// Frame number, in the host's counting, of the recording that follows: objects replaced by set_* die after it.
    void set_frame(std::uint64_t frame) noexcept;

    /// Records transmittance and multi-scatter if the air has changed. Tables are left in State::sampled.
    void record(rhi::CommandList& commands, TimestampSlots timestamps = {});
    [[nodiscard]] std::span<const PassReport> reports() const noexcept;

    [[nodiscard]] rhi::Device& device() const noexcept;
    [[nodiscard]] rhi::Texture transmittance_table() const noexcept;  ///< Optical depth to the top: see transmittance.glsl.
    [[nodiscard]] rhi::Texture multi_scatter_table() const noexcept;  ///< Moments: see multi_scatter.glsl.
    [[nodiscard]] std::uint64_t table_bytes() const noexcept;         ///< Device memory of the tables.

    struct Impl;
    [[nodiscard]] Impl& impl() const noexcept { return *impl_; }

private:
    std::unique_ptr<Impl> impl_;
};

enum class ToneMap : std::uint8_t { none, aces_fitted };

struct ViewSettings {
    Projection projection = Projection::matrix;    ///< Of every camera that the view is given: kernels are made for it.
    std::uint32_t max_suns = 1;                    ///< In [1, 4].
    bool aerial_perspective = true;                ///< False: no froxels; the composite leaves geometry as it is.
    double aerial_perspective_distance_m = 96000;  ///< Depth of the last slice. Finite, > 0.
    bool light = true;                             ///< Sun colour and SH-L2 sky irradiance for the host's own lights.
};

struct CompositeSettings {
    rhi::Format target_format = rhi::Format::rgba16_float;
    bool raster = false;       ///< Full-screen draw instead of compute.
    bool scene_color = false;  ///< The host gives its colour; without it geometry is black.
    bool scene_depth = false;  ///< The host gives its depth; without it every pixel is sky.
    bool sun_disk = true;
    double exposure = 1;  ///< Multiplies the result. Finite, > 0.
    ToneMap tone_map = ToneMap::none;
    bool encode_srgb = false;  ///< Apply the sRGB curve (for rgba8_unorm targets).
    bool dither = false;       ///< Triangular noise of one 8-bit step, after everything else.
};

/// The host's textures for one composite. Colour and depth in State::sampled / depth_read; target in storage_write (compute) or
/// color_attachment (raster). All are left in the state in which they came.
struct CompositeTargets {
    rhi::Texture scene_color{}, scene_depth{};  ///< Of the target's size.
    rhi::Texture target{};
    rhi::Texture directions{};  ///< Optional rgba32_float texture of the target's size: world directions (xyz) that replace the
                                ///< camera's rays; for tools that probe single directions.
    rhi::Extent extent{};       ///< Of the target. Another size is rejected if the device knows its textures (Device::find).
};

/// A camera's own tables, and the pass that shows them.
class View {
public:
    /// `atmosphere` must outlive the view.
    View(Atmosphere& atmosphere, const ViewSettings& settings = {}, const CompositeSettings& composite = {});
    ~View();
    View(const View&) = delete;
    View& operator=(const View&) = delete;

    /// Takes the frame's camera and suns (at most max_suns; none: night). Throws and changes nothing if a value is rejected. A
    /// camera that comes closer to the planet's centre than half its radius is told to the log, as a warning.
    void update(const Camera& camera, std::span<const Sun> suns);

    /// Replaces CompositeSettings::exposure. Finite, in [1e-30, 1e30].
    void set_exposure(double exposure);

    /// Records of sky-view, aerial perspective and light those that follow from what has changed in camera, suns and air:
    /// turning the camera makes new froxels alone, a new exposure or nothing makes none.
    void record(rhi::CommandList& commands, TimestampSlots timestamps = {});
    /// Prepares the bindings for these textures (may allocate; call when they change, at most once per swapchain image).
    void prepare_composite(const CompositeTargets& targets);
    /// Forgets textures that are about to be destroyed (a resized swapchain). Unknown targets are ignored.
    void release_composite(const CompositeTargets& targets) noexcept;
    /// Records the composite. `targets` must have been prepared, and the tables recorded since the air's structure changed;
    /// else nothing is recorded, and the log says so.
    void record_composite(rhi::CommandList& commands, const CompositeTargets& targets, TimestampSlots timestamps = {});
    [[nodiscard]] std::span<const PassReport> reports() const noexcept;

    [[nodiscard]] rhi::Texture sky_view_table() const noexcept;
    [[nodiscard]] rhi::Texture aerial_perspective_table() const noexcept;
    /// 10 x max_suns rgba32_float texels, one row a sun: [0..8] SH-L2 coefficients of sky radiance (world axes, real basis in
    /// the order 00, 1-1, 10, 11, 2-2 .. 22), [9] the sun's transmitted irradiance at the camera. The same on every backend;
    /// LightTable (light.h) takes what was read back. Null without ViewSettings::light.
    [[nodiscard]] rhi::Texture light_table() const noexcept;
    [[nodiscard]] std::uint64_t table_bytes() const noexcept;

    /// For a host's own shaders that include <aureole/glsl/aureole.glsl>: "#define AUREOLE_SPEC_<id> <value>" lines that go
    /// before it, and what to bind beside the tables. Valid until the structure of the air changes (set_parameters).
    [[nodiscard]] std::string shader_defines() const;
    [[nodiscard]] rhi::Buffer air_block() const noexcept;     ///< Uniform block, State::constants after the first record.
    [[nodiscard]] rhi::Buffer view_block() const noexcept;    ///< Uniform block, State::constants after the first record.
    [[nodiscard]] rhi::Texture phase_table() const noexcept;  ///< State::sampled after Atmosphere::record.

    struct Impl;
    [[nodiscard]] Impl& impl() const noexcept { return *impl_; }

private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace aureole
