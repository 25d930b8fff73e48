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
// everything as it was. One thread at a time may use an Atmosphere and its views. What is recorded counts as done, in the order
// of recording: a host that drops a recording says so (invalidate). Errors: Error(invalid_argument) names field, value and
// allowed range; where the device lacks something or fails, the code is another (error.h).
#pragma once

#include <aureole/camera.h>
#include <aureole/model.h>
#include <aureole/parameters.h>
#include <aureole/quality.h>
#include <aureole/rhi/device.h>
#include <aureole/shadows.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aureole {

/// What one pass did in the latest recording: for benchmarks and for hosts that show their costs.
struct PassReport {
    /// The model's own passes first (of `aureole`: "transmittance", "multi_scatter"; of a view "sky_view",
    /// "aerial_perspective"; of others what their pages name, or none). Then, of every model's views: "shadows" where a view
    /// has them, "light" (never recorded without ViewSettings::light), "composite".
    std::string_view name{};
    bool recorded = false;          ///< False when nothing that it depends on had changed; then the rest is of an earlier one.
    std::uint64_t invocations = 0;  ///< Shader invocations, those beyond the edges of tables left out.
    std::uint64_t bytes_written = 0;  ///< To tables and targets, by their formats.
};

/// Optional timestamps: pass i of reports() that is recorded writes slots first + 2 i, before it, and first + 2 i + 1, after
/// it. So Atmosphere::record takes 2 * reports().size() slots from `first` on, and so do View::record and
/// View::record_composite together, given the same `first`: the composite is the last pass of a view's reports. How many that
/// are depends on the model and on ViewSettings. A slot of Capabilities::timestamp_slots or beyond is not written, and the
/// device's message callback says so.
struct TimestampSlots {
    bool enabled = false;     ///< False: none are written.
    std::uint32_t first = 0;  ///< In [0, Capabilities::timestamp_slots - number of slots].
};

/// A planet's air on a device: its parameters, and the tables that its model makes of it. Views of it share them.
class Atmosphere {
public:
    /// Creates pipelines and tables on `device`, which must outlive this object. Validates both arguments; throws
    /// Error(unsupported) naming what the device lacks. Nothing is left behind then.
    Atmosphere(rhi::Device& device, const AtmosphereParameters& parameters, const ModelPtr& model);
    /// The model `aureole` with these settings.
    Atmosphere(rhi::Device& device, const AtmosphereParameters& parameters,
               const QualitySettings& quality = QualitySettings::standard());
    ~Atmosphere();
    Atmosphere(const Atmosphere&) = delete;
    Atmosphere& operator=(const Atmosphere&) = delete;

    /// New air or ground. Tables are rebuilt by the next record(), unless all is as it was. Throws and changes nothing if a
    /// value is rejected. Other numbers make no device object, but for an upload buffer where a tabulated profile or phase
    /// function is another one; another structure (number or kinds of terms, which of them share a phase function) makes new
    /// pipelines and tables, for all views too.
    void set_parameters(const AtmosphereParameters& parameters);
    [[nodiscard]] const AtmosphereParameters& parameters() const noexcept;  ///< As set last.
    [[nodiscard]] const Model& model() const noexcept;                      ///< As given to the constructor.
    [[nodiscard]] const QualitySettings& quality() const noexcept;          ///< Of the model.

    /// Passes of the multi-scatter fixed point recorded by each record() after a change, in [0, 64], else
    /// Error(invalid_argument): 0 solves at once (default), n spreads the solution over frames, n passes each; the table in use
    /// stays complete meanwhile. A solution that has been started is finished for the air that it was started for, and shown;
    /// the next one is for the air of that moment, so air that changes every frame is followed: what is shown is
    /// less than two solutions' frames old. Solved at once all the same: the first solution, one after a change of the planet's
    /// radii or of the structure, and that of a model without orders to solve (hillaire, or aureole with
    /// QualitySettings::multi_scatter_orders 0). n > 0 keeps a copy of what a solution reads: memory of one more transmittance
    /// table, and of the tabulated profiles (table_bytes); of `bruneton`, which shows the old air whole meanwhile, one more set
    /// of all tables. `first_too`: a model whose solution takes seconds spreads its first one as well; until that one is
    /// complete views have nothing to show.
    void set_multi_scatter_passes_per_frame(int passes, bool first_too = false);

