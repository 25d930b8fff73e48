#version 430
// The engine's own last step: exposure, then the curve, the encoding and the dither of the composite's own display (display.glsl).
#define real float
const int TONE_MAP = 1;
const bool ENCODE_SRGB = true;
const bool DITHER = true;
#include "display.glsl"

uniform sampler2D picture;
uniform float exposure;
in vec2 place;
out vec4 shown;

void main() {
    shown = vec4(display(exposure * texture(picture, place).rgb, ivec2(gl_FragCoord.xy), 0.0), 1.0);
}
