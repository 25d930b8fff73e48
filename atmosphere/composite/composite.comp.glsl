// The composite of models with sky-view tables, as a compute pass.
#include "composite/inputs.glsl"
#include "sky_view/sky_light.glsl"
#include "composite/compute.glsl"
