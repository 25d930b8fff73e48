// From exposed scene-linear light to the window. The curve is the composite's own (composite/display.glsl), so that a screenshot
// can be compared with what `aureole render` writes; a host has its own.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#define real float
const int TONE_MAP = 1;
layout(constant_id = 0) const bool ENCODE_SRGB = true;
const bool DITHER = true;
#include "composite/display.glsl"

layout(set = 0, binding = 2) uniform sampler2D picture;
layout(location = 0) out vec4 color;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    color = vec4(display(texelFetch(picture, pixel, 0).rgb, pixel, frame.counts.w), 1);
}
