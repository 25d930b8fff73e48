// One model of the ladder on every backend, over every preset, from the ground to space, from noon to night.
#pragma once

#include "passes/trio.h"

namespace aureole::passes {

/// Records and shows the model everywhere, over geometry and sky: all numbers are finite and none is negative, and the backends
/// agree. Prints what was measured under this name.
void check_model(Backends& backends, const ModelPtr& model, const std::string& name);

}  // namespace aureole::passes