    /// Frame number, in the host's counting, of the recording that follows: objects replaced by set_* die after it. Any number;
    /// it must not fall. 0 before the first call.
    void set_frame(std::uint64_t frame) noexcept;

    /// The tables are lost, and those of all views of this atmosphere: a list that they were recorded into was never executed
    /// (its submission failed, its image was out of date, it was reset or forgotten). The next record() of each records
    /// everything anew, the multi-scatter solution at once; until then views have nothing to show. Lists that have been
    /// submitted may still be running. Allocates nothing.
    void invalidate() noexcept;

    /// Records the model's tables of the air, if it keeps any and the air has changed. They are left in State::sampled.
    /// `commands` belongs to the device of the constructor, outside of a render pass, and is executed before whatever reads the
    /// tables; if it never is, call invalidate().
    void record(rhi::CommandList& commands, TimestampSlots timestamps = {});
    /// Of the latest record(): the model's passes over the air, as PassReport::name has them; empty for a model without any.
    [[nodiscard]] std::span<const PassReport> reports() const noexcept;

    /// Share of the tables for the air as it is that has been recorded, in [0, 1]; below 1 only where a model spreads its work
    /// over frames (by its own settings, or first_too above), and before that has begun.
    [[nodiscard]] double progress() const noexcept;

    [[nodiscard]] rhi::Device& device() const noexcept;  ///< As given to the constructor.
    // Null of a model that keeps no such table (its page says which it keeps). All can be copied from: out of State::sampled
    // and back into it.
    /// Optical depth to the top: see transmittance.glsl.
    [[nodiscard]] rhi::Texture transmittance_table() const noexcept;
    /// Of `aureole` moments (multi_scatter.glsl; null where QualitySettings::multi_scatter_orders is 0), of `hillaire` its
    /// isotropic source. Null in N wavelengths (models/spectral.h).
    [[nodiscard]] rhi::Texture multi_scatter_table() const noexcept;
    [[nodiscard]] std::uint64_t table_bytes() const noexcept;  ///< Device memory of the tables, those at work included.

    struct Impl;
    [[nodiscard]] Impl& impl() const noexcept { return *impl_; }

private:
    std::unique_ptr<Impl> impl_;
};

/// From exposed scene-linear light to what a display shows.
enum class ToneMap : std::uint8_t {
    none,         ///< As it is.
    aces_fitted,  ///< Stephen Hill's fit of the ACES reference and output transforms (composite/display.glsl): in [0, 1].
};

/// What a View makes. A value out of range is Error(invalid_argument) from View's constructor.
struct ViewSettings {
    /// Of every camera that the view is given: kernels are made for it.
    Projection projection = Projection::matrix;
    /// Rows and layers of suns in the view's tables: the most suns that update takes. In [1, 4]; tables grow with it, and where
    /// the device cannot hold them Error(unsupported) names the model's sky_view.height, aerial_perspective.height or
    /// dome.size.height.
    std::uint32_t max_suns = 1;
    bool aerial_perspective = true;  ///< False: the composite leaves geometry as it is, and there are no froxels.
    /// Depth of the last slice of froxels, metres; geometry beyond it gets the air up to there. In [1e-3, 1e13].
    double aerial_perspective_distance_m = 96000;
    ShadowSettings shadows{};  ///< Shadows in the air (shadows.h). Off by default.
    bool light = true;         ///< Sun colour and SH-L2 sky irradiance for the host's own lights (light_table).
};

