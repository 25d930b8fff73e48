// What is outside the envelope, to the log.
#pragma once

#include <aureole/envelope.h>
#include <aureole/model.h>

#include <vector>

namespace aureole::detail {

/// Warns of each field of `now` that is not in `known`, which then becomes `now`: what stays outside is told once. `told`: by
/// all that share an air; two views of one camera say the same but once.
void tell_outside(std::vector<OutsideEnvelope>& known, std::vector<OutsideEnvelope> now, std::vector<OutsideEnvelope>& told);

/// What the model keeps in half floats, with twilight as dark as it is: the sky that is shown; tables for geometry.
[[nodiscard]] InHalfFloats kept_in_half(const Model& model, const AtmosphereParameters& parameters);

}  // namespace aureole::detail
