// crossfade.glsl as a full-screen draw.
#include "planned_sky/crossfade.glsl"

FRAGMENT_MAIN(pixel) { return crossfade_pixel(pixel); }
