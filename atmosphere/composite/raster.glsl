// A composite kernel as a full-screen draw.
#ifndef AUREOLE_COMPOSITE_RASTER_GLSL
#define AUREOLE_COMPOSITE_RASTER_GLSL

#include "composite/composite.glsl"

FRAGMENT_MAIN(pixel) { return composite_pixel(pixel); }

#endif
