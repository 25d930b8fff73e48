// From exposed scene-linear light to the window. The curve is the composite's own, so that a screenshot
// can be compared with what `aureole render` writes; a host has its own.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "aureole_display.glsl"
layout(constant_id = 0) const bool ENCODE_SRGB = true;

layout(set = 0, binding = 2) uniform sampler2D picture;
layout(location = 0) out vec4 color;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    color = vec4(aureole_display(texelFetch(picture, pixel, 0).rgb, 1, ENCODE_SRGB, true, pixel, frame.counts.w), 1);
}
