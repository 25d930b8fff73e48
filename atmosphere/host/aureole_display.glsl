// The composite's last step for a host that shows the picture itself: tone map, the sRGB curve and dither, as CompositeSettings has
// them (atmosphere.h). The build makes one self-contained file of this one, <aureole/glsl/aureole_display.glsl>; it declares no
// resources. How to use it: host.md.
#ifndef AUREOLE_HOST_DISPLAY_GLSL
#define AUREOLE_HOST_DISPLAY_GLSL

#include "composite/display.glsl"

// `color`: exposed, scene-linear, Rec.709. `tone_map`: 0 none, 1 as ToneMap::aces_fitted. `srgb`: for targets that do not encode by
// themselves. `dither`: noise of one step of 8 bits, which moves with `frame`, a whole number in [0, 1024), and `pixel`.
vec3 aureole_display(vec3 color, int tone_map, bool srgb, bool dither, ivec2 pixel, real frame) {
    return display(color, tone_map, srgb, dither, pixel, frame);
}

#endif
