// The ladder of sky models: one description by which a host chooses what draws its sky, from a fog of one colour to a path
// tracer. Each model has a header of its own with its settings (aureole/models/<name>.h); all are used alike:
//
//     Atmosphere air(device, presets::earth(), models::aureole(QualitySettings::high()));
#pragma once

#include <aureole/parameters.h>
#include <aureole/quality.h>
#include <aureole/rhi/device.h>

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aureole {

namespace detail {
struct AirResources;
class ModelAir;
}  // namespace detail

/// A table that a model keeps, as its settings have it.
struct ModelTable {
    std::string name;      ///< "transmittance table", "multi-scatter table", "sky-view table", "froxels" ...
    rhi::Extent size{};    ///< Nodes on its axes, of one layer and one sun: the texture may have more rows.
    rhi::Format format{};  ///< Where the device can filter it.
    std::string samples;   ///< What each texel is made of: "8 nodes a ray".
};

/// A model with its settings: does not change, and may be shared by any number of atmospheres.
class Model {
public:
    virtual ~Model() = default;
    [[nodiscard]] virtual std::string_view name() const noexcept = 0;  ///< "aureole", "hillaire", "fog" ...
    /// Settings of the tables, for models that make some of them; else the default ones, of no effect.
    [[nodiscard]] virtual const QualitySettings& quality() const noexcept = 0;
    /// The settings that this air gets: a model may leave out what would make no difference.
    [[nodiscard]] virtual QualitySettings quality_for(const AtmosphereParameters& /*parameters*/) const { return quality(); }
    /// The tables of this air and of a view, from the air to the camera; empty of a model without any.
    [[nodiscard]] virtual std::vector<ModelTable> tables_for(const AtmosphereParameters& /*parameters*/) const { return {}; }
    /// Throws Error(invalid_argument) at the first setting outside its range.
    virtual void validate() const = 0;
    /// Throws Error(unsupported) naming what the model needs and the device lacks.
    virtual void require(const rhi::Device& device) const = 0;
    /// What is shown of it comes from tables alone: of several wavelengths (models/spectral.h) these are added up, else pixels.
    [[nodiscard]] virtual bool by_tables() const noexcept { return false; }
    /// Whether the host's shadow maps can darken its air (ViewSettings::shadows): its light is single scattering of the air's
    /// terms, and more.
    [[nodiscard]] virtual bool has_shadows() const noexcept { return true; }
    /// For the module's use: everything on the device that belongs to one air.
    [[nodiscard]] virtual std::unique_ptr<detail::ModelAir> make_air(detail::AirResources& shared,
                                                                     const AtmosphereParameters& parameters) const = 0;
};
using ModelPtr = std::shared_ptr<const Model>;  ///< Models hold settings alone, and are shared.

/// Names of all models, from the cheapest to the dearest.
[[nodiscard]] std::span<const std::string_view> model_names();
/// What one of them is, in a line. Throws as model_by_name does.
[[nodiscard]] std::string_view model_summary(std::string_view name);
/// A model by its name, in one of quality_names(), or "converged". Throws Error(invalid_argument) naming the field ("model" or
/// "quality") and what it may be.
[[nodiscard]] ModelPtr model_by_name(std::string_view name, std::string_view quality = "default");

}  // namespace aureole
