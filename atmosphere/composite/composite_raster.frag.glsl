// The composite of models with sky-view tables, as a full-screen draw.
#include "composite/inputs.glsl"
#include "sky_view/sky_light.glsl"
#include "composite/raster.glsl"
