#version 430
// The engine's own last step: exposure, then the curve, the encoding and the dither of the composite's own display.
#include "aureole_display.glsl"

uniform sampler2D picture;
uniform float exposure;
in vec2 place;
out vec4 shown;

void main() {
    shown = vec4(aureole_display(exposure * texture(picture, place).rgb, 1, true, true, ivec2(gl_FragCoord.xy), 0.0), 1.0);
}