/// How a View shows its tables. A value out of range is Error(invalid_argument) from View's constructor; a format that the
/// device cannot write in the chosen way is Error(unsupported) there.
struct CompositeSettings {
    /// Of CompositeTargets::target: any colour format that the device can store to (compute) or draw to (raster).
    rhi::Format target_format = rhi::Format::rgba16_float;
    bool raster = false;       ///< Full-screen draw instead of compute.
    bool scene_color = false;  ///< The host gives its colour; without it geometry is black.
    bool scene_depth = false;  ///< The host gives its depth; without it every pixel is sky.
    bool sun_disk = true;      ///< Draw the disks of suns with an angular radius, limb darkening and air included.
    /// In place of disks, the cheap sun of tutorials: a lobe of Henyey & Greenstein with this mean cosine around each sun that
    /// has an angular radius, of the same irradiance, seen through the same air. No edge, no limb darkening, and unlike a disk
    /// it is seen while any of the sky is, also when the sun has set. 0: disks. In [0, 0.9999]; 0.999 has half of its light
    /// within 0.1 degrees. Nothing without sun_disk.
    double sun_lobe_g = 0;
    double exposure = 1;               ///< Multiplies the result, before the tone map. In [1e-30, 1e30].
    ToneMap tone_map = ToneMap::none;  ///< After the exposure.
    bool encode_srgb = false;          ///< Apply the sRGB curve (for rgba8_unorm targets).
    bool dither = false;               ///< Triangular noise of one 8-bit step, after everything else.
};

/// The host's textures for one composite. Colour and depth in State::sampled / depth_read; target in storage_write (compute) or
/// color_attachment (raster). All are left in the state in which they came. A missing texture or an extent out of range is
/// Error(invalid_argument) from View::prepare_composite, and so is a target of another format than
/// CompositeSettings::target_format, or one that is read as well, if the device knows it (Device::find); another usage or
/// dimension is the device's error there.
struct CompositeTargets {
    rhi::Texture scene_color{};  ///< Scene-linear radiance in the suns' unit, not exposed; of the target's size. With
                                 ///< CompositeSettings::scene_color, else ignored.
    rhi::Texture scene_depth{};  ///< As Camera::projection stores it; of the target's size. With
                                 ///< CompositeSettings::scene_depth, else ignored.
    rhi::Texture target{};       ///< Every texel of it is written. Not scene_color.
    /// Optional rgba32_float texture of the target's size, State::sampled: world directions (xyz, of any length) that replace
    /// the camera's rays; for tools that probe single directions. A zero vector gives black. Not with ViewSettings::shadows,
    /// which are found along the camera's rays: Error(unsupported).
    rhi::Texture directions{};
    rhi::Extent extent{};  ///< Of the target, texels. Width and height in [1, Capabilities::max_texture_2d]; depth is ignored.
                           ///< Another size than the textures' is rejected if the device knows theirs (Device::find).
    [[nodiscard]] bool operator==(const CompositeTargets&) const = default;
};

/// A camera's own tables, and the pass that shows them.
class View {
public:
    /// `atmosphere` must outlive the view. Makes pipelines and tables; nothing is left behind by an error.
    View(Atmosphere& atmosphere, const ViewSettings& settings = {}, const CompositeSettings& composite = {});
    ~View();
    View(const View&) = delete;
    View& operator=(const View&) = delete;

    /// Takes the frame's camera (of the view's projection) and suns (at most max_suns; none: night). Throws and changes nothing
    /// if a value is rejected. A camera that comes closer to the planet's centre than half its radius is told to the log, as a
    /// warning; and so is what leaves the envelope of stability (envelope.h), once.
    void update(const Camera& camera, std::span<const Sun> suns);

    /// Replaces CompositeSettings::exposure. In [1e-30, 1e30], else Error(invalid_argument).
    void set_exposure(double exposure);

    /// The shadow map of one sun, if ViewSettings::shadows asks for one: to be called whenever it has been drawn anew or its
    /// matrices have changed, before record(); what is set stays until then. Allocates where the texture is another one. Throws
    /// and changes nothing if a value is rejected. The texture must live as long as it is set: null ends its use.
    void set_shadow_map(const ShadowMap& map);

