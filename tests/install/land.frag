// A material of an outside project, lit by the installed look-ups.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "aureole/glsl/aureole.glsl"

layout(location = 0) in vec3 offset_m;
layout(location = 1) in vec3 normal;
layout(location = 0) out vec4 color;

void main() {
    vec3 sun = aureole_sun_irradiance(0, offset_m) * max(dot(normal, vec3(0, 0, 1)), 0.0);
    color = vec4((sun + aureole_sky_irradiance(normal)) * (0.3 / 3.14159265), 1);
}
