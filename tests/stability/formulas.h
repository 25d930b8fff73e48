// The kernels' functions, callable in float and in double, for the air and the camera of a case.
#pragma once

#include "stability/inputs.h"

#define AUREOLE_PHASE_TABLE 1
#define AUREOLE_PROFILE_TABLE 2
#define AUREOLE_COLUMN_QUADRATURE quadrature
#define AUREOLE_COLUMN_NODES RAY_NODES
namespace aureole::kernels {
AUREOLE_DEFINE_CPU_KERNEL(StabilityFormulas)
#include "common/blocks.glsl"
#include "common/constants.glsl"
#include "common/specialization.glsl"
UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(3, QuadratureBlock, quadrature)
UNIFORMS(4, ViewBlock, view)
UNIFORMS(5, QuadratureBlock, zenith_quadrature)
SPEC_INT(8, RAY_NODES, 8)
CONST(bool, SINGLE_SCATTERING, true)
CONST(bool, MULTIPLE_SCATTERING, false)
// In this order:
#include "transmittance/by_quadrature.glsl"

#include "common/march.glsl"

#include "aerial_perspective/slices.glsl"
#include "common/ground.glsl"
#include "common/view_ray.glsl"
#include "composite/display.glsl"
#include "light/directions.glsl"
#include "light/harmonics.glsl"
#include "light/sun.glsl"
#include "models/hillaire/steps.glsl"
#include "multi_scatter/directions.glsl"
#include "phase/phase.glsl"
#include "phase/phase_sampling.glsl"
#include "phase/smooth_phase.glsl"
#include "sky_view/camera_ray.glsl"
#include "sky_view/sky_view.glsl"
};
}  // namespace aureole::kernels
#undef AUREOLE_PHASE_TABLE
#undef AUREOLE_PROFILE_TABLE
#undef AUREOLE_COLUMN_QUADRATURE
#undef AUREOLE_COLUMN_NODES

namespace aureole::stability {

template <class real>
using Formulas = Fed<kernels::StabilityFormulas, real>;

}  // namespace aureole::stability
