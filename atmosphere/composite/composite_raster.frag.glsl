// The composite as a full-screen draw.
#include "composite/composite.glsl"

FRAGMENT_MAIN(pixel) { return composite_pixel(pixel); }
