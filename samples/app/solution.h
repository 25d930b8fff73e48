// Making an atmosphere's tables where a model takes seconds for them.
#pragma once

#include "app/pass_times.h"

namespace aureole::app {

/// Records the tables of the air until they are complete. A model that takes long is given its passes one by one, with a bar on
/// the standard error. Appends each pass's time, of all parts together.
void solve(Backend& backend, Atmosphere& air, std::vector<PassTime>& times);
/// An atmosphere with its tables. Throws as Atmosphere's constructor does.
[[nodiscard]] std::unique_ptr<Atmosphere> solved(Backend& backend, const AtmosphereParameters& parameters,
                                                 const ModelPtr& model);

}  // namespace aureole::app
