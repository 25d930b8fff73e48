// What a model of the ladder implements. The module owns the air's numbers, the camera's and the suns', the composite and the
// light pass; a model owns its tables, and gives composite and light the kernels that look them up.
#pragma once

#include "common/pass.h"

#include <aureole/model.h>

#include <vector>

namespace aureole::detail {

/// What every pass of a view shares.
struct ViewResources {
    Objects& objects;
    AirResources& air;
    TrackedBuffer& block;  ///< ViewBlock
    std::uint32_t suns;    ///< Most suns that the view is given.
    Projection projection;
    rhi::Buffer triplet{};  ///< TripletBlock, if kernels compute light of three of N wavelengths; null: red, green and blue.
    /// Specialization of every kernel of a view.
    [[nodiscard]] Specialize specialize() const;
    /// For common/triplet.glsl.
    [[nodiscard]] rhi::Binding triplet_binding() const { return {15, {}, {}, triplet ? triplet : air.block.handle}; }
};

struct ModelKernels;
/// What composite, light and shadows are run with for three of N wavelengths.
struct TripletKernels {
    ViewResources* shared;
    const ModelKernels* kernels;
    rhi::Texture transmittance{};  ///< ModelAir::transmittance_table of the air at these wavelengths; shadows alone read it.
};

/// The kernels that show a model's sky, each with the slots of composite/inputs.glsl or light/inputs.glsl and the model's own.
struct ModelKernels {
    const rhi::Shader* composite = nullptr;
    const rhi::Shader* composite_raster = nullptr;
    const rhi::Shader* light = nullptr;
    std::vector<rhi::Binding> tables;                 ///< Of the model; each kernel takes those that it has slots for.
    std::vector<rhi::Specialization> specialization;  ///< Beyond ViewResources::specialize.
    /// Number of a boolean constant of the composite's, true where the camera stands above the air; 0: it has none.
    std::uint32_t space_constant = 0;
    bool aerial_perspective = true;          ///< False: geometry is left as it is.
    std::vector<TripletKernels> triplets{};  ///< Run in turn and added up, in place of these kernels; none: these.
    /// Airs that shadows take light from, each at three wavelengths, whether or not the tables shown are sums; none: the view's
    /// own.
    std::vector<TripletKernels> shadow_triplets{};
};
/// What composite and light run: the triplets, or the kernels themselves.
[[nodiscard]] std::vector<TripletKernels> runs_of(ViewResources& shared, const ModelKernels& kernels);
/// Of n runs each but the last leaves its sum to the next in one of so many textures, in turn.
[[nodiscard]] constexpr std::size_t sums_between(std::size_t runs) { return runs > 2 ? 2 : runs - 1; }

/// A table of light that a model's views read, and how it is made up: for adding up the tables of several wavelengths.
struct LightTexture {
    TrackedTexture* table;
    std::uint32_t layers = 1;  ///< Of equal height, stacked in y.
    int depth_layer = -1;      ///< That which holds optical depth; the others are proportional to radiance. -1: none does.
};

/// What a model keeps for a camera.
class ModelView {
public:
    virtual ~ModelView() = default;
    /// Names of its passes, in the order of their reports; none if it keeps no tables of a camera.
    [[nodiscard]] virtual std::span<const std::string_view> passes() const noexcept { return {}; }
    [[nodiscard]] virtual const ModelKernels& kernels() const noexcept = 0;
    /// Camera or suns have changed.
    virtual void update(const ViewBlock& /*before*/, const ViewBlock& /*fresh*/) noexcept {}
    /// The air has changed.
    virtual void restart() noexcept {}
    /// Everything on the device is lost.
    virtual void invalidate() noexcept {}
    /// Records what has become due, leaving all textures that kernels() names in State::sampled.
    virtual void record(rhi::CommandList& /*commands*/, std::span<PassReport> /*reports*/, TimestampSlots /*timestamps*/) {}
    /// Has been recorded since it was made.
    [[nodiscard]] virtual bool ready() const noexcept { return true; }
    [[nodiscard]] virtual bool due() const noexcept { return false; }  ///< record() has something to do.
    /// All that is shown, of models with Model::by_tables; else those that a host may look up.
    [[nodiscard]] virtual std::vector<LightTexture> light_textures() { return {}; }
    /// For a host's own shaders (host/aureole.glsl): null where a model keeps none.
    [[nodiscard]] virtual rhi::Texture sky_view_table() const noexcept { return {}; }
    [[nodiscard]] virtual rhi::Texture aerial_perspective_table() const noexcept { return {}; }
    /// Where frames add up; null where they do not.
    [[nodiscard]] virtual rhi::Texture film_table() const noexcept { return {}; }
};

/// Where the numbers of a changed air go.
enum class NewAir {
    shown,  ///< To what views read.
    apart,  ///< To the model, which has something else to show until record() says that it is done.
    later,  ///< Nowhere: the model is at work for the air before.
};

/// What a model keeps for an air of one structure; made anew when that changes.
class ModelAir {
public:
    virtual ~ModelAir() = default;
    [[nodiscard]] virtual std::span<const std::string_view> passes() const noexcept { return {}; }
    /// Completes the block with what the model's own kernels read of it.
    virtual void complete(const AtmosphereParameters& /*parameters*/, AtmosphereBlock& /*block*/) const noexcept {}
    /// The air's numbers have changed from one block to the other. May throw, and then nothing has changed.
    virtual void restart(const AtmosphereParameters& /*parameters*/, const AtmosphereBlock& /*before*/,
                         const AtmosphereBlock& /*fresh*/) {}
    virtual void invalidate() noexcept {}
    /// Of the next record().
    [[nodiscard]] virtual NewAir new_air() const noexcept { return NewAir::shown; }
    /// Where the air's block and tables go, and are copied from when they are shown, of a model with NewAir::apart; null: it
    /// needs none of its own.
    [[nodiscard]] virtual AirResources* apart() noexcept { return nullptr; }
    /// Records what has become due; true if anything that views read has changed.
    virtual bool record(rhi::CommandList& /*commands*/, const AtmosphereBlock& /*block*/, std::span<PassReport> /*reports*/,
                        TimestampSlots /*timestamps*/) {
        return false;
    }
    [[nodiscard]] virtual bool ready() const noexcept { return true; }
    /// record() has something to do although the air has not changed.
    [[nodiscard]] virtual bool due() const noexcept { return false; }
    [[nodiscard]] virtual std::vector<LightTexture> light_textures() { return {}; }  ///< As of ModelView.
    /// False where these parameters, of the same structure, call for other objects all the same.
    [[nodiscard]] virtual bool fits(const AtmosphereParameters& /*parameters*/) const { return true; }
    /// How much of the solution for the air as it is has been recorded, in [0, 1].
    [[nodiscard]] virtual double progress() const noexcept { return 1; }
    /// Passes of iterative solutions recorded by each record(); 0: all at once. May throw, and then nothing has changed.
    virtual void spread(int /*passes_per_frame*/, bool /*first_too*/) {}
    /// Device memory of textures that are not in AirResources::objects, bytes.
    [[nodiscard]] virtual std::uint64_t more_texture_bytes() const noexcept { return 0; }
    [[nodiscard]] virtual std::unique_ptr<ModelView> make_view(ViewResources& shared, const ViewSettings& settings) = 0;
    [[nodiscard]] virtual rhi::Texture transmittance_table() const noexcept { return {}; }
    [[nodiscard]] virtual rhi::Texture multi_scatter_table() const noexcept { return {}; }
};

/// The bindings that a kernel has slots for.
[[nodiscard]] std::vector<rhi::Binding> bindings_of(const rhi::Shader& shader, std::span<const rhi::Binding> offered);

}  // namespace aureole::detail
