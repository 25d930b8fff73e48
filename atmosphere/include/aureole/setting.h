// What can be chosen for a scene, by name: a model, how finely it is made, and what is left out of it. What is measured
// (docs/measure.md), and what the planner chooses among (plan.h).
//
//     const Setting setting{.model = "aureole", .quality = "default", .without = {"ozone"}};
//     if (const auto ready = prepare(setting, presets::earth())) Atmosphere air(device, ready->air, ready->model);
#pragma once

#include <aureole/model.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aureole {

/// A way to make a sky, by names: what plans are made of, and what suites measure.
struct Setting {
    std::string model = "aureole";       ///< One of model_names().
    std::string quality = "default";     ///< One of quality_names(), or "converged".
    std::string spectral = "rgb";        ///< "rgb", or a number of wavelengths as models::wavelengths_by_name takes it.
    std::vector<std::string> without{};  ///< Each a term of the air by its name, or one of simplification_names().

    [[nodiscard]] bool in_rgb() const { return spectral == "rgb"; }  ///< Not in wavelengths.
    /// "aureole default", "aureole default 4", "aureole default, without ozone and mie"
    [[nodiscard]] std::string id() const;
    /// The id of the same with nothing left out; empty for one of which nothing is.
    [[nodiscard]] std::string baseline() const;
    [[nodiscard]] bool leaves_out(std::string_view what) const;  ///< Whether `without` names it.
    [[nodiscard]] bool operator==(const Setting&) const = default;
};

/// What can be left out besides a term of the air by its name:
///   "multiple scattering"    light scattered more than once, and the sky's light on the ground (aureole)
///   "its direction"          all of multiple scattering but its mean (aureole)
///   "ground light"           what the ground sends into the air; the ground itself stays as it is seen (aureole)
///   "half the samples"       every second node or step along rays (aureole, hillaire, bruneton, single, single-lut)
///   "float tables"           tables are half floats (aureole, bruneton, single-lut)
///   "coloured transmittance" all colours are dimmed alike by the air in front of geometry (hillaire high)
///   "wavelengths"            the model in red, green and blue (settings with `spectral`)
[[nodiscard]] std::span<const std::string_view> simplification_names();

/// Throws Error(invalid_argument) naming "model", "quality", "spectral" or "without" if this is no setting: a name that there
/// is not, or something left out that the model does not have, or twice. A word that is no simplification's counts as a term's
/// name: whether there is such a term only an air can tell (prepare).
void validate(const Setting& setting);

/// A model in an air, ready to be given to an Atmosphere.
struct Prepared {
    AtmosphereParameters air;  ///< Without what is left out of it.
    ModelPtr model;            ///< To be given to Atmosphere with it.
};
/// None where a term is to be left out that the air does not have. Throws as validate does.
[[nodiscard]] std::optional<Prepared> prepare(const Setting& setting, const AtmosphereParameters& air);

/// The same as fine as the model gets, with the same left out of the light itself (not of samples and formats), be it by
/// `without` or by the quality (the grey air of hillaire, the mean of aureole low, fog of one colour): what separates the two
/// is discretisation. It does not validate: of what is no setting it makes another such, which validate() and prepare() refuse.
[[nodiscard]] Setting converged(const Setting& setting);

}  // namespace aureole
