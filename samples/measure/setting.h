// The settings of a suite made ready for an air: what is left out of the air and of the model.
#pragma once

#include "measure/suite.h"

#include <aureole/model.h>

#include <optional>
#include <span>
#include <string_view>

namespace aureole::app {

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
/// is not, or something left out that the model does not have.
void check(const SuiteSetting& setting);

/// A model in an air, ready to be evaluated.
struct Prepared {
    AtmosphereParameters air;
    ModelPtr model;
};
/// None where a term is to be left out that the air does not have.
[[nodiscard]] std::optional<Prepared> prepare(const SuiteSetting& setting, const AtmosphereParameters& air);
/// Whether it is measured in this air: in colours of its truth, with nothing left out that the air does not have.
[[nodiscard]] bool is_for(const SuiteSetting& setting, const SuiteAir& air);
/// The same as fine as the model gets, with the same left out of the light itself (not of samples and formats), be it by
/// `without` or by the quality (the grey air of hillaire, the mean of aureole low, fog of one colour): what separates the two
/// is discretisation.
[[nodiscard]] SuiteSetting converged(const SuiteSetting& setting);

}  // namespace aureole::app
