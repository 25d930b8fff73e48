#version 450
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(push_constant) uniform Push { int cascade; } push;

void main() {
    vec3 place = (frame.camera_to_map[push.cascade] * vec4(position + frame.mesh_origin.xyz, 1)).xyz;
    gl_Position = vec4(2.0 * place.xy - 1.0, place.z, 1);
}