    /// Records of the model's tables of the camera (none, for some models), shadows and light those that follow from what has
    /// changed in camera, suns and air: turning the camera makes new froxels alone, a new exposure or nothing makes none. After
    /// update() and Atmosphere::record; earlier, nothing is recorded and the log says so, once until it is mended. As there, a
    /// list that is never executed calls for invalidate().
    void record(rhi::CommandList& commands, TimestampSlots timestamps = {});
    /// The view's tables are lost, as by Atmosphere::invalidate, which does this for all views: for a list of which only this
    /// view's recording was dropped. The next record() records everything anew. Allocates nothing.
    void invalidate() noexcept;
    /// Prepares the bindings for these textures (may allocate; call when they change, once per swapchain image). The 16 used
    /// last stay prepared, also over Atmosphere::set_parameters; others must be prepared again. Throws and changes nothing if
    /// something is missing. A model of pixels in N wavelengths (models/spectral.h) makes one or two rgba32_float textures of
    /// the targets' size for each.
    void prepare_composite(const CompositeTargets& targets);
    /// Forgets textures that are about to be destroyed (a resized swapchain). Unknown targets are ignored.
    void release_composite(const CompositeTargets& targets) noexcept;
    /// Records the composite. `targets` must have been prepared, and the tables recorded since the air's structure changed;
    /// else nothing is recorded, and the log says so, once for each set of targets.
    void record_composite(rhi::CommandList& commands, const CompositeTargets& targets, TimestampSlots timestamps = {});
    /// Of the latest record(): the model's passes, shadows, light (PassReport::name); of the latest record_composite(), the
    /// last: composite.
    [[nodiscard]] std::span<const PassReport> reports() const noexcept;

    // Tables stay the same textures until the structure of the air changes (set_parameters), and can be copied from.
    // Null of a model, or settings of it, that keep no such table: all but `aureole` and the tables of `hillaire`, so far.
    [[nodiscard]] rhi::Texture sky_view_table() const noexcept;            ///< See sky_view.glsl.
    [[nodiscard]] rhi::Texture aerial_perspective_table() const noexcept;  ///< See aerial_perspective.glsl.
    /// Of a model in which frames add up (models/reference.h, if it is asked for a film; not in N wavelengths); else null.
    /// rgba32_float, to be read back.
    [[nodiscard]] rhi::Texture film_table() const noexcept;
    /// 10 x max_suns rgba32_float texels, one row a sun: [0..8] SH-L2 coefficients of sky radiance (world axes, real basis in
    /// the order 00, 1-1, 10, 11, 2-2 .. 22), [9] the sun's transmitted irradiance at the camera. The same on every backend;
    /// LightTable (light.h) takes what was read back. Null without ViewSettings::light.
    [[nodiscard]] rhi::Texture light_table() const noexcept;
    [[nodiscard]] std::uint64_t table_bytes() const noexcept;  ///< Device memory of the tables.

    /// For a host's own shaders that include <aureole/glsl/aureole.glsl> (its page says of which models): "#define
    /// AUREOLE_SPEC_<id> <value>" lines that go before it, and what to bind beside the tables. Valid until the structure of the
    /// air changes (set_parameters).
    [[nodiscard]] std::string shader_defines() const;
    /// The same as specialization constants (`layout(constant_id = id)`): for a shader that was compiled ahead, without
    /// AUREOLE_DEFINED_CONSTANTS, when its pipeline is made. All ids are below 64; values the shader does not know do no harm.
    [[nodiscard]] std::vector<rhi::Specialization> shader_constants() const;
    [[nodiscard]] rhi::Buffer view_block() const noexcept;  ///< Uniform block, State::constants after the first record.
    /// Uniform block, State::constants once there is something to show (Atmosphere::progress). Of the air that is shown.
    [[nodiscard]] rhi::Buffer air_block() const noexcept;
    [[nodiscard]] rhi::Texture phase_table() const noexcept;    ///< Likewise State::sampled.
    [[nodiscard]] rhi::Texture profile_table() const noexcept;  ///< Likewise State::sampled. For aureole_march.

    struct Impl;
    [[nodiscard]] Impl& impl() const noexcept { return *impl_; }

private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace aureole
