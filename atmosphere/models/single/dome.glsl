// The sky of single scattering at the vertices of a dome: a table with the axes and layers of sky_view.glsl, one vertex a texel.
#ifndef AUREOLE_DOME_GLSL
#define AUREOLE_DOME_GLSL

#include "models/single/single.glsl"
#include "sky_view/sky_view.glsl"
#define AUREOLE_SKY_VIEW_MARCH march_single
#include "sky_view/sky_view_texel.glsl"

LOCAL_SIZE(32, 2, 1)

COMPUTE_MAIN(id) { sky_view_texel(ivec2(id.x, id.y)); }

#endif
