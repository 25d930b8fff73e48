// The kernels' formulas for phase functions and medium, callable by the host in float and double: nothing is typed twice.
#pragma once

#include "common/host_blocks.h"

#define AUREOLE_PHASE_TABLE 0
#define AUREOLE_PROFILE_TABLE 1

namespace aureole::kernels {

AUREOLE_DEFINE_CPU_KERNEL(AirFormulas)
#include "common/blocks.glsl"
UNIFORMS(2, AtmosphereBlock, atm)
#include "medium/medium.glsl"
#include "phase/phase.glsl"
};

}  // namespace aureole::kernels

#undef AUREOLE_PHASE_TABLE
#undef AUREOLE_PROFILE_TABLE
